#include "bench/quantize/quantize_contender.h"

namespace terrview {

std::vector<QuantizeContender> imagequant_quantizers() { return {}; }

}  // namespace terrview
