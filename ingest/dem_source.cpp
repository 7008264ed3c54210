#include "ingest/dem_source.h"

#include <array>
#include <cmath>
#include <utility>

#include <gdal_priv.h>

#include "ingest/dem_crs.h"
#include "ingest/height_unit.h"
#include "terrain/error.h"

namespace terrview {
namespace {

using GeoTransform = std::array<double, 6>;

std::string why_unopened(const std::string& path, const std::string& reason) {
  VSIStatBufL status;
  const bool exists = VSIStatL(path.c_str(), &status) == 0;
  if (exists && VSI_ISREG(status.st_mode) && status.st_size == 0) {
    return path + ": the file is empty: fetch it again";
  }
  if (!exists && (reason.find("No such file") != std::string::npos ||
                  reason.find("does not exist") != std::string::npos)) {
    return path + ": no such file: check the path";
  }
  if (reason.empty() || reason.find("not recognized as") != std::string::npos) {
    return path +
           ": not a raster that GDAL can read: check its header and its name's ending, or convert "
           "it";
  }
  return path + ": cannot be opened (" + reason + "): fetch it again or convert it";
}

GDALDataset* open_raster(const std::string& path, GdalScope& scope) {
  auto* dataset = GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_VERBOSE_ERROR);
  const std::string reason = scope.take_failure();
  if (dataset == nullptr) throw InputError(why_unopened(path, reason));
  return dataset;
}

// A VRT may carry code in its text; GDAL is told never to run it, here the user is told why.
void refuse_code(GDALDataset& dataset, const std::string& path) {
  const char* const* xml = dataset.GetMetadata("xml:VRT");
  if (xml == nullptr || *xml == nullptr) return;
  const std::string text = *xml;
  if (text.find("PixelFunctionCode") == std::string::npos &&
      text.find("PixelFunctionLanguage") == std::string::npos) {
    return;
  }
  throw InputError(path +
                   ": carries program code, which is never run: have it written out as a "
                   "plain file by somebody who trusts it");
}

[[noreturn]] void refuse_container(GDALDataset& dataset, const std::string& path) {
  const char* const* names = dataset.GetMetadata("SUBDATASETS");
  const char* first = CSLFetchNameValue(names, "SUBDATASET_1_NAME");
  if (first == nullptr) throw InputError(path + ": holds no raster: give a file that does");
  throw InputError(path + ": holds several rasters: name one, such as '" + first + "'");
}

GDALRasterBand* find_band(GDALDataset& dataset, int number, const std::string& path) {
  const int count = dataset.GetRasterCount();
  if (count == 0) refuse_container(dataset, path);
  if (number < 1 || number > count) {
    throw InputError(path + ": has no band " + std::to_string(number) + ": choose -b 1" +
                     (count > 1 ? " to " + std::to_string(count) : ""));
  }
  GDALRasterBand* band = dataset.GetRasterBand(number);
  if (GDALDataTypeIsComplex(band->GetRasterDataType()) != 0) {
    throw InputError(path + ": holds complex numbers, not heights: choose another band with -b");
  }
  return band;
}

std::optional<GeoTransform> find_geotransform(GDALDataset& dataset) {
  GeoTransform transform;
  if (dataset.GetGeoTransform(transform.data()) != CE_None) return std::nullopt;
  return transform;
}

GeoTransform require_geotransform(GDALDataset& dataset, const std::string& path) {
  if (const auto transform = find_geotransform(dataset)) return *transform;
  if (dataset.GetGCPCount() > 0) {
    throw InputError(path + ": placed by ground control points: run gdalwarp on it first");
  }
  if (dataset.GetMetadata("RPC") != nullptr || dataset.GetMetadata("GEOLOCATION") != nullptr) {
    throw InputError(path +
                     ": placed by a camera model (RPC) or geolocation arrays: run gdalwarp "
                     "on it first");
  }
  throw InputError(path +
                   ": says not where its posts lie: give their spacing in metres with "
                   "--spacing DX,DY");
}

PostPlacement from_geotransform(const GeoTransform& t, const std::string& path) {
  const PostPlacement placement{{t[0] + 0.5 * t[1] + 0.5 * t[2], t[3] + 0.5 * t[4] + 0.5 * t[5]},
                                {t[1], t[4], t[2], t[5]}};
  const double area = t[1] * t[5] - t[2] * t[4];
  if (!std::isfinite(placement.origin.x) || !std::isfinite(placement.origin.y) ||
      !std::isfinite(area) || area == 0) {
    throw InputError(path +
                     ": its geotransform places all posts on one line or nowhere: give their "
                     "spacing in metres with --spacing DX,DY");
  }
  return placement;
}

// The file's south-west post is (0, 0); its rows and columns keep their directions.
PostPlacement from_spacing(GDALDataset& dataset, glm::dvec2 spacing) {
  if (!(spacing.x > 0) || !(spacing.y > 0) || !std::isfinite(spacing.x + spacing.y)) {
    throw InputError("--spacing: needs two lengths above zero: give DX,DY or DX,DY,DZ");
  }
  const auto transform = find_geotransform(dataset);
  const bool westward = transform && (*transform)[1] < 0;
  const bool northward = transform && (*transform)[5] > 0;
  const int columns = dataset.GetRasterXSize();
  const int rows = dataset.GetRasterYSize();
  return {{westward ? spacing.x * (columns - 1) : 0, northward ? 0 : spacing.y * (rows - 1)},
          {westward ? -spacing.x : spacing.x, 0, 0, northward ? spacing.y : -spacing.y}};
}

struct Extent {
  double largest_x = 0;  // magnitudes of the outermost posts' coordinates
  double largest_y = 0;
  double largest_step = 0;
};

Extent extent_of(const DemHeader& header) {
  Extent extent;
  for (const int row : {0, header.rows - 1}) {
    for (const int column : {0, header.columns - 1}) {
      const glm::dvec2 corner = header.placement.at({column, row});
      extent.largest_x = std::max(extent.largest_x, std::abs(corner.x));
      extent.largest_y = std::max(extent.largest_y, std::abs(corner.y));
    }
  }
  const glm::dmat2& step = header.placement.step;
  for (int axis = 0; axis < 2; ++axis) {
    extent.largest_step =
        std::max({extent.largest_step, std::abs(step[axis].x), std::abs(step[axis].y)});
  }
  return extent;
}

void check_extent(const DemHeader& header, bool spacing_given) {
  const Extent extent = extent_of(header);
  constexpr double kRounding_deg = 1e-6;
  if (header.geographic && extent.largest_y > 90 + kRounding_deg) {
    throw InputError(header.name +
                     ": has latitudes beyond 90 degrees under a geographic CRS: name "
                     "the right one with --a-srs");
  }
  if (header.crs_wkt.empty() && !spacing_given && extent.largest_x <= 360 &&
      extent.largest_y <= 90 && extent.largest_step < 0.1) {
    throw InputError(header.name +
                     ": has no CRS, and its coordinates look like degrees: pass "
                     "--a-srs EPSG:4326, or --spacing DX,DY in metres");
  }
}

DemCrs find_crs(const GDALDataset& dataset, const DemOptions& options, const std::string& path) {
  if (!options.crs.empty() && options.spacing) {
    throw InputError("--a-srs: --spacing leaves no CRS: give one of them");
  }
  if (!options.crs.empty()) return parse_crs(options.crs);
  const OGRSpatialReference* crs = dataset.GetSpatialRef();
  if (crs == nullptr || crs->IsEmpty() != 0) return {};
  return options.spacing ? vertical_part(*crs) : split_crs(*crs, path);
}

double require_unit(const std::string& name) {
  const auto metres = metres_per_height_unit(name);
  if (!metres)
    throw InputError("--z-unit " + name + ": unknown: use m, ft, us-ft, km, dm, cm or mm");
  return *metres;
}

// Options first, then the band's unit, then the vertical CRS's.
void settle_unit(DemHeader& header, const std::string& of_band, const DemCrs& crs,
                 const DemOptions& options) {
  if (options.height_factor && !options.height_unit.empty()) {
    throw InputError("--z-unit: --spacing DX,DY,DZ says it already: give one of them");
  }
  if (options.height_factor &&
      !(*options.height_factor > 0 && std::isfinite(*options.height_factor))) {
    throw InputError("--spacing: DZ is the metres of a unit of height: give a number above zero");
  }
  header.height_unit = of_band.empty() ? crs.height_unit : of_band;
  if (options.height_factor) {
    header.metres_per_unit = *options.height_factor;
  } else if (!options.height_unit.empty()) {
    header.height_unit = options.height_unit;
    header.metres_per_unit = require_unit(options.height_unit);
  } else if (of_band.empty()) {
    header.metres_per_unit = crs.metres_per_unit;
  } else if (const auto metres = metres_per_height_unit(of_band)) {
    header.metres_per_unit = *metres;
  } else {
    header.warnings.push_back(header.name + ": unknown unit of heights '" + of_band +
                              "' taken as metres: name another with --z-unit");
  }
}

std::optional<double> declared_nodata(GDALRasterBand& band) {
  int declared = 0;
  double nodata = 0;
  switch (band.GetRasterDataType()) {
    case GDT_Int64:
      nodata = static_cast<double>(band.GetNoDataValueAsInt64(&declared));
      break;
    case GDT_UInt64:
      nodata = static_cast<double>(band.GetNoDataValueAsUInt64(&declared));
      break;
    default:
      nodata = band.GetNoDataValue(&declared);
  }
  return declared != 0 ? std::optional(nodata) : std::nullopt;
}

void warn_of_colours(DemHeader& header, GDALRasterBand& band) {
  const GDALColorInterp meaning = band.GetColorInterpretation();
  if (meaning == GCI_Undefined || meaning == GCI_GrayIndex) return;
  header.warnings.push_back(header.name + ": band " + std::to_string(band.GetBand()) +
                            " says it is " + GDALGetColorInterpretationName(meaning) +
                            ", not heights: is this the DEM, and the band (-b)?");
}

HeightConversion find_conversion(GDALRasterBand& band, const DemOptions& options,
                                 const DemHeader& header) {
  HeightConversion conversion;
  conversion.scale = band.GetScale();
  conversion.offset = band.GetOffset();
  conversion.metres_per_unit = header.metres_per_unit;
  conversion.nodata = options.nodata ? options.nodata : declared_nodata(band);
  conversion.nodata_given = options.nodata.has_value();
  const double factor = conversion.scale * conversion.metres_per_unit;
  if (!std::isfinite(factor) || factor == 0 || !std::isfinite(conversion.offset)) {
    throw InputError(header.name +
                     ": its scale and offset make no heights: correct them with "
                     "gdal_edit.py -scale 1 -offset 0");
  }
  return conversion;
}

}  // namespace

