// One test per promise of cli/impact/building_sight.h, over a plain at 300 m.
#include "cli/impact/building_sight.h"

#include <cmath>

#include "cli/prepare_view.h"
#include "ingest/dem.h"
#include "tests/cli/small_view.h"

namespace terrview {
namespace {

// Of a rectangle `d` away, from the foot of its normal to a corner a by b away.
double quadrant_sr(double a, double b, double d) {
  return std::atan(a * b / (d * std::sqrt(a * a + b * b + d * d)));
}

class BuildingSights : public SmallView {
 protected:
  // A block 60 m wide and 40 m high, and one 90 m high behind it.
  BuildingSights() {
    write_text(path("b.geojson"), R"({"type":"FeatureCollection","features":[
      {"type":"Feature","properties":{"height":40},"geometry":{"type":"Polygon",
       "coordinates":[[[360,200],[420,200],[420,240],[360,240],[360,200]]]}},
      {"type":"Feature","properties":{"height":90},"geometry":{"type":"Polygon",
       "coordinates":[[[360,300],[420,300],[420,340],[360,340],[360,300]]]}}]})");
  }

  std::vector<BuildingSight> sights(const std::string& eye, std::int32_t before,
                                    const SightOptions& how = {},
                                    const std::string& size = "64x48") const {
    const ViewOptions options =
        parse_view(words("--eye-xy " + eye + " --heading 200 --size " + size + " --buildings " +
                         path("b.geojson") + " " + path("plain.asc")),
                   "test");
    const View view = make_view(options, read_dems(options.dems));
    return sights_of(view, before, how);
  }
};

TEST_F(BuildingSights, AreThoseOfItsFormWhateverThePicture) {
  const auto found = sights("390,50,320", 0);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].id, 1);
  EXPECT_EQ(found[1].id, 2);
  const double front_sr = 4 * quadrant_sr(30, 20, 150);
  EXPECT_NEAR(found[0].solid_angle_sr, front_sr, 0.01 * front_sr);
  // Behind the first one's top, which is 20 m over the eye.
  const double over_m = 250 * 20 / 150.0;
  const double above_sr = 2 * (quadrant_sr(30, 70, 250) - quadrant_sr(30, over_m, 250));
  const double whole_sr = 2 * (quadrant_sr(30, 70, 250) + quadrant_sr(30, 20, 250));
  EXPECT_NEAR(found[1].solid_angle_sr, above_sr, 0.01 * whole_sr);
  EXPECT_NEAR(found[1].facade.seen_m2, 60 * (70 - over_m), 0.01 * 60 * 90);
  const auto in_a_large_picture = sights("390,50,320", 0, {}, "400x300");
  EXPECT_EQ(in_a_large_picture[0].solid_angle_sr, found[0].solid_angle_sr);
}

TEST_F(BuildingSights, HaveTheirNearestAndFarthestPoints) {
  const BuildingSight front = sights("390,50,320", 0).front();
  EXPECT_NEAR(front.nearest->distance_m, 150, 0.1);
  EXPECT_NEAR(front.farthest->distance_m, std::sqrt(30 * 30 + 20 * 20 + 150 * 150), 0.3);
  EXPECT_NEAR(front.nearest->view_m.y, 150, 0.01);
  EXPECT_NEAR(std::abs(front.farthest->view_m.x), 30, 0.5);
}

TEST_F(BuildingSights, AroundTheEyeAreRightToo) {
  const BuildingSight wall = sights("390,198,310", 0).front();
  const double expected_sr = 2 * (quadrant_sr(30, 10, 2) + quadrant_sr(30, 30, 2));
  EXPECT_NEAR(wall.solid_angle_sr, expected_sr, 0.01 * expected_sr);
  EXPECT_NEAR(wall.nearest->distance_m, 2, 0.01);
}

TEST_F(BuildingSights, LeaveOutThoseThatStandAlready) {
  const auto found = sights("390,50,320", 1);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].id, 2);
}

TEST_F(BuildingSights, OfWhatIsHiddenAreNothing) {
  const auto found = sights("390,199,301.6", 1);
  EXPECT_EQ(found[0].solid_angle_sr, 0);
  EXPECT_FALSE(found[0].nearest);
  EXPECT_EQ(found[0].facade.seen_m2, 0);
  EXPECT_NEAR(found[0].facade.facing_m2, 60 * 90, 1e-6);
}

TEST_F(BuildingSights, AreTheSameForAnyNumberOfThreads) {
  const auto one = sights("380,50,320", 0, {.rays_across = 100, .threads = 1});
  const auto many = sights("380,50,320", 0, {.rays_across = 100, .threads = 7});
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].solid_angle_sr, many[i].solid_angle_sr);
    EXPECT_EQ(one[i].facade.seen_m2, many[i].facade.seen_m2);
  }
}

}  // namespace
}  // namespace terrview
