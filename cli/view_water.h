// The water of a view.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/view_options.h"
#include "ingest/water_file.h"
#include "render/painted_sky.h"
#include "render/water.h"

namespace terrview {

void add_water_options(CommandLine& app, WaterOptions& options);

[[nodiscard]] bool has_water(const WaterOptions& options);

// Throws InputError for options that need others.
void check_water(const WaterOptions& options);

struct LaidWater {
  std::optional<FloodedDems> lakes;   // none: no file
  std::vector<std::string> messages;  // what became of the file's features, a line each
};

// Lays the lakes of the file, if there is one, into the DEMs. Throws InputError.
[[nodiscard]] LaidWater lay_water(const WaterOptions& options, const std::vector<Dem>& dems);

// The water of `scene`, which is whole but for it. Where it `mirrors`, `mirrored_sky` is what
// PaintedSky::mirrored() makes, and InputError is thrown if the eye is under water; else it shows
// its body alone, as maps do.
[[nodiscard]] std::shared_ptr<const Water> make_water(
    const WaterOptions& options, const LaidWater& laid, const Scene& scene, bool mirrors,
    const std::shared_ptr<const PaintedSky>& mirrored_sky);

}  // namespace terrview
