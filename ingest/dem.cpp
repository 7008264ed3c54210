#include "ingest/dem.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "ingest/dem_crs.h"
#include "ingest/dem_heights.h"
#include "ingest/dem_source.h"
#include "ingest/fill_voids.h"
#include "ingest/gdal_scope.h"
#include "ingest/lattice.h"
#include "terrain/error.h"

namespace terrview {
namespace {

// What to read of one file, and where it lies once rows run south and columns east.
struct Part {
  DemHeader header;
  HeightTarget target;
  PostPlacement placement;
  double block_bytes = 0;
};

PostWindow checked_window(const DemHeader& header, const PostWindow& window) {
  const auto [column, row, width, height] = window;
  if (column < 0 || row < 0 || width < 1 || height < 1 || width > header.columns - column ||
      height > header.rows - row) {
    std::ostringstream text;
    text << header.name << ": --window " << column << ',' << row << ',' << width << ',' << height
         << " reaches outside its " << header.columns << " x " << header.rows
         << " posts: give COL,ROW,W,H within them";
    throw InputError(text.str());
  }
  return window;
}

std::optional<PostWindow> chosen_window(const DemHeader& header, const DemOptions& options) {
  std::optional<PostWindow> window = PostWindow{0, 0, header.columns, header.rows};
  if (options.choose_window) {
    window = options.choose_window(header);
  } else if (options.window) {
    window = options.window;
  }
  return window ? std::optional(checked_window(header, *window)) : std::nullopt;
}

Part plan_part(DemHeader header, const PostWindow& window) {
  Part part;
  part.target.window = window;
  const auto [column, row, width, height] = window;
  glm::dmat2 step = header.placement.step;
  part.target.flip_columns = step[0].x < 0;
  part.target.flip_rows = step[1].y > 0;
  const glm::dvec2 first{part.target.flip_columns ? column + width - 1 : column,
                         part.target.flip_rows ? row + height - 1 : row};
  if (part.target.flip_columns) step[0] = glm::dvec2(0) - step[0];
  if (part.target.flip_rows) step[1] = glm::dvec2(0) - step[1];
  part.placement = {header.placement.at(first), step};
  part.header = std::move(header);
  return part;
}

std::vector<Part> plan_parts(const std::vector<std::string>& paths, const DemOptions& options,
                             GdalScope& scope) {
  std::vector<Part> parts;
  for (const std::string& path : paths) {
    const DemSource source(path, options, scope);
    const auto window = chosen_window(source.header(), options);
    if (!window) continue;
    parts.push_back(plan_part(source.header(), *window));
    parts.back().block_bytes = block_bytes(source);
  }
  if (parts.empty()) throw InputError("no DEM within reach: give one that covers the place");
  return parts;
}

std::vector<Tile> to_tiles(const std::vector<Part>& parts) {
  std::vector<Tile> tiles;
  for (const Part& part : parts) {
    const auto same = [&](const Part& other) {
      return same_crs(other.header.crs_wkt, part.header.crs_wkt);
    };
    const auto first = std::find_if(parts.begin(), parts.end(), same);
    tiles.push_back({part.target.window[2], part.target.window[3], part.placement,
                     static_cast<int>(first - parts.begin()), part.header.geographic});
  }
  return tiles;
}

double half_of_memory_bytes() {
  return 0.5 * static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
         static_cast<double>(sysconf(_SC_PAGESIZE));
}

std::string mebibytes(double bytes) {
  std::ostringstream text;
  text.precision(0);
  text << std::fixed << std::ceil(bytes / (1 << 20)) << " MiB";
  return text.str();
}

// Before anything is allocated: a header may claim any size.
void check_sizes(const std::vector<Mosaic>& mosaics, const std::vector<Part>& parts,
                 const DemOptions& options) {
  const double limit =
      options.memory_bytes > 0 ? static_cast<double>(options.memory_bytes) : half_of_memory_bytes();
  constexpr double kPost_bytes = sizeof(float) + 0.25;  // and two bits to find voids
  double needed = 0;
  for (const Mosaic& mosaic : mosaics) {
    const std::string& name = parts[static_cast<std::size_t>(mosaic.parts[0].tile)].header.name;
    const std::string size =
        std::to_string(mosaic.columns) + " x " + std::to_string(mosaic.rows) + " posts";
    if (mosaic.columns < 2 || mosaic.rows < 2) {
      throw InputError(name + ": " + size +
                       " make no ground: give a DEM, or a --window, of at least "
                       "2 x 2");
    }
    double block = 0;
    for (const Mosaic::Part& part : mosaic.parts) {
      block = std::max(block, parts[static_cast<std::size_t>(part.tile)].block_bytes);
    }
    needed += kPost_bytes * mosaic.columns * mosaic.rows;
    if (needed + block > limit) {
      throw InputError(name + ": " + size + " need " + mebibytes(needed + block) +
                       " of memory, more than the limit of " + mebibytes(limit) +
                       ": read a part with --window COL,ROW,W,H, or raise --memory");
    }
  }
}

// Counts posts read over all files.
class Progress {
 public:
  Progress(const std::vector<Part>& parts, const DemOptions& options) : options_(options) {
    for (const Part& part : parts) {
      total_ += static_cast<double>(part.target.window[2]) * part.target.window[3];
    }
  }

  void advance(double posts) {
    done_ += posts;
    if (options_.progress) options_.progress(done_ / total_);
  }

