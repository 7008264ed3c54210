#include "tests/support/oracle.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace terrview::oracle {
namespace {

struct Uv {
  Real u, v;
};

// A place where the track crosses a line of the grid, or begins or ends.
struct Crossing {
  Real t;
  Uv uv;
  bool along_band = false;  // a line that counts where ground begins or ends, and nowhere else
};

// The track of a ray over one grid: a polyline.
struct Track {
  std::vector<Crossing> knots;

  [[nodiscard]] Uv at(Real t) const {
    std::size_t end = 1;
    while (end + 1 < knots.size() && knots[end].t < t) ++end;
    const Crossing& a = knots[end - 1];
    const Crossing& b = knots[end];
    const Real share = b.t > a.t ? (t - a.t) / (b.t - a.t) : 0;
    return {a.uv.u + (b.uv.u - a.uv.u) * share, a.uv.v + (b.uv.v - a.uv.v) * share};
  }
};

// A part of a ray, by the distance along it.
struct Part {
  Real from_t, to_t;
};

// A ray, its direction one metre long, and its line on the ground.
struct Line {
  explicit Line(const Ray& ray)
      : x(ray.origin_m.x), y(ray.origin_m.y), z(ray.origin_m.z), length(ray.length_m) {
    const Real norm = std::hypot(Real(ray.direction.x), ray.direction.y, ray.direction.z);
    dx = ray.direction.x / norm;
    dy = ray.direction.y / norm;
    dz = ray.direction.z / norm;
    run = std::hypot(dx, dy);
    ground.origin_m = {ray.origin_m.x, ray.origin_m.y};
    if (run > 0) ground.direction = {static_cast<double>(dx / run), static_cast<double>(dy / run)};
  }

  // As far as the ray may meet ground: to its end, or to where it leaves the disc of `reach_m`. A
  // vertical ray is a point of the ground at every t.
  [[nodiscard]] Part within(Real reach_m) const {
    if (run == 0) return {0, std::min(length, 4 * (std::fabs(z) + 1e31L))};
    const Real along = (x * dx + y * dy) / run;
    const Real chord2 = along * along + reach_m * reach_m - x * x - y * y;
    if (chord2 < 0) return {0, -1};
    return {0, std::min(length, (std::sqrt(chord2) - along) / run)};
  }

  Real x, y, z;
  Real dx, dy, dz;
  Real run;  // ground metres per metre
  Real length;
  GroundLine ground;
};

Crossing knot(const GroundMap& map, const Line& line, double g_m, Shift shift) {
  const glm::dvec2 uv = map.to_grid(line.ground.at(g_m));
  return {line.run > 0 ? g_m / line.run : 0, {uv.x + shift.u, uv.y + shift.v}};
}

Track track_of(const GroundMap& map, const Line& line, Part part, Shift shift) {
  auto g_m = static_cast<double>(part.from_t * line.run);
  const auto limit_m = static_cast<double>(part.to_t * line.run);
  Track track{{knot(map, line, g_m, shift)}};
  while (g_m < limit_m) {
    const double next_m = map.piece_end_m(line.ground, g_m, limit_m);
    if (!(next_m > g_m && next_m <= limit_m)) throw std::logic_error("a piece must go forward");
    track.knots.push_back(knot(map, line, next_m, shift));
    g_m = next_m;
  }
  if (track.knots.size() == 1) track.knots.push_back(track.knots.front());
  // Parts of one ray meet exactly.
  track.knots.front().t = part.from_t;
  track.knots.back().t = part.to_t;
  return track;
}

// Adds the crossings of the piece a b with the lines f = 0, 1, ... last, where f goes from fa to
// fb. `snap` puts a point exactly onto its line.
struct Lines {
  int first, last;
  bool along_band = false;
};
template <class Snap>
void add_crossings(std::vector<Crossing>& out, const Crossing& a, const Crossing& b, Real fa,
                   Real fb, Lines lines, const Snap& snap) {
  if (fa == fb) return;
  const Real lowest = std::max(std::ceil(std::min(fa, fb)), static_cast<Real>(lines.first));
  const Real highest = std::min(std::floor(std::max(fa, fb)), static_cast<Real>(lines.last));
  for (Real line = lowest; line <= highest; ++line) {
    const Real share = (line - fa) / (fb - fa);
    const Uv uv{a.uv.u + (b.uv.u - a.uv.u) * share, a.uv.v + (b.uv.v - a.uv.v) * share};
    out.push_back({a.t + (b.t - a.t) * share, snap(uv, line), lines.along_band});
  }
}

std::vector<Crossing> crossings_of(const Track& track, const HeightGrid& grid, SurfaceModel model) {
  std::vector<Crossing> out{track.knots.front()};
  for (std::size_t i = 1; i < track.knots.size(); ++i) {
    const Crossing& a = track.knots[i - 1];
    const Crossing& b = track.knots[i];
    const bool is_band = model == SurfaceModel::band;
    const bool by_columns =
        std::fabs(b.uv.u - a.uv.u) > (1 + Real{1e-9}) * std::fabs(b.uv.v - a.uv.v);
    add_crossings(out, a, b, a.uv.u, b.uv.u, {0, grid.columns - 1, is_band && !by_columns},
                  [](Uv uv, Real line) {
                    return Uv{line, uv.v};
                  });
    add_crossings(out, a, b, a.uv.v, b.uv.v, {0, grid.rows - 1, is_band && by_columns},
                  [](Uv uv, Real line) {
                    return Uv{uv.u, line};
                  });
    if (model == SurfaceModel::triangles)
      add_crossings(out, a, b, a.uv.u - a.uv.v, b.uv.u - b.uv.v, {1 - grid.rows, grid.columns - 1},
                    [](Uv uv, Real line) {
                      return Uv{uv.v + line, uv.v};
                    });
    if (model == SurfaceModel::bilinear || i + 1 == track.knots.size()) out.push_back(b);
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Crossing& a, const Crossing& b) { return a.t < b.t; });
  return out;
}

