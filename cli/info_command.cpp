#include "cli/info_command.h"

#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "cli/command_line.h"
#include "cli/interrupt.h"
#include "cli/output_options.h"
#include "cli/progress.h"
#include "cli/view_options.h"
#include "ingest/dem_info.h"

namespace terrview {
namespace {

using Json = nlohmann::ordered_json;

struct InfoOptions {
  std::vector<std::string> dems;
  DemOptions dem;
  bool json = false;
  BarOptions bar;
};

InfoOptions parse_info(const std::vector<std::string>& args) {
  InfoOptions options;
  CommandLine app("What DEMs hold", "terrview info");
  add_dem_options(app, options.dems, options.dem);
  app.add_flag("--json", options.json, "As JSON");
  add_bar_options(app, options.bar.quiet, options.bar.progress);
  app.parse_args(args);
  return options;
}

std::vector<Dem> read(InfoOptions& options) {
  ProgressBar bar("reading", options.bar.show());
  options.dem.progress = [&](double share) {
    check_interrupt();
    bar.report(share);
  };
  return read_dems(options.dems, options.dem);
}

void add_place(Json& json, const PostCoordinates& place) {
  json["x"] = place.xy.x;
  json["y"] = place.xy.y;
  if (!place.geographic) return;
  json["latitude"] = place.geographic->latitude_deg;
  json["longitude"] = place.geographic->longitude_deg;
}

Json text_or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json to_json(const PostCoordinates& place) {
  Json json;
  add_place(json, place);
  return json;
}

Json crs_json(const DemInfo& info) {
  if (!info.operation) return nullptr;
  Json json{{"name", info.crs_name}, {"code", text_or_null(info.crs_code)}};
  json["to_wgs84"] = {{"operation", info.operation->name}, {"accuracy_m", nullptr}};
  if (info.operation->accuracy_m) json["to_wgs84"]["accuracy_m"] = *info.operation->accuracy_m;
  return json;
}

Json to_json(const Dem& dem, const DemInfo& info) {
  Json json;
  json["name"] = dem.name;
  json["columns"] = dem.grid->columns;
  json["rows"] = dem.grid->rows;
  json["spacing_m"] = {info.spacing_m.x, info.spacing_m.y};
  json["crs"] = crs_json(info);
  json["first_post"] = to_json(info.first_post);
  json["last_post"] = to_json(info.last_post);
  json["middle"] = to_json(info.middle);
  json["lowest_m"] = info.range.lowest_m;
  json["highest_m"] = info.range.highest_m;
  json["height_unit"] = text_or_null(dem.height_unit);
  json["vertical_datum"] = text_or_null(dem.vertical_datum);
  json["voids"] = {{"filled", dem.voids_filled}, {"open", dem.voids_open}};
  json["summits"] = Json::array();
  for (const SummitPlace& summit : info.summits) {
    Json place{{"height_m", summit.height_m}};
    add_place(place, summit.place);
    json["summits"].push_back(place);
  }
  json["warnings"] = dem.warnings;
  return json;
}

std::string to_text(const PostCoordinates& place) {
  char text[80];
  if (place.geographic) {
    std::snprintf(text, sizeof text, "%.6f, %.6f", place.geographic->latitude_deg,
                  place.geographic->longitude_deg);
  } else {
    std::snprintf(text, sizeof text, "x %.2f, y %.2f", place.xy.x, place.xy.y);
  }
  return text;
}

const char* or_unknown(const std::string& text) { return text.empty() ? "unknown" : text.c_str(); }

void print_crs(const DemInfo& info) {
  if (!info.operation) {
    std::printf("  CRS        none: flat\n");
    return;
  }
  std::printf("  CRS        %s%s%s%s\n", info.crs_name.c_str(), info.crs_code.empty() ? "" : " (",
              info.crs_code.c_str(), info.crs_code.empty() ? "" : ")");
  std::printf("  to WGS 84  %s, accuracy ", info.operation->name.c_str());
  if (info.operation->accuracy_m) {
    std::printf("%g m\n", *info.operation->accuracy_m);
  } else {
    std::printf("unknown\n");
  }
}

void print(const Dem& dem, const DemInfo& info) {
  std::printf("%s\n", dem.name.c_str());
  std::printf("  posts      %d x %d, %.4g m x %.4g m apart\n", dem.grid->columns, dem.grid->rows,
              info.spacing_m.x, info.spacing_m.y);
  print_crs(info);
  std::printf("  from       %s to %s\n", to_text(info.first_post).c_str(),
              to_text(info.last_post).c_str());
  std::printf("  middle     %s\n", to_text(info.middle).c_str());
  std::printf("  heights    %.1f to %.1f m; unit in the file %s, vertical datum %s\n",
              static_cast<double>(info.range.lowest_m), static_cast<double>(info.range.highest_m),
              or_unknown(dem.height_unit), or_unknown(dem.vertical_datum));
  std::printf("  voids      %zu posts filled, %zu open\n", dem.voids_filled, dem.voids_open);
  for (std::size_t i = 0; i < info.summits.size(); ++i) {
    const SummitPlace& summit = info.summits[i];
    std::printf("  %-9s  %s  %.1f m\n", i == 0 ? "summits" : "", to_text(summit.place).c_str(),
                static_cast<double>(summit.height_m));
  }
}

}  // namespace

int run_info(const std::vector<std::string>& args) {
  InfoOptions options = parse_info(args);
  const std::vector<Dem> dems = read(options);
  Json json;
  json["dems"] = Json::array();
  for (const Dem& dem : dems) {
    const DemInfo info = describe_dem(dem);
    if (options.json) {
      json["dems"].push_back(to_json(dem, info));
    } else {
      print(dem, info);
    }
    for (const std::string& warning : dem.warnings) {
      if (!options.bar.quiet) std::fprintf(stderr, "warning: %s\n", warning.c_str());
    }
  }
  if (options.json) std::printf("%s\n", json.dump(2).c_str());
  return 0;
}

}  // namespace terrview
