#include "ingest/gpx_track.h"

#include <ctime>

#include <cpl_time.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "ingest/gdal_scope.h"
#include "terrain/error.h"

namespace terrview {
namespace {

std::optional<double> time_of(const OGRFeature& feature) {
  const int field = feature.GetFieldIndex("time");
  int year = 0;
  int month = 0;
  int day = 0;
  int hour = 0;
  int minute = 0;
  float second = 0;
  int zone = 0;
  if (field < 0 ||
      !feature.GetFieldAsDateTime(field, &year, &month, &day, &hour, &minute, &second, &zone))
    return std::nullopt;
  std::tm date{};
  date.tm_year = year - 1900;
  date.tm_mon = month - 1;
  date.tm_mday = day;
  date.tm_hour = hour;
  date.tm_min = minute;
  constexpr int kUtc = 100;  // zones count quarters of an hour from it; less than 2: unknown
  const int offset_s = zone > 1 ? (zone - kUtc) * 15 * 60 : 0;
  return static_cast<double>(CPLYMDHMSToUnixTime(&date) - offset_s) + double{second};
}

std::vector<TrackPoint> points_of(OGRLayer& layer) {
  std::vector<TrackPoint> points;
  for (const auto& feature : layer) {
    const OGRGeometry* geometry = feature->GetGeometryRef();
    if (geometry == nullptr || wkbFlatten(geometry->getGeometryType()) != wkbPoint) continue;
    const OGRPoint& at = *geometry->toPoint();
    points.push_back({{at.getY(), at.getX()}, time_of(*feature)});
  }
  return points;
}

}  // namespace

std::vector<TrackPoint> read_gpx_track(const std::string& path) {
  GdalScope scope;
  const GDALDatasetUniquePtr file(
      GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY));
  std::vector<TrackPoint> points;
  for (const char* name : {"track_points", "route_points"}) {
    OGRLayer* layer = file ? file->GetLayerByName(name) : nullptr;
    if (layer != nullptr && points.empty()) points = points_of(*layer);
  }
  const std::string failure = scope.take_failure();
  if (!file || !failure.empty())
    throw InputError("'" + path + "': cannot be read as GPX" +
                     (failure.empty() ? "" : " (" + failure + ")") + ": check the file");
  if (points.size() < 2)
    throw InputError("'" + path + "': has no track and no route: give one of two points or more");
  return points;
}

}  // namespace terrview
