// A polygon with holes as rays see it from above.
//
// Inside is what a line from far away reaches over an odd number of edges, so rings may be wound
// either way, and touch or cross themselves and each other.
//
// Watertight: an edge is crossed where the signs of its two ends differ, and the sign of a vertex
// is computed once for all edges that meet there, those of other polygons included.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace terrview {

class Polygon {
 public:
  using Ring = std::vector<glm::dvec2>;

  // Rings may repeat their first point at the end.
  explicit Polygon(std::span<const Ring> rings);

  // Where a line crosses an edge: at origin + t * direction.
  struct Crossing {
    double t;
    std::size_t edge;
  };
  using Crossings = std::pmr::vector<Crossing>;

  // Fills in the crossings of a line, by growing t: an even number. Takes a time that grows with
  // their number and the logarithm of that of the edges.
  void cross(glm::dvec2 origin, glm::dvec2 direction, Crossings& crossings) const;

  [[nodiscard]] bool contains(glm::dvec2 point) const;

  // Whether an edge begins at that vertex: none does at the last of a ring.
  [[nodiscard]] bool is_edge(std::size_t vertex) const;

  // From one end of the edge to the other.
  [[nodiscard]] glm::dvec2 edge(std::size_t edge) const {
    return vertices_[edge + 1] - vertices_[edge];
  }

  // All rings', each ring's first also at its end.
  [[nodiscard]] std::span<const glm::dvec2> vertices() const { return vertices_; }
  [[nodiscard]] glm::dvec2 lowest() const { return lowest_; }
  [[nodiscard]] glm::dvec2 highest() const { return highest_; }

  // Of the first ring less the others, however they are wound.
  [[nodiscard]] double area() const;

 private:
  struct Rectangle {
    glm::dvec2 lowest;
    glm::dvec2 highest;
  };
  struct Line;

  void group_edges();
  void cross_edges(const Line& line, std::size_t first, std::size_t last,
                   Crossings& crossings) const;
  void cross_group(const Line& line, std::size_t level, std::size_t group,
                   Crossings& crossings) const;

  std::vector<glm::dvec2> vertices_;
  std::vector<std::size_t> ring_ends_;  // index of each ring's last vertex
  // groups_[k] bounds runs of kGroup^(k + 1) edges.
  std::vector<std::vector<Rectangle>> groups_;
  glm::dvec2 lowest_;
  glm::dvec2 highest_;
};

}  // namespace terrview
