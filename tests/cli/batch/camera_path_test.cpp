// Promises of cli/batch/spline.h and cli/batch/camera_path.h.
#include "cli/batch/camera_path.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "cli/batch/spline.h"
#include "cli/parse.h"
#include "terrain/error.h"
#include "tests/ingest/test_raster.h"
#include "tests/support/temporary_folder.h"

namespace terrview {
namespace {

std::vector<double> increasing(std::size_t count) {
  std::vector<double> knots{0};
  while (knots.size() < count) knots.push_back(knots.back() + *rc::gen::inRange(1, 50) / 8.0);
  return knots;
}

RC_GTEST_PROP(SplineProperty, GoesThroughItsValuesWithOneSlope, ()) {
  const auto knots = increasing(*rc::gen::inRange<std::size_t>(2, 9));
  std::vector<double> values;
  for (std::size_t i = 0; i < knots.size(); ++i) values.push_back(*rc::gen::inRange(-99, 99));
  const Spline spline(knots, values);
  constexpr double kStep = 1e-6;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    RC_ASSERT(spline.at(knots[i]) == values[i]);
    if (i == 0 || i + 1 == knots.size()) continue;
    const double before = (values[i] - spline.at(knots[i] - kStep)) / kStep;
    const double after = (spline.at(knots[i] + kStep) - values[i]) / kStep;
    RC_ASSERT(std::abs(before - after) < 0.1);
  }
}

RC_GTEST_PROP(SplineProperty, IsExactOnAParabola, ()) {
  const auto knots = increasing(*rc::gen::inRange<std::size_t>(3, 9));
  const double a = *rc::gen::inRange(-9, 9);
  const double b = *rc::gen::inRange(-9, 9);
  const auto parabola = [&](double t) { return a * t * t + b * t + 3; };
  std::vector<double> values;
  for (const double t : knots) values.push_back(parabola(t));
  const Spline spline(knots, values);
  for (int i = 0; i <= 100; ++i) {
    const double t = knots.back() * i / 100;
    RC_ASSERT(std::abs(spline.at(t) - parabola(t)) < 1e-9 * (1 + std::abs(parabola(t))));
  }
}

RC_GTEST_PROP(SplineProperty, ThatIsMonotoneStaysBetweenNeighboursWithOneSlope, ()) {
  const auto knots = increasing(*rc::gen::inRange<std::size_t>(2, 9));
  std::vector<double> values;
  for (std::size_t i = 0; i < knots.size(); ++i) values.push_back(*rc::gen::inRange(0, 9));
  const Spline spline(knots, values, Spline::Shape::monotone);
  constexpr double kStep = 1e-6;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const auto [low, high] = std::minmax(values[i], values[i + 1]);
    for (double x = 0; x <= 1; x += 1.0 / 64) {
      const double value = spline.at(knots[i] + x * (knots[i + 1] - knots[i]));
      RC_ASSERT(value >= low - 1e-12 && value <= high + 1e-12);
    }
    if (i == 0) continue;
    const double before = (values[i] - spline.at(knots[i] - kStep)) / kStep;
    const double after = (spline.at(knots[i] + kStep) - values[i]) / kStep;
    RC_ASSERT(std::abs(before - after) < 0.1);
  }
}

JobTable frames(const std::string& csv, const PathOptions& options = {.frames_per_s = 1}) {
  return frames_of_keyframes(parse_job_table(csv, "t"), options);
}

TEST(CameraPath, HasAFrameForEachStepOfTime) {
  const JobTable table = frames("time,eye,heading,sky\n0,\"48,7,+2\",10,1\n2,\"48.2,7,+4\",30,2\n");
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_EQ(table.rows[0].text("eye"), "48,7,+2");
  EXPECT_EQ(table.rows[1].text("eye"), "48.1,7,+3");
  EXPECT_EQ(table.rows[1].text("heading"), "20");
  EXPECT_EQ(table.rows[1].text("sky"), "1");
  EXPECT_EQ(table.rows[2].text("sky"), "2");
  EXPECT_EQ(frames("time,eye\n0,\"48,7,2\"\n2,\"49,7,2\"\n", {.frames_per_s = 25}).rows.size(),
            51U);
}

TEST(CameraPath, CountsFramesFromOne) {
  const JobTable table = frames("frame,fov\n1,60\n11,20\n", {.frames_per_s = 24});
  ASSERT_EQ(table.rows.size(), 11U);
  EXPECT_EQ(table.rows[10].text("fov"), "20");
}

TEST(CameraPath, TurnsTheShorterWay) {
  const JobTable table = frames("time,heading,eye\n0,350,\"0,179,1\"\n2,20,\"0,-179,1\"\n");
  EXPECT_NEAR(parse_number("", table.rows[1].text("heading")), 5, 1e-9);
  EXPECT_NEAR(std::abs(parse_eye(table.rows[1].text("eye")).geographic->longitude_deg), 180, 1e-9);
}

