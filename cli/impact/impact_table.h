// The numbers of a study as tables: docs/impact.md.
#pragma once

#include <string>
#include <vector>

#include "cli/impact/impact_study.h"
#include "ingest/feature_file.h"

namespace terrview {

// What a study found, and what it is about.
struct ImpactStudy {
  Project project;
  std::vector<ViewpointStudy> viewpoints;
  std::string crs_wkt;  // of the project's and the viewpoints' places; empty = none
};

// For each viewpoint a row of the whole project (without a building), then one of each of its
// buildings.
[[nodiscard]] FeatureLayer sights_layer(const ImpactStudy& study);

[[nodiscard]] FeatureLayer viewpoints_layer(const ImpactStudy& study);

[[nodiscard]] FeatureLayer buildings_layer(const ImpactStudy& study);

// As RFC 4180 has it, with a header; without geometry.
[[nodiscard]] std::string csv_text(const FeatureLayer& layer);

}  // namespace terrview
