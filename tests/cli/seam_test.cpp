// Tiles of one lattice look like the mosaic that gdalbuildvrt makes of them.
#include <gdal_utils.h>

#include <cmath>

#include "tests/cli/small_view.h"

namespace terrview {
namespace {

struct Tiles {
  const char* first;
  const char* second;
  const char* view;
};

class Seam : public SmallView, public testing::WithParamInterface<Tiles> {};

void mosaic(const std::string& first, const std::string& second, const std::string& to) {
  const char* const paths[] = {first.c_str(), second.c_str()};
  GDALDatasetH made = GDALBuildVRT(to.c_str(), 2, nullptr, paths, nullptr, nullptr);
  ASSERT_NE(made, nullptr);
  GDALClose(made);
}

TEST_P(Seam, IsNotSeen) {
  NEEDS_SHARED_DATA();
  const std::string first = shared_data(GetParam().first);
  const std::string second = shared_data(GetParam().second);
  mosaic(first, second, path("mosaic.vrt"));
  const Arguments line = words(GetParam().view) + words("-q --size 160x90 -o p.png --overwrite");
  ASSERT_EQ(run(Arguments{first, second, "--layers", "tiles.tif"} + line).exit_code, 0);
  ASSERT_EQ(run(Arguments{path("mosaic.vrt"), "--layers", "mosaic.tif"} + line).exit_code, 0);
  const Layers tiles = layers("tiles.tif");
  const Layers whole = layers("mosaic.tif");
  int hits = 0;
  for (int row = 0; row < tiles.height_px; ++row) {
    for (int column = 0; column < tiles.width_px; ++column) {
      const double distance_m = tiles.at("distance_m", column, row);
      const double expected_m = whole.at("distance_m", column, row);
      ASSERT_EQ(std::isnan(distance_m), std::isnan(expected_m)) << column << ", " << row;
      if (std::isnan(distance_m)) continue;
      ++hits;
      ASSERT_EQ(distance_m, expected_m) << column << ", " << row;
      ASSERT_EQ(tiles.at("height_m", column, row), whole.at("height_m", column, row));
    }
  }
  EXPECT_GT(hits, 1000);
}

INSTANTIATE_TEST_SUITE_P(
    Pairs, Seam,
    testing::Values(Tiles{"vosges/N47E007.hgt", "vosges/N48E007.hgt",
                          "--eye 47.98,7.05,+300 --heading 20 --pitch -4"},
                    Tiles{"osterrain50/NN16.asc", "osterrain50/NN17.asc",
                          "--eye 56.76,-5.05,1200 --heading 20 --pitch -15 --a-srs EPSG:27700"}));

}  // namespace
}  // namespace terrview
