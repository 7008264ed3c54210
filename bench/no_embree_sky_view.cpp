#include "bench/light_study.h"

namespace terrview {

SkyTracer embree_sky_tracer(const BenchDem& /*dem*/) { return {}; }

}  // namespace terrview
