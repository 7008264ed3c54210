#include "sky/image_cell.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace terrview {
namespace {

bool before_the_eye(const ImageCell& cell) {
  return std::min({cell[0].w, cell[1].w, cell[2].w, cell[3].w}) > 0;
}

glm::dvec2 pixel(const ImagePoint& point) {
  const double nearness = 1 / point.w;
  return {point.x * nearness, point.y * nearness};
}

}  // namespace

ImagePoint LayerImage::at(const glm::dvec2& place) const {
  const glm::dvec3 point_m = layer_.point_m(place);
  const double depth = glm::dot(point_m, camera_.forward);
  const glm::dvec2& middle_px = camera_.middle_px;
  return {camera_.focal_px * glm::dot(point_m, camera_.right) + middle_px.x * depth,
          -camera_.focal_px * glm::dot(point_m, camera_.up) + middle_px.y * depth, depth};
}

ImagePoint LayerImage::corner(int level, std::int64_t column, std::int64_t row) const {
  const auto cells = static_cast<double>(std::int64_t{1} << level);
  return at(glm::dvec2(column, row) / cells);
}

ImageCell root_image(const LayerImage& image, const CellPlace& at) {
  return {image.corner(at.level, at.column, at.row), image.corner(at.level, at.column + 1, at.row),
          image.corner(at.level, at.column, at.row + 1),
          image.corner(at.level, at.column + 1, at.row + 1)};
}

std::array<ImageCell, 4> divided_image(const LayerImage& image, const CellPlace& at,
                                       const ImageCell& cell) {
  if (!image.is_flat(at.level)) {
    std::array<ImageCell, 4> cells;
    for (int k = 0; k < 4; ++k) cells[static_cast<std::size_t>(k)] = root_image(image, at.child(k));
    return cells;
  }
  const auto& [sw, se, nw, ne] = cell;
  const ImagePoint s = harmonic_middle(sw, se);
  const ImagePoint n = harmonic_middle(nw, ne);
  const ImagePoint w = harmonic_middle(sw, nw);
  const ImagePoint e = harmonic_middle(se, ne);
  const ImagePoint center = harmonic_middle(w, e);
  return {ImageCell{sw, s, w, center}, ImageCell{s, se, center, e}, ImageCell{w, center, nw, n},
          ImageCell{center, e, n, ne}};
}

bool is_small(const ImageCell& cell, double leaf_px) {
  if (!before_the_eye(cell)) return false;
  const glm::dvec2 sw = pixel(cell[0]);
  const glm::dvec2 se = pixel(cell[1]);
  const glm::dvec2 nw = pixel(cell[2]);
  const glm::dvec2 ne = pixel(cell[3]);
  const glm::dvec2 rising = ne - sw;
  const glm::dvec2 falling = se - nw;
  const double area = 0.5 * (rising.x * falling.y - rising.y * falling.x);
  const auto squared = [](const glm::dvec2& edge) { return glm::dot(edge, edge); };
  const double longest =
      std::max({squared(se - sw), squared(ne - nw), squared(nw - sw), squared(ne - se)});
  return area * area < leaf_px * leaf_px * longest;
}

Within compare(const ImageCell& cell, const ImageWindow& window) {
  // Five half-spaces through the eye: in homogeneous coordinates they hold behind it too.
  std::array<int, 5> outside{};
  for (const ImagePoint& point : cell) {
    outside[0] += point.x < window.first.x * point.w ? 1 : 0;
    outside[1] += point.x > window.last.x * point.w ? 1 : 0;
    outside[2] += point.y < window.first.y * point.w ? 1 : 0;
    outside[3] += point.y > window.last.y * point.w ? 1 : 0;
    outside[4] += point.w <= 0 ? 1 : 0;
  }
  if (*std::max_element(outside.begin(), outside.end()) == 4) return Within::outside;
  for (const int count : outside) {
    if (count != 0) return Within::cut;
  }
  return Within::inside;
}

ImageWindow bounds(const ImageCell& cell) {
  const std::array<glm::dvec2, 4> corner{pixel(cell[0]), pixel(cell[1]), pixel(cell[2]),
                                         pixel(cell[3])};
  const auto [left, right] = std::minmax({corner[0].x, corner[1].x, corner[2].x, corner[3].x});
  const auto [top, bottom] = std::minmax({corner[0].y, corner[1].y, corner[2].y, corner[3].y});
  return {{left, top}, {right, bottom}};
}

}  // namespace terrview
