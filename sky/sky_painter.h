// The whole sky of a picture: clear sky, sun, halo, clouds.
//
// Clouds are the field's values through a colour table. Up to its `clear_until` the table shows the
// clear sky, and there alone the sun's disc and its halo, which falls with the square of the
// distance, act (Coquillart 1984, chapter 4, 3.3.4). Clouds take the table's colour, in the light
// of the sun and of the sky: brighter where the field falls off towards the sun, and where they are
// thin and near it. With the distance they melt into the clear sky behind them.
#pragma once

#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "sky/clear_sky.h"
#include "sky/cloud_painter.h"
#include "sky/color_table.h"

namespace terrview {

struct Clouds {
  FieldOptions field;
  CloudLayer layer;
  ColorTable table;
  // Of the air before them: 0.4 of what a visibility of 60 km is on the ground, for it is thinner.
  double extinction_per_m = 2.6e-5;
};

struct SkyOptions {
  ClearSkyOptions clear;
  std::optional<Clouds> clouds;
  double sun_radius_rad = 0.004652;  // 0 hides the disc
  double halo = 0.5;                 // brightness beside the disc; 0 = none
  double leaf_px = 1;                // see CloudPainter
};

class SkyPainter {
 public:
  SkyPainter(SkyOptions options, const SkyCamera& camera);
  SkyPainter(const SkyPainter&) = delete;
  SkyPainter& operator=(const SkyPainter&) = delete;

  // Linear Rec. 709 of the wanted pixels of a window, row by row; black elsewhere. Windows as
  // CloudPainter's; any order, any thread.
  [[nodiscard]] std::vector<glm::vec3> paint(const PixelWindow& window) const;

  // One pixel by itself: the same, bit for bit.
  [[nodiscard]] glm::vec3 color(const glm::ivec2& pixel) const;

  // Between clouds: what a direction of unit length shows.
  [[nodiscard]] glm::vec3 clear_color(const glm::dvec3& direction) const;

  // The same without the sun and its halo: the clear sky's colour, greyer the more clouds there
  // are, for the light between them is theirs too.
  [[nodiscard]] glm::vec3 background(const glm::dvec3& direction) const;

 private:
  // `density` is the field's sample at the pixel, `towards_sun` one some way towards the sun.
  [[nodiscard]] glm::vec3 composed(const glm::ivec2& pixel, const CloudSample& density,
                                   const CloudSample& towards_sun) const;
  [[nodiscard]] glm::vec3 sun_and_halo(double angle_rad) const;
  [[nodiscard]] glm::vec3 cloud_color(float address, float lit, double angle_to_sun_rad,
                                      float cover) const;

  SkyOptions options_;
  SkyCamera camera_;
  ClearSky clear_;
  glm::vec3 sunlight_;
  glm::vec3 skylight_;
  float pixel_rad_;
  // With clouds only.
  std::optional<RandomField> field_;
  std::optional<CloudPainter> density_;
  std::optional<CloudPainter> sunward_;
  std::optional<BakedTable> colors_;
  float addresses_per_unit_ = 0;
  float veil_ = 0;  // the share of grey in the background
};

}  // namespace terrview
