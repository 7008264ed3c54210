#include "cli/batch/batch_report.h"

#include <cstdio>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>

#include "cli/batch/output_template.h"
#include "cli/say_error.h"

namespace terrview {
namespace {

// One line for each reason.
void say_what_failed(const std::vector<FailedJob>& failed) {
  std::map<std::string, int> others;
  for (const FailedJob& one : failed) ++others[one.error];
  for (const FailedJob& one : failed) {
    const auto count = others.find(one.error);
    if (count == others.end()) continue;
    const std::string alike =
        count->second > 1 ? " (and " + std::to_string(count->second - 1) + " more)" : "";
    say_error(one.job->label() + alike + ": " + one.error);
    others.erase(count);
  }
}

// A word of a shell's command line.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

void say_how_to_film(const BatchOptions& options) {
  const std::string pattern = OutputTemplate("-o", options.view.output).numbered_pattern();
  if (pattern.empty()) return;
  std::fprintf(stderr,
               "ffmpeg -framerate %g -start_number 1 -i %s -c:v libx264 -pix_fmt yuv420p %s\n",
               options.moving.frames_per_s, quoted(pattern).c_str(),
               quoted(std::filesystem::path(options.path).stem().string() + ".mp4").c_str());
}

}  // namespace

int report_batch(const BatchOptions& options, const JobPlan& plan, const BatchOutcome& outcome,
                 ManifestFile& manifest) {
  say_what_failed(outcome.failed);
  if (!manifest.complete())
    throw std::runtime_error("'" + manifest.path() +
                             "': writing failed: make room, and go on with --resume");
  if (!options.view.quiet)
    std::fprintf(stderr, "%d of %zu views written, %zu failed, %d were up to date: %s\n",
                 outcome.done, plan.to_do.size(), outcome.failed.size(), plan.up_to_date,
                 manifest.path().c_str());
  if (!options.path.empty() && !options.view.quiet) say_how_to_film(options);
  if (outcome.interrupted) {
    say_error("interrupted: --resume does the other views");
    return 130;
  }
  constexpr int kSomeFailed = 3;
  return outcome.failed.empty() ? 0 : kSomeFailed;
}

}  // namespace terrview
