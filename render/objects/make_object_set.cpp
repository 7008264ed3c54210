#include "render/objects/make_object_set.h"

#include <utility>

namespace terrview {

std::unique_ptr<ObjectSet> make_object_set(Objects objects) {
  return std::make_unique<ObjectList>(std::move(objects));
}

}  // namespace terrview