Real height(const HeightGrid& grid, int column, int row) {
  return grid.heights_m[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) +
                        static_cast<std::size_t>(column)];
}

bool has_ground(const HeightGrid& grid, glm::ivec2 cell) {
  for (const int row : {cell.y, cell.y + 1})
    for (const int column : {cell.x, cell.x + 1})
      if (std::isnan(height(grid, column, row))) return false;
  return true;
}

// The cell of a point; the last line of the grid belongs to the last cell. False outside the grid.
bool find_cell(const HeightGrid& grid, Uv uv, glm::ivec2& cell) {
  if (!(uv.u >= 0 && uv.v >= 0 && uv.u <= grid.columns - 1 && uv.v <= grid.rows - 1)) return false;
  cell = {std::min(static_cast<int>(uv.u), grid.columns - 2),
          std::min(static_cast<int>(uv.v), grid.rows - 2)};
  return has_ground(grid, cell);
}

// Drops the crossings that a band goes over: those with ground on both sides, or on neither.
void join_bands(std::vector<Crossing>& crossings, const Track& track, const HeightGrid& grid) {
  // By crossing, whether there is ground on the way there from the one before.
  std::vector<bool> ground(crossings.size(), false);
  for (std::size_t i = 1; i < crossings.size(); ++i) {
    glm::ivec2 cell;
    const Real from_t = crossings[i - 1].t;
    ground[i] = from_t == crossings[i].t
                    ? static_cast<bool>(ground[i - 1])
                    : find_cell(grid, track.at((from_t + crossings[i].t) / 2), cell);
  }
  std::vector<Crossing> kept;
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    std::size_t after = i;
    while (after + 1 < crossings.size() && crossings[after].t == crossings[i].t) ++after;
    if (!crossings[i].along_band || ground[i] != ground[after]) kept.push_back(crossings[i]);
  }
  crossings = kept;
}

// 1 / R along the azimuth of a ground point, by Euler's formula.
Real curvature_per_m(const VerticalFrame& frame, Real x_m, Real y_m) {
  const Real s = std::hypot(x_m, y_m);
  if (s == 0) return frame.north_curvature_per_m;
  const Real east = x_m / s;
  const Real north = y_m / s;
  return north * north * frame.north_curvature_per_m + east * east * frame.east_curvature_per_m;
}

Real stretch(Real gamma) { return gamma > 0 ? gamma / std::sin(gamma) : 1; }

// The ground of one cell as it stands under a ray.
struct CellView {
  const Terrain& terrain;
  const Line& line;
  const HeightGrid& grid;
  glm::ivec2 cell;

  [[nodiscard]] Real z_at(const Crossing& at) const {
    const Real moved = line.run > 0 ? at.t : 0;
    return z_m(terrain.frame(), line.x + line.dx * moved, line.y + line.dy * moved, height_at(at));
  }

  // The bilinear patch's height in the middle over the chord's, times dz/dh where the span begins.
  [[nodiscard]] Real bulge_m(const Crossing& a, const Crossing& b) const {
    if (terrain.model() != SurfaceModel::bilinear) return 0;
    const Real twist = height(grid, cell.x, cell.y) - height(grid, cell.x + 1, cell.y) -
                       height(grid, cell.x, cell.y + 1) + height(grid, cell.x + 1, cell.y + 1);
    const VerticalFrame& frame = terrain.frame();
    return -twist * frame.z_scale * (b.uv.u - a.uv.u) * (b.uv.v - a.uv.v) / 4 *
           z_per_height(frame, line.x + line.dx * a.t, line.y + line.dy * a.t, height_at(a));
  }

  // A band may begin and end beside the cell in its middle.
  [[nodiscard]] Real height_at(const Crossing& at) const {
    if (terrain.model() == SurfaceModel::band) return band_height(at.uv) * terrain.frame().z_scale;
    return scene_height_m(grid, terrain.model(), cell, at.uv.u, at.uv.v, terrain.frame().z_scale);
  }

