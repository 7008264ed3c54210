#include "cli/batch/shared_palette.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <glm/common.hpp>

#include "cli/camera_json.h"
#include "cli/output_file.h"
#include "cli/palette_file.h"
#include "cli/palette_picture.h"
#include "cli/read_file.h"
#include "cli/view_command.h"
#include "render/write_file.h"
#include "terrain/error.h"

namespace terrview {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostJobs = 32;
constexpr double kWidest_px = 320;

ViewOptions small_view(ViewOptions options, int threads) {
  const glm::ivec2 size_px = options.size_px.value_or(ResolvedView{}.size_px);
  const double scale =
      std::min(1.0, kWidest_px / (options.crop ? options.crop->size_px.x : size_px.x));
  const auto small = [&](glm::ivec2 px) { return glm::ivec2(scale * glm::dvec2(px)); };
  const glm::ivec2 whole_px = glm::max(glm::ivec2(1), small(size_px));
  options.size_px = whole_px;
  if (options.crop) {
    const glm::ivec2 first_px = glm::min(small(options.crop->first_px), whole_px - 1);
    const glm::ivec2 room_px = whole_px - first_px;
    options.crop = {first_px, glm::clamp(small(options.crop->size_px), glm::ivec2(1), room_px)};
  }
  options.quiet = true;
  options.threads = threads;
  return options;
}

}  // namespace

std::vector<const Job*> palette_jobs(const std::vector<Job>& jobs) {
  std::vector<const Job*> good;
  for (const Job& job : jobs)
    if (job.error.empty()) good.push_back(&job);
  const std::size_t count = std::min(good.size(), kMostJobs);
  std::vector<const Job*> chosen;
  for (std::size_t i = 0; i < count; ++i)
    chosen.push_back(good[(2 * i + 1) * good.size() / (2 * count)]);
  return chosen;
}

Palette make_shared_palette(const std::vector<const Job*>& jobs, const std::vector<Dem>& dems,
                            int threads) {
  SharedInputs inputs;
  ColorCounts counts;
  std::string error = "no row of the table is good";
  for (const Job* job : jobs) {
    try {
      count_colors(make_image(small_view(job->options, threads), dems, inputs), counts);
    } catch (const InputError& said) {
      error = said.what();
    }
  }
  if (counts.empty()) throw InputError("--shared-palette: there is no picture: " + error);
  return choose_palette(counts, jobs.front()->options.palette, /*has_nodata=*/false).palette;
}

void save_shared_palette(const Palette& palette, const std::string& path,
                         const std::string& own_path, bool replaces) {
  const std::string text = palette_text(palette, path);
  std::error_code ignored;
  if (!replaces && fs::exists(path, ignored)) {
    if (read_file(path) == text) return;
    throw InputError("'" + path +
                     "': is another palette: give --overwrite, or --resume to keep it");
  }
  OutputFile file(own_path, /*overwrite=*/true);
  file.fill([&](const std::string& temporary) { write_file(temporary, text); });
  file.commit();
  fs::rename(own_path, path);
}

}  // namespace terrview
