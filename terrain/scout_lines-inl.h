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
#include <vector>

#include <glm/common.hpp>
#include <glm/mat2x2.hpp>

#include "terrain/eye_tracks.h"
#include "terrain/scout_walk-inl.h"
#include "terrain/vec_inline.h"
#include "terrain/vector_sectors-inl.h"

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
    const std::vector<double>& knots_m = tracks_.knots_m();
    VI piece = hn::Zero(I());
    for (std::size_t i = 1; i + 1 < knots_m.size(); ++i)
      piece = piece + hn::IfThenElseZero(hn::RebindMask(I(), g >= of(knots_m[i])), hn::Set(I(), 1));
    return piece;
  }

  // Loads pieces.
  VEC_INLINE void lay(Walker::Walk& w, VF x, VF y, VI piece, MF lanes) const {
    const VI sector = hn::ConvertTo(I(), sectors_of(F(), x, y, tracks_.sectors_a_side()));
    const VI known = hn::IfThenElseZero(hn::RebindMask(I(), lanes), piece);
    const VI at =
        (hn::IfThenElseZero(hn::RebindMask(I(), lanes), sector) * hn::Set(I(), tracks_.pieces()) +
         known) *
        hn::Set(I(), EyeTracks::kCoefficients);
    const float* lines = tracks_.lines().data();
    const auto along = [&](int i) HWY_ATTR {
      return hn::GatherIndex(F(), lines + i, at) * x + hn::GatherIndex(F(), lines + i + 1, at) * y;
    };
    w.base_u = of(eye_.x) + along(0);
    w.base_v = of(eye_.y) + along(2);
    w.rate_u = along(4);
    w.rate_v = along(6);
    w.metres_u = hn::Set(F(), 1.0F) / w.rate_u;
    w.metres_v = hn::Set(F(), 1.0F) / w.rate_v;
    w.end = hn::GatherIndex(F(), tracks_.near_knots_m().data() + 1, known);
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
