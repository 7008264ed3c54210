// Footprints and trees as files have them: ingest/footprints.h.
#include "ingest/footprints.h"

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <cmath>
#include <string>
#include <vector>

#include "ingest/feature_attributes.h"
#include "terrain/error.h"
#include "tests/ingest/test_raster.h"

namespace terrview {
namespace {

const std::string kSquare =
    R"({"type":"Polygon","coordinates":[[[7,48],[7.001,48],[7.001,48.001],[7,48.001],[7,48]]]})";

std::string feature(const std::string& properties, const std::string& geometry = kSquare) {
  return R"({"type":"Feature","properties":{)" + properties + R"(},"geometry":)" + geometry + "}";
}

std::string collection(const std::vector<std::string>& features) {
  std::string text;
  for (const std::string& one : features) text += (text.empty() ? "" : ",") + one;
  return R"({"type":"FeatureCollection","features":[)" + text + "]}";
}

class Footprints : public testing::Test {
 protected:
  std::string write(const std::string& text) {
    write_text(folder_ / "f.geojson", text);
    return folder_ / "f.geojson";
  }
  FootprintFile read(const std::string& text, const FootprintOptions& options = {}) {
    return read_footprints(write(text), options);
  }
  // The message with which the file is refused; empty if it is not.
  std::string refused(const std::string& text) {
    try {
      static_cast<void>(read(text));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
};

TEST_F(Footprints, TakeTheirHeightsFromTheFirstFieldThatHasOne) {
  const FootprintFile file = read(collection(
      {feature(R"("height_m":7.5,"height":9)"), feature(R"("height_m":null,"height":"12 m")"),
       feature(R"("height":"30'")"), feature(R"("building:height":4.25)"),
       feature(R"("building_levels":"3")"), feature(R"("levels":2.5)"), feature(R"("height":0)"),
       feature(R"("height":"tall","levels":1)"), feature(R"("height":-3)"), feature("")}));
  const std::vector<std::optional<double>> expected{7.5, 12, 9.144, 4.25,         9,
                                                    7.5, {}, 3,     std::nullopt, std::nullopt};
  ASSERT_EQ(file.footprints.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(file.footprints[i].height_m.has_value(), expected[i].has_value()) << i;
    EXPECT_DOUBLE_EQ(file.footprints[i].height_m.value_or(0), expected[i].value_or(0)) << i;
    EXPECT_EQ(file.footprints[i].number, static_cast<int>(i) + 1);
  }
  EXPECT_EQ(file.unread_heights, 1);
}

TEST_F(Footprints, TakeTheirHeightsFromTheFieldNamed) {
  const FootprintFile file =
      read(collection({feature(R"("Eaves":8,"height":5)"), feature(R"("height":5,"levels":1)")}),
           {.height_field = "eaves", .color_field = {}});
  EXPECT_EQ(file.footprints[0].height_m, 8);
  EXPECT_EQ(file.footprints[1].height_m, 3);
}

TEST_F(Footprints, AreRefusedWithoutTheFieldNamed) {
  const std::string text = collection({feature(R"("height":5,"paint":null)")});
  EXPECT_EQ(read(text, {.height_field = "HEIGHT", .color_field = "paint"}).footprints.size(), 1U);
  for (const FootprintOptions& options :
       {FootprintOptions{.height_field = "hieght", .color_field = {}},
        FootprintOptions{.height_field = {}, .color_field = "300,0,0"}}) {
    try {
      static_cast<void>(read(text, options));
      ADD_FAILURE() << options.height_field << options.color_field;
    } catch (const InputError& error) {
      EXPECT_TRUE(says(error.what(), {options.height_field + options.color_field,
                                      "f.geojson': has no field", "give one of height, paint"}));
    }
  }
}

TEST_F(Footprints, HaveNoHeightWhereItsTextIsEmpty) {
  const FootprintFile file = read(collection({feature(R"("height_m":"","height":"7")")}));
  EXPECT_EQ(file.footprints[0].height_m, 7);
  EXPECT_EQ(file.unread_heights, 0);
}

TEST_F(Footprints, KeepEveryRingOfEveryPolygon) {
  const FootprintFile file = read(collection(
      {feature("", R"({"type":"MultiPolygon","coordinates":[
          [[[0,0],[9,0],[9,9],[0,0]],[[1,1],[1,2],[2,2],[1,1]]],[[[20,20],[21,20],[21,21],[20,20]]]]})"),
       feature(
           "",
           R"({"type":"GeometryCollection","geometries":[{"type":"Point","coordinates":[1,2]},)" +
               kSquare + "]}"),
       feature("", "null"), feature("", R"({"type":"Point","coordinates":[1,2]})")}));
  ASSERT_EQ(file.footprints.size(), 2U);
  ASSERT_EQ(file.footprints[0].polygons.size(), 2U);
  EXPECT_EQ(file.footprints[0].polygons[0].size(), 2U);
  EXPECT_EQ(file.footprints[0].polygons[0][1][1], glm::dvec2(1, 2));
  EXPECT_EQ(file.footprints[1].polygons.size(), 1U);
  EXPECT_EQ(file.without_polygon, 2);
  EXPECT_EQ(file.file.features, 4);
}

TEST_F(Footprints, KnowRoofsAndColours) {
  const FootprintFile file = read(collection(
      {feature(
           R"("roof:shape":"gabled","roof:height":"2.5","roof:direction":"WSW","roof:colour":"#f00")"),
       feature(R"("roof_shape":"hipped","roof:orientation":"across","building:colour":"white")"),
       feature(R"("roof:shape":"sawtooth")")}));
  EXPECT_EQ(file.footprints[0].roof, RoofShape::gabled);
  EXPECT_EQ(file.footprints[0].roof_height_m, 2.5);
  EXPECT_EQ(file.footprints[0].roof_azimuth_deg, 247.5);
  EXPECT_EQ(file.footprints[0].roof_color, glm::vec3(1, 0, 0));
  EXPECT_EQ(file.footprints[1].roof, RoofShape::hipped);
  EXPECT_TRUE(file.footprints[1].ridge_across);
  EXPECT_EQ(file.footprints[1].color, glm::vec3(1, 1, 1));
  EXPECT_EQ(file.footprints[2].roof, RoofShape::flat);
  EXPECT_EQ(file.unknown_roofs, 1);
}

TEST(FeatureAttributes, AreNothingButWhatTheySay) {
  EXPECT_EQ(length_of(" 3.5 m "), 3.5);
  for (const char* text : {"", "m", "nan", "inf", "1e999", "3 x", "1,5", "--2"})
    EXPECT_EQ(length_of(text), std::nullopt) << text;
  for (const char* text : {"", "#12", "#12345g", "1,2", "1,2,3,4", "256,0,0", "plaid"})
    EXPECT_EQ(color_of(text), std::nullopt) << text;
  EXPECT_EQ(color_of("255, 255, 255"), color_of("#ffffff"));
  EXPECT_EQ(azimuth_deg_of("90"), 90);
  EXPECT_EQ(azimuth_deg_of("up"), std::nullopt);
}

// A layer of one square of 10 m in UTM 32N, in OGR's own formats.
TEST_F(Footprints, AreReadInAnyFormatAndCoordinateSystem) {
  GDALAllRegister();
  for (const auto& [driver, name] :
       {std::pair("GPKG", "a.gpkg"), std::pair("ESRI Shapefile", "a.shp"),
        std::pair("FlatGeobuf", "a.fgb")}) {
    GDALDriver* found = GetGDALDriverManager()->GetDriverByName(driver);
    if (found == nullptr) continue;
    {
      const GDALDatasetUniquePtr file(
          found->Create((folder_ / name).c_str(), 0, 0, 0, GDT_Unknown, nullptr));
      OGRSpatialReference crs;
      crs.importFromEPSG(32632);
      OGRLayer* layer = file->CreateLayer("houses", &crs, wkbPolygon);
      OGRFieldDefn height("HEIGHT", OFTReal);
      layer->CreateField(&height);
      OGRFeature house(layer->GetLayerDefn());
      house.SetField("HEIGHT", 11.0);
      OGRGeometry* square = nullptr;
      const char* text = "POLYGON ((400000 5300000,400010 5300000,400010 5300010,400000 5300000))";
      OGRGeometryFactory::createFromWkt(&text, nullptr, &square);
      house.SetGeometryDirectly(square);
      ASSERT_EQ(layer->CreateFeature(&house), OGRERR_NONE);
    }
    const FootprintFile file = read_footprints(folder_ / name, {});
    ASSERT_EQ(file.footprints.size(), 1U) << driver;
    EXPECT_EQ(file.footprints[0].height_m, 11);
    EXPECT_EQ(file.footprints[0].polygons[0][0][0], glm::dvec2(400000, 5300000));
    EXPECT_FALSE(file.file.crs_wkt.empty());
    EXPECT_FALSE(file.file.geographic);
  }
}

TEST_F(Footprints, CutOffAnywhereAreRefused) {
  const std::string whole = collection({feature(R"("height":5,"name":"a")"), feature("")});
  ASSERT_EQ(refused(whole), "");
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const std::string message = refused(whole.substr(0, length));
    ASSERT_NE(message, "") << length;
    EXPECT_EQ(message.find('\n'), std::string::npos);
    EXPECT_NE(message.find("f.geojson"), std::string::npos);
  }
}

TEST_F(Footprints, ThatAreBrokenAreRefusedWithTheirFeature) {
  const auto polygon = [](const std::string& coordinates) {
    return R"({"type":"Polygon","coordinates":)" + coordinates + "}";
  };
  const std::string deep(5000, '[');
  for (const std::string& broken :
       {feature("", polygon("[[[NaN,48],[7.1,48],[7.1,48.1],[7,48]]]")),
        feature("", polygon("[[[1e308,48],[7.1,48],[7.1,48.1],[7,48]]]")),
        feature("", polygon("[[[1e999,48],[7.1,48],[7.1,48.1],[7,48]]]")),
        feature(R"("height":1e308)"), feature("", polygon(R"([[["7",48],[7.1,48],[7.1,48.1]]])")),
        feature("", polygon("[[7,48],[7.1,48],[7.1,48.1],[7,48]]")),
        feature("", polygon("[[[7],[7.1],[7.1],[7]]]")),
        feature("", polygon("[[[7,48],[7.1,48],[[7.1,48.1]]]]")), feature("", polygon("{}")),
        feature("", polygon("7")), feature("", polygon(deep)), feature("", R"({"type":"Poligon"})"),
        feature("", R"({"coordinates":[]})"), feature("", "[]"), feature("", "\"here\""),
        std::string("null"), std::string("7"), std::string("[]"), std::string("\"feature\"")}) {
    const std::string message = refused(collection({feature(""), broken}));
    EXPECT_NE(message.find("feature 2"), std::string::npos)
        << broken.substr(0, 120) << " -> " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
  for (const char* other : {"", "{}", "[]", "7", "not json", R"({"type":"FeatureCollection"})"})
    EXPECT_NE(refused(other), "") << other;
}

TEST_F(Footprints, MayHaveAMillionCorners) {
  std::string ring;
  constexpr int kCorners = 1000000;
  ring.reserve(kCorners * 24);
  for (int i = 0; i <= kCorners; ++i) {
    const double angle = 6.283185307179586 * (i % kCorners) / kCorners;
    char corner[64];
    std::snprintf(corner, sizeof corner, "%s[%.9f,%.9f]", i > 0 ? "," : "",
                  7 + 0.01 * std::cos(angle), 48 + 0.01 * std::sin(angle));
    ring += corner;
  }
  const FootprintFile file =
      read(collection({feature("", R"({"type":"Polygon","coordinates":[[)" + ring + "]]}")}));
  EXPECT_EQ(file.footprints.at(0).polygons[0][0].size(), kCorners + 1U);
}

TEST_F(Footprints, OfTreesArePoints) {
  const auto point = [](const std::string& properties) {
    return feature(properties, R"({"type":"Point","coordinates":[7,48]})");
  };
  const TreeFile file =
      read_trees(write(collection({point(R"("height":22,"diameter_crown":"9 m","min_height":3)"),
                                   feature(""), point(R"("height":"tall")")})));
  ASSERT_EQ(file.trees.size(), 2U);
  EXPECT_EQ(file.trees[0].height_m, 22);
  EXPECT_EQ(file.trees[0].crown_m, 9);
  EXPECT_EQ(file.trees[0].min_height_m, 3);
  EXPECT_EQ(file.trees[1].number, 3);
  EXPECT_EQ(file.without_point, 1);
  EXPECT_EQ(file.unread_heights, 1);
  for (const char* giant : {R"("height":2001)", R"("diameter_crown":2001)", R"("min_height":2001)"})
    EXPECT_THROW(static_cast<void>(read_trees(write(collection({point(giant)})))), InputError);
}

}  // namespace
}  // namespace terrview
