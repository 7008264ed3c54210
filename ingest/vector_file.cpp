#include "ingest/vector_file.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include <cpl_string.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "ingest/gdal_scope.h"
#include "ingest/geojson_check.h"
#include "terrain/error.h"

namespace terrview {
namespace {

constexpr int kAnyFeature = 0;

[[noreturn]] void refuse_file(const std::string& file, int number, const std::string& what) {
  throw InputError("'" + file + "'" +
                   (number > kAnyFeature ? ", feature " + std::to_string(number) : "") + ": " +
                   what);
}

bool same_name(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  const auto plain = [](char c) {
    return c == ':' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  };
  for (std::size_t i = 0; i < a.size(); ++i)
    if (plain(a[i]) != plain(b[i])) return false;
  return true;
}

struct Closing {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, Closing>;

Dataset open(const std::string& path, GdalScope& scope) {
  Dataset dataset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY));
  const std::string failure = scope.take_failure();
  if (!dataset || !failure.empty())
    refuse_file(path, kAnyFeature,
                "cannot be read as features" + (failure.empty() ? "" : " (" + failure + ")") +
                    ": give a vector file that ogrinfo reads");
  return dataset;
}

OGRLayer& first_layer(GDALDataset& dataset, VectorFile& file) {
  if (dataset.GetLayerCount() == 0)
    refuse_file(file.name, kAnyFeature, "has no layer of features: give a vector file");
  OGRLayer& layer = *dataset.GetLayer(0);
  if (dataset.GetLayerCount() > 1)
    file.warnings.push_back("'" + file.name + "': of " + std::to_string(dataset.GetLayerCount()) +
                            " layers only the first, '" + layer.GetName() + "', is read");
  return layer;
}

void describe_crs(OGRLayer& layer, VectorFile& file) {
  const OGRSpatialReference* crs = layer.GetSpatialRef();
  if (crs == nullptr) return;
  char* text = nullptr;
  crs->exportToWkt(&text);
  if (text != nullptr) file.crs_wkt = text;
  CPLFree(text);
  file.geographic = crs->IsGeographic() != 0;
}

// As ISO 8601, to the millisecond; with an offset from UTC only where the field has one.
std::string date_time_text(const OGRFeature& feature, int field) {
  constexpr int kLocalTime = 1;  // OGR's flags: 0 is unknown; others count quarters of an hour
  constexpr int kUtc = 100;
  int year = 0, month = 0, day = 0, hour = 0, minute = 0, zone = 0;
  float second = 0;
  feature.GetFieldAsDateTime(field, &year, &month, &day, &hour, &minute, &second, &zone);
  char text[96];
  std::snprintf(text, sizeof text, "%04d-%02d-%02dT%02d:%02d:%06.3f", year, month, day, hour,
                minute, static_cast<double>(second));
  if (zone <= kLocalTime) return text;
  if (zone == kUtc) return std::string(text) + "Z";
  const int minutes = 15 * std::abs(zone - kUtc);
  char offset[32];
  std::snprintf(offset, sizeof offset, "%c%02d:%02d", zone < kUtc ? '-' : '+', minutes / 60,
                minutes % 60);
  return std::string(text) + offset;
}

std::string field_text(const OGRFeature& feature, int field) {
  const bool is_time = feature.GetFieldDefnRef(field)->GetType() == OFTDateTime;
  return is_time ? date_time_text(feature, field) : feature.GetFieldAsString(field);
}

}  // namespace

const OGRGeometry* VectorFeature::geometry() const { return feature_.GetGeometryRef(); }

std::optional<std::string> VectorFeature::text(std::span<const std::string_view> names) const {
  for (const std::string_view name : names) {
    for (int i = 0; i < feature_.GetFieldCount(); ++i) {
      if (!feature_.IsFieldSetAndNotNull(i)) continue;
      if (!same_name(feature_.GetFieldDefnRef(i)->GetNameRef(), name)) continue;
      std::string value = field_text(feature_, i);
      if (!value.empty()) return value;
    }
  }
  return std::nullopt;
}

std::string VectorFeature::line(std::span<const std::string_view> names) const {
  std::string value = text(names).value_or("");
  if (CPLIsUTF8(value.data(), static_cast<int>(value.size())) == 0)
    refuse("its " + std::string(names.front()) + " is not UTF-8: save the file as UTF-8");
  for (char& c : value)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
  const std::size_t first = value.find_first_not_of(' ');
  if (first == std::string::npos) return "";
  return value.substr(first, value.find_last_not_of(' ') - first + 1);
}

std::string VectorFeature::fields() const {
  constexpr int kMostNamed = 20;
  std::string names;
  for (int i = 0; i < std::min(feature_.GetFieldCount(), kMostNamed); ++i)
    names += (i > 0 ? ", " : "") + std::string(feature_.GetFieldDefnRef(i)->GetNameRef());
  return names + (feature_.GetFieldCount() > kMostNamed ? ", ..." : "");
}

void VectorFeature::require_field(std::string_view name) const {
  for (int i = 0; i < feature_.GetFieldCount(); ++i)
    if (same_name(feature_.GetFieldDefnRef(i)->GetNameRef(), name)) return;
  const std::string known = fields();
  refuse_file(file_, kAnyFeature,
              "has no field '" + std::string(name) +
                  "': " + (known.empty() ? "it has none" : "give one of " + known));
}

void VectorFeature::refuse(const std::string& what) const { refuse_file(file_, number_, what); }

VectorFile read_vector_file(const std::string& path,
                            const std::function<void(const VectorFeature& feature)>& take) {
  GdalScope scope;
  VectorFile file{.name = path, .crs_wkt = {}, .warnings = {}};
  // What GDAL forgives in GeoJSON would be missing from the scene.
  check_geojson(path);
  const Dataset dataset = open(path, scope);
  OGRLayer& layer = first_layer(*dataset, file);
  describe_crs(layer, file);
  layer.ResetReading();
  while (true) {
    const std::unique_ptr<OGRFeature> feature(layer.GetNextFeature());
    const std::string failure = scope.take_failure();
    if (!failure.empty()) refuse_file(path, file.features + 1, failure + ": mend the file");
    if (!feature) break;
    take(VectorFeature(file.name, ++file.features, *feature));
  }
  return file;
}

}  // namespace terrview
