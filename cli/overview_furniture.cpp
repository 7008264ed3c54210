#include "cli/overview_furniture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "cli/overview_ticks.h"
#include "ingest/crs_transform.h"
#include "render/map_ink.h"

namespace terrview {
namespace {

constexpr int kMostTicks = 6;
constexpr double kTick = 0.6;  // of a letter
const glm::vec3 kInk(0.02F);

// How the first DEM's coordinates are told.
struct Grid {
  Coordinates coordinates;
  CoordinateKind kind;
  glm::dvec2 step;  // of a post

  Grid(const Dem& dem, TickSystem system) {
    const PostPlacement placement = dem.placement;
    const glm::dvec2 size = glm::dvec2(dem.grid->columns - 1, dem.grid->rows - 1);
    coordinates = [placement](glm::dvec2 uv) { return placement.at(uv); };
    kind = dem.crs_wkt.empty() ? CoordinateKind::plain : CoordinateKind::grid;
    if (!dem.crs_wkt.empty()) {
      const std::array<glm::dvec2, 3> area{placement.at(glm::dvec2(0)), placement.at(size / 2.0),
                                           placement.at(size)};
      const auto crs = std::make_shared<const CrsTransform>(dem.name, dem.crs_wkt, area);
      const bool geographic = crs->turn() && std::abs(*crs->turn() - 360) < 1e-6;
      if (geographic || system == TickSystem::degrees) kind = CoordinateKind::degrees;
      if (!geographic && system == TickSystem::degrees)
        coordinates = [placement, crs, middle = area[1]](glm::dvec2 uv) {
          std::array<glm::dvec2, 2> points{placement.at(uv), middle};
          crs->to_geographic(points);
          const double turns = std::round((points[1].x - points[0].x) / 360);
          return points[0] + glm::dvec2(360 * turns, 0);
        };
    }
    const glm::dvec2 here = coordinates(size / 2.0);
    step = glm::abs(coordinates(size / 2.0 + glm::dvec2(1)) - here);
  }
};

class Furniture {
 public:
  Furniture(const OverviewOptions& options, const std::vector<Dem>& dems, const BlockView& block,
            Image& image)
      : dem_(dems.front()),
        block_(block),
        image_(image),
        letter_px_(block.letter_px),
        font_(block.fonts->words),
        grid_(dem_, options.ticks) {
    const TerrainLayer& layer = block.view.scene.terrain->layers().front();
    below_eye_uv_ = layer.map->to_grid(glm::dvec2(0));
    to_ground_ = glm::inverse(*layer.map->linear());
  }

  void title(const std::string& text) const {
    ink_text({text, glm::dvec2(1.5, 1.2) * letter_px_}, block_.fonts->title, kInk, image_);
  }

  void sides() {
    const glm::dvec2 last(dem_.grid->columns - 1, dem_.grid->rows - 1);
    const std::array<glm::dvec2, 4> corners{glm::dvec2(0, 0), glm::dvec2(last.x, 0), last,
                                            glm::dvec2(0, last.y)};
    std::array<bool, 4> seen{};
    for (std::size_t i = 0; i < 4; ++i) seen[i] = faces_eye(corners[i], corners[(i + 1) % 4]);
    for (std::size_t i = 0; i < 4; ++i)
      if (seen[i] || seen[(i + 3) % 4]) corner(corners[i]);
    for (std::size_t i = 0; i < 4; ++i)
      if (seen[i]) side(corners[i], corners[(i + 1) % 4]);
  }

