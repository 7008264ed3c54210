#include "cli/overview_command.h"

#include <cstdio>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "cli/interrupt.h"
#include "cli/overview_block.h"
#include "cli/overview_furniture.h"
#include "cli/overview_options.h"
#include "cli/overview_sheets.h"
#include "cli/prepare_view.h"
#include "cli/progress.h"
#include "cli/view_command.h"
#include "cli/view_files.h"
#include "cli/view_ground.h"
#include "cli/view_light.h"
#include "cli/view_messages.h"

namespace terrview {
namespace {

Frame render_block(const OverviewOptions& options, const View& view) {
  ProgressBar bar("rendering", show_bar(options.view));
  return render(view.scene, view.camera,
                {.threads = options.view.threads,
                 .samples = options.view.sampling.samples,
                 .contrast = static_cast<float>(options.view.sampling.contrast),
                 .progress = [&](double share) {
                   check_interrupt();
                   bar.report(share);
                 }});
}

// With what stands about the block.
ImageFileOptions file_options(const OverviewOptions& options, const View& view) {
  ImageFileOptions file = image_options(options.view, view);
  std::string& text = file.metadata.at("terrview:view");
  auto json = nlohmann::ordered_json::parse(text);
  auto& block = json["block"] = {{"plain", options.plain}};
  if (!options.plain) {
    block["title"] = block_title(options);
    block["ticks"] = options.ticks == TickSystem::degrees ? "degrees" : "own";
    const std::string& font = options.view.labels.font;
    if (!font.empty()) block["font"] = std::filesystem::path(font).filename().string();
  }
  text = json.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace);
  return file;
}

int make_block_picture(OverviewOptions options) {
  check_light(options.view.light);
  check_ground_colors(options.view);
  check_z_scale(options.view);
  ViewFiles files(options.view);
  const std::vector<Dem> dems = read_with_bar(options.view);
  const BlockView block = make_block(options, dems);
  if (!options.view.quiet) {
    say_what_is_seen(dems, block.view);
    std::fprintf(stderr, "heights x %g, %.4g m a pixel\n", block.z_scale, block.m_per_px);
  }
  Frame frame = render_block(options, block.view);
  if (!options.plain) draw_furniture(options, dems, block, frame.image);
  files.image->fill([&](const std::string& path) {
    write_image(path, frame.image, file_options(options, block.view));
  });
  files.commit();
  if (!options.view.quiet) std::fprintf(stderr, "wrote %s\n", files.image->path().c_str());
  return 0;
}

}  // namespace

int run_overview(const std::vector<std::string>& args) {
  OverviewOptions options = parse_overview(args);
  if (!options.plan) return make_block_picture(std::move(options));
  prepare(options.view);
  if (options.in_sheets()) return make_sheets(std::move(options));
  return run_prepared_view(std::move(options.view));
}

}  // namespace terrview
