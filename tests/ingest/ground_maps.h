// The ground maps of DEMs in every kind of coordinate system, for tests of their promises.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <glm/common.hpp>

#include "ingest/lay_grid.h"
#include "tests/ingest/geodesy_cases.h"

namespace terrview {

inline constexpr double kSight_m = 400e3;

class GroundMaps : public testing::TestWithParam<cases::GridCase> {
 protected:
  GroundMaps()
      : crs_(cases::transform(GetParam())),
        eye_(cases::eye_point(GetParam(), *crs_)),
        exact_(eye_, crs_, cases::placement(GetParam())),
        laid_(lay_grid(exact_, GetParam().posts, kSight_m)),
        oracle_(GetParam(), eye_) {}

  [[nodiscard]] const GroundMap& map() const { return *laid_[0].map; }
  [[nodiscard]] glm::dvec2 last_post() const { return GetParam().posts - 1; }

  // How far a point of the grid frame is off the grid; negative on it.
  [[nodiscard]] double off_grid(glm::dvec2 uv) const {
    const glm::dvec2 out = glm::max(uv - last_post(), -uv);
    return std::max(out.x, out.y);
  }

  // Ground points of posts all over the grid; none within a metre of a pole, where the map jumps.
  [[nodiscard]] std::vector<glm::dvec2> ground_of_posts(int count) const {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> share(0, 1);
    std::vector<glm::dvec2> points;
    while (static_cast<int>(points.size()) < count) {
      glm::dvec2 point = last_post() * glm::dvec2(share(random), share(random));
      points.push_back(laid_[0].exact.to_ground(point));
    }
    return points;
  }

  [[nodiscard]] static GroundLine line_from_eye(int index, int count) {
    const double azimuth = 2 * std::numbers::pi * (index + 0.37) / count;
    return {{0, 0}, {std::sin(azimuth), std::cos(azimuth)}};
  }

  std::shared_ptr<const CrsTransform> crs_;
  GeoPoint eye_;
  ExactGroundMap exact_;
  std::vector<LaidGrid> laid_;
  cases::Oracle oracle_;
};

inline std::string name_of_case(const testing::TestParamInfo<cases::GridCase>& test) {
  std::string name = test.param.name;
  std::erase_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
  return name;
}

}  // namespace terrview
