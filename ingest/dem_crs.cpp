#include "ingest/dem_crs.h"

#include <cmath>
#include <memory>

#include <cpl_conv.h>
#include <ogr_spatialref.h>

#include "terrain/error.h"

namespace terrview {
namespace {

const char* const kWkt2[] = {"FORMAT=WKT2_2019", "MULTILINE=NO", nullptr};
const char* const kNoNetwork[] = {"ALLOW_NETWORK_ACCESS=NO", nullptr};

std::string to_wkt(const OGRSpatialReference& crs) {
  char* text = nullptr;
  const OGRErr error = crs.exportToWkt(&text, kWkt2);
  const std::unique_ptr<char, void (*)(void*)> owner(text, CPLFree);
  return error == OGRERR_NONE && text != nullptr ? std::string(text) : std::string();
}

void split_vertical(OGRSpatialReference& crs, DemCrs& result) {
  if (crs.IsCompound() != 0) {
    const char* datum = crs.GetAttrValue("COMPD_CS|VERT_CS|VERT_DATUM");
    if (datum == nullptr) datum = crs.GetAttrValue("COMPD_CS|VERT_CS");
    result.vertical_datum = datum != nullptr ? datum : "";
    const char* unit = nullptr;
    result.metres_per_unit = crs.GetTargetLinearUnits("VERT_CS", &unit);
    result.height_unit = unit != nullptr ? unit : "";
    crs.StripVertical();
  } else if (crs.GetAxesCount() == 3) {
    result.vertical_datum = "heights above the ellipsoid";
    crs.DemoteTo2D(nullptr);
  }
}

void require_metres(const OGRSpatialReference& crs, const std::string& where) {
  const char* unit = nullptr;
  if (std::abs(crs.GetLinearUnits(&unit) - 1) <= 1e-9) return;
  throw InputError(where + ": its local coordinates are in " + (unit != nullptr ? unit : "?") +
                   ": give the posts' spacing in metres with --spacing DX,DY");
}

}  // namespace

DemCrs split_crs(const OGRSpatialReference& whole, const std::string& where) {
  DemCrs result;
  OGRSpatialReference crs(whole);
  split_vertical(crs, result);
  if (crs.IsLocal() != 0) {
    require_metres(crs, where);
    return result;
  }
  if (crs.IsGeographic() == 0 && crs.IsProjected() == 0 && crs.IsDerivedGeographic() == 0) {
    throw InputError(where +
                     ": its CRS is neither geographic nor projected: name one with --a-srs");
  }
  result.wkt = to_wkt(crs);
  if (result.wkt.empty()) {
    throw InputError(where + ": its CRS cannot be written as WKT: name another with --a-srs");
  }
  constexpr double kDegree_rad = 0.0174532925199433;
  result.geographic = crs.IsGeographic() != 0 && crs.IsDerivedGeographic() == 0 &&
                      std::abs(crs.GetAngularUnits() / kDegree_rad - 1) < 1e-9;
  return result;
}

DemCrs vertical_part(const OGRSpatialReference& whole) {
  DemCrs result;
  OGRSpatialReference crs(whole);
  split_vertical(crs, result);
  return result;
}

DemCrs parse_crs(const std::string& text) {
  OGRSpatialReference crs;
  if (crs.SetFromUserInput(text.c_str(), kNoNetwork) != OGRERR_NONE) {
    throw InputError("--a-srs " + text +
                     ": not a CRS that PROJ knows: try a code such as EPSG:4326");
  }
  return split_crs(crs, "--a-srs " + text);
}

std::string crs_name(const std::string& wkt) {
  OGRSpatialReference crs;
  if (wkt.empty() || crs.importFromWkt(wkt.c_str()) != OGRERR_NONE) return "";
  const char* name = crs.GetName();
  return name != nullptr ? name : "";
}

std::string crs_code(const std::string& wkt) {
  OGRSpatialReference crs;
  if (wkt.empty() || crs.importFromWkt(wkt.c_str()) != OGRERR_NONE) return "";
  constexpr int kSure_percent = 90;
  const std::unique_ptr<OGRSpatialReference, void (*)(OGRSpatialReference*)> known(
      crs.FindBestMatch(kSure_percent), [](OGRSpatialReference* match) { match->Release(); });
  const OGRSpatialReference& named = known ? *known : crs;
  const char* authority = named.GetAuthorityName(nullptr);
  const char* code = named.GetAuthorityCode(nullptr);
  return authority != nullptr && code != nullptr ? std::string(authority) + ":" + code : "";
}

bool same_crs(const std::string& wkt, const std::string& other_wkt) {
  if (wkt == other_wkt) return true;
  if (wkt.empty() || other_wkt.empty()) return false;
  OGRSpatialReference crs;
  OGRSpatialReference other;
  return crs.importFromWkt(wkt.c_str()) == OGRERR_NONE &&
         other.importFromWkt(other_wkt.c_str()) == OGRERR_NONE && crs.IsSame(&other) != 0;
}

}  // namespace terrview
