#include "bench/objects/object_contender.h"

namespace terrview {

std::vector<ObjectContender> embree_object_contenders(const Objects& /*objects*/) { return {}; }

}  // namespace terrview
