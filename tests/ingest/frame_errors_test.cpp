// One test per promise of ingest/frame_errors.h: what is wrong is seen.
#include "ingest/frame_errors.h"

#include <gtest/gtest.h>

#include "terrain/ground_map.h"
#include "tests/ingest/geodesy_cases.h"

namespace terrview {
namespace {

constexpr double kSight_m = 300e3;

const cases::GridCase kGrid{"geographic", "EPSG:4326", {6.3, 48.7},
                            1.0 / 300,    {400, 300},  {0.2, 0.8}};

class Errors : public testing::Test {
 protected:
  Errors()
      : crs_(cases::transform(kGrid)),
        eye_(cases::eye_point(kGrid, *crs_)),
        exact_(eye_, crs_, cases::placement(kGrid)),
        heights_(cases::hills(kGrid.posts, 3000)) {}

  [[nodiscard]] FrameErrors measure(const LaidGrid& laid, const VerticalFrame& frame) const {
    return measure_errors(laid, *heights_, eye_, frame, kSight_m);
  }

  std::shared_ptr<const CrsTransform> crs_;
  GeoPoint eye_;
  ExactGroundMap exact_;
  std::shared_ptr<const HeightGrid> heights_;
  // At 48 degrees north.
  VerticalFrame frame_{.eye_height_m = 4000,
                       .north_curvature_per_m = 1 / 6370850.0,
                       .east_curvature_per_m = 1 / 6389950.0};
};

TEST_F(Errors, AreSmallWhereAllIsRight) {
  const FrameErrors errors = measure(lay_grid(exact_, kGrid.posts, kSight_m)[0], frame_);
  EXPECT_LE(errors.track_cells, GroundMap::kTrackError_cells);
  EXPECT_LE(errors.direction_rad, GroundMap::kTrackError_rad + 2e-6);
}

TEST_F(Errors, ShowAFrameOfTheWrongRadius) {
  VerticalFrame wrong = frame_;
  wrong.north_curvature_per_m *= 1.1;
  wrong.east_curvature_per_m *= 1.1;
  const FrameErrors errors = measure(lay_grid(exact_, kGrid.posts, kSight_m)[0], wrong);
  // A tenth of s / (2 R), 115 km away.
  EXPECT_NEAR(errors.direction_rad, 0.1 * 115e3 / (2 * 6.37e6), 2e-4);
}

TEST_F(Errors, ShowAMapThatIsFlat) {
  const auto flat = std::make_shared<AffineGroundMap>(exact_.to_grid(glm::dvec2(0)),
                                                      exact_.jacobian(glm::dvec2(0)), kGrid.posts);
  const FrameErrors errors = measure({flat, exact_}, frame_);
  // A square of 100 km away to the north-east, meridians have drawn together by a fiftieth.
  EXPECT_GT(errors.track_cells, 3);
  EXPECT_GT(errors.direction_rad, 5e-3);
}

}  // namespace
}  // namespace terrview
