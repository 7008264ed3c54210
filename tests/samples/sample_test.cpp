// One test per promise of samples/: the committed files are what make_sample writes.
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "samples/mountains.h"

namespace terrview {
namespace {

class Sample : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    GDALAllRegister();
    const std::string path = std::string(TERRVIEW_SOURCE_DIR "/samples/") + GetParam();
    file_.reset(GDALDataset::Open(path.c_str()));
    ASSERT_TRUE(file_) << path;
  }

  GDALDatasetUniquePtr file_;
};

TEST_P(Sample, HoldsTheHeightsThatItsProgramMakes) {
  const HeightGrid expected = make_mountains();
  ASSERT_EQ(file_->GetRasterXSize(), expected.columns);
  ASSERT_EQ(file_->GetRasterYSize(), expected.rows);
  std::vector<float> heights_m(expected.heights_m.size());
  ASSERT_EQ(file_->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, expected.columns, expected.rows,
                                              heights_m.data(), expected.columns, expected.rows,
                                              GDT_Float32, 0, 0, nullptr),
            CE_None);
  EXPECT_EQ(heights_m, expected.heights_m);
}

TEST_P(Sample, HasItsMiddlePostOn48North7East) {
  std::array<double, 6> transform{};
  ASSERT_EQ(file_->GetGeoTransform(transform.data()), CE_None);
  const double middle = kSampleSize_posts / 2 + 0.5;
  EXPECT_NEAR(transform[0] + middle * transform[1], 7, 1e-9);
  EXPECT_NEAR(transform[3] + middle * transform[5], 48, 1e-9);
  ASSERT_TRUE(file_->GetSpatialRef());
  EXPECT_TRUE(file_->GetSpatialRef()->IsGeographic());
}

TEST_P(Sample, HasCellsOfAbout60By90Metres) {
  std::array<double, 6> transform{};
  ASSERT_EQ(file_->GetGeoTransform(transform.data()), CE_None);
  // A degree on the WGS 84 ellipsoid at 48 N.
  EXPECT_NEAR(transform[1] * 74628, 60, 0.1);
  EXPECT_NEAR(-transform[5] * 111200, 90, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Files, Sample, testing::Values("vosges_like.tif", "vosges_like.asc"),
                         [](const auto& file) {
                           std::string name = file.param;
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

TEST(Mountains, RiseFromAValleyTo1400Metres) {
  const std::vector<float> heights_m = make_mountains().heights_m;
  const auto [lowest, highest] = std::minmax_element(heights_m.begin(), heights_m.end());
  EXPECT_NEAR(*lowest, 300, 20);
  EXPECT_NEAR(*highest, 1400, 50);
}

TEST(Mountains, HaveWholeMetresEverywhere) {
  for (const float height_m : make_mountains().heights_m) ASSERT_EQ(height_m, std::floor(height_m));
}

}  // namespace
}  // namespace terrview
