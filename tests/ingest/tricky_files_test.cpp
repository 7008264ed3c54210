// Every odd or broken file of the shared test data: what it must give, and why.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "terrain/error.h"
#include "tests/ingest/test_raster.h"

namespace terrview {
namespace {

struct Expectation {
  std::string file;
  std::string why;
  std::string refusal;  // part of the message; empty = it is read
  glm::ivec2 size{64, 64};
  float lowest_m = 558;
  float highest_m = 1413;
  std::size_t voids_filled = 0;
  std::size_t voids_open = 0;
  std::string warning;  // part of the only one; empty = none
  DemOptions options;

  Expectation with(const DemOptions& given) const {
    Expectation other = *this;
    other.options = given;
    return other;
  }

  Expectation warned(const std::string& part) const {
    Expectation other = *this;
    other.warning = part;
    return other;
  }

  friend std::ostream& operator<<(std::ostream& out, const Expectation& e) {
    return out << e.file << ": " << e.why;
  }
};

// The heights of base.tif, some of them filled in.
Expectation like_base(const char* variant, const char* why, std::size_t voids_filled = 0) {
  Expectation expectation;
  expectation.file = std::string("made_from_vosges/") + variant;
  expectation.why = why;
  expectation.voids_filled = voids_filled;
  return expectation;
}

Expectation refused(const char* file, const char* why, const char* message) {
  Expectation expectation;
  expectation.file = file;
  expectation.why = why;
  expectation.refusal = message;
  return expectation;
}

struct Heights {
  glm::ivec2 size;
  double lowest_m;
  double highest_m;
  std::size_t voids_open = 0;
};

Expectation other(const char* file, const char* why, const Heights& heights) {
  Expectation expectation;
  expectation.file = file;
  expectation.why = why;
  expectation.size = heights.size;
  expectation.lowest_m = static_cast<float>(heights.lowest_m);
  expectation.highest_m = static_cast<float>(heights.highest_m);
  expectation.voids_open = heights.voids_open;
  return expectation;
}

DemOptions in_degrees() {
  DemOptions options;
  options.crs = "EPSG:4326";
  return options;
}

DemOptions in_feet() {
  DemOptions options;
  options.height_unit = "ft";
  return options;
}

DemOptions with_spacing() {
  DemOptions options;
  options.spacing = glm::dvec2(62, 92.7);
  return options;
}

std::vector<Expectation> expectations_of_variants() {
  return {
      // Conventions that change nothing.
      like_base("base.tif", "the plain file"),
      like_base("aaigrid_float.asc", "ESRI ASCII grid with a .prj"),
      like_base("bigtiff_be_tiled_lzw.tif", "big-endian tiled BigTIFF"),
      like_base("east_west_flipped.tif", "columns from east to west"),
      like_base("ehdr_float.flt", "EHdr"),
      like_base("envi.img", "ENVI"),
      like_base("float32_nan_nodata.tif", "nodata is NaN"),
      like_base("float64.tif", "Float64"),
      like_base("int32_nodata_min.tif", "Int32"),
      like_base("netcdf.nc", "netCDF"),
      like_base("offset_int16.tif", "an offset of 1000"),
      like_base("pixelispoint.tif", "pixel is point"),
      like_base("rotated30.tif", "rotated rows and columns"),
      like_base("scaled_uint16_dm.tif", "a scale of 0.1"),
      like_base("south_up.tif", "rows from south to north"),
      like_base("three_bands.tif", "the first of three bands"),
      like_base("feet_unit_tagged.tif", "the unit says feet"),
      like_base("feet_float32.tif", "the user says feet").with(in_feet()),
      // Elsewhere on the Earth.
      like_base("antimeridian.tif", "longitudes beyond 180"),
      like_base("near_pole.tif", "latitudes short of 90"),
      // Other numbers.
      other("made_from_vosges/byte_relief.tif", "bytes are as good", {{64, 64}, 95, 240}),
      other("made_from_vosges/two_by_two.tif", "the smallest ground", {{2, 2}, 776, 835}),
      // Holes.
      like_base("hole.tif", "a declared void of 20 x 20", 400),
      like_base("hole_undeclared_nodata.tif", "an undeclared one", 400).warned("--nodata -32768"),
      like_base("float_inf_nan_no_nodata.tif", "no heights", 3),
      like_base("spike_1e30.tif", "no height either", 1).warned("1e+30 m at column 10, row 10"),
      refused("made_from_vosges/all_nodata.tif", "nothing to see", "--nodata"),
      // Not enough said.
      refused("made_from_vosges/no_crs.tif", "degrees without a CRS", "--a-srs EPSG:4326"),
      like_base("no_crs.tif", "the user says which").with(in_degrees()),
      refused("made_from_vosges/no_georef.tif", "no place at all", "--spacing"),
      like_base("no_georef.tif", "the user gives one").with(with_spacing()),
      refused("made_from_vosges/xyz16.xyz", "degrees without a CRS", "--a-srs EPSG:4326"),
      other("made_from_vosges/xyz16.xyz", "the user says which", {{16, 16}, 615, 1012})
          .with(in_degrees()),
      // Too little in them.
      refused("made_from_vosges/empty.tif", "no byte", "empty"),
      refused("made_from_vosges/one_col.tif", "no ground between posts", "2 x 2"),
      refused("made_from_vosges/one_pixel.tif", "no ground between posts", "2 x 2"),
      refused("made_from_vosges/one_row.tif", "no ground between posts", "2 x 2"),
      refused("made_from_vosges/truncated.tif", "broken off", "read to its end"),
      refused("made_from_vosges/truncated.asc", "broken off", "read to its end").with(in_degrees()),
  };
}

std::vector<Expectation> expectations_of_drivers() {
  return {
      // ASCII grids.
      other("gdrivers/aaigrid/byte.tif.grd", "another ending", {{20, 20}, 74, 255}),
      other("gdrivers/aaigrid/case_sensitive.ASC", "capital endings", {{15, 12}, 0, 3450}),
      other("gdrivers/aaigrid/float64.asc", "nodata with twelve decimals, all but one post",
            {{5, 5}, 1.2345678, 1.2345678, 24}),
      other("gdrivers/aaigrid/nodata_float.asc", "nodata not met", {{5, 5}, 107, 156}),
      other("gdrivers/aaigrid/nodata_int.asc", "nodata not met", {{5, 5}, 107, 156}),
      refused("gdrivers/aaigrid/nodata_nan.asc", "GDAL loses a row with nan first", "convert it"),
      refused("gdrivers/aaigrid/starting_with_nan.asc", "GDAL finds no numbers", "convert it"),
      refused("gdrivers/aaigrid/nonsquare.vrt", "its source is missing", "small.raw"),
      other("gdrivers/aaigrid/pixel_per_line.asc", "one number a line", {{15, 12}, 0, 3450}),
      other("gdrivers/aaigrid/pixel_per_line_comma.asc", "decimal commas", {{15, 12}, 0, 3450}),
      // DTED.
      other("gdrivers/dted/n43_bad_crc.dt0", "checksums do not matter", {{121, 121}, 75, 460}),
      refused("gdrivers/dted/n43_coord_inverted.dt0", "broken off", "read to its end"),
      other("gdrivers/dted/n43_partial_cols.dt0", "two columns", {{121, 121}, 0, 0, 14399}),
      other("gdrivers/dted/n43_sparse_cols.dt0", "two columns", {{121, 121}, 0, 0, 14399}),
      other("gdrivers/dted/n43_wgs72.dt0", "an old datum, which GDAL doubts", {{121, 121}, 75, 460})
          .warned("WGS72"),
      refused("gdrivers/dted/w118n033_trunc.dt1", "broken off", "read to its end"),
      // EHdr.
      other("gdrivers/ehdr/ehdr11.flt", "two rows", {{321, 2}, 70.26, 71.34}),
      other("gdrivers/ehdr/float32.bil", "NAD 27", {{20, 20}, -0.8392157, 2}),
      refused("gdrivers/ehdr/truncated.bin", "broken off", "read to its end"),
      // Code.
      refused("gdrivers/vrt/n43_hillshade.vrt", "Python in a VRT", "never run"),
  };
}

class TrickyFile : public testing::TestWithParam<Expectation> {};

TEST_P(TrickyFile, GivesWhatTheTableSays) {
  const Expectation& expected = GetParam();
  NEEDS_SHARED_DATA();
  const std::string path = shared_data("tricky/" + expected.file);
  SCOPED_TRACE(expected.why);
  std::vector<Dem> dems;
  std::string refused;
  testing::internal::CaptureStderr();
  try {
    dems = read_dems({path}, expected.options);
  } catch (const InputError& error) {
    refused = error.what();
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  if (!expected.refusal.empty()) {
    EXPECT_TRUE(says(refused, {path, expected.refusal}));
    EXPECT_EQ(refused.find('\n'), std::string::npos);
    return;
  }
  ASSERT_EQ(refused, "");
  ASSERT_EQ(dems.size(), 1U);
  const Dem& dem = dems[0];
  EXPECT_EQ(glm::ivec2(dem.grid->columns, dem.grid->rows), expected.size);
  const HeightRange range = height_range(*dem.grid);
  EXPECT_NEAR(range.lowest_m, expected.lowest_m, 1e-3);
  EXPECT_NEAR(range.highest_m, expected.highest_m, 1e-3);
  EXPECT_EQ(dem.voids_filled, expected.voids_filled);
  EXPECT_EQ(dem.voids_open, expected.voids_open);
  ASSERT_EQ(dem.warnings.size(), expected.warning.empty() ? 0U : 1U);
  for (const std::string& warning : dem.warnings) {
    EXPECT_TRUE(says(warning, {path, expected.warning}));
  }
}

INSTANTIATE_TEST_SUITE_P(Variants, TrickyFile, testing::ValuesIn(expectations_of_variants()));
INSTANTIATE_TEST_SUITE_P(Drivers, TrickyFile, testing::ValuesIn(expectations_of_drivers()));

TEST(TrickyFiles, EachIsInTheTable) {
  NEEDS_SHARED_DATA();
  const std::string folder = shared_data("tricky");
  std::set<std::string> listed;
  for (const Expectation& expected : expectations_of_variants()) listed.insert(expected.file);
  for (const Expectation& expected : expectations_of_drivers()) listed.insert(expected.file);
  const std::set<std::string> beside{".prj", ".PRJ", ".hdr", ".xml", ".sh"};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || beside.contains(entry.path().extension().string())) continue;
    const std::string name = std::filesystem::relative(entry.path(), folder).string();
    EXPECT_TRUE(listed.contains(name)) << name;
  }
}

// A variant of made_from_vosges that says the same as base.tif.
struct Variant {
  const char* file;
  double tolerance_m;
  DemOptions options;

