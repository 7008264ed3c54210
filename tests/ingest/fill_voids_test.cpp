// One test per promise of ingest/fill_voids.h.
#include "ingest/fill_voids.h"

#include <gdal_alg.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace terrview {
namespace {

constexpr float kVoid = std::numeric_limits<float>::quiet_NaN();

HeightGrid make_slope(int columns, int rows) {
  HeightGrid grid{columns, rows, {}};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      grid.heights_m.push_back(
          static_cast<float>(1000 + 7 * column - 3 * row + (column * row) % 11));
    }
  }
  return grid;
}

float& post(HeightGrid& grid, int column, int row) {
  return grid.heights_m[static_cast<std::size_t>(row * grid.columns + column)];
}

void make_void(HeightGrid& grid, int column, int row, int width, int height) {
  for (int y = row; y < row + height; ++y) {
    for (int x = column; x < column + width; ++x) post(grid, x, y) = kVoid;
  }
}

std::size_t count_voids(const HeightGrid& grid) {
  std::size_t count = 0;
  for (const float height : grid.heights_m) count += std::isnan(height) ? 1U : 0U;
  return count;
}

TEST(FillVoids, SmallOnesAreFilledAndCounted) {
  HeightGrid grid = make_slope(100, 80);
  make_void(grid, 10, 20, 32, 5);
  make_void(grid, 60, 20, 7, 32);
  make_void(grid, 1, 1, 1, 1);
  EXPECT_EQ(fill_voids(grid, 32), 32U * 5 + 7 * 32 + 1);
  EXPECT_EQ(count_voids(grid), 0U);
}

TEST(FillVoids, WideOnesStayOpenAsAWhole) {
  HeightGrid grid = make_slope(100, 80);
  make_void(grid, 10, 20, 33, 2);
  make_void(grid, 60, 20, 2, 33);
  EXPECT_EQ(fill_voids(grid, 32), 0U);
  EXPECT_EQ(count_voids(grid), 2U * 2 * 33);
}

TEST(FillVoids, ThoseAtTheBorderStayOpen) {
  HeightGrid grid = make_slope(40, 30);
  make_void(grid, 0, 10, 2, 2);
  make_void(grid, 38, 10, 2, 2);
  make_void(grid, 20, 0, 2, 2);
  make_void(grid, 20, 28, 2, 2);
  EXPECT_EQ(fill_voids(grid, 32), 0U);
  EXPECT_EQ(count_voids(grid), 16U);
}

TEST(FillVoids, VoidsThatTouchAtACornerAreOne) {
  HeightGrid grid = make_slope(100, 80);
  make_void(grid, 10, 10, 20, 4);
  make_void(grid, 30, 14, 20, 4);
  EXPECT_EQ(fill_voids(grid, 32), 0U);
  make_void(grid, 60, 60, 3, 3);
  EXPECT_EQ(fill_voids(grid, 32), 9U);
}

TEST(FillVoids, CrookedVoidsAreFoundWhole) {
  HeightGrid grid = make_slope(60, 60);
  // A comb: teeth hang from a back, joined only there.
  make_void(grid, 10, 10, 21, 1);
  for (int tooth = 10; tooth <= 30; tooth += 2) make_void(grid, tooth, 11, 1, 15);
  HeightGrid upside_down = grid;
  std::reverse(upside_down.heights_m.begin(), upside_down.heights_m.end());
  EXPECT_EQ(fill_voids(grid, 32), 21U + 11 * 15);
  EXPECT_EQ(fill_voids(upside_down, 32), 21U + 11 * 15);
  // With a tooth that is too long all of it stays open.
  make_void(grid, 10, 10, 21, 1);
  make_void(grid, 20, 11, 1, 32);
  EXPECT_EQ(fill_voids(grid, 32), 0U);
}

TEST(FillVoids, HeightsThatWereThereStay) {
  HeightGrid grid = make_slope(50, 50);
  const HeightGrid before = grid;
  make_void(grid, 20, 20, 6, 6);
  fill_voids(grid, 32);
  for (int row = 0; row < 50; ++row) {
    for (int column = 0; column < 50; ++column) {
      const bool inside = column >= 20 && column < 26 && row >= 20 && row < 26;
      EXPECT_NEAR(grid.at(column, row), before.at(column, row), inside ? 30 : 0);
    }
  }
}

// GDAL's fill over the whole grid.
HeightGrid filled_by_gdal(HeightGrid grid) {
  std::vector<unsigned char> valid;
  for (float& height : grid.heights_m) {
    valid.push_back(std::isnan(height) ? 0 : 255);
    if (std::isnan(height)) height = 0;
  }
  GDALAllRegister();
  GDALDriver& driver = *GetGDALDriverManager()->GetDriverByName("MEM");
  const GDALDatasetUniquePtr heights(
      driver.Create("", grid.columns, grid.rows, 1, GDT_Float32, nullptr));
  const GDALDatasetUniquePtr mask(driver.Create("", grid.columns, grid.rows, 1, GDT_Byte, nullptr));
  const auto transfer = [&](GDALDataset& dataset, GDALRWFlag flag, void* data, GDALDataType type) {
    EXPECT_EQ(dataset.GetRasterBand(1)->RasterIO(flag, 0, 0, grid.columns, grid.rows, data,
                                                 grid.columns, grid.rows, type, 0, 0, nullptr),
              CE_None);
  };
  transfer(*heights, GF_Write, grid.heights_m.data(), GDT_Float32);
  transfer(*mask, GF_Write, valid.data(), GDT_Byte);
  EXPECT_EQ(GDALFillNodata(heights->GetRasterBand(1), mask->GetRasterBand(1), kFillReach_posts, 0,
                           0, nullptr, nullptr, nullptr),
            CE_None);
  transfer(*heights, GF_Read, grid.heights_m.data(), GDT_Float32);
  return grid;
}

TEST(FillVoids, IsGdalsFillOfTheWholeGrid) {
  std::mt19937 random(7);
  const auto below = [&](unsigned limit) { return static_cast<int>(random() % limit); };
  for (int round = 0; round < 5; ++round) {
    HeightGrid grid = make_slope(300, 270);  // more than one block
    for (int i = 0; i < 150; ++i) {
      make_void(grid, 1 + below(285), 1 + below(255), 1 + below(12), 1 + below(12));
    }
    const HeightGrid expected = filled_by_gdal(grid);
    const std::size_t voids = count_voids(grid);
    const std::size_t filled = fill_voids(grid, 32);
    EXPECT_EQ(filled + count_voids(grid), voids);
    EXPECT_GT(filled, 0U);
    for (std::size_t i = 0; i < grid.heights_m.size(); ++i) {
      if (std::isnan(grid.heights_m[i])) continue;
      EXPECT_EQ(grid.heights_m[i], expected.heights_m[i]);
    }
  }
}

TEST(FillVoids, AGridWithoutHeightsStaysEmpty) {
  HeightGrid grid{10, 10, std::vector<float>(100, kVoid)};
  EXPECT_EQ(fill_voids(grid, 32), 0U);
  EXPECT_EQ(count_voids(grid), 100U);
}

}  // namespace
}  // namespace terrview
