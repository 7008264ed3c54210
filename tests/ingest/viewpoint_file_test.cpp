// One test per promise of ingest/viewpoint_file.h.
#include "ingest/viewpoint_file.h"

#include <ogrsf_frmts.h>

#include "terrain/error.h"
#include "tests/ingest/test_raster.h"

namespace terrview {
namespace {

std::string collection(const std::string& features) {
  return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}

std::string point(const std::string& properties, const std::string& at = "7.5,48.25") {
  return R"({"type":"Feature","properties":)" + properties +
         R"(,"geometry":{"type":"Point","coordinates":[)" + at + "]}}";
}

class Viewpoints : public testing::Test {
 protected:
  Viewpoints() {
    utm_ = read_one(TestRaster{}.write(folder_ / "utm.tif"));
    TestRaster bare;
    bare.crs = "";
    bare_ = read_one(bare.write(folder_ / "bare.tif"));
  }

  ViewpointFile read(const std::string& features, const Dem& dem) const {
    write_text(folder_ / "v.geojson", collection(features));
    return read_viewpoints(folder_ / "v.geojson", dem);
  }

  std::string refused(const std::string& features) const {
    try {
      static_cast<void>(read(features, utm_));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
  Dem utm_;
  Dem bare_;
};

TEST_F(Viewpoints, AreReadWithTheirNamesHeightsAndOptions) {
  const auto found =
      read(point(R"({"name":"Bridge\nnorth","eye_height":"2.5","fov":40,"look_at":"48,7"})") + "," +
               point(R"({"id":7,"height":"6 ft","owner":"nobody","heading":0})", "8,48"),
           utm_)
          .viewpoints;
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].number, 1);
  EXPECT_EQ(found[0].name, "Bridge north");
  EXPECT_EQ(found[0].place, glm::dvec2(7.5, 48.25));
  EXPECT_EQ(found[0].eye_height_m, 2.5);
  EXPECT_EQ(found[0].options,
            (std::map<std::string, std::string>{{"fov", "40"}, {"look-at", "48,7"}}));
  EXPECT_EQ(found[1].name, "7");
  EXPECT_NEAR(*found[1].eye_height_m, 6 * 0.3048, 1e-9);
  EXPECT_EQ(found[1].options, (std::map<std::string, std::string>{{"heading", "0"}}));
}

// OGR makes dates of such texts, whose own text is no ISO 8601.
TEST_F(Viewpoints, KeepTheirTimesAndOffsetsInAnyFormat) {
  const std::string times[] = {"2026-06-21T15:00:00Z", "2026-06-21T15:00:30.250+05:45",
                               "2026-06-21T15:00:00-08:00", "2026-06-21T15:00:00"};
  std::string features;
  for (const std::string& time : times)
    features += (features.empty() ? "" : ",") + point(R"({"time":")" + time + R"("})");
  const auto times_of = [](const ViewpointFile& file) {
    std::vector<std::string> found;
    for (const Viewpoint& viewpoint : file.viewpoints)
      found.push_back(viewpoint.options.at("time"));
    return found;
  };
  EXPECT_EQ(times_of(read(features, utm_)),
            (std::vector<std::string>{"2026-06-21T15:00:00.000Z", "2026-06-21T15:00:30.250+05:45",
                                      "2026-06-21T15:00:00.000-08:00", "2026-06-21T15:00:00.000"}));

  const std::string first = point(R"({"time":"2026-06-21T15:00:00Z"})");
  write_text(folder_ / "z.geojson", collection(first));
  {
    const GDALDatasetUniquePtr from(
        GDALDataset::Open((folder_ / "z.geojson").c_str(), GDAL_OF_VECTOR));
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
    const GDALDatasetUniquePtr to(
        driver->Create((folder_ / "z.gpkg").c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    ASSERT_NE(to->CopyLayer(from->GetLayer(0), "z"), nullptr);
  }
  EXPECT_EQ(times_of(read_viewpoints(folder_ / "z.gpkg", utm_)),
            std::vector<std::string>{"2026-06-21T15:00:00.000Z"});
}

TEST_F(Viewpoints, OfAFileWithoutASystemAreInThatOfTheDem) {
  write_text(folder_ / "v.csv", "name,X,Y\nA,400100,5299900\n");
  write_text(folder_ / "v.vrt",
             "<OGRVRTDataSource><OGRVRTLayer name='v'><SrcDataSource>" + (folder_ / "v.csv") +
                 "</SrcDataSource><GeometryField encoding='PointFromColumns' x='X' y='Y'/>"
                 "</OGRVRTLayer></OGRVRTDataSource>");
  const Viewpoint in_utm = read_viewpoints(folder_ / "v.vrt", utm_).viewpoints.at(0);
  EXPECT_NEAR(in_utm.place.x, 7.66, 0.01) << "a longitude";
  EXPECT_NEAR(in_utm.place.y, 47.84, 0.01);
  EXPECT_FALSE(in_utm.eye_height_m);
  const Viewpoint flat = read_viewpoints(folder_ / "v.vrt", bare_).viewpoints.at(0);
  EXPECT_EQ(flat.place, glm::dvec2(400100, 5299900));
}

TEST_F(Viewpoints, ThatCannotBeAreRefused) {
  EXPECT_NE(refused("").find("has no features"), std::string::npos);
  EXPECT_NE(refused(R"({"type":"Feature","properties":{},"geometry":null})").find("is no point"),
            std::string::npos);
  EXPECT_NE(refused(point(R"({"height":"tall"})")).find("eye height 'tall'"), std::string::npos);
  EXPECT_NE(refused(point(R"({"eye_height":-1})")).find("above the ground"), std::string::npos);
  EXPECT_NE(refused(point("{}", "7,95")).find("nowhere on the Earth"), std::string::npos);
}

}  // namespace
}  // namespace terrview