DemSource::DemSource(const std::string& path, const DemOptions& options, GdalScope& scope)
    : dataset_(open_raster(path, scope), [](GDALDataset* open) { GDALClose(open); }) {
  header_.name = path;
  refuse_code(*dataset_, path);
  band_ = find_band(*dataset_, options.band, path);
  header_.columns = dataset_->GetRasterXSize();
  header_.rows = dataset_->GetRasterYSize();
  header_.placement = options.spacing
                          ? from_spacing(*dataset_, *options.spacing)
                          : from_geotransform(require_geotransform(*dataset_, path), path);
  const DemCrs crs = find_crs(*dataset_, options, path);
  header_.crs_wkt = crs.wkt;
  header_.geographic = crs.geographic;
  header_.vertical_datum = crs.vertical_datum;
  check_extent(header_, options.spacing.has_value());
  settle_unit(header_, band_->GetUnitType(), crs, options);
  conversion_ = find_conversion(*band_, options, header_);
  warn_of_colours(header_, *band_);
  for (const std::string& text : scope.take_warnings()) {
    header_.warnings.push_back(path + ": " + text);
  }
}

DemSource::~DemSource() = default;
DemSource::DemSource(DemSource&&) noexcept = default;

DemHeader read_dem_header(const std::string& path, const DemOptions& options) {
  GdalScope scope;
  return DemSource(path, options, scope).header();
}

}  // namespace terrview
