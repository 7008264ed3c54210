#include "ingest/dem_plan.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <utility>

#include "ingest/dem_crs.h"
#include "ingest/dem_source.h"
#include "ingest/memory_limit.h"
#include "terrain/error.h"

namespace terrview {
namespace {

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

DemPart plan_part(DemHeader header, const PostWindow& window) {
  DemPart part;
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

std::vector<DemPart> plan_parts(const std::vector<std::string>& paths, const DemOptions& options,
                                GdalScope& scope) {
  std::vector<DemPart> parts;
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

std::vector<LatticeTile> to_tiles(const std::vector<DemPart>& parts) {
  std::vector<LatticeTile> tiles;
  for (const DemPart& part : parts) {
    const auto same = [&](const DemPart& other) {
      return same_crs(other.header.crs_wkt, part.header.crs_wkt);
    };
    const auto first = std::find_if(parts.begin(), parts.end(), same);
    tiles.push_back({part.target.window[2], part.target.window[3], part.placement,
                     static_cast<int>(first - parts.begin()), part.header.geographic});
  }
  return tiles;
}

void check_sizes(const std::vector<Mosaic>& mosaics, const std::vector<DemPart>& parts,
                 const DemOptions& options) {
  const double limit = memory_limit_bytes(options.memory_bytes);
  constexpr double kPost_bytes = sizeof(float) + 0.375;  // and three bits to find voids
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

}  // namespace

DemPlan plan_dems(const std::vector<std::string>& paths, const DemOptions& options,
                  GdalScope& scope) {
  DemPlan plan;
  plan.parts = plan_parts(paths, options, scope);
  plan.mosaics = join_tiles(to_tiles(plan.parts));
  check_sizes(plan.mosaics, plan.parts, options);
  return plan;
}

std::size_t covered_posts(const Mosaic& mosaic, const std::vector<DemPart>& parts) {
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

}  // namespace terrview
