// One way to find what rays meet, ready to be timed.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "render/objects/object_set.h"

namespace terrview {

struct Found {
  double distance_m = std::numeric_limits<double>::infinity();
  int object = -1;
};

struct ObjectContender {
  std::string name;
  double build_s;  // processor time
  double bytes;
  std::function<void(std::span<const Ray>, std::span<Found>)> first_hits;
  std::function<void(std::span<const Ray>, std::span<std::uint8_t>)> stops;
  std::shared_ptr<const ObjectSet> set;  // where it counts its work
};

// Processor time of the whole process.
[[nodiscard]] double processor_s();

[[nodiscard]] ObjectContender set_contender(const std::string& name,
                                            std::shared_ptr<const ObjectSet> set, double build_s,
                                            double bytes);

// User geometry in Embree, on one thread: single rays and packets of 16, whose call-backs compare
// boxes in float; nothing where Embree is not installed. The objects are their bounds.
[[nodiscard]] std::vector<ObjectContender> embree_object_contenders(const Objects& objects);

}  // namespace terrview
