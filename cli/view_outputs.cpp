#include "cli/view_outputs.h"

#include <sys/resource.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "cli/parse.h"
#include "ingest/layers_file.h"
#include "render/image_file.h"
#include "render/parallel.h"
#include "terrain/error.h"

namespace terrview {
namespace {

using Json = nlohmann::ordered_json;

std::string layers_extension(const std::string& path) {
  return lower_case(std::filesystem::path(path).extension().string());
}

bool is_hit(const PixelSample& sample) { return sample.object_id != PixelSample::kNothing; }

// Calls fill(sample, index) for every pixel that hit something.
template <class Fill>
void for_each_hit(const Raster<PixelSample>& samples, int threads, const Fill& fill) {
  parallel_for(samples.height_px(), threads, [&](int row) {
    for (int column = 0; column < samples.width_px(); ++column) {
      const PixelSample& sample = samples.at(column, row);
      const auto index =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(samples.width_px()) +
          static_cast<std::size_t>(column);
      if (is_hit(sample)) fill(sample, index);
    }
  });
}

void write_geotiff_layers(const std::string& path, const Raster<PixelSample>& samples,
                          const ViewFrame& frame, int threads, const std::string& camera_json) {
  const bool geographic = frame.is_geographic();
  const std::vector<double> nothing(samples.pixels().size(),
                                    std::numeric_limits<double>::quiet_NaN());
  std::vector<LayerBand> bands{{"distance_m", nothing},
                               {geographic ? "latitude" : "x", nothing},
                               {geographic ? "longitude" : "y", nothing},
                               {"height_m", nothing},
                               {"object_id", nothing}};
  const VerticalFrame& vertical = frame.terrain()->frame();
  for_each_hit(samples, threads, [&](const PixelSample& sample, std::size_t i) {
    const glm::dvec2 ground_m(sample.position_m);
    bands[0].values[i] = glm::length(frame.to_true_enu(sample.position_m));
    if (geographic) {
      const GeoPoint point = frame.from_ground(ground_m);
      bands[1].values[i] = point.latitude_deg;
      bands[2].values[i] = point.longitude_deg;
    } else {
      const glm::dvec2 point = frame.projected_from_ground(ground_m);
      bands[1].values[i] = point.x;
      bands[2].values[i] = point.y;
    }
    bands[3].values[i] =
        vertical.at(ground_m).scene_height_m(sample.position_m.z) / vertical.z_scale;
    bands[4].values[i] = sample.object_id;
  });
  write_layers(path, samples.width_px(), samples.height_px(), bands, camera_json);
}

// What the air does to every pixel, hit or not: colour = clear * q + air * (1 - q).
void add_air_channels(const Raster<PixelSample>& samples, std::vector<FloatChannel>& channels) {
  const auto add = [&](const char* name, const auto& value_of) {
    FloatChannel channel{name, {}};
    channel.values.reserve(samples.pixels().size());
    for (const PixelSample& sample : samples.pixels()) channel.values.push_back(value_of(sample));
    channels.push_back(std::move(channel));
  };
  add("clear.R", [](const PixelSample& s) { return s.clear.x; });
  add("clear.G", [](const PixelSample& s) { return s.clear.y; });
  add("clear.B", [](const PixelSample& s) { return s.clear.z; });
  add("air.R", [](const PixelSample& s) { return s.air.x; });
  add("air.G", [](const PixelSample& s) { return s.air.y; });
  add("air.B", [](const PixelSample& s) { return s.air.z; });
  add("q", [](const PixelSample& s) { return s.transmission; });
}

void write_exr_layers(const std::string& path, const Raster<PixelSample>& samples,
                      const ViewFrame& frame, int threads, const std::string& camera_json) {
  const std::vector<float> nothing(samples.pixels().size(),
                                   std::numeric_limits<float>::quiet_NaN());
  std::vector<FloatChannel> channels;
  for (const char* name : {"distance", "E", "N", "U", "normal.x", "normal.y", "normal.z", "id"})
    channels.push_back({name, nothing});
  for_each_hit(samples, threads, [&](const PixelSample& sample, std::size_t i) {
    const glm::dvec3 enu_m = frame.to_true_enu(sample.position_m);
    channels[0].values[i] = static_cast<float>(glm::length(enu_m));
    for (int axis = 0; axis < 3; ++axis) {
      channels[static_cast<std::size_t>(1 + axis)].values[i] = static_cast<float>(enu_m[axis]);
      channels[static_cast<std::size_t>(4 + axis)].values[i] = sample.normal[axis];
    }
    channels[7].values[i] = static_cast<float>(sample.object_id);
  });
  add_air_channels(samples, channels);
  write_exr(path, {samples.width_px(), samples.height_px()}, channels,
            {{"terrview:camera", camera_json}});
}

double peak_memory_mib() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

// The angle of one pixel in the middle of the picture, `reach_m` away if that matters.
double pixel_rad(const Camera& camera, double reach_m) {
  const bool parallel = camera.options().projection == Projection::orthographic;
  return parallel ? camera.per_px() / reach_m : camera.per_px();
}

Json eye_json(const ViewFrame::Eye& eye) {
  Json json;
  if (eye.geographic) {
    json["latitude"] = eye.geographic->latitude_deg;
    json["longitude"] = eye.geographic->longitude_deg;
  } else {
    json["x"] = eye.projected.x;
    json["y"] = eye.projected.y;
  }
  json["height_m"] = eye.height_m;
  json["ground_m"] = eye.ground_m ? Json(*eye.ground_m) : Json(nullptr);
  return json;
}

double per(std::int64_t count, std::int64_t rays) {
  return rays > 0 ? static_cast<double>(count) / static_cast<double>(rays) : 0;
}

}  // namespace

void check_layers_name(const std::string& path) {
  const std::string extension = layers_extension(path);
  if (!path.empty() && extension != ".tif" && extension != ".tiff" && extension != ".exr")
    throw InputError("--layers " + path + ": unknown extension: end the name in .tif or .exr");
}

void write_layers_file(const std::string& path, const Frame& frame, const ViewFrame& view_frame,
                       int threads, const std::string& camera_json) {
  (layers_extension(path) == ".exr" ? write_exr_layers : write_geotiff_layers)(
      path, frame.samples, view_frame, threads, camera_json);
}

Json stats_json(const Frame& frame, const ViewFrame& view_frame, const Camera& camera,
                const std::vector<Dem>& dems, const WorkSeconds& seconds) {
  const RenderCounts& counts = frame.counts;
  const double threads_s = counts.trace_s + counts.shade_s;
  const double trace_share = threads_s > 0 ? counts.trace_s / threads_s : 0;
  std::size_t filled = 0;
  std::size_t open = 0;
  for (const Dem& dem : dems) {
    filled += dem.voids_filled;
    open += dem.voids_open;
  }
  Json json;
  json["rays"] = counts.rays;
  json["hits"] = counts.hits;
  json["shadow_rays"] = counts.shadow_rays;
  json["tests_per_ray"] = per(counts.tests, counts.rays);
  json["nodes_per_ray"] = per(counts.nodes, counts.rays);
  json["seconds"] = {{"read", seconds.read},
                     {"build", seconds.build},
                     {"trace", seconds.render * trace_share},
                     {"shade", seconds.render * (1 - trace_share)},
                     {"write", seconds.write}};
  json["peak_memory_mib"] = peak_memory_mib();
  json["eye"] = eye_json(view_frame.eye());
  json["refraction_multiplier"] = 1 - view_frame.terrain()->frame().refraction;
  json["errors"] = {{"track_cells", view_frame.track_error_cells()},
                    {"pixel", view_frame.direction_error_rad() /
                                  pixel_rad(camera, view_frame.terrain()->reach_m())}};
  json["voids"] = {{"filled", filled}, {"open", open}};
  if (counts.objects.tests > 0 || counts.shadow_objects.tests > 0)
    json["objects"] = {
        {"tests_per_ray", per(counts.objects.tests, counts.rays)},
        {"steps_per_ray", per(counts.objects.steps, counts.rays)},
        {"tests_per_shadow_ray", per(counts.shadow_objects.tests, counts.shadow_rays)},
        {"steps_per_shadow_ray", per(counts.shadow_objects.steps, counts.shadow_rays)}};
  return json;
}

}  // namespace terrview
