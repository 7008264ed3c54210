#include "bench/machine.h"

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <thread>

#include "bench/contender.h"

namespace terrview {
namespace {

using Json = nlohmann::ordered_json;

Json cpu_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return nullptr;
}

double memory_gib() {
  const double bytes =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  return std::round(bytes / (1 << 30) * 10) / 10;
}

Json load_1min() {
  double load = 0;
  return getloadavg(&load, 1) == 1 ? Json(std::round(load * 100) / 100) : Json(nullptr);
}

}  // namespace

Json describe_machine() {
  const std::string embree = embree_version();
  return {{"cpu", cpu_name()},
          {"threads", std::thread::hardware_concurrency()},
          {"memory_gib", memory_gib()},
          {"load_1min", load_1min()},
          {"compiler", TERRVIEW_COMPILER},
          {"build", TERRVIEW_BUILD_TYPE},
          {"embree", embree.empty() ? Json(nullptr) : Json(embree)}};
}

std::string utc_date() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  return {text, std::strftime(text, sizeof(text), "%Y-%m-%dT%H:%M:%SZ", &utc)};
}

}  // namespace terrview
