#include "bench/file_to_png.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iomanip>
#include <numbers>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "cli/run.h"
#include "ingest/dem.h"

namespace terrview {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

double median_seconds(int repetitions, const std::function<void()>& act) {
  std::vector<double> seconds;
  for (int i = 0; i < repetitions; ++i) {
    const auto start = std::chrono::steady_clock::now();
    act();
    seconds.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
  std::nth_element(seconds.begin(), middle, seconds.end());
  return *middle;
}

template <class... Values>
std::string comma_list(Values... values) {
  std::ostringstream text;
  text << std::setprecision(17);
  const char* comma = "";
  ((text << std::exchange(comma, ",") << values), ...);
  return text.str();
}

std::vector<std::string> view_command(const PngTask& task, const std::string& png) {
  const PostPlacement placement = read_dems({task.path})[0].placement;
  const glm::dvec2 eye = placement.at(task.view.eye_uv);
  const CameraOptions& camera = task.view.camera.options();
  const glm::dvec3& sun = task.view.to_sun;
  return {"view",
          task.path,
          "--earth=flat",
          "--eye-xy=" + comma_list(eye.x, eye.y, task.view.eye_m.z),
          "--heading=" + comma_list(camera.heading_rad * kDegrees),
          "--pitch=" + comma_list(camera.pitch_rad * kDegrees),
          "--fov=" + comma_list(camera.fov_rad * kDegrees),
          "--size=" + std::to_string(camera.size_px.x) + "x" + std::to_string(camera.size_px.y),
          "--sun=" + comma_list(std::atan2(sun.x, sun.y) * kDegrees, std::asin(sun.z) * kDegrees),
          "--threads=" + std::to_string(task.threads),
          "--quiet",
          "--overwrite",
          "-o",
          png};
}

double command_seconds(const PngTask& task) {
  const std::string png = task.path + ".bench.png";
  const std::vector<std::string> command = view_command(task, png);
  const double seconds = median_seconds(task.repetitions, [&] {
    if (run(command) != 0) throw std::runtime_error("terrview view failed on " + task.path);
  });
  std::filesystem::remove(png);
  return seconds;
}

// The seconds and the rays of a frame with its shadows.
struct Rays {
  std::string contender;
  double seconds = 0;
  std::int64_t count = 0;
};

// Of the contenders of that name, or whose names begin with it where it ends in '-', the fastest.
std::optional<Rays> fastest_rays(const std::vector<BenchResult>& measured,
                                 const std::string& family, int threads) {
  std::vector<Rays> all;
  for (const BenchResult& result : measured) {
    const bool is_meant =
        family.ends_with('-') ? result.contender.starts_with(family) : result.contender == family;
    if (result.threads != threads || !is_meant) continue;
    auto found = std::find_if(all.begin(), all.end(),
                              [&](const Rays& rays) { return rays.contender == result.contender; });
    if (found == all.end()) found = all.insert(all.end(), {result.contender});
    found->seconds += static_cast<double>(result.ray_count) / (1e6 * result.mrays_per_s);
    found->count += result.ray_count;
  }
  const auto best = std::min_element(
      all.begin(), all.end(), [](const Rays& a, const Rays& b) { return a.seconds < b.seconds; });
  return best == all.end() ? std::nullopt : std::optional(*best);
}

}  // namespace

std::vector<BenchResult> file_to_png(const PngTask& task, const std::vector<Contender>& contenders,
                                     const std::vector<BenchResult>& measured) {
  std::vector<BenchResult> results;
  const auto add = [&](const Rays& rays, double seconds) {
    BenchResult result;
    result.dem = task.dem.name;
    result.view = task.view.name;
    result.rays = "file-to-png";
    result.contender = rays.contender;
    result.threads = task.threads;
    result.ray_count = rays.count;
    result.mrays_per_s = static_cast<double>(rays.count) / seconds / 1e6;
    result.seconds = seconds;
    results.push_back(std::move(result));
  };
  if (const auto rays = fastest_rays(measured, kDefaultWay, task.threads))
    add({kDefaultWay, 0, rays->count}, command_seconds(task));
  const double read_s =
      median_seconds(task.repetitions, [&] { static_cast<void>(read_dems({task.path})); });
  for (const char* family : {"embree-tri-", "embree-grid-"}) {
    const auto rays = fastest_rays(measured, family, task.threads);
    if (!rays) continue;
    const auto contender =
        std::find_if(contenders.begin(), contenders.end(),
                     [&](const Contender& each) { return each.name == rays->contender; });
    add(*rays, read_s + contender->ready_s.value_or(0) + rays->seconds);
  }
  return results;
}

}  // namespace terrview
