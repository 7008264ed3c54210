// The part of JSON Schema that docs/scene.schema.json is written in.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace terrview {

// Where and why a value does not fit the schema; empty: it does. Ends the test on a keyword that it
// does not know.
[[nodiscard]] std::string schema_fault(const nlohmann::ordered_json& schema,
                                       const nlohmann::ordered_json& value);

}  // namespace terrview
