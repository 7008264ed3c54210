// The light of a view.
#pragma once

#include <optional>
#include <string>

#include "cli/view_options.h"
#include "ingest/crs_transform.h"
#include "render/scene.h"

namespace terrview {

// Throw InputError for what no sun and no air can be.
void check_light(const LightOptions& light);
void check_air(const AirOptions& air);

// Where an eye is, as far as the sun is concerned.
struct SunSeenFrom {
  std::optional<GeoPoint> place;  // none: nothing tells
  double height_m = 0;
};

// The sun of --sun or --time, or three in the afternoon on the longest day at the eye's latitude;
// for relief, a light from the north-west. Throws InputError for --time without a place.
[[nodiscard]] SunPosition resolve_sun(const LightOptions& light, const SunSeenFrom& eye);

[[nodiscard]] bool casts_shadows(const LightOptions& light);

// Sets the light and the sky of `scene`.
void set_light(const LightOptions& light, const SunPosition& sun, Scene& scene);

// Of air that no option tells of.
inline constexpr double kUsualVisibility_km = 60;

[[nodiscard]] Air make_air(const AirOptions& options);

}  // namespace terrview
