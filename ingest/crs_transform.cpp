#include "ingest/crs_transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>
#include <vector>

#include <proj.h>

#include "terrain/error.h"

namespace terrview {
namespace {

template <auto destroy>
struct Destroyer {
  template <class T>
  void operator()(T* object) const {
    destroy(object);
  }
};
using Context = std::unique_ptr<PJ_CONTEXT, Destroyer<proj_context_destroy>>;
using Object = std::unique_ptr<PJ, Destroyer<proj_destroy>>;
using ObjectList = std::unique_ptr<PJ_OBJ_LIST, Destroyer<proj_list_destroy>>;
using FactoryContext = std::unique_ptr<PJ_OPERATION_FACTORY_CONTEXT,
                                       Destroyer<proj_operation_factory_context_destroy>>;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegreesPerRadian = 57.29577951308232;

struct Area {
  double west_deg;
  double south_deg;
  double east_deg;
  double north_deg;
};

Context offline_context() {
  Context context(proj_context_create());
  proj_context_set_enable_network(context.get(), 0);
  proj_log_level(context.get(), PJ_LOG_NONE);
  return context;
}

Object horizontal_part(PJ_CONTEXT* context, Object crs) {
  if (crs && proj_get_type(crs.get()) == PJ_TYPE_COMPOUND_CRS)
    crs.reset(proj_crs_get_sub_crs(context, crs.get(), 0));
  return crs;
}

void transform(PJ* operation, PJ_DIRECTION direction, std::span<glm::dvec2> points) {
  if (points.empty()) return;
  proj_trans_generic(operation, direction, &points[0].x, sizeof(glm::dvec2), points.size(),
                     &points[0].y, sizeof(glm::dvec2), points.size(), nullptr, 0, 0, nullptr, 0, 0);
  for (glm::dvec2& point : points)
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) point = {kNaN, kNaN};
}

// Longitudes of the CRS's own geographic axes to degrees from Greenwich.
struct LongitudeUnit {
  double degrees = 1;
  double prime_meridian_deg = 0;
};

LongitudeUnit longitude_unit(PJ_CONTEXT* context, const PJ* geographic) {
  LongitudeUnit unit;
  const Object axes(proj_crs_get_coordinate_system(context, geographic));
  double radians = 0;
  if (axes && proj_cs_get_axis_info(context, axes.get(), 0, nullptr, nullptr, nullptr, &radians,
                                    nullptr, nullptr, nullptr) != 0)
    unit.degrees = radians * kDegreesPerRadian;
  const Object meridian(proj_get_prime_meridian(context, geographic));
  double longitude = 0;
  if (meridian && proj_prime_meridian_get_parameters(context, meridian.get(), &longitude, &radians,
                                                     nullptr) != 0)
    unit.prime_meridian_deg = longitude * radians * kDegreesPerRadian;
  return unit;
}

double in_turn(double longitude_deg) { return std::remainder(longitude_deg, 360.0); }

// The arc of longitudes that leaves out the widest gap between the points.
Area bounds(std::vector<glm::dvec2> points) {
  std::sort(points.begin(), points.end(), [](auto a, auto b) { return a.x < b.x; });
  Area area{points.front().x, 90, points.back().x, -90};
  double widest_gap = points.front().x + 360 - points.back().x;
  for (std::size_t i = 0; i < points.size(); ++i) {
    area.south_deg = std::min(area.south_deg, points[i].y);
    area.north_deg = std::max(area.north_deg, points[i].y);
    if (i == 0 || points[i].x - points[i - 1].x <= widest_gap) continue;
    widest_gap = points[i].x - points[i - 1].x;
    area.west_deg = points[i].x;
    area.east_deg = points[i - 1].x;
  }
  if (widest_gap < 180) std::tie(area.west_deg, area.east_deg) = std::pair(-180.0, 180.0);
  return area;
}

// Roughly where the DEM lies, by the CRS's own datum; nullopt where its points are nowhere.
std::optional<Area> area_of_use(PJ_CONTEXT* context, const PJ* crs,
                                std::span<const glm::dvec2> area) {
  const Object geographic(proj_crs_get_geodetic_crs(context, crs));
  if (!geographic) return std::nullopt;
  const Object conversion(
      proj_create_crs_to_crs_from_pj(context, crs, geographic.get(), nullptr, nullptr));
  if (!conversion) return std::nullopt;
  const Object eastings_first(proj_normalize_for_visualization(context, conversion.get()));
  if (!eastings_first) return std::nullopt;
  std::vector<glm::dvec2> points(area.begin(), area.end());
  transform(eastings_first.get(), PJ_FWD, points);
  std::erase_if(points, [](glm::dvec2 p) { return std::isnan(p.x); });
  if (points.empty()) return std::nullopt;
  const LongitudeUnit unit = longitude_unit(context, geographic.get());
  for (glm::dvec2& point : points) {
    point.x = in_turn(point.x * unit.degrees + unit.prime_meridian_deg);
    point.y = std::clamp(point.y * unit.degrees, -90.0, 90.0);
  }
  return bounds(std::move(points));
}

ObjectList operations(PJ_CONTEXT* context, const PJ* crs, const Area& area) {
  const Object wgs84(proj_create(context, "EPSG:4326"));
  const FactoryContext factory(proj_create_operation_factory_context(context, nullptr));
  if (!wgs84 || !factory) return nullptr;
  proj_operation_factory_context_set_area_of_interest(
      context, factory.get(), area.west_deg, area.south_deg, area.east_deg, area.north_deg);
  proj_operation_factory_context_set_spatial_criterion(context, factory.get(),
                                                       PROJ_SPATIAL_CRITERION_PARTIAL_INTERSECTION);
  proj_operation_factory_context_set_grid_availability_use(
      context, factory.get(), PROJ_GRID_AVAILABILITY_DISCARD_OPERATION_IF_MISSING_GRID);
  proj_operation_factory_context_set_allow_ballpark_transformations(context, factory.get(), 0);
  return ObjectList(proj_create_operations(context, crs, wgs84.get(), factory.get()));
}

// The first operation that can be carried out.
Object first_usable(PJ_CONTEXT* context, const PJ_OBJ_LIST* list) {
  const int count = list != nullptr ? proj_list_get_count(list) : 0;
  for (int i = 0; i < count; ++i) {
    Object operation(proj_list_get(context, list, i));
    if (!operation || proj_coordoperation_is_instantiable(context, operation.get()) == 0) continue;
    if (proj_coordoperation_has_ballpark_transformation(context, operation.get()) != 0) continue;
    return operation;
  }
  return nullptr;
}

std::string describe(const PJ* crs) {
  const char* const name = proj_get_name(crs);
  return name != nullptr && *name != '\0' ? name : "its coordinate system";
}

// The x of points 30 degrees apart around a parallel, the first again at the end.
constexpr int kMeridians = 12;
using Parallel = std::array<double, kMeridians + 1>;

double longitude_of(double meridian) { return in_turn(-175 + 360.0 / kMeridians * meridian); }

double x_at(PJ* operation, double meridian, double latitude_deg) {
  glm::dvec2 point(longitude_of(meridian), latitude_deg);
  transform(operation, PJ_INV, {&point, 1});
  return point.x;
}

// The step between the meridians where x starts again, if on all others x grows alike (but for a
// change of datum).
std::optional<int> find_cut(const Parallel& x, double step) {
  std::optional<int> cut;
  for (int i = 0; i < kMeridians; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (std::abs(x[at + 1] - x[at] - step) <= 1e-3 * std::abs(step)) continue;
    if (cut) return std::nullopt;
    cut = i;
  }
  return cut;
}

std::optional<double> find_turn(PJ* operation) {
  std::array<Parallel, 2> parallels;
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i <= kMeridians; ++i) {
      parallels[j][i] = x_at(operation, static_cast<double>(i), j == 0 ? 10 : 40);
      if (std::isnan(parallels[j][i])) return std::nullopt;
    }
  const Parallel& x = parallels[0];
  std::array<double, 3> steps{x[1] - x[0], x[2] - x[1], x[3] - x[2]};
  std::sort(steps.begin(), steps.end());
  const auto cut = find_cut(x, steps[1]);
  if (!cut || find_cut(parallels[1], steps[1]) != cut) return std::nullopt;
  // Close in on the cut: there x jumps by a whole turn.
  double before = *cut;
  double after = before + 1;
  while (true) {
    const double middle = (before + after) / 2;
    if (middle == before || middle == after) break;
    const double growth = x_at(operation, middle, 10) - x_at(operation, before, 10);
    const double expected = steps[1] * (middle - before);
    (std::abs(growth - expected) < std::abs(steps[1]) ? before : after) = middle;
  }
  return x_at(operation, before, 10) - x_at(operation, after, 10);
}

}  // namespace

