#include "bench/embree_ground.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "render/parallel.h"

namespace terrview {
namespace {

constexpr int kTile_cells = 64;

struct Vertex {
  float x_m, y_m, z_m;
};
struct Triangle {
  std::uint32_t a, b, c;
};

template <class Item>
Item* new_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t count) {
  return static_cast<Item*>(
      rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Item), count));
}

// Row by row from the south: Embree splits a cell of a grid from its second to its fourth vertex,
// which is then from the south-east to the north-west.
void fill_vertices(const BenchDem& dem, RTCGeometry geometry) {
  const HeightGrid& grid = *dem.grid;
  auto* vertices = new_buffer<Vertex>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3,
                                      grid.heights_m.size());
  if (!vertices) return;
  parallel_for(grid.rows, 0, [&](int line) {
    const int row = grid.rows - 1 - line;
    Vertex* vertex =
        vertices + static_cast<std::size_t>(line) * static_cast<std::size_t>(grid.columns);
    for (int column = 0; column < grid.columns; ++column) {
      const glm::dvec2 xy_m = dem.scene_xy_m({column, row});
      *vertex++ = {static_cast<float>(xy_m.x), static_cast<float>(xy_m.y), grid.at(column, row)};
    }
  });
}

void fill_triangles(const HeightGrid& grid, RTCGeometry geometry) {
  const auto columns = static_cast<std::uint32_t>(grid.columns);
  const auto rows = static_cast<std::uint32_t>(grid.rows);
  const std::size_t per_row = 2 * static_cast<std::size_t>(columns - 1);
  auto* triangles =
      new_buffer<Triangle>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, per_row * (rows - 1));
  if (!triangles) return;
  parallel_for(grid.rows - 1, 0, [&](int row) {
    Triangle* triangle = triangles + static_cast<std::size_t>(row) * per_row;
    const std::uint32_t south = (rows - 2 - static_cast<std::uint32_t>(row)) * columns;
    for (std::uint32_t sw = south; sw < south + columns - 1; ++sw) {
      const std::uint32_t nw = sw + columns;
      *triangle++ = {nw, sw, sw + 1};
      *triangle++ = {nw, sw + 1, nw + 1};
    }
  });
}

std::vector<EmbreeGround::Tile> fill_grids(const HeightGrid& grid, RTCGeometry geometry) {
  const int cells_wide = grid.columns - 1;
  const int cells_high = grid.rows - 1;
  std::vector<RTCGrid> primitives;
  std::vector<EmbreeGround::Tile> tiles;
  for (int south = 0; south < cells_high; south += kTile_cells)
    for (int west = 0; west < cells_wide; west += kTile_cells) {
      const int wide = std::min(kTile_cells, cells_wide - west);
      const int high = std::min(kTile_cells, cells_high - south);
      primitives.push_back(
          {static_cast<unsigned>(south * grid.columns + west), static_cast<unsigned>(grid.columns),
           static_cast<unsigned short>(wide + 1), static_cast<unsigned short>(high + 1)});
      tiles.push_back({(cells_high - 1 - south) * cells_wide + west, static_cast<float>(wide),
                       static_cast<float>(high)});
    }
  auto* buffer =
      new_buffer<RTCGrid>(geometry, RTC_BUFFER_TYPE_GRID, RTC_FORMAT_GRID, primitives.size());
  if (buffer) std::copy(primitives.begin(), primitives.end(), buffer);
  return tiles;
}

}  // namespace

EmbreeGround::EmbreeGround(const BenchDem& dem, EmbreeGeometry geometry, int threads)
    : device_(rtcNewDevice(("threads=" + std::to_string(threads)).c_str())),
      cells_in_row_(dem.grid->columns - 1) {
  if (!device_) throw std::runtime_error("Embree: no device");
  rtcSetDeviceMemoryMonitorFunction(device_.get(), count_bytes, this);
  scene_.reset(rtcNewScene(device_.get()));
  rtcSetSceneFlags(scene_.get(), geometry == EmbreeGeometry::compact_triangles
                                     ? RTC_SCENE_FLAG_COMPACT
                                     : RTC_SCENE_FLAG_NONE);
  const auto start = std::chrono::steady_clock::now();
  attach(dem, geometry);
  const auto attached = std::chrono::steady_clock::now();
  rtcCommitScene(scene_.get());
  const auto built = std::chrono::steady_clock::now();
  build_s_ = std::chrono::duration<double>(built - attached).count();
  ready_s_ = std::chrono::duration<double>(built - start).count();
  check();
}

double EmbreeGround::memory_mib() const { return static_cast<double>(bytes_) / (1 << 20); }

bool EmbreeGround::count_bytes(void* ground, ssize_t bytes, bool /*after*/) {
  static_cast<EmbreeGround*>(ground)->bytes_ += bytes;
  return true;
}

void EmbreeGround::attach(const BenchDem& dem, EmbreeGeometry geometry) {
  const bool grids = geometry == EmbreeGeometry::grid;
  RTCGeometry made =
      rtcNewGeometry(device_.get(), grids ? RTC_GEOMETRY_TYPE_GRID : RTC_GEOMETRY_TYPE_TRIANGLE);
  fill_vertices(dem, made);
  if (grids) {
    tiles_ = fill_grids(*dem.grid, made);
  } else {
    fill_triangles(*dem.grid, made);
  }
  check();
  rtcCommitGeometry(made);
  rtcAttachGeometry(scene_.get(), made);
  rtcReleaseGeometry(made);
}

void EmbreeGround::check() const {
  const RTCError error = rtcGetDeviceError(device_.get());
  if (error != RTC_ERROR_NONE)
    throw std::runtime_error("Embree: error " + std::to_string(error) +
                             (error == RTC_ERROR_OUT_OF_MEMORY ? ": out of memory" : ""));
}

}  // namespace terrview
