// The rays of a picture: which go through a pixel, and what they show.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/meet.h"
#include "render/pixel_tracer.h"
#include "render/render.h"
#include "render/shade.h"

namespace terrview {

// What is kept of a ray for the picture.
struct Sample {
  glm::vec3 color{0, 0, 0};
  // Infinite: nothing hit. NaN: not traced.
  float distance_m = std::numeric_limits<float>::quiet_NaN();

  [[nodiscard]] bool traced() const { return distance_m == distance_m; }
  [[nodiscard]] bool ground() const { return distance_m < std::numeric_limits<float>::infinity(); }
};

// What a ray from the eye shows.
struct Seen {
  std::int32_t id = PixelSample::kNothing;  // as PixelSample::object_id
  glm::dvec3 position_m{0, 0, 0};           // where it shows something
};

// Where in its pixel the ray `index` goes, both coordinates in [0, 1): the centre for 0, then the
// (0, 2)-sequence of van der Corput and Sobol', turned so that it begins there. The first four and
// the first sixteen have one in each of as many columns, rows and squares of the pixel.
[[nodiscard]] glm::dvec2 sample_offset(int index);

// Traces rays of one picture with all threads. What it returns does not depend on their number.
class Sampler {
 public:
  // References must outlive it.
  Sampler(const Scene& scene, const Camera& camera, const RenderOptions& options);

  // What is done with a pixel's ray: called once each, from any thread.
  using Take = std::function<void(glm::ivec2 pixel, const ShadedRay& shaded, const Seen& seen)>;
  // Whether a pixel is wanted; empty = all are.
  using Wanted = std::function<bool(glm::ivec2 pixel)>;

  // The rays `index` of every `step`-th wanted pixel, along rows and columns from the first. Adds
  // to the counts.
  void trace_lattice(int index, int step, const Wanted& wanted, const Take& take);

  // The rays through some points of the image, in order, on the calling thread.
  [[nodiscard]] std::vector<Sample> trace_points(std::span<const glm::dvec2> points_px,
                                                 RenderCounts& counts) const;

  // Of trace_lattice(), and what is added by hand.
  RenderCounts total;

  // Passes to come report their progress as this part of the whole.
  void set_progress(double from, double to);
  // From any thread: the share of the pass that is done.
  void report(double share) const;

  [[nodiscard]] int threads() const { return options_.threads; }
  [[nodiscard]] const Scene& scene() const { return scene_; }

 private:
  struct LatticeBlock {
    const Block& block;
    int step;
    bool is_known;  // its hits are those of centres_
  };
  // Puts objects before the ground, and shades what the rays meet. Adds to `counts`.
  std::vector<ShadedRay> shade_rays(std::span<const Ray> rays, RayHits& hits,
                                    RenderCounts& counts) const;
  [[nodiscard]] Seen seen(const RayHits& hits, std::size_t i) const;
  RenderCounts trace_block(const PixelTracer& tracer, const LatticeBlock& part,
                           const Wanted& wanted, const Take& take) const;

  const Scene& scene_;
  const Camera& camera_;
  const RenderOptions& options_;
  PixelWidth pixel_width_;
  std::unique_ptr<const EyeFront> front_;
  Raster<std::optional<Hit>> centres_;  // of Coherence::neighbours
  double progress_from_ = 0;
  double progress_to_ = 1;
};

}  // namespace terrview