  // On a line it takes the posts of that line alone: others may have no height. Crossings on the
  // rim may be rounded over it.
  [[nodiscard]] Real band_height(Uv uv) const {
    uv.u = std::clamp<Real>(uv.u, 0, grid.columns - 1);
    uv.v = std::clamp<Real>(uv.v, 0, grid.rows - 1);
    const auto column = static_cast<int>(uv.u);
    const auto row = static_cast<int>(uv.v);
    const Real p = uv.u - column;
    const Real q = uv.v - row;
    const Real from = height(grid, column, row);
    if (p == 0 && q == 0) return from;
    if (q == 0) return from + (height(grid, column + 1, row) - from) * p;
    if (p == 0) return from + (height(grid, column, row + 1) - from) * q;
    return scene_height_m(grid, SurfaceModel::band, {column, row}, uv.u, uv.v, 1);
  }
};

std::vector<Span> spans_of(const Terrain& terrain, const Line& line, std::size_t layer, Part part,
                           Shift shift) {
  const TerrainLayer& here = terrain.layers()[layer];
  const Track track = track_of(*here.map, line, part, shift);
  std::vector<Crossing> crossings = crossings_of(track, *here.grid, terrain.model());
  if (terrain.model() == SurfaceModel::band) join_bands(crossings, track, *here.grid);
  const bool is_point = part.from_t == part.to_t;
  std::vector<Span> spans;
  for (std::size_t i = 1; i < crossings.size(); ++i) {
    const Crossing& a = crossings[i - 1];
    const Crossing& b = crossings[i];
    if (a.t == b.t && !is_point) continue;
    glm::ivec2 cell;
    if (!find_cell(*here.grid, track.at((a.t + b.t) / 2), cell)) continue;
    const CellView view{terrain, line, *here.grid, cell};
    spans.push_back(
        {a.t, b.t, view.z_at(a), view.z_at(b), view.bulge_m(a, b), static_cast<int>(layer), cell});
    if (is_point) break;
  }
  return spans;
}

// The spans of `layer`, and where it has no ground those of the layers after it.
void add_spans(std::vector<Span>& out, const Terrain& terrain, const Line& line, std::size_t layer,
               Part part, Shift shift) {
  if (layer == terrain.layers().size()) return;
  Real covered_t = part.from_t;
  bool is_covered = false;
  for (const Span& span : spans_of(terrain, line, layer, part, shift)) {
    if (span.from_t > covered_t)
      add_spans(out, terrain, line, layer + 1, {covered_t, span.from_t}, shift);
    out.push_back(span);
    covered_t = span.to_t;
    is_covered = true;
  }
  if (covered_t < part.to_t || !is_covered)
    add_spans(out, terrain, line, layer + 1, {covered_t, part.to_t}, shift);
}

}  // namespace

Real z_m(const VerticalFrame& frame, Real x_m, Real y_m, Real scene_height_m) {
  const Real s = std::hypot(x_m, y_m);
  const Real curvature = curvature_per_m(frame, x_m, y_m);
  const Real gamma = s * curvature;
  const Real drop = -s * std::tan(gamma / 2) + frame.refraction * s * gamma / 2;
  return drop +
         stretch(gamma) * (scene_height_m - frame.eye_height_m) / (1 + curvature * scene_height_m);
}

Real z_per_height(const VerticalFrame& frame, Real x_m, Real y_m, Real scene_height_m) {
  const Real curvature = curvature_per_m(frame, x_m, y_m);
  const Real shrink = 1 + curvature * scene_height_m;
  return stretch(std::hypot(x_m, y_m) * curvature) * (1 + curvature * frame.eye_height_m) /
         (shrink * shrink);
}

Real scene_height_m(const HeightGrid& grid, SurfaceModel model, glm::ivec2 cell, Real u, Real v,
                    Real z_scale) {
  const Real p = u - cell.x;
  const Real q = v - cell.y;
  const Real h00 = height(grid, cell.x, cell.y);
  const Real h10 = height(grid, cell.x + 1, cell.y);
  const Real h01 = height(grid, cell.x, cell.y + 1);
  const Real h11 = height(grid, cell.x + 1, cell.y + 1);
  if (model == SurfaceModel::triangles) {
    const Real h =
        p > q ? h00 + (h10 - h00) * p + (h11 - h10) * q : h00 + (h11 - h01) * p + (h01 - h00) * q;
    return h * z_scale;
  }
  return z_scale * ((1 - p) * (1 - q) * h00 + p * (1 - q) * h10 + (1 - p) * q * h01 + p * q * h11);
}

Real Span::z_at(Real t) const {
  const Real share = to_t > from_t ? (t - from_t) / (to_t - from_t) : 0;
  return from_z_m + (to_z_m - from_z_m) * share + 4 * bulge_m * share * (1 - share);
}

Real Profile::clearance_m(const Span& span, Real t) const {
  return ray_z_m + ray_slope * t - span.z_at(t);
}

bool Profile::continues(std::size_t span) const {
  return span > 0 && spans[span - 1].to_t == spans[span].from_t;
}

Profile profile(const Terrain& terrain, const Ray& ray, Shift shift_cells) {
  const Line line(ray);
  Profile out{line.z, line.dz, line.run, {}};
  const Part part = line.within(terrain.reach_m());
  if (part.to_t >= 0) add_spans(out.spans, terrain, line, 0, part, shift_cells);
  return out;
}

}  // namespace terrview::oracle
