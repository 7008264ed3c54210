#include "bench/contender.h"

namespace terrview {

std::vector<Contender> embree_contenders(const BenchDem& /*dem*/) { return {}; }

std::string embree_version() { return {}; }

}  // namespace terrview
