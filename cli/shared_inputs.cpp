#include "cli/shared_inputs.h"

#include <sstream>
#include <utility>

#include "ingest/drape_file.h"
#include "ingest/shared_tables.h"

namespace terrview {
namespace {

// Of the posts, which lakes do not move.
std::string place_of(const Dem& dem) {
  std::ostringstream text;
  text << dem.name << std::hexfloat;
  for (const double number : {dem.placement.origin.x, dem.placement.origin.y})
    text << ' ' << number;
  return text.str();
}

}  // namespace

std::shared_ptr<const FootprintFile> SharedInputs::footprints(const std::string& path,
                                                              const FootprintOptions& options) {
  const std::string key = path + '\n' + options.height_field + '\n' + options.color_field;
  return footprints_.get(
      key, [&] { return std::make_shared<const FootprintFile>(read_footprints(path, options)); });
}

std::shared_ptr<const TreeFile> SharedInputs::trees(const std::string& path) {
  return trees_.get(path, [&] { return std::make_shared<const TreeFile>(read_trees(path)); });
}

std::shared_ptr<const Drape> SharedInputs::drape(const std::string& path,
                                                 const std::vector<Dem>& dems,
                                                 std::size_t memory_bytes) {
  std::string key = path;
  for (const Dem& dem : dems) key += '\n' + place_of(dem);
  return drapes_.get(key, [&] { return read_drape(path, dems, memory_bytes); });
}

std::shared_ptr<const LaidWater> SharedInputs::water(const WaterOptions& options,
                                                     const std::vector<Dem>& dems) {
  return water_.get(options.file, [&] {
    LaidWater laid = lay_water(options, dems);
    const bool shares_tables = laid.lakes && dems.front().ceilings;
    if (shares_tables) make_shared_tables(laid.lakes->dems, /*threads=*/1);
    return std::make_shared<const LaidWater>(std::move(laid));
  });
}

}  // namespace terrview
