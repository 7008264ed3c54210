// A study as one HTML page that needs nothing else.
#pragma once

#include <string>
#include <vector>

#include "cli/impact/impact_options.h"
#include "cli/impact/impact_table.h"
#include "ingest/dem.h"
#include "ingest/zone.h"

namespace terrview {

struct ReportParts {
  const ImpactStudy& study;
  const ImpactOptions& options;
  const std::vector<Dem>& dems;
  const Zone* zone;  // null: none was asked for
  std::string map_svg;
};

[[nodiscard]] std::string report_html(const ReportParts& parts);

}  // namespace terrview