  friend std::ostream& operator<<(std::ostream& out, const Variant& v) { return out << v.file; }
};

class VariantOfBase : public testing::TestWithParam<Variant> {};

TEST_P(VariantOfBase, HasItsHeightsInItsPlaces) {
  const Variant& variant = GetParam();
  NEEDS_SHARED_DATA();
  const std::string folder = shared_data("tricky/made_from_vosges");
  const Dem base = read_one(folder + "/base.tif");
  const Dem dem = read_one(folder + "/" + variant.file, variant.options);
  ASSERT_EQ(dem.grid->heights_m.size(), base.grid->heights_m.size());
  for (std::size_t i = 0; i < base.grid->heights_m.size(); ++i) {
    EXPECT_NEAR(dem.grid->heights_m[i], base.grid->heights_m[i], variant.tolerance_m);
  }
  // Text formats keep twelve decimals of a degree.
  for (const glm::dvec2 post : {glm::dvec2(0, 0), {63, 0}, {0, 63}, {63, 63}}) {
    EXPECT_NEAR(dem.placement.at(post).x, base.placement.at(post).x, 1e-10);
    EXPECT_NEAR(dem.placement.at(post).y, base.placement.at(post).y, 1e-10);
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, VariantOfBase,
    testing::Values(Variant{"aaigrid_float.asc", 0, {}}, Variant{"bigtiff_be_tiled_lzw.tif", 0, {}},
                    Variant{"east_west_flipped.tif", 0, {}}, Variant{"ehdr_float.flt", 0, {}},
                    Variant{"envi.img", 0, {}}, Variant{"float32_nan_nodata.tif", 0, {}},
                    Variant{"float64.tif", 0, {}}, Variant{"int32_nodata_min.tif", 0, {}},
                    Variant{"netcdf.nc", 0, {}}, Variant{"offset_int16.tif", 0, {}},
                    Variant{"pixelispoint.tif", 0, {}}, Variant{"south_up.tif", 0, {}},
                    Variant{"three_bands.tif", 0, {}}, Variant{"no_crs.tif", 0, in_degrees()},
                    Variant{"scaled_uint16_dm.tif", 1e-3, {}},
                    Variant{"feet_unit_tagged.tif", 1e-3, {}},
                    Variant{"feet_float32.tif", 1e-3, in_feet()}));

}  // namespace
}  // namespace terrview
