#include "ingest/dataset_place.h"

#include <array>

#include <gdal_priv.h>
#include <ogr_spatialref.h>

namespace terrview {

void set_place(GDALDataset& dataset, const PostPlacement& corners, const std::string& crs_wkt) {
  const glm::dmat2& step = corners.step;
  std::array<double, 6> transform{corners.origin.x, step[0].x, step[1].x,
                                  corners.origin.y, step[0].y, step[1].y};
  dataset.SetGeoTransform(transform.data());
  if (crs_wkt.empty()) return;
  OGRSpatialReference crs;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (crs.SetFromUserInput(crs_wkt.c_str(),
                           OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get()) ==
      OGRERR_NONE)
    dataset.SetSpatialRef(&crs);
}

}  // namespace terrview
