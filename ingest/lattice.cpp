#include "ingest/lattice.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include <glm/matrix.hpp>

namespace terrview {
namespace {

// Posts [first, last] of a lattice.
struct Box {
  glm::i64vec2 first;
  glm::i64vec2 last;

  [[nodiscard]] double posts() const {
    return static_cast<double>(last.x - first.x + 1) * static_cast<double>(last.y - first.y + 1);
  }
};

Box bounds(const Box& a, const Box& b) {
  return {{std::min(a.first.x, b.first.x), std::min(a.first.y, b.first.y)},
          {std::max(a.last.x, b.last.x), std::max(a.last.y, b.last.y)}};
}

// Whether cells lie between or within both: they share posts or are one step apart, along more than
// a corner.
bool touch(const Box& a, const Box& b) {
  const auto common_x = std::min(a.last.x, b.last.x) - std::max(a.first.x, b.first.x);
  const auto common_y = std::min(a.last.y, b.last.y) - std::max(a.first.y, b.first.y);
  return common_x >= -1 && common_y >= -1 && (common_x >= 1 || common_y >= 1);
}

// Where a tile of `anchor`'s lattice lies on it, in posts of `anchor`; nullopt if it is of another.
std::optional<glm::i64vec2> offset_on_lattice(const LatticeTile& anchor, const LatticeTile& tile,
                                              double shift_x) {
  const glm::dmat2 to_posts = glm::inverse(anchor.placement.step);
  const glm::dvec2 shift{shift_x, 0};
  const glm::dvec2 offset = to_posts * (tile.placement.origin + shift - anchor.placement.origin);
  constexpr double kFar_posts = 1e9;
  if (!(std::abs(offset.x) < kFar_posts && std::abs(offset.y) < kFar_posts)) return std::nullopt;
  const glm::dvec2 whole = glm::round(offset);
  for (const int row : {0, tile.rows - 1}) {
    for (const int column : {0, tile.columns - 1}) {
      const glm::dvec2 corner{column, row};
      const glm::dvec2 off =
          to_posts * (tile.placement.at(corner) + shift - anchor.placement.at(whole + corner));
      if (!(std::abs(off.x) <= kLatticeTolerance_posts &&
            std::abs(off.y) <= kLatticeTolerance_posts)) {
        return std::nullopt;
      }
    }
  }
  return glm::i64vec2(whole);
}

struct Group {
  struct Member {
    int tile;
    glm::i64vec2 first;  // on the lattice of the group's anchor
  };
  int anchor;  // tile
  std::vector<Member> members;
  Box box;
  double posts = 0;  // of all members
  bool stopped_by_waste = false;
};

Group alone(const LatticeTile& tile, int index) {
  const Box box{{0, 0}, {tile.columns - 1, tile.rows - 1}};
  return {index, {{index, {0, 0}}}, box, box.posts()};
}

// The box of `other` on the lattice of `group` where the two touch, trying the same place a turn of
// the Earth to the east and west.
std::optional<glm::i64vec2> find_touch(const std::vector<LatticeTile>& tiles, const Group& group,
                                       const Group& other) {
  const LatticeTile& anchor = tiles[static_cast<std::size_t>(group.anchor)];
  const LatticeTile& tile = tiles[static_cast<std::size_t>(other.anchor)];
  if (anchor.crs != tile.crs) return std::nullopt;
  for (const double turn : {0.0, 360.0, -360.0}) {
    if (turn != 0 && !anchor.geographic) break;
    const auto offset = offset_on_lattice(anchor, tile, turn);
    if (offset && touch(group.box, {other.box.first + *offset, other.box.last + *offset})) {
      return offset;
    }
  }
  return std::nullopt;
}

// Joins `other` to `group` if they touch on one lattice and little is wasted.
bool try_join(const std::vector<LatticeTile>& tiles, Group& group, Group& other) {
  const auto offset = find_touch(tiles, group, other);
  if (!offset) return false;
  const Box box = bounds(group.box, {other.box.first + *offset, other.box.last + *offset});
  constexpr auto kMost = std::numeric_limits<int>::max();
  if (box.posts() > kMostWaste * (group.posts + other.posts) || box.last.x - box.first.x >= kMost ||
      box.last.y - box.first.y >= kMost) {
    group.stopped_by_waste = other.stopped_by_waste = true;
    return false;
  }
  for (const Group::Member& member : other.members) {
    group.members.push_back({member.tile, member.first + *offset});
  }
  group.box = box;
  group.posts += other.posts;
  return true;
}

// One pass over all pairs. Returns whether any were joined.
bool join_pairs(const std::vector<LatticeTile>& tiles, std::vector<Group>& groups) {
  bool joined = false;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (std::size_t j = i + 1; j < groups.size();) {
      if (try_join(tiles, groups[i], groups[j])) {
        groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(j));
        joined = true;
      } else {
        ++j;
      }
    }
  }
  return joined;
}

Mosaic to_mosaic(const std::vector<LatticeTile>& tiles, Group group) {
  std::sort(group.members.begin(), group.members.end(),
            [](const auto& a, const auto& b) { return a.tile < b.tile; });
  const PostPlacement& anchor = tiles[static_cast<std::size_t>(group.anchor)].placement;
  Mosaic mosaic;
  for (const Group::Member& member : group.members) {
    mosaic.parts.push_back({member.tile, glm::ivec2(member.first - group.box.first)});
  }
  mosaic.columns = static_cast<int>(group.box.last.x - group.box.first.x + 1);
  mosaic.rows = static_cast<int>(group.box.last.y - group.box.first.y + 1);
  mosaic.placement = {anchor.at(glm::dvec2(group.box.first)), anchor.step};
  mosaic.stopped_by_waste = group.stopped_by_waste;
  return mosaic;
}

}  // namespace

std::vector<Mosaic> join_tiles(const std::vector<LatticeTile>& tiles) {
  std::vector<Group> groups;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    groups.push_back(alone(tiles[i], static_cast<int>(i)));
  }
  while (join_pairs(tiles, groups)) {
  }
  std::vector<Mosaic> mosaics;
  for (Group& group : groups) mosaics.push_back(to_mosaic(tiles, std::move(group)));
  return mosaics;
}

}  // namespace terrview
