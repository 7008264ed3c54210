#include "bench/objects/city_bench.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iomanip>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "bench/objects/object_contender.h"
#include "bench/objects/object_scene.h"
#include "bench/objects/uniform_grid.h"
#include "render/objects/cell_map.h"
#include "render/objects/rectangle_map.h"

namespace terrview {
namespace {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double seconds_of(const std::function<void()>& work) {
  const double start_s = processor_s();
  work();
  return processor_s() - start_s;
}

template <class Set>
ObjectContender built(const std::string& name, const Objects& objects, int repetitions) {
  std::vector<double> times_s;
  std::shared_ptr<const Set> set;
  for (int i = 0; i < repetitions; ++i) {
    set.reset();
    times_s.push_back(seconds_of([&] { set = std::make_shared<const Set>(objects); }));
  }
  return set_contender(name, set, median(times_s), static_cast<double>(set->bytes()));
}

std::vector<ObjectContender> contenders(const Objects& objects, int repetitions) {
  std::vector<ObjectContender> all{built<CellMap>("cell map", objects, repetitions),
                                   built<RectangleMap>("rectangle map", objects, repetitions),
                                   built<UniformGrid>("uniform grid", objects, repetitions)};
  std::vector<std::vector<double>> times_s;
  for (int i = 0; i < repetitions; ++i) {
    std::vector<ObjectContender> embree = embree_object_contenders(objects);
    times_s.resize(embree.size());
    for (std::size_t k = 0; k < embree.size(); ++k) times_s[k].push_back(embree[k].build_s);
    if (i + 1 < repetitions) continue;
    for (std::size_t k = 0; k < embree.size(); ++k) {
      embree[k].build_s = median(times_s[k]);
      all.push_back(std::move(embree[k]));
    }
  }
  return all;
}

std::vector<ObjectView> views(const City& city) {
  const double middle_m = city.middle_m();
  const glm::ivec2 size_px(640, 360);
  const glm::dvec3 middle(middle_m, middle_m, 0);
  return {{"oblique, from 1000 m", middle + glm::dvec3(0, -1400, 1000), middle, 1, size_px},
          {"down, from 3000 m", middle + glm::dvec3(0, 0, 3000), middle, 1, size_px},
          {"from a roof", middle + glm::dvec3(0, 0, 60), middle + glm::dvec3(100, 1000, 30), 1,
           size_px},
          {"from 3 km beside", {middle_m, -3000, 300}, middle, 1, size_px},
          {"in a street", middle + glm::dvec3(0, 0, 2), middle + glm::dvec3(100, 1000, 10), 1,
           size_px}};
}

// What one contender did with the rays of one view.
struct Turns {
  std::vector<Found> found;
  std::vector<std::uint8_t> stopped;
  std::vector<double> primary_s;
  std::vector<double> shadow_s;
};

struct Rays {
  std::vector<Ray> primary;
  std::vector<Ray> shadow;
};

std::vector<Turns> race(const std::vector<ObjectContender>& contenders, const Rays& rays,
                        int repetitions) {
  std::vector<Turns> turns(contenders.size());
  for (Turns& it : turns) {
    it.found.resize(rays.primary.size());
    it.stopped.resize(rays.shadow.size());
  }
  for (int i = 0; i < repetitions; ++i)
    for (std::size_t k = 0; k < contenders.size(); ++k) {
      const auto primary = [&] { contenders[k].first_hits(rays.primary, turns[k].found); };
      const auto shadow = [&] { contenders[k].stops(rays.shadow, turns[k].stopped); };
      turns[k].primary_s.push_back(seconds_of(primary));
      turns[k].shadow_s.push_back(seconds_of(shadow));
    }
  return turns;
}

ObjectCounts work_of(const ObjectSet& set, const std::vector<Ray>& rays) {
  ObjectCounts counts;
  for (const Ray& ray : rays) (void)set.first_hit(ray, &counts);
  return counts;
}

// Against the cell map, which the tests compare with testing every object.
void write_errors(const Turns& turns, const Turns& exact, std::ostream& out) {
  std::size_t others = 0;
  double largest_m = 0;
  for (std::size_t i = 0; i < turns.found.size(); ++i) {
    const bool is_same = turns.found[i].object == exact.found[i].object;
    if (!is_same) ++others;
    if (is_same && turns.found[i].object >= 0)
      largest_m =
          std::max(largest_m, std::abs(turns.found[i].distance_m - exact.found[i].distance_m));
  }
  std::size_t flips = 0;
  for (std::size_t i = 0; i < turns.stopped.size(); ++i)
    if (turns.stopped[i] != exact.stopped[i]) ++flips;
  out << others << " | " << std::setprecision(3) << largest_m << " | " << flips;
}

void write_view(const std::vector<ObjectContender>& contenders, const ObjectView& view,
                int repetitions, std::ostream& out) {
  Rays rays{view_rays(view), {}};
  const glm::dvec3 to_sun = glm::normalize(glm::dvec3(0.5, -0.6, 0.35));
  rays.shadow = shadow_rays(*contenders[0].set, rays.primary, to_sun, 1e-3);
  const std::vector<Turns> turns = race(contenders, rays, repetitions);
  const auto ns = [](const std::vector<double>& times_s, const std::vector<Ray>& traced) {
    return 1e9 * median(times_s) / static_cast<double>(traced.size());
  };
  const double own_ns = ns(turns[0].primary_s, rays.primary);
  const double own_shadow_ns = ns(turns[0].shadow_s, rays.shadow);
  for (std::size_t k = 0; k < contenders.size(); ++k) {
    const double primary_ns = ns(turns[k].primary_s, rays.primary);
    const double shadow_ns = ns(turns[k].shadow_s, rays.shadow);
    out << std::fixed << "| " << view.name << " | " << contenders[k].name << " | "
        << std::setprecision(0) << primary_ns << " | " << std::setprecision(2)
        << primary_ns / own_ns << " | " << std::setprecision(0) << shadow_ns << " | "
        << std::setprecision(2) << shadow_ns / own_shadow_ns << " | ";
    if (contenders[k].set) {
      const ObjectCounts counts = work_of(*contenders[k].set, rays.primary);
      const auto count = static_cast<double>(rays.primary.size());
      out << static_cast<double>(counts.tests) / count << " + "
          << static_cast<double>(counts.steps) / count;
    } else {
      out << '-';
    }
    out << " | ";
    write_errors(turns[k], turns[0], out);
    out << " |\n";
  }
}

}  // namespace

void write_city_tables(const City& city, std::ostream& out) {
  constexpr int kRepetitions = 5;
  const Objects objects = city_scene(city);
  const auto all = contenders(objects, kRepetitions);
  out << '\n'
      << city.boxes << " boxes, ground of " << city.relief_m << " m relief, a town every "
      << city.apart << " km\n\n"
      << "| | build, ms | memory for each object, bytes |\n|---|---|---|\n";
  for (const ObjectContender& it : all)
    out << std::fixed << "| " << it.name << " | " << std::setprecision(1) << 1e3 * it.build_s
        << " | " << std::setprecision(0) << it.bytes / city.boxes << " |\n";
  out << "\n| view | | ns a primary ray | times the cell map's | ns a shadow ray | times the cell "
         "map's | tests + steps a primary ray | other object | largest error, m | shadow flips "
         "|\n|---|---|---|---|---|---|---|---|---|---|\n";
  for (const ObjectView& view : views(city)) write_view(all, view, kRepetitions, out);
}

}  // namespace terrview