  void north_arrow() const {
    const Camera& camera = block_.view.camera;
    // East and north as the picture has them, not so foreshortened that they can't be read.
    constexpr double kFlattest = 0.35;
    const double steep = std::max(kFlattest, std::abs(camera.forward().z));
    const auto in_plan = [&](const glm::dvec3& towards) {
      const double down = -glm::dot(towards, camera.up()) / std::abs(camera.forward().z);
      return glm::dvec2(glm::dot(towards, camera.right()), steep * down);
    };
    const glm::dvec2 east = in_plan({1, 0, 0});
    const glm::dvec2 north = in_plan({0, 1, 0});
    const double size_px = 1.6 * letter_px_;
    const glm::dvec2 middle(image_.width_px() - 3.5 * letter_px_, 3 * letter_px_);
    const auto at = [&](double x, double y) { return middle + size_px * (x * east + y * north); };
    const std::array<glm::dvec2, 4> arrow{at(0, 1), at(0.5, -0.8), at(0, -0.45), at(-0.5, -0.8)};
    ink_polygon(arrow, kInk, image_);
    const glm::dvec2 letter = at(0, 1) + glm::normalize(north) * (0.8 * letter_px_);
    ink_text({"N", letter, glm::dvec2(0.5)}, font_, kInk, image_);
  }

  void scale() const {
    const double most_m = 0.22 * image_.width_px() * block_.m_per_px;
    const double length_m = round_length(most_m);
    const double length_px = length_m / block_.m_per_px;
    const glm::dvec2 start(1.5 * letter_px_, image_.height_px() - 1.8 * letter_px_);
    const double thick_px = 0.35 * letter_px_;
    constexpr int kParts = 4;
    ink_line(start, start + glm::dvec2(length_px, 0), thick_px, kInk, image_);
    for (int part = 1; part < kParts; part += 2)
      ink_line(start + glm::dvec2(length_px * part / kParts + 1, 0),
               start + glm::dvec2(length_px * (part + 1) / kParts - 1, 0), thick_px - 2,
               glm::vec3(1), image_);
    const bool kilometres = length_m >= 1000;
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%g %s", kilometres ? length_m / 1000 : length_m,
                  kilometres ? "km" : "m");
    ink_text({text.data(), start + glm::dvec2(length_px + 0.6 * letter_px_, 0), {0, 0.5}}, font_,
             kInk, image_);
    std::snprintf(text.data(), text.size(), "heights × %g", block_.z_scale);
    const glm::dvec2 end(image_.width_px() - 1.5 * letter_px_, start.y);
    ink_text({text.data(), end, {1, 0.5}}, font_, kInk, image_);
  }

 private:
  [[nodiscard]] glm::dvec3 at_plinth(glm::dvec2 uv) const {
    return {to_ground_ * (uv - below_eye_uv_), block_.plinth_z_m};
  }
  [[nodiscard]] glm::dvec2 in_picture(const glm::dvec3& point_m) const {
    return *block_.view.camera.project(point_m);
  }
  [[nodiscard]] glm::dvec3 middle() const {
    return at_plinth(glm::dvec2(dem_.grid->columns - 1, dem_.grid->rows - 1) / 2.0);
  }

  // Of the side between two corners, outward.
  [[nodiscard]] glm::dvec3 normal(glm::dvec2 from_uv, glm::dvec2 to_uv) const {
    const glm::dvec3 along = at_plinth(to_uv) - at_plinth(from_uv);
    const glm::dvec3 aside = glm::normalize(glm::dvec3(-along.y, along.x, 0));
    return glm::dot(aside, at_plinth(from_uv) - middle()) > 0 ? aside : -aside;
  }
  [[nodiscard]] bool faces_eye(glm::dvec2 from_uv, glm::dvec2 to_uv) const {
    constexpr double kEdgeOn = 1e-3;
    return glm::dot(normal(from_uv, to_uv), block_.view.camera.forward()) < -kEdgeOn;
  }

