#include "ingest/memory_limit.h"

#include <unistd.h>

#include <cmath>
#include <sstream>

namespace terrview {

double memory_limit_bytes(std::size_t memory_bytes) {
  if (memory_bytes > 0) return static_cast<double>(memory_bytes);
  return 0.5 * static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
         static_cast<double>(sysconf(_SC_PAGESIZE));
}

std::string mebibytes(double bytes) {
  std::ostringstream text;
  text.precision(0);
  text << std::fixed << std::ceil(bytes / (1 << 20)) << " MiB";
  return text.str();
}

}  // namespace terrview
