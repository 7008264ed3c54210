#include "ingest/pixel_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "ingest/crs_transform.h"
#include "ingest/dem_crs.h"
#include "ingest/ground_patch.h"
#include "terrain/error.h"

namespace terrview {
namespace {

constexpr int kMostSquares = 64;  // along a side

class AffinePixelMap final : public PixelMap {
 public:
  AffinePixelMap(const PostPlacement& posts, const PostPlacement& corners)
      : jacobian_(glm::inverse(corners.step) * posts.step),
        first_px_(corners.posts(posts.origin)) {}

  [[nodiscard]] glm::dvec2 to_pixels(glm::dvec2 uv) const override {
    return first_px_ + jacobian_ * uv;
  }
  [[nodiscard]] glm::dmat2 jacobian(glm::dvec2 /*uv*/) const override { return jacobian_; }

 private:
  glm::dmat2 jacobian_;
  glm::dvec2 first_px_;
};

// By PROJ, post by post.
class ExactPixelMap {
 public:
  ExactPixelMap(const Dem& dem, const PicturePlace& picture)
      : posts_(dem.placement),
        corners_(picture.corners),
        same_(same_crs(dem.crs_wkt, picture.crs_wkt)),
        middle_uv_(0.5 * (dem.grid->columns - 1), 0.5 * (dem.grid->rows - 1)) {
    if (picture.crs_wkt.empty()) return;
    const glm::dvec2 last_post = 2.0 * middle_uv_;
    const glm::dvec2 last_px(picture.size_px);
    from_.emplace(dem.name, dem.crs_wkt, over(posts_, last_post));
    to_.emplace(picture.name, picture.crs_wkt, over(corners_, last_px));
    turn_ = to_->turn();
    glm::dvec2 middle = posts_.at(middle_uv_);
    convert({&middle, 1});
    middle_x_ = near(middle.x, corners_.at(0.5 * last_px).x);
    turns_ = middle_x_ - middle.x;
  }

  [[nodiscard]] bool is_affine() const { return same_; }
  [[nodiscard]] AffinePixelMap affine() const {
    PostPlacement posts = posts_;
    posts.origin.x += turns_;
    return {posts, corners_};
  }

  // From grid coordinates, in place.
  void to_pixels(std::span<glm::dvec2> points) const {
    for (glm::dvec2& point : points) point = posts_.at(point);
    convert(points);
    for (glm::dvec2& point : points) {
      point.x = near(point.x, middle_x_);
      point = corners_.posts(point);
    }
  }

 private:
  static std::array<glm::dvec2, 5> over(const PostPlacement& placement, glm::dvec2 last) {
    return {placement.at({0, 0}), placement.at({last.x, 0}), placement.at({0, last.y}),
            placement.at(last), placement.at(0.5 * last)};
  }

  void convert(std::span<glm::dvec2> points) const {
    if (same_) return;
    from_->to_geographic(points);
    to_->from_geographic(points);
  }

  // The x of the same meridian next to `other_x`.
  [[nodiscard]] double near(double x, double other_x) const {
    return turn_ ? x - *turn_ * std::round((x - other_x) / *turn_) : x;
  }

  PostPlacement posts_;
  PostPlacement corners_;
  bool same_;
  glm::dvec2 middle_uv_;
  std::optional<CrsTransform> from_;
  std::optional<CrsTransform> to_;
  std::optional<double> turn_;
  double middle_x_ = 0;
  double turns_ = 0;
};

// Patches over squares of a grid; NaN where one has a post that the picture has no place for.
class PatchedPixelMap final : public PixelMap {
 public:
  // `squares` of them along the longer side.
  PatchedPixelMap(const ExactPixelMap& exact, glm::dvec2 last_post, int squares)
      : side_(std::max(last_post.x, last_post.y) / squares), size_(glm::ceil(last_post / side_)) {
    for (int row = 0; row < size_.y; ++row) {
      for (int column = 0; column < size_.x; ++column) {
        const GroundSquare square{side_ * (glm::dvec2(column, row) + 0.5), 0.5 * side_};
        GroundPatch::Nodes nodes = GroundPatch::nodes(square);
        exact.to_pixels(nodes);
        patches_.emplace_back(square, nodes);
      }
    }
  }

  [[nodiscard]] glm::dvec2 to_pixels(glm::dvec2 uv) const override { return patch(uv).at(uv); }
  [[nodiscard]] glm::dmat2 jacobian(glm::dvec2 uv) const override { return patch(uv).jacobian(uv); }

  // In pixels, of what `exact` defines: infinite where only `exact` is defined.
  [[nodiscard]] double error_px(const ExactPixelMap& exact) const {
    double worst_px = 0;
    for (const GroundPatch& patch : patches_) {
      std::vector<glm::dvec2> points;
      for (const double x : kChecked)
        for (const double y : kChecked) points.push_back(patch.square().at({x, y}));
      std::vector<glm::dvec2> expected = points;
      exact.to_pixels(expected);
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (std::isnan(expected[i].x)) continue;
        const double error_px = glm::distance(patch.at(points[i]), expected[i]);
        worst_px = std::max(worst_px, std::isnan(error_px) ? kNever : error_px);
      }
    }
    return worst_px;
  }

 private:
  static constexpr std::array kChecked{-1.0, -0.4, 0.1, 0.6, 1.0};
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  [[nodiscard]] const GroundPatch& patch(glm::dvec2 uv) const {
    const glm::ivec2 at = glm::clamp(glm::ivec2(uv / side_), glm::ivec2(0), size_ - 1);
    return patches_[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(size_.x) +
                    static_cast<std::size_t>(at.x)];
  }

  double side_;
  glm::ivec2 size_;
  std::vector<GroundPatch> patches_;
};

void check_systems(const Dem& dem, const PicturePlace& picture) {
  if (dem.crs_wkt.empty() == picture.crs_wkt.empty()) return;
  if (picture.crs_wkt.empty())
    throw InputError("--drape '" + picture.name +
                     "': has no coordinate system, but the DEM has: give it one with "
                     "gdal_translate -a_srs EPSG:CODE");
  throw InputError("--drape '" + picture.name + "': has a coordinate system, but '" + dem.name +
                   "' has none: give that one with --a-srs EPSG:CODE");
}

}  // namespace

std::shared_ptr<const PixelMap> map_to_picture(const Dem& dem, const PicturePlace& picture) {
  check_systems(dem, picture);
  const ExactPixelMap exact(dem, picture);
  if (exact.is_affine()) return std::make_shared<AffinePixelMap>(exact.affine());
  const glm::dvec2 last_post(dem.grid->columns - 1, dem.grid->rows - 1);
  for (int squares = 1; squares <= kMostSquares; squares *= 2) {
    auto map = std::make_shared<PatchedPixelMap>(exact, last_post, squares);
    if (map->error_px(exact) <= kMapError_px) return map;
  }
  throw InputError("--drape '" + picture.name + "': its coordinates are too sharply bent over '" +
                   dem.name + "': warp it with gdalwarp to that DEM's system");
}

}  // namespace terrview
