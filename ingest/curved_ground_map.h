// The ground map of a DEM on the curved Earth: fast, and as exact as its patches.
//
// Inside a disc around the grid the map is that of a PatchTree; outside, where no post lies, it is
// carried on along the radii of the disc. It is built by one thread and then immutable: neither
// PROJ nor GeographicLib is called by its functions.
#pragma once

#include <optional>
#include <span>

#include "ingest/ground_disc.h"
#include "ingest/patch_tree.h"
#include "terrain/eye_tracks.h"
#include "terrain/ground_map.h"

namespace terrview {

class CurvedGroundMap final : public GroundMap {
 public:
  // `reach_m` as GroundMap::reach_m(). Throws InputError where the map is too sharply bent.
  CurvedGroundMap(const ExactGroundMap& exact, glm::ivec2 grid_size, const GroundDisc& disc,
                  double reach_m);

  [[nodiscard]] glm::dvec2 to_grid(glm::dvec2 ground_m) const override;
  [[nodiscard]] glm::dmat2 jacobian(glm::dvec2 ground_m) const override;
  void places(const GroundPoints& points, const Places& found) const override;
  void jacobians(const GroundPoints& points, const Jacobians& found) const override;
  [[nodiscard]] double piece_end_m(const GroundLine& line, double from_m,
                                   double limit_m) const override;
  void piece_ends_m(const GroundLines& lines, const Stretches& stretches,
                    std::span<double> ends_m) const override;
  [[nodiscard]] double distance_from_grid(const GroundLine& line, double from_m,
                                          double to_m) const override;
  [[nodiscard]] double reach_m() const override { return reach_m_; }
  [[nodiscard]] double reach_m(glm::dvec2 direction) const override;

  [[nodiscard]] const EyeTracks* eye_tracks() const override {
    return tracks_ ? &*tracks_ : nullptr;
  }

  [[nodiscard]] const PatchTree& patches() const { return patches_; }

 private:
  [[nodiscard]] double end_inside(const GroundLine& line, double from_m, double limit_m) const;
  [[nodiscard]] double end_outside(const GroundLine& line, double from_m, double limit_m) const;
  [[nodiscard]] double chord_excess(const GroundLine& line, double from_m, double to_m) const;

  glm::dvec2 last_post_;
  GroundDisc disc_;
  double reach_m_;
  PatchTree patches_;
  glm::dvec2 centre_uv_;
  double piece_error_cells_;         // what the patches and the table leave of kTrackError_cells
  std::optional<EyeTracks> tracks_;  // where the eye is in the disc
};

}  // namespace terrview
