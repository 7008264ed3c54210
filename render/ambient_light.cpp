#include "render/ambient_light.h"

#include "render/objects/scene_objects.h"

namespace terrview {

glm::vec3 sky_light(const Scene& scene, int grid, glm::dvec2 uv) {
  if (!scene.sky_views) return scene.light.ambient;
  return scene.light.ambient * (*scene.sky_views)[static_cast<std::size_t>(grid)].at(uv);
}

glm::vec3 light_on_object(const Scene& scene, const glm::dvec3& position_m,
                          const glm::vec3& normal) {
  const float share = 0.75F + 0.25F * normal.z;
  if (scene.objects->walls_in_ground) return share * scene.light.ambient;
  const auto ground = scene.terrain->ground_at(glm::dvec2(position_m));
  return share * (ground ? sky_light(scene, ground->grid, ground->uv) : scene.light.ambient);
}

}  // namespace terrview