struct CrsTransform::Impl {
  Context context;
  Object operation;
  CrsOperation description;
  std::optional<double> turn;
  mutable std::mutex turn_taking;

  void run(PJ_DIRECTION direction, std::span<glm::dvec2> points) const {
    const std::lock_guard lock(turn_taking);
    transform(operation.get(), direction, points);
  }
};

CrsTransform::CrsTransform(const std::string& dem, const std::string& crs_wkt,
                           std::span<const glm::dvec2> area)
    : impl_(std::make_unique<Impl>()) {
  impl_->context = offline_context();
  PJ_CONTEXT* const context = impl_->context.get();
  const Object crs = horizontal_part(context, Object(proj_create(context, crs_wkt.c_str())));
  if (!crs)
    throw InputError("'" + dem + "': PROJ does not understand its coordinate system: " +
                     "give it with --a-srs EPSG:CODE");
  const auto where = area_of_use(context, crs.get(), area);
  if (!where)
    throw InputError("'" + dem + "': its posts are nowhere on the Earth in " + describe(crs.get()) +
                     ": check its geotransform, or give the right system with --a-srs EPSG:CODE");
  const Object chosen = first_usable(context, operations(context, crs.get(), *where).get());
  if (!chosen)
    throw InputError("'" + dem + "': where it lies, PROJ knows only a ballpark operation from " +
                     describe(crs.get()) + " to WGS 84: give the exact system with --a-srs, " +
                     "or warp the DEM with gdalwarp");
  impl_->operation.reset(proj_normalize_for_visualization(context, chosen.get()));
  if (!impl_->operation)
    throw InputError("'" + dem + "': PROJ cannot carry out " + describe(chosen.get()) +
                     ": warp the DEM with gdalwarp");
  const double accuracy_m = proj_coordoperation_get_accuracy(context, impl_->operation.get());
  impl_->description.dem = dem;
  impl_->description.name = describe(chosen.get());
  if (accuracy_m >= 0) impl_->description.accuracy_m = accuracy_m;
  impl_->turn = find_turn(impl_->operation.get());
}

CrsTransform::~CrsTransform() = default;
CrsTransform::CrsTransform(CrsTransform&&) noexcept = default;
CrsTransform& CrsTransform::operator=(CrsTransform&&) noexcept = default;

void CrsTransform::to_geographic(std::span<glm::dvec2> points) const { impl_->run(PJ_FWD, points); }

void CrsTransform::from_geographic(std::span<glm::dvec2> points) const {
  impl_->run(PJ_INV, points);
}

std::optional<double> CrsTransform::turn() const { return impl_->turn; }

const CrsOperation& CrsTransform::operation() const { return impl_->description; }

}  // namespace terrview
