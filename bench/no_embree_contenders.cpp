#include "bench/contender.h"

namespace terrview {

std::vector<Contender> embree_contenders(const BenchDem& /*dem*/, const IsWanted& /*is_wanted*/) {
  return {};
}

std::string embree_version() { return {}; }

}  // namespace terrview
