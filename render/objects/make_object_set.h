// The set that suits the objects.
#pragma once

#include <memory>

#include "render/objects/object_set.h"

namespace terrview {

[[nodiscard]] std::unique_ptr<ObjectSet> make_object_set(Objects objects);

}  // namespace terrview