TEST(CameraPath, StaysOverTheGroundBetweenKeyframesThatDo) {
  const JobTable table =
      frames("time,eye\n0,\"48,7,+300\"\n2,\"48,7,+0\"\n4,\"48,7,+0\"\n6,\"48,7,+300\"\n",
             {.frames_per_s = 8});
  ASSERT_EQ(table.rows.size(), 49U);
  for (const JobRow& row : table.rows) EXPECT_GE(parse_eye(row.text("eye")).height_m, 0);
  EXPECT_EQ(table.rows[24].text("eye"), "48,7,+0");
}

TEST(CameraPath, OfOneKeyframeLastsForTheDuration) {
  const JobTable table = frames("time,fov\n5,60\n", {.frames_per_s = 2, .duration_s = 3.0});
  ASSERT_EQ(table.rows.size(), 7U);
  EXPECT_EQ(table.rows[6].text("fov"), "60");
}

TEST(CameraPath, StretchesToADuration) {
  EXPECT_EQ(frames("time,fov\n5,60\n6,20\n", {.frames_per_s = 10, .duration_s = 3.0}).rows.size(),
            31U);
}

TEST(CameraPath, ThatCannotBeIsRefused) {
  for (const std::string text :
       {"time,fov\n1,60\n1,20\n", "fov\n60\n", "time,frame,fov\n1,1,60\n", "time,fov\nx,60\n",
        "time,eye\n0,\"48,7,+2\"\n1,\"48,7,900\"\n", "time,fov\n0,wide\n",
        "time,fov\n0,60\n1e9,20\n", "time,look-at\n0,\"48,7\"\n1,\"48,7,900\"\n"})
    EXPECT_THROW(static_cast<void>(frames(text)), InputError) << text;
}

class GpxPath : public testing::Test {
 protected:
  // A hundredth of a degree to the north in 24 minutes, then to the east in 16, from the equator.
  void write_track(bool timed) const {
    std::string text =
        "<?xml version=\"1.0\"?>\n<gpx version=\"1.1\" "
        "xmlns=\"http://www.topografix.com/GPX/1/1\"><trk><trkseg>";
    const auto add = [&](double latitude, double longitude, int minute) {
      text += "<trkpt lat=\"" + std::to_string(latitude) + "\" lon=\"" + std::to_string(longitude) +
              "\"><ele>500</ele>";
      if (timed) text += "<time>2026-06-21T10:" + std::to_string(minute) + ":00Z</time>";
      text += "</trkpt>";
    };
    for (int i = 0; i <= 4; ++i) add(0.0025 * i, 7, 10 + 6 * i);
    for (int i = 0; i <= 4; ++i) add(0.01, 7 + 0.0025 * i, 34 + 4 * i);
    write_text(folder_ / "t.gpx", text + "</trkseg></trk></gpx>\n");
  }

  [[nodiscard]] JobTable read(const PathOptions& options) const {
    return read_camera_path(folder_ / "t.gpx", options);
  }

  [[nodiscard]] static GeoPoint place(const JobRow& row) {
    return *parse_eye(row.text("eye")).geographic;
  }

  TemporaryFolder folder_;
};

TEST_F(GpxPath, TakesItsTimes) {
  write_track(true);
  const JobTable table = read({.frames_per_s = 1, .duration_s = 40.0, .lift_m = 5});
  ASSERT_EQ(table.rows.size(), 41U);
  EXPECT_NEAR(place(table.rows[24]).latitude_deg, 0.01, 1e-12);
  EXPECT_NEAR(place(table.rows[24]).longitude_deg, 7, 1e-12);
  EXPECT_NEAR(place(table.rows[40]).longitude_deg, 7.01, 1e-12);
  EXPECT_TRUE(table.rows[7].text("eye").ends_with(",+5"));
}

TEST_F(GpxPath, GoesAtASpeedAndLooksAhead) {
  write_track(false);
  const JobTable table = read({.frames_per_s = 1, .speed_m_per_s = 50.0});
  // 1105.7 m along the meridian at the equator and 1113.2 m along the parallel.
  ASSERT_EQ(table.rows.size(), 45U);
  EXPECT_NEAR(place(table.rows[11]).latitude_deg, 0.01 * 550 / 1105.7, 1e-5);
  EXPECT_NEAR(parse_number("", table.rows[0].text("heading")), 0, 5);
  EXPECT_NEAR(parse_number("", table.rows[40].text("heading")), 90, 10);
  EXPECT_EQ(read({.frames_per_s = 1, .aims = false}).rows[0].cells.count("heading"), 0U);
}

TEST_F(GpxPath, ThatIsNoneIsRefused) {
  write_text(folder_ / "t.gpx", "<gpx></gpx>");
  EXPECT_THROW(static_cast<void>(read({})), InputError);
  write_track(true);
  const std::string whole = read_text(folder_ / "t.gpx");
  write_text(folder_ / "t.gpx", whole.substr(0, whole.size() / 2));
  EXPECT_THROW(static_cast<void>(read({})), InputError);
}

}  // namespace
}  // namespace terrview
