// The sections of a report.
#pragma once

#include <string>

#include "cli/impact/impact_report.h"

namespace terrview {

[[nodiscard]] std::string summary_section(const ReportParts& parts);

[[nodiscard]] std::string viewpoint_section(const ReportParts& parts,
                                            const ViewpointStudy& viewpoint);

// What was done with which data, what the numbers mean, and what is not modelled.
[[nodiscard]] std::string method_section(const ReportParts& parts);

}  // namespace terrview
