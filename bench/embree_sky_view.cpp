#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include <embree3/rtcore.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "bench/embree_ground.h"
#include "bench/light_study.h"
#include "render/sampling.h"

namespace terrview {
namespace {

constexpr int kLanes = 16;
constexpr double kLift_m = 0.02;

glm::dvec3 normal_at(const BenchDem& dem, glm::ivec2 post) {
  const HeightGrid& grid = *dem.grid;
  const auto height = [&](int column, int row) {
    return static_cast<double>(
        grid.at(std::clamp(column, 0, grid.columns - 1), std::clamp(row, 0, grid.rows - 1)));
  };
  const glm::dvec2 slope_m((height(post.x + 1, post.y) - height(post.x - 1, post.y)) / 2,
                           (height(post.x, post.y + 1) - height(post.x, post.y - 1)) / 2);
  const glm::dvec2 gradient = glm::transpose(glm::inverse(dem.step_m)) * slope_m;
  return glm::normalize(glm::dvec3(-gradient, 1));
}

// A direction about `normal`, by the cosine to it: the square's points on a disc, raised.
glm::dvec3 cosine_weighted(const glm::dvec3& normal, glm::dvec2 square) {
  const double radius = std::sqrt(square.x);
  const double turn_rad = 2 * std::numbers::pi * square.y;
  const glm::dvec3 side = glm::normalize(glm::cross(normal, glm::dvec3(0, 1, 0)));
  return radius * std::cos(turn_rad) * side +
         radius * std::sin(turn_rad) * glm::cross(normal, side) + std::sqrt(1 - square.x) * normal;
}

double share_seen(RTCScene scene, const glm::dvec3& from_m, const glm::dvec3& normal,
                  glm::dvec2 shift, int rays) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  int seen = 0;
  for (int first = 0; first < rays; first += kLanes) {
    alignas(64) int valid[kLanes];
    RTCRay16 packet;
    for (int lane = 0; lane < kLanes; ++lane) {
      const glm::dvec3 direction =
          cosine_weighted(normal, glm::fract(sample_offset(first + lane) + shift));
      valid[lane] = direction.z > 0 ? -1 : 0;  // below the horizon there is no sky
      packet.org_x[lane] = static_cast<float>(from_m.x);
      packet.org_y[lane] = static_cast<float>(from_m.y);
      packet.org_z[lane] = static_cast<float>(from_m.z);
      packet.dir_x[lane] = static_cast<float>(direction.x);
      packet.dir_y[lane] = static_cast<float>(direction.y);
      packet.dir_z[lane] = static_cast<float>(direction.z);
      packet.tnear[lane] = 0;
      packet.tfar[lane] = std::numeric_limits<float>::infinity();
      packet.time[lane] = 0;
      packet.mask[lane] = ~0U;
      packet.flags[lane] = 0;
    }
    rtcOccluded16(valid, scene, &context, &packet);
    for (int lane = 0; lane < kLanes; ++lane) seen += valid[lane] && packet.tfar[lane] > 0 ? 1 : 0;
  }
  return static_cast<double>(seen) / rays;
}

}  // namespace

SkyTracer embree_sky_tracer(const BenchDem& dem) {
  const auto ground = std::make_shared<const EmbreeGround>(dem, EmbreeGeometry::triangles, 1);
  return [&dem, ground](std::span<const glm::ivec2> posts, int rays) {
    std::vector<double> shares;
    for (std::size_t i = 0; i < posts.size(); ++i) {
      const glm::dvec3 normal = normal_at(dem, posts[i]);
      const glm::dvec3 at_m(dem.scene_xy_m(posts[i]), dem.grid->at(posts[i].x, posts[i].y));
      // Each post has its own turn of the sequence, so that their errors are not alike.
      shares.push_back(share_seen(ground->scene(), at_m + kLift_m * normal, normal,
                                  sample_offset(static_cast<int>(i) + 1), rays));
    }
    return shares;
  };
}

}  // namespace terrview
