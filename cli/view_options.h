// The options of `terrview view`: docs/cli.md, one field each.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "cli/parse.h"
#include "cli/quantize_options.h"
#include "ingest/buildings.h"
#include "ingest/dem.h"
#include "ingest/view_frame.h"
#include "render/camera.h"
#include "render/render.h"
#include "render/scene.h"
#include "sky/clear_sky.h"
#include "sky/sun.h"

namespace terrview {

class CommandLine;

struct SceneContents;

struct LightOptions {
  std::optional<SunPosition> sun;
  std::optional<double> time;  // Julian day of UTC
  bool refracted_sun = false;  // drawn where refraction lifts it
  bool soft_shadows = false;
  bool no_shadows = false;
  bool relief = false;   // a map's light
  int sky_azimuths = 0;  // of the horizons that dim the sky's light; 0 = it is even
};

struct AirOptions {
  std::optional<double> visibility_km;  // infinite = no air; none = 60
  std::optional<double> extinction_per_km;
  std::optional<glm::vec3> color;
  std::optional<glm::vec3> sunward;
  double haze_px = 0;  // at the distance of the visibility
};

struct ViewSkyOptions {
  bool none = false;  // the plain gradient
  std::uint64_t seed = 1;
  double clouds = 0.35;
  std::optional<HeightText> cloud_base;  // none: 2000 m above the eye
  double cloud_cell_m = 8000;
  bool cloud_shadows = false;
  SkyModel model = SkyModel::preetham;
  double turbidity = 2.5;
};

struct NaturalOptions {
  std::optional<double> snow_line_m;
  std::optional<double> rock_slope_deg;
};

struct WaterOptions {
  std::optional<double> level_m;
  std::string file;
  std::optional<glm::vec3> color;
};

struct ObjectOptions {
  std::vector<std::string> buildings;
  std::string trees;
  FootprintOptions reading;
  BuildingOptions placing;
  std::string building_color;  // as given
  std::string csv;
};

struct LabelOptions {
  std::string peaks;
  std::string svg;
  std::string font;  // empty: a usual one
  std::optional<int> size_px;
};

struct WirelineOptions {
  std::string file;
  std::optional<int> step_posts;  // none: as the picture has room
};

struct SamplingOptions {
  int samples = 0;  // a pixel; 0 = adaptive
  double contrast = 0.03;
  bool preview = false;
  bool detail = true;
};

struct ViewOptions {
  std::vector<std::string> dems;                  // none only with `contents`
  std::shared_ptr<const SceneContents> contents;  // of a scene file; null: none
  DemOptions dem;

  std::optional<EyePlace> eye;    // none: a plan's is above the middle of the first DEM
  std::optional<Target> look_at;  // none: the centre of the first DEM
  std::optional<double> heading_deg;
  std::optional<double> pitch_deg;
  std::optional<double> roll_deg;
  std::optional<double> fov_deg;
  std::optional<double> width_m;
  std::optional<glm::ivec2> size_px;
  std::optional<Projection> projection;
  bool plan = false;                     // instead of a projection
  std::optional<glm::dvec2> resolution;  // of a plan, in units of the DEM's coordinates
  bool plan_alpha = false;               // of a plan, even where it has no gaps
  std::optional<glm::dvec2> shift;
  std::optional<PixelRect> crop;
  std::string preset;
  std::optional<double> dpi;  // for paper; a preset's size in pixels follows from it
  std::optional<EarthModel> earth;
  std::optional<double> refraction;
  std::optional<double> z_scale;
  std::string from_camera;

  SurfaceModel surface = SurfaceModel::hyperboloid;
  Coherence coherence = Coherence::on;
  NormalKind normals = NormalKind::smooth;
  LightOptions light;
  AirOptions air;
  ViewSkyOptions sky;
  ObjectOptions objects;
  LabelOptions labels;
  WirelineOptions wireline;
  SamplingOptions sampling;
  std::string colors;
  NaturalOptions natural;
  std::string drape;
  double contour_interval_m = 0;  // 0 = no contour lines
  WaterOptions water;
  int threads = 0;

  PaletteOptions palette;
  std::string output;
  std::string format;
  std::map<std::string, std::string> creation;
  bool overwrite = false;
  std::string layers;
  std::string stats;
  std::string camera;
  std::string progressive;
  bool quiet = false;
  bool progress = false;
  bool prints_scene = false;  // instead of a picture
};

// Adds the options that say how DEMs are read: shared by the commands that read any.
void add_dem_options(CommandLine& app, std::vector<std::string>& dems, DemOptions& options);

void add_view_options(CommandLine& app, ViewOptions& options);

}  // namespace terrview
