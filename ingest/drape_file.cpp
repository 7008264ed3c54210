#include "ingest/drape_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <gdal_priv.h>
#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include "ingest/dem_crs.h"
#include "ingest/memory_limit.h"
#include "ingest/picture_source.h"
#include "ingest/pixel_map.h"
#include "terrain/error.h"

namespace terrview {
namespace {

using Maps = std::vector<std::shared_ptr<const PixelMap>>;

PicturePlace place_of(const std::string& path, const PictureSource& source) {
  GDALDataset& dataset = source.dataset();
  std::array<double, 6> t{};
  if (dataset.GetGeoTransform(t.data()) != CE_None)
    throw InputError("--drape '" + path +
                     "': says not where it lies: give it a place with gdal_translate -a_ullr, or "
                     "run gdalwarp on it");
  PicturePlace place;
  place.name = path;
  place.corners = {{t[0], t[3]}, {t[1], t[4], t[2], t[5]}};
  const double area = glm::determinant(place.corners.step);
  if (!std::isfinite(area + t[0] + t[3]) || area == 0)
    throw InputError("--drape '" + path +
                     "': its geotransform places all pixels on one line or nowhere: mend it with "
                     "gdal_translate -a_ullr");
  place.size_px = source.size_px();
  const OGRSpatialReference* crs = dataset.GetSpatialRef();
  if (crs != nullptr && crs->IsLocal() == 0)
    place.crs_wkt = split_crs(*crs, "--drape '" + path + "'").wkt;
  return place;
}

// Columns and rows of the picture, the last ones excluded.
struct PixelWindow {
  glm::ivec2 first;
  glm::ivec2 end;

  [[nodiscard]] glm::ivec2 size() const { return end - first; }
  [[nodiscard]] bool empty() const { return size().x <= 0 || size().y <= 0; }
};

// Every pixel that is under one of the DEMs, and what is around to filter it with.
PixelWindow window_under(const std::vector<Dem>& dems, const Maps& maps, glm::ivec2 size_px) {
  constexpr int kSteps = 32;
  constexpr double kMargin_px = 16;
  glm::dvec2 least(std::numeric_limits<double>::infinity());
  glm::dvec2 most(-least);
  for (std::size_t i = 0; i < dems.size(); ++i) {
    const glm::dvec2 last_post(dems[i].grid->columns - 1, dems[i].grid->rows - 1);
    for (int row = 0; row <= kSteps; ++row) {
      for (int column = 0; column <= kSteps; ++column) {
        const glm::dvec2 at =
            maps[i]->to_pixels(last_post * glm::dvec2(column, row) / static_cast<double>(kSteps));
        if (std::isnan(at.x)) continue;
        least = glm::min(least, at);
        most = glm::max(most, at);
      }
    }
  }
  if (!(least.x <= most.x)) return {{0, 0}, {0, 0}};
  const glm::dvec2 margin = kMargin_px + (most - least) / static_cast<double>(kSteps);
  const glm::dvec2 size(size_px);
  return {glm::ivec2(glm::clamp(glm::floor(least - margin), glm::dvec2(0), size)),
          glm::ivec2(glm::clamp(glm::ceil(most + margin), glm::dvec2(0), size))};
}

void check_memory(const std::string& path, const PictureSource& source, glm::ivec2 size_px,
                  std::size_t memory_bytes) {
  const double limit = memory_limit_bytes(memory_bytes);
  constexpr double kPixel_bytes = 4 * 4 / 3.0;  // and its halves
  constexpr double kReading_bytes = 6;
  const double needed =
      kPixel_bytes * size_px.x * size_px.y +
      kReading_bytes * static_cast<double>(source.size_px().x) * source.lines_at_once();
  if (needed > limit)
    throw InputError("--drape '" + path + "': its " + std::to_string(size_px.x) + " x " +
                     std::to_string(size_px.y) + " pixels need " + mebibytes(needed) +
                     " of memory, more than the limit of " + mebibytes(limit) +
                     ": make it smaller with gdal_translate -outsize 50% 0 -r average, or raise "
                     "--memory");
}

Raster<glm::u8vec4> read_window(const PictureSource& source, const PixelWindow& window) {
  Raster<glm::u8vec4> picture(window.size().x, window.size().y);
  std::vector<glm::u8vec3> colors;
  std::vector<std::uint8_t> valid;
  const int width_px = source.size_px().x;
  for (int first = window.first.y; first < window.end.y; first += source.lines_at_once()) {
    const int lines = std::min(source.lines_at_once(), window.end.y - first);
    source.read(first, lines, colors, valid);
    for (int line = 0; line < lines; ++line) {
      for (int column = window.first.x; column < window.end.x; ++column) {
        const auto at = static_cast<std::size_t>(line) * static_cast<std::size_t>(width_px) +
                        static_cast<std::size_t>(column);
        picture.at(column - window.first.x, first + line - window.first.y) =
            glm::u8vec4(colors[at], valid.empty() ? 255 : valid[at]);
      }
    }
  }
  return picture;
}

}  // namespace

std::shared_ptr<const Drape> read_drape(const std::string& path, const std::vector<Dem>& dems,
                                        std::size_t memory_bytes) {
  const PictureSource source(path);
  PicturePlace place = place_of(path, source);
  const auto maps = [&] {
    Maps all;
    for (const Dem& dem : dems) all.push_back(map_to_picture(dem, place));
    return all;
  };
  const PixelWindow window = window_under(dems, maps(), place.size_px);
  if (window.empty())
    throw InputError("--drape '" + path +
                     "': does not lie on the ground of the DEM: check its coordinate system and "
                     "its place with gdalinfo");
  check_memory(path, source, window.size(), memory_bytes);
  Raster<glm::u8vec4> picture = read_window(source, window);
  place.corners.origin = place.corners.at(window.first);
  place.size_px = window.size();
  return std::make_shared<Drape>(PicturePyramid(std::move(picture)), maps());
}

}  // namespace terrview
