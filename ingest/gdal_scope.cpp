#include "ingest/gdal_scope.h"

#include <algorithm>
#include <array>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal_priv.h>

namespace terrview {
namespace {

// Key and value of settings that hold while a scope lives: no Python out of a VRT; the vertical
// part of every GeoTIFF's CRS.
constexpr std::array<std::array<const char*, 2>, 2> kSettings{
    {{"GDAL_VRT_ENABLE_PYTHON", "NO"}, {"GTIFF_REPORT_COMPD_CS", "YES"}}};

// GDAL's own default is a share of the machine's memory, which would stand beside the heights.
constexpr GIntBig kBlockCache_bytes = 64 << 20;

void register_drivers() {
  static const bool once = [] {
    GDALAllRegister();
    if (CPLGetConfigOption("GDAL_CACHEMAX", nullptr) == nullptr) {
      GDALSetCacheMax64(kBlockCache_bytes);
    }
    return true;
  }();
  static_cast<void>(once);
}

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' '; }, ' ');
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return text;
}

}  // namespace

GdalScope::GdalScope() {
  register_drivers();
  CPLPushErrorHandlerEx([](CPLErr severity, CPLErrorNum number,
                           const char* text) { collect(severity, number, text); },
                        this);
  for (const auto& [key, value] : kSettings) CPLSetThreadLocalConfigOption(key, value);
}

GdalScope::~GdalScope() {
  for (const auto& [key, value] : kSettings) CPLSetThreadLocalConfigOption(key, nullptr);
  CPLPopErrorHandler();
}

void GdalScope::collect(int severity, int number, const char* text) {
  if (severity == CE_Debug) {
    CPLDefaultErrorHandler(CE_Debug, number, text);
    return;
  }
  auto& scope = *static_cast<GdalScope*>(CPLGetErrorHandlerUserData());
  auto& list = severity == CE_Warning ? scope.warnings_ : scope.failures_;
  const std::string line = one_line(text);
  if (std::find(list.begin(), list.end(), line) == list.end()) list.push_back(line);
}

std::string GdalScope::take_failure() {
  const std::string first = failures_.empty() ? std::string() : failures_.front();
  failures_.clear();
  return first;
}

std::vector<std::string> GdalScope::take_warnings() {
  std::vector<std::string> taken;
  taken.swap(warnings_);
  return taken;
}

}  // namespace terrview
