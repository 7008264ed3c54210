// Did you mean ...?
#pragma once

#include <string>
#include <vector>

namespace terrview {

// Of `names`, which are not empty, the first of those that look most like `text`: the fewest
// letters are put in, taken out or changed (Levenshtein's distance).
[[nodiscard]] std::string nearest_name(const std::vector<std::string>& names,
                                       const std::string& text);

}  // namespace terrview
