// The options of a random field: shared by the commands that make one.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "sky/random_field.h"

namespace terrview {

class CommandLine;

// H, or H and from which division on another one holds: "0,8:0.3" is 0 for divisions 0 to 7, then
// 0.3. Throws InputError.
[[nodiscard]] std::vector<double> parse_h(const std::string& text);

// N, or NX:NY. Throws InputError.
[[nodiscard]] glm::ivec2 parse_levels(const std::string& text);

// A whole number of 64 bits. Throws InputError.
[[nodiscard]] std::uint64_t parse_seed(const std::string& option, const std::string& text);

// --seed, --h, --levels, --field and --law.
void add_field_options(CommandLine& app, FieldOptions& options);

// What they have become, as a picture says of itself.
[[nodiscard]] nlohmann::ordered_json field_json(const FieldOptions& options);

}  // namespace terrview