  // Text beyond a point, the way of `towards`, unless other words are there.
  void label(const std::vector<std::string>& lines, glm::dvec2 at_px, glm::dvec2 towards) {
    const glm::dvec2 anchor = 0.5 - 0.5 * glm::clamp(1.4 * towards, -1.0, 1.0);
    const double line_px = font_.ascent_px() + font_.descent_px();
    std::vector<InkText> texts;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const double down_px =
          (static_cast<double>(i) - anchor.y * static_cast<double>(lines.size() - 1)) * line_px;
      texts.push_back({lines[i], at_px + glm::dvec2(0, down_px), anchor});
    }
    for (const InkText& text : texts)
      if (!is_free(text_box(text, font_))) return;
    for (const InkText& text : texts) {
      ink_text(text, font_, kInk, image_);
      taken_.push_back(text_box(text, font_));
    }
  }

  [[nodiscard]] bool is_free(const PixelRect& box) const {
    const int apart_px = block_.letter_px / 2;
    return std::none_of(taken_.begin(), taken_.end(), [&](const PixelRect& other) {
      const glm::ivec2 low = glm::max(box.first_px, other.first_px);
      const glm::ivec2 high = glm::min(box.first_px + box.size_px, other.first_px + other.size_px);
      return low.x < high.x + apart_px && low.y < high.y;
    });
  }

  // Whether the words at a corner tell the place.
  [[nodiscard]] bool is_at_corner(glm::dvec2 at_px, glm::dvec2 corner_uv) const {
    return glm::distance(at_px, in_picture(at_plinth(corner_uv))) < letter_px_;
  }

  void corner(glm::dvec2 uv) {
    const glm::dvec2 xy = grid_.coordinates(uv);
    const auto text = [&](int axis) {
      return coordinate_text(grid_.kind, axis, xy[axis], grid_.step[axis]);
    };
    const glm::dvec2 at_px = in_picture(at_plinth(uv));
    const glm::dvec2 towards = glm::normalize(at_px - in_picture(middle()));
    label({text(1), text(0)}, at_px + towards * (1.0 * letter_px_), towards);
  }

  void side(glm::dvec2 from_uv, glm::dvec2 to_uv) {
    const Ticks ticks = ticks_along(from_uv, to_uv, grid_.coordinates, kMostTicks);
    const glm::dvec3 outward = normal(from_uv, to_uv) * block_.m_per_px;
    for (const Tick& tick : ticks.ticks) {
      const glm::dvec3 foot = at_plinth(tick.uv);
      const glm::dvec2 foot_px = in_picture(foot);
      if (is_at_corner(foot_px, from_uv) || is_at_corner(foot_px, to_uv)) continue;
      const glm::dvec2 towards = glm::normalize(in_picture(foot + outward) - foot_px);
      ink_line(foot_px, foot_px + towards * (kTick * letter_px_), 1.5, kInk, image_);
      label({coordinate_text(grid_.kind, ticks.axis, tick.value, ticks.step)},
            foot_px + towards * (letter_px_ * (kTick + 0.3)), towards);
    }
  }

  const Dem& dem_;
  const BlockView& block_;
  Image& image_;
  double letter_px_;
  const Font& font_;
  Grid grid_;
  glm::dvec2 below_eye_uv_{0, 0};
  glm::dmat2 to_ground_{1};
  std::vector<PixelRect> taken_;
};

std::string names_of(const std::vector<std::string>& paths) {
  constexpr std::size_t kMostNamed = 3;
  std::string names;
  for (std::size_t i = 0; i < std::min(paths.size(), kMostNamed); ++i)
    names += (i > 0 ? " + " : "") + std::filesystem::path(paths[i]).stem().string();
  if (paths.size() > kMostNamed)
    names += " and " + std::to_string(paths.size() - kMostNamed) + " more";
  return names;
}

}  // namespace

std::string block_title(const OverviewOptions& options) {
  return options.title.value_or(names_of(options.view.dems));
}

void draw_furniture(const OverviewOptions& options, const std::vector<Dem>& dems,
                    const BlockView& block, Image& image) {
  Furniture furniture(options, dems, block, image);
  furniture.title(block_title(options));
  furniture.sides();
  furniture.north_arrow();
  furniture.scale();
}

}  // namespace terrview
