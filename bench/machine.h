// What the figures of a benchmark depend on.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace terrview {

// {cpu, threads, memory_gib, load_1min, compiler, build, embree}; what is not known is null.
[[nodiscard]] nlohmann::ordered_json describe_machine();

// Now, ISO 8601, UTC.
[[nodiscard]] std::string utc_date();

}  // namespace terrview