 private:
  const DemOptions& options_;
  double total_ = 0;
  double done_ = 0;
};

// Posts of the mosaic that belong to a tile.
std::size_t covered_posts(const Mosaic& mosaic, const std::vector<Part>& parts) {
  std::size_t covered = 0;
  std::vector<std::pair<int, int>> runs;
  for (int row = 0; row < mosaic.rows; ++row) {
    runs.clear();
    for (const Mosaic::Part& part : mosaic.parts) {
      const PostWindow& window = parts[static_cast<std::size_t>(part.tile)].target.window;
      if (row >= part.first.y && row < part.first.y + window[3]) {
        runs.emplace_back(part.first.x, part.first.x + window[2]);
      }
    }
    std::sort(runs.begin(), runs.end());
    int end = 0;
    for (const auto& [first, last] : runs) {
      covered += static_cast<std::size_t>(std::max(0, last - std::max(first, end)));
      end = std::max(end, last);
    }
  }
  return covered;
}

std::size_t count_heights(const HeightGrid& grid) {
  return static_cast<std::size_t>(std::count_if(grid.heights_m.begin(), grid.heights_m.end(),
                                                [](float height) { return !std::isnan(height); }));
}

void add_lines(std::vector<std::string>& lines, const std::vector<std::string>& more) {
  for (const std::string& line : more) {
    if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
  }
}

class DemReader {
 public:
  DemReader(const std::vector<Part>& parts, const DemOptions& options, GdalScope& scope)
      : parts_(parts), options_(options), scope_(scope), progress_(parts, options) {}

  Dem read(const Mosaic& mosaic) {
    Dem dem = describe(mosaic);
    auto grid = std::make_shared<HeightGrid>();
    grid->columns = mosaic.columns;
    grid->rows = mosaic.rows;
    grid->heights_m.assign(
        static_cast<std::size_t>(mosaic.columns) * static_cast<std::size_t>(mosaic.rows),
        std::numeric_limits<float>::quiet_NaN());
    for (const Mosaic::Part& part : mosaic.parts) read_part(part, *grid, dem);
    if (options_.fill_voids) dem.voids_filled = fill_voids(*grid, kFilledVoid_posts);
    dem.voids_open = open_posts(mosaic, *grid);
    dem.grid = std::move(grid);
    return dem;
  }

 private:
  [[nodiscard]] const Part& part_of(const Mosaic::Part& part) const {
    return parts_[static_cast<std::size_t>(part.tile)];
  }

  [[nodiscard]] Dem describe(const Mosaic& mosaic) const {
    const DemHeader& first = part_of(mosaic.parts[0]).header;
    Dem dem;
    dem.placement = mosaic.placement;
    dem.crs_wkt = first.crs_wkt;
    dem.vertical_datum = first.vertical_datum;
    dem.height_unit = first.height_unit;
    for (const Mosaic::Part& part : mosaic.parts) {
      const DemHeader& header = part_of(part).header;
      dem.name += (dem.name.empty() ? "" : " + ") + header.name;
      add_lines(dem.warnings, header.warnings);
    }
    if (mosaic.stopped_by_waste) {
      dem.warnings.push_back(dem.name +
                             ": lies too scattered to be joined with its neighbours, so a "
                             "slot stays open: give the tiles between as well");
    }
    return dem;
  }

  void read_part(const Mosaic::Part& where, HeightGrid& grid, Dem& dem) {
    const Part& part = part_of(where);
    DemSource source(part.header.name, options_, scope_);
    if (source.header().columns != part.header.columns ||
        source.header().rows != part.header.rows) {
      throw InputError(part.header.name + ": changed while it was read: try again");
    }
    HeightTarget target = part.target;
    target.first = where.first;
    const auto advance = [this](double posts) { progress_.advance(posts); };
    add_lines(dem.warnings, read_heights(source, target, grid, scope_, advance));
    for (const std::string& text : scope_.take_warnings()) {
      add_lines(dem.warnings, {part.header.name + ": " + text});
    }
  }

  [[nodiscard]] std::size_t open_posts(const Mosaic& mosaic, const HeightGrid& grid) const {
    const std::size_t covered = covered_posts(mosaic, parts_);
    return covered - std::min(covered, count_heights(grid));
  }

  const std::vector<Part>& parts_;
  const DemOptions& options_;
  GdalScope& scope_;
  Progress progress_;
};

bool has_heights(const Dem& dem) {
  return std::any_of(dem.grid->heights_m.begin(), dem.grid->heights_m.end(),
                     [](float height) { return !std::isnan(height); });
}

// Leaves out DEMs without any height; what was said of them is kept.
std::vector<Dem> keep_those_with_heights(std::vector<Dem> dems) {
  std::vector<Dem> kept;
  std::vector<std::string> said;
  for (Dem& dem : dems) {
    if (has_heights(dem)) {
      kept.push_back(std::move(dem));
      continue;
    }
    add_lines(said, dem.warnings);
    add_lines(said, {dem.name + ": no post has a height: name its nodata number with --nodata, or "
                                "another band with -b"});
  }
  if (kept.empty()) throw InputError(said.front());
  add_lines(kept.front().warnings, said);
  return kept;
}

}  // namespace

std::vector<Dem> read_dems(const std::vector<std::string>& paths, const DemOptions& options) {
  if (paths.empty()) throw InputError("no DEM: give a file");
  GdalScope scope;
  const std::vector<Part> parts = plan_parts(paths, options, scope);
  const std::vector<Mosaic> mosaics = join_tiles(to_tiles(parts));
  check_sizes(mosaics, parts, options);
  DemReader reader(parts, options, scope);
  std::vector<Dem> dems;
  for (const Mosaic& mosaic : mosaics) dems.push_back(reader.read(mosaic));
  return keep_those_with_heights(std::move(dems));
}

}  // namespace terrview
