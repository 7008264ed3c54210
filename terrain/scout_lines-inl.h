// The lines that scouts walk along, in single precision. Included once for every instruction set.
#if defined(TERRVIEW_TERRAIN_SCOUT_LINES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TERRVIEW_TERRAIN_SCOUT_LINES_INL_H_
#undef TERRVIEW_TERRAIN_SCOUT_LINES_INL_H_
#else
#define TERRVIEW_TERRAIN_SCOUT_LINES_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <glm/common.hpp>
#include <glm/mat2x2.hpp>

#include "terrain/eye_tracks.h"
#include "terrain/scout_walk-inl.h"
#include "terrain/vec_inline.h"
#include "terrain/vector_masks-inl.h"
#include "terrain/vector_sectors-inl.h"
#include "terrain/vector_tracks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {

// Straight ones, over an affine map.
template <Ground kGround>
class ScoutLines {
 public:
  using Walker = ScoutWalk<kGround>;
  using VF = typename Walker::VF;
  using F = typename Walker::F;

  explicit ScoutLines(const Terrain& terrain) : jacobian_(*terrain.layers()[0].map->linear()) {}

  [[nodiscard]] double posts_per_m() const {
    return std::max(std::abs(jacobian_[0][0]) + std::abs(jacobian_[1][0]),
                    std::abs(jacobian_[0][1]) + std::abs(jacobian_[1][1]));
  }

  // Sets the rates of lines.
  VEC_INLINE void lay(typename Walker::Walk& w, VF x, VF y) const {
    w.rate_u = of(jacobian_[0][0]) * x + of(jacobian_[1][0]) * y;
    w.rate_v = of(jacobian_[0][1]) * x + of(jacobian_[1][1]) * y;
    w.metres_u = of(1) / w.rate_u;
    w.metres_v = of(1) / w.rate_v;
  }

 private:
  static VEC_INLINE VF of(double x) { return hn::Set(F(), static_cast<float>(x)); }

  const glm::dmat2& jacobian_;
};

// The pieces of bent ones.
template <>
class ScoutLines<Ground::bent> {
 public:
  using Walker = ScoutWalk<Ground::bent>;
  using F = Walker::F;
  using I = Walker::I;
  using VF = Walker::VF;
  using VI = Walker::VI;
  using MF = Walker::MF;

  explicit ScoutLines(const Terrain& terrain) : tracks_(*terrain.layers()[0].map->eye_tracks()) {
    const glm::dvec2 eye_uv = tracks_.eye_uv();
    eye_ = eye_uv - glm::floor(eye_uv);
  }

  [[nodiscard]] double posts_per_m() const { return tracks_.posts_per_m(); }
  [[nodiscard]] int pieces() const { return tracks_.pieces(); }

  // The pieces that distances lie on.
  VEC_INLINE VI piece_at(VF g) const {
    return hn::ConvertTo(I(), pieces_at(F(), tracks_.knots_m(), g));
  }

  // The first pieces of the tracks of directions.
  VEC_INLINE VI first_piece(VF x, VF y) const {
    return hn::ConvertTo(I(), sectors_of(F(), x, y, tracks_.sectors_a_side())) *
           hn::Set(I(), tracks_.pieces());
  }

  // Loads pieces, counted from first ones; of other lanes than `lanes`, any.
  VEC_INLINE void lay(Walker::Walk& w, VF x, VF y, VI first_piece, VI piece, MF lanes) const {
    const std::uint32_t wanted = mask_bits(F(), lanes);
    const auto line = shared_rows<EyeTracks::kCoefficients>(
        F(), tracks_.lines().data(), EyeTracks::kCoefficients, first_piece + piece, wanted);
    w.base_u = of(eye_.x) + (line[0] * x + line[1] * y);
    w.base_v = of(eye_.y) + (line[2] * x + line[3] * y);
    w.rate_u = line[4] * x + line[5] * y;
    w.rate_v = line[6] * x + line[7] * y;
    w.metres_u = hn::Set(F(), 1.0F) / w.rate_u;
    w.metres_v = hn::Set(F(), 1.0F) / w.rate_v;
    w.end = shared_rows<1>(F(), tracks_.near_knots_m().data() + 1, 1, piece, wanted)[0];
  }

 private:
  static VEC_INLINE VF of(double x) { return hn::Set(F(), static_cast<float>(x)); }

  const EyeTracks& tracks_;
  glm::dvec2 eye_;
};

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#endif
