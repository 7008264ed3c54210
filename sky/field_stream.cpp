#include "sky/field_stream.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

namespace terrview {
namespace {

using Id = std::uint32_t;

// Things that come and go, by number.
template <class Thing>
class Pool {
 public:
  Id add(const Thing& thing) {
    ++live_;
    most_ = std::max(most_, live_);
    if (free_.empty()) {
      things_.push_back(thing);
      return static_cast<Id>(things_.size() - 1);
    }
    const Id id = free_.back();
    free_.pop_back();
    things_[id] = thing;
    return id;
  }
  void remove(Id id) {
    --live_;
    free_.push_back(id);
  }
  [[nodiscard]] Thing& operator[](Id id) { return things_[id]; }
  [[nodiscard]] std::size_t most() const { return most_; }

 private:
  std::vector<Thing> things_;
  std::vector<Id> free_;
  std::size_t live_ = 0;
  std::size_t most_ = 0;
};

// Two vertices, or, once divided, two edges: the western or southern one first.
struct Edge {
  bool divided;
  Id first;
  Id second;
};

// The edges around a region.
struct Region {
  Id west;
  Id south;
  Id north;
  Id east;
};

class Stream {
 public:
  Stream(const RandomField& field, const std::function<void(const FieldCorners&)>& take)
      : field_(field), take_(take) {}

  StreamCounts run(const glm::i64vec2& root_cell) {
    std::array<Id, 4> corner{};
    for (std::size_t k = 0; k < 4; ++k) {
      const std::int64_t column = root_cell.x + static_cast<std::int64_t>(k & 1);
      const std::int64_t row = root_cell.y + static_cast<std::int64_t>(k >> 1);
      const glm::ivec2 levels = field_.options().levels;
      corner[k] =
          vertices_.add({column * (std::int64_t{1} << levels.x),
                         row * (std::int64_t{1} << levels.y), field_.root_value(column, row)});
    }
    const Region root{
        edges_.add({false, corner[0], corner[2]}), edges_.add({false, corner[0], corner[1]}),
        edges_.add({false, corner[2], corner[3]}), edges_.add({false, corner[1], corner[3]})};
    process(0, root);
    return {vertices_.most(), edges_.most()};
  }

 private:
  void process(int level, const Region& region) {
    const glm::ivec2 levels = field_.options().levels;
    if (level == field_.levels()) {
      hand_over(region);
    } else if (level >= levels.y) {
      divide_columns(level + 1, region);
    } else if (level >= levels.x) {
      divide_rows(level + 1, region);
    } else {
      divide_in_four(level + 1, region);
    }
  }

  // Of the cells around a vertex the north-eastern one comes last, and there the vertex is the
  // south-western corner.
  void hand_over(const Region& region) {
    const Id south_west = edges_[region.west].first;
    take_({vertices_[south_west], vertices_[edges_[region.south].second],
           vertices_[edges_[region.west].second], vertices_[edges_[region.east].second]});
    vertices_.remove(south_west);
  }

  void divide_in_four(int level, const Region& region) {
    const Id upright = divide_region(level, region.south, region.north);
    const Id level_edge = divide_region(level, region.west, region.east);
    make_center(level, upright, level_edge);
    const Edge west = edges_[region.west];
    const Edge south = edges_[region.south];
    const Edge north = edges_[region.north];
    const Edge east = edges_[region.east];
    const Edge up = edges_[upright];
    const Edge across = edges_[level_edge];
    process(level, {west.first, south.first, across.first, up.first});
    drop(west.first, south.first);
    process(level, {up.first, south.second, across.second, east.first});
    drop(up.first, south.second);
    process(level, {west.second, across.first, north.first, up.second});
    drop(west.second, across.first);
    process(level, {up.second, across.second, north.second, east.second});
    drop(up.second, across.second);
    drop(upright, level_edge);
  }

  // West and east of a new edge.
  void divide_columns(int level, const Region& region) {
    const Id upright = divide_region(level, region.south, region.north);
    const Edge south = edges_[region.south];
    const Edge north = edges_[region.north];
    process(level, {region.west, south.first, north.first, upright});
    edges_.remove(south.first);
    process(level, {upright, south.second, north.second, region.east});
    drop(upright, south.second);
  }

  // South and north of a new edge.
  void divide_rows(int level, const Region& region) {
    const Id across = divide_region(level, region.west, region.east);
    const Edge west = edges_[region.west];
    const Edge east = edges_[region.east];
    process(level, {west.first, region.south, across, east.first});
    edges_.remove(west.first);
    process(level, {west.second, across, region.north, east.second});
    drop(across, west.second);
  }

  void drop(Id first, Id second) {
    edges_.remove(first);
    edges_.remove(second);
  }

  // The edge between the middles of two opposite ones.
  Id divide_region(int level, Id first, Id second) {
    divide_edge(level, first);
    divide_edge(level, second);
    return edges_.add({false, middle(first), middle(second)});
  }

  // The vertex in the middle of a divided edge, whose halves may be divided themselves.
  Id middle(Id edge) {
    Edge half = edges_[edges_[edge].first];
    while (half.divided) half = edges_[half.second];
    return half.second;
  }

  void divide_edge(int level, Id edge) {
    const Edge whole = edges_[edge];
    if (whole.divided) return;
    FieldVertex vertex = between(whole);
    vertex.value = mean(vertices_[whole.first].value, vertices_[whole.second].value) +
                   field_.deviation(level) * field_.random().first(bits(level, vertex));
    split(edge, vertices_.add(vertex));
  }

  // The mean of two draws is made before its vertex: making a vertex for each, as the thesis's
  // procedure does, would have one more alive than its formula says.
  void make_center(int level, Id upright, Id across) {
    const Edge along = edges_[upright];
    const Edge beside = edges_[across];
    FieldVertex vertex = between(along);
    const std::uint64_t two = bits(level, vertex);
    const float deviation = field_.deviation(level);
    const float from_sides = mean(vertices_[beside.first].value, vertices_[beside.second].value) +
                             deviation * field_.random().first(two);
    const float from_ends = mean(vertices_[along.first].value, vertices_[along.second].value) +
                            deviation * field_.random().second(two);
    vertex.value = mean(from_sides, from_ends);
    const Id center = vertices_.add(vertex);
    split(upright, center);
    split(across, center);
  }

  void split(Id edge, Id vertex) {
    const Edge whole = edges_[edge];
    const Id first = edges_.add({false, whole.first, vertex});
    const Id second = edges_.add({false, vertex, whole.second});
    edges_[edge] = {true, first, second};
  }

  [[nodiscard]] FieldVertex between(const Edge& edge) {
    const FieldVertex& a = vertices_[edge.first];
    const FieldVertex& b = vertices_[edge.second];
    return {(a.column + b.column) >> 1, (a.row + b.row) >> 1, 0};
  }

  // The key of a vertex counts in vertices of its own level.
  [[nodiscard]] std::uint64_t bits(int level, const FieldVertex& vertex) const {
    const glm::ivec2 left = field_.options().levels - field_.divisions(level);
    return KeyedRandom::bits(field_.random().row_key(level, vertex.row >> left.y),
                             vertex.column >> left.x);
  }

  const RandomField& field_;
  const std::function<void(const FieldCorners&)>& take_;
  Pool<FieldVertex> vertices_;
  Pool<Edge> edges_;
};

}  // namespace

StreamCounts stream_root_cell(const RandomField& field, const glm::i64vec2& root_cell,
                              const std::function<void(const FieldCorners&)>& take) {
  assert(field.options().kind == FieldKind::midpoint);
  return Stream(field, take).run(root_cell);
}

}  // namespace terrview
