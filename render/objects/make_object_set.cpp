#include "render/objects/make_object_set.h"

#include <cstddef>
#include <utility>

#include "render/objects/rectangle_map.h"

namespace terrview {

std::unique_ptr<ObjectSet> make_object_set(Objects objects) {
  constexpr std::size_t kFew = 4;
  if (objects.size() <= kFew) return std::make_unique<ObjectList>(std::move(objects));
  return std::make_unique<RectangleMap>(std::move(objects));
}

}  // namespace terrview
