#include <cmath>
#include <optional>
#include <vector>

#include <glm/matrix.hpp>

#include "bench/light_study.h"
#include "bench/study_text.h"
#include "terrain/sky_view.h"

namespace terrview {
namespace {

constexpr int kReferenceRays = 8192;

// Blocks of neighbours, as a program that did all posts would take them, spread over the grid.
std::vector<glm::ivec2> chosen_posts(const HeightGrid& grid) {
  constexpr int kBlocks = 6;
  constexpr int kSide = 8;
  std::vector<glm::ivec2> posts;
  for (int block = 0; block < kBlocks * kBlocks; ++block) {
    const glm::ivec2 first((2 * (block % kBlocks) + 1) * (grid.columns - kSide) / (2 * kBlocks),
                           (2 * (block / kBlocks) + 1) * (grid.rows - kSide) / (2 * kBlocks));
    for (int i = 0; i < kSide * kSide; ++i)
      posts.push_back(first + glm::ivec2(i % kSide, i / kSide));
  }
  return posts;
}

double rms(const std::vector<double>& values, const std::vector<double>& expected) {
  double squares = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    squares += (values[i] - expected[i]) * (values[i] - expected[i]);
  return std::sqrt(squares / static_cast<double>(values.size()));
}

struct Measured {
  int number = 0;  // azimuths or rays
  double seconds = 0;
  double error = 0;
};

Measured measure_sweep(const BenchDem& dem, int azimuths, std::span<const glm::ivec2> posts,
                       const std::vector<double>& reference) {
  const double start_s = thread_seconds();
  SkyViewSweep sweep(*dem.grid, glm::inverse(dem.step_m), 1, azimuths);
  for (int step = 0; step < sweep.steps(); ++step) {
    for (int part = 0; part < sweep.parts(step); ++part) sweep.sweep(step, part);
  }
  const SkyView view = sweep.result();
  const double spent_s = thread_seconds() - start_s;
  std::vector<double> found;
  for (const glm::ivec2& post : posts) found.push_back(view.at(post));
  return {azimuths, spent_s, rms(found, reference)};
}

// The seconds at which rays have `error`, between two measured numbers of them; nullopt outside.
std::optional<double> seconds_at(const std::vector<Measured>& measured, double error) {
  for (std::size_t i = 1; i < measured.size(); ++i) {
    const Measured& few = measured[i - 1];
    const Measured& many = measured[i];
    if (error > few.error || error < many.error) continue;
    const double share = std::log(few.error / error) / std::log(few.error / many.error);
    return few.seconds * std::pow(many.seconds / few.seconds, share);
  }
  return std::nullopt;
}

}  // namespace

void print_sky_view_study(std::ostream& out, const BenchDem& dem) {
  const SkyTracer trace = embree_sky_tracer(dem);
  if (!trace) {
    print_line(out, "%s", "\nsky view: the build found no Embree to compare with");
    return;
  }
  const std::vector<glm::ivec2> posts = chosen_posts(*dem.grid);
  const std::vector<double> reference = trace(posts, kReferenceRays);
  const double all = static_cast<double>(dem.grid->heights_m.size());
  print_line(out, "\nsky view of %d x %d posts (%s), one thread; error beside %d rays at %zu posts",
             dem.grid->columns, dem.grid->rows, dem.name.c_str(), kReferenceRays, posts.size());
  std::vector<Measured> traced;
  for (const int rays : {16, 32, 64, 128, 256, 512, 1024, 2048}) {
    const double start_s = thread_seconds();
    const std::vector<double> found = trace(posts, rays);
    const double seconds = (thread_seconds() - start_s) * all / static_cast<double>(posts.size());
    traced.push_back({rays, seconds, rms(found, reference)});
    print_line(out, "  Embree, %4d rays a post %9.1f s (scaled from those posts), rms error %.4f",
               rays, seconds, traced.back().error);
  }
  for (const int azimuths : {16, 32, 64}) {
    const Measured sweep = measure_sweep(dem, azimuths, posts, reference);
    print_line(out, "  sweep, %3d azimuths     %9.1f s, rms error %.4f", azimuths, sweep.seconds,
               sweep.error);
    if (const auto equal_s = seconds_at(traced, sweep.error))
      print_line(out, "    Embree takes %.1f s for that error: %.1f times as long", *equal_s,
                 *equal_s / sweep.seconds);
  }
}

}  // namespace terrview
