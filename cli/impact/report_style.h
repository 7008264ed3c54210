// The look of a report, and what moves its sliders.
#pragma once

#include <string_view>

namespace terrview {

extern const std::string_view kReportStyle;   // CSS
extern const std::string_view kReportScript;  // JavaScript, for the end of the body

}  // namespace terrview
