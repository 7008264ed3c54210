#include "ingest/gdal_scope.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal_priv.h>

namespace terrview {
namespace {

// Key and value of settings that hold while a scope lives: no Python out of a VRT; the vertical
// part of every GeoTIFF's CRS; no rounding of an ASCII grid whose first numbers happen to be whole.
constexpr std::array<std::array<const char*, 2>, 3> kSettings{{{"GDAL_VRT_ENABLE_PYTHON", "NO"},
                                                               {"GTIFF_REPORT_COMPD_CS", "YES"},
                                                               {"AAIGRID_DATATYPE", "Float64"}}};

// GDAL's own default is a share of the machine's memory, which would stand beside the heights.
constexpr GIntBig kBlockCache_bytes = 64 << 20;

void register_drivers() {
  static const bool once = [] {
    GDALAllRegister();
    limit_block_cache(kBlockCache_bytes);
    return true;
  }();
  static_cast<void>(once);
}

// Runs of blanks and control characters become one blank; none at the end, and no full stop.
std::string one_line(const char* text) {
  std::string line;
  for (; *text != '\0'; ++text) {
    const bool blank = static_cast<unsigned char>(*text) <= ' ';
    if (!blank) line += *text;
    if (blank && !line.empty() && line.back() != ' ') line += ' ';
  }
  while (!line.empty() && (line.back() == ' ' || line.back() == '.')) line.pop_back();
  return line;
}

}  // namespace

void limit_block_cache(std::int64_t bytes) {
  if (CPLGetConfigOption("GDAL_CACHEMAX", nullptr) == nullptr) GDALSetCacheMax64(bytes);
}

GdalScope::GdalScope() {
  register_drivers();
  CPLPushErrorHandlerEx([](CPLErr severity, CPLErrorNum number,
                           const char* text) { collect(severity, number, text); },
                        this);
  for (const auto& [key, value] : kSettings) {
    const char* before = CPLGetThreadLocalConfigOption(key, nullptr);
    settings_before_.push_back(before != nullptr ? std::optional<std::string>(before)
                                                 : std::nullopt);
    CPLSetThreadLocalConfigOption(key, value);
  }
}

GdalScope::~GdalScope() {
  for (std::size_t i = 0; i < kSettings.size(); ++i) {
    const auto& before = settings_before_[i];
    CPLSetThreadLocalConfigOption(kSettings[i][0], before ? before->c_str() : nullptr);
  }
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

void GdalScope::throw_failure() {
  const std::string reason = take_failure();
  throw std::runtime_error(reason.empty() ? "GDAL gives no reason" : reason);
}

std::vector<std::string> GdalScope::take_warnings() {
  std::vector<std::string> taken;
  taken.swap(warnings_);
  return taken;
}

}  // namespace terrview
