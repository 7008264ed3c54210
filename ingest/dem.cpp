#include "ingest/dem.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ingest/dem_heights.h"
#include "ingest/dem_plan.h"
#include "ingest/dem_source.h"
#include "ingest/fill_voids.h"
#include "ingest/gdal_scope.h"
#include "terrain/error.h"
#include "terrain/huge_pages.h"

namespace terrview {
namespace {

// Counts posts read over all files.
class Progress {
 public:
  Progress(const std::vector<DemPart>& parts, const DemOptions& options) : options_(options) {
    for (const DemPart& part : parts) {
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

std::size_t count_heights(const HeightGrid& grid) {
  return static_cast<std::size_t>(std::count_if(grid.heights_m.begin(), grid.heights_m.end(),
                                                [](float height) { return !std::isnan(height); }));
}

void add_lines(std::vector<std::string>& lines, const std::vector<std::string>& more) {
  for (const std::string& line : more) {
    if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
  }
}

// A Dem, and what was said of posts that lost their numbers.
struct ReadDem {
  Dem dem;
  std::vector<std::string> losses;
};

class DemReader {
 public:
  DemReader(const std::vector<DemPart>& parts, const DemOptions& options, GdalScope& scope)
      : parts_(parts), options_(options), scope_(scope), progress_(parts, options) {}

  ReadDem read(const Mosaic& mosaic) {
    ReadDem result{describe(mosaic), {}};
    auto grid = std::make_shared<HeightGrid>();
    grid->columns = mosaic.columns;
    grid->rows = mosaic.rows;
    grid->heights_m = floats_in_huge_pages(
        static_cast<std::size_t>(mosaic.columns) * static_cast<std::size_t>(mosaic.rows),
        std::numeric_limits<float>::quiet_NaN());
    for (const Mosaic::Part& part : mosaic.parts) read_part(part, *grid, result);
    Dem& dem = result.dem;
    if (options_.fill_voids) dem.voids_filled = fill_voids(*grid, kFilledVoid_posts);
    dem.voids_open = open_posts(mosaic, *grid);
    dem.grid = std::move(grid);
    return result;
  }

 private:
  [[nodiscard]] const DemPart& part_of(const Mosaic::Part& part) const {
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

  void read_part(const Mosaic::Part& where, HeightGrid& grid, ReadDem& result) {
    const DemPart& part = part_of(where);
    DemSource source(part.header.name, options_, scope_);
    if (source.header().columns != part.header.columns ||
        source.header().rows != part.header.rows) {
      throw InputError(part.header.name + ": changed while it was read: try again");
    }
    HeightTarget target = part.target;
    target.first = where.first;
    const auto advance = [this](double posts) { progress_.advance(posts); };
    const auto losses = read_heights(source, target, grid, scope_, advance);
    add_lines(result.losses, losses);
    add_lines(result.dem.warnings, losses);
    for (const std::string& text : scope_.take_warnings()) {
      add_lines(result.dem.warnings, {part.header.name + ": " + text});
    }
  }

  [[nodiscard]] std::size_t open_posts(const Mosaic& mosaic, const HeightGrid& grid) const {
    const std::size_t covered = covered_posts(mosaic, parts_);
    return covered - std::min(covered, count_heights(grid));
  }

  const std::vector<DemPart>& parts_;
  const DemOptions& options_;
  GdalScope& scope_;
  Progress progress_;
};

bool has_heights(const Dem& dem) {
  return std::any_of(dem.grid->heights_m.begin(), dem.grid->heights_m.end(),
                     [](float height) { return !std::isnan(height); });
}

std::string why_empty(const ReadDem& read) {
  if (!read.losses.empty()) return read.losses.front() + "; no height is left";
  return read.dem.name +
         ": no post has a height: name its nodata number with --nodata, or another "
         "band with -b";
}

// Leaves out DEMs without any height; what was said of them is kept.
std::vector<Dem> keep_those_with_heights(std::vector<ReadDem> all) {
  std::vector<Dem> kept;
  std::vector<std::string> said;
  for (ReadDem& read : all) {
    if (has_heights(read.dem)) {
      kept.push_back(std::move(read.dem));
    } else {
      add_lines(said, {why_empty(read)});
    }
  }
  if (kept.empty()) throw InputError(said.front());
  add_lines(kept.front().warnings, said);
  return kept;
}

}  // namespace

std::vector<Dem> read_dems(const std::vector<std::string>& paths, const DemOptions& options) {
  if (paths.empty()) throw InputError("no DEM: give a file");
  GdalScope scope;
  const DemPlan plan = plan_dems(paths, options, scope);
  DemReader reader(plan.parts, options, scope);
  std::vector<ReadDem> all;
  for (const Mosaic& mosaic : plan.mosaics) all.push_back(reader.read(mosaic));
  return keep_those_with_heights(std::move(all));
}

}  // namespace terrview
