// Promises of cli/batch/batch_run.h; those of whole batches are in batch_test.cpp.
#include "cli/batch/batch_run.h"

#include <gtest/gtest.h>

namespace terrview {
namespace {

constexpr double kMebibyte = 1 << 20;

class ViewsInFlight : public testing::Test {
 protected:
  ViewsInFlight() {
    HeightGrid grid{1000, 1000, {}};
    dems_.resize(1);
    dems_[0].grid = std::make_shared<const HeightGrid>(std::move(grid));
    job_.options.size_px = {1000, 1000};
    job_.outputs = {"a.png"};
  }

  [[nodiscard]] int of(std::size_t jobs, int threads, double mebibytes) const {
    return views_in_flight(std::vector<const Job*>(jobs, &job_), dems_, threads,
                           mebibytes * kMebibyte);
  }

  std::vector<Dem> dems_;
  Job job_;
};

TEST_F(ViewsInFlight, AreOneAThreadOrFewerJobs) {
  EXPECT_EQ(of(100, 8, 1e6), 8);
  EXPECT_EQ(of(3, 8, 1e6), 3);
  EXPECT_EQ(of(0, 8, 1e6), 1);
}

TEST_F(ViewsInFlight, FitIntoTheMemory) {
  EXPECT_EQ(of(100, 8, 1), 1);
  int before = 1;
  for (double mebibytes = 100; mebibytes < 2000; mebibytes += 50) {
    const int views = of(100, 8, mebibytes);
    EXPECT_GE(views, before);
    EXPECT_TRUE(views == 1 || views * view_bytes(job_, dems_) < mebibytes * kMebibyte);
    before = views;
  }
  EXPECT_EQ(before, 8);
}

TEST_F(ViewsInFlight, CountLayersAndWhatTheLightNeeds) {
  const double plain = view_bytes(job_, dems_);
  Job layers = job_;
  layers.outputs.emplace_back("a.tif");
  EXPECT_GT(view_bytes(layers, dems_), 2 * plain);
  Job sky = job_;
  sky.options.light.sky_azimuths = 16;
  EXPECT_GT(view_bytes(sky, dems_), plain + 28e6);
  Job soft = job_;
  soft.options.light.soft_shadows = true;
  EXPECT_DOUBLE_EQ(view_bytes(soft, dems_), plain - 4e6);  // no map of the sun
}

TEST_F(ViewsInFlight, CountThePixelsThatAreMade) {
  Job part = job_;
  part.options.size_px = {20'000, 20'000};
  part.options.crop = PixelRect{{9000, 9000}, {1000, 1000}};
  EXPECT_EQ(view_bytes(part, dems_), view_bytes(job_, dems_));
  Job plan;
  plan.options.plan = true;
  const double of_posts = view_bytes(plan, dems_);
  EXPECT_GT(of_posts, 26e6);  // 26 a pixel, as measured
  dems_[0].placement = {{0, 0}, {{10, 0}, {0, -10}}};
  plan.options.resolution = glm::dvec2(1, 1);
  EXPECT_GT(view_bytes(plan, dems_), 70 * of_posts);
  plan.options.resolution = glm::dvec2(-1, 1);  // none
  EXPECT_LT(view_bytes(plan, dems_), of_posts);
}

}  // namespace
}  // namespace terrview
