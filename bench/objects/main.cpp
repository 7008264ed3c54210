// terrview-bench-objects [BOXES]: the rectangle map beside other ways, as tables of Markdown.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <memory>
#include <string>

#include "bench/objects/object_contender.h"
#include "bench/objects/object_scene.h"
#include "bench/objects/uniform_grid.h"
#include "render/objects/rectangle_map.h"

namespace terrview {
namespace {

double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v[v.size() / 2];
}

void bench(const char* title, const Objects& objects, const std::vector<ObjectView>& views) {
  std::vector<ObjectContender> contenders;
  std::vector<double> builds;
  std::shared_ptr<RectangleMap> map;
  for (int i = 0; i < 5; ++i) {
    map.reset();
    const double s = processor_s();
    map = std::make_shared<RectangleMap>(objects);
    builds.push_back(processor_s() - s);
  }
  contenders.push_back(set_contender("rectangle map", map, median(builds), double(map->bytes())));
  {
    const double s = processor_s();
    auto grid = std::make_shared<UniformGrid>(objects);
    const double e = processor_s() - s;
    const double b = grid->bytes();
    contenders.push_back(set_contender("uniform grid", grid, e, b));
  }
  std::vector<double> eb;
  for (int i = 0; i < 5; ++i) {
    auto e = embree_object_contenders(objects);
    if (!e.empty()) eb.push_back(e[0].build_s);
  }
  for (auto& c : embree_object_contenders(objects)) {
    c.build_s = median(eb);
    contenders.push_back(c);
  }
  std::printf("%s: %zu rectangles, %zu empty\n", title, map->rectangles(), map->empty_rectangles());
  for (auto& c : contenders)
    std::printf("  %-24s build %.1f ms  %.0f B/object\n", c.name.c_str(), c.build_s * 1e3,
                c.bytes / double(objects.size()));
  for (const auto& view : views) {
    const auto rays = view_rays(view);
    std::vector<std::vector<Found>> found(contenders.size(), std::vector<Found>(rays.size()));
    const auto shadow = shadow_rays(*map, rays, glm::normalize(glm::dvec3(0.5, -0.6, 0.35)), 1e-3);
    std::vector<std::vector<std::uint8_t>> stopped(contenders.size(),
                                                   std::vector<std::uint8_t>(shadow.size()));
    std::vector<std::vector<double>> t(contenders.size()), ts(contenders.size());
    for (int rep = 0; rep < 5; ++rep)
      for (std::size_t c = 0; c < contenders.size(); ++c) {
        double s = processor_s();
        contenders[c].first_hits(rays, found[c]);
        t[c].push_back(processor_s() - s);
        s = processor_s();
        contenders[c].stops(shadow, stopped[c]);
        ts[c].push_back(processor_s() - s);
      }
    std::size_t hits = 0;
    for (auto& f : found[0]) hits += f.object >= 0;
    std::printf(" %s: %.0f%% hit, %zu shadow rays\n", view.name.c_str(),
                100.0 * double(hits) / double(rays.size()), shadow.size());
    for (std::size_t c = 0; c < contenders.size(); ++c) {
      std::size_t differ = 0, flips = 0;
      double err = 0;
      for (std::size_t i = 0; i < rays.size(); ++i) {
        if (found[c][i].object != found[0][i].object)
          ++differ;
        else if (found[c][i].object >= 0)
          err = std::max(err, std::abs(found[c][i].distance_m - found[0][i].distance_m));
      }
      for (std::size_t i = 0; i < shadow.size(); ++i) flips += stopped[c][i] != stopped[0][i];
      ObjectCounts counts, sc;
      if (contenders[c].set) {
        for (auto& r : rays) (void)contenders[c].set->first_hit(r, &counts);
        for (auto& r : shadow) (void)contenders[c].set->stops(r, &sc);
      }
      const double n = double(rays.size()), m = std::max(1.0, double(shadow.size()));
      std::printf(
          "  %-24s %7.1f ns/ray  %7.1f ns/shadow  tests %.2f/%.2f steps %.2f/%.2f differ %zu err "
          "%.1e flips %zu\n",
          contenders[c].name.c_str(), median(t[c]) / n * 1e9, median(ts[c]) / m * 1e9,
          double(counts.tests) / n, double(sc.tests) / m, double(counts.steps) / n,
          double(sc.steps) / m, differ, err, flips);
    }
  }
}

int run(int boxes) {
  const double e = city_extent_m(boxes);
  const glm::ivec2 size(640, 360);
  const std::vector<ObjectView> views{
      {"oblique", {e / 2, -0.05 * e, 1000}, {e / 2, 1400 - 0.05 * e, 0}, 1.0, size},
      {"down", {e / 2, e / 2, 3000}, {e / 2, e / 2, 0}, 1.0, size},
      {"roof", {e / 2, e / 2, 60}, {e / 2 + 100, e / 2 + 1000, 30}, 1.0, size},
      {"far horizon", {e / 2, -3000, 300}, {e / 2, e / 2, 0}, 1.0, size},
      {"street", {e / 2, e / 2, 2}, {e / 2 + 100, e / 2 + 1000, 10}, 1.0, size}};
  bench("flat city", city_scene(boxes, 0), views);
  bench("hilly city", city_scene(boxes, 300), views);
  bench("S", sphere_scene(), {{"S", {50, -90, 90}, {50, 50, 25}, 0.9, {640, 480}}});
  bench("P", prism_scene(), {{"P", {73, -70, 90}, {73, 73, 0}, 0.9, {640, 480}}});
  return 0;
}
}  // namespace
}  // namespace terrview

int main(int argc, char** argv) try {
  return terrview::run(argc > 1 ? std::stoi(argv[1]) : 100000);
} catch (const std::exception& error) {
  std::cerr << "terrview-bench-objects: " << error.what() << '\n';
  return 1;
}
