#include "tests/cli/small_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>
#include <stdexcept>

namespace terrview {
namespace {

const std::set<std::string> kDems{"hills.tif", "plain.asc"};

void write_hills(const std::string& path) {
  TestRaster hills;
  hills.columns = 41;
  hills.rows = 41;
  hills.number = [](int column, int row) {
    return 600 + 120 * std::sin(column * 0.5) * std::cos(row * 0.4) + 4 * column;
  };
  hills.geotransform = {{7 - 20.5 * 0.001, 0.001, 0, 48 + 20.5 * 0.001, 0, -0.001}};
  hills.crs = "EPSG:4326";
  hills.write(path);
}

void write_plain(const std::string& path) {
  std::string text = "ncols 80\nnrows 60\nxllcenter 0\nyllcenter 0\ncellsize 10\n";
  for (int row = 0; row < 60; ++row) {
    for (int column = 0; column < 80; ++column) text += "300 ";
    text += '\n';
  }
  write_text(path, text);
}

bool has(const Arguments& args, const std::string& option) {
  return std::find(args.begin(), args.end(), option) != args.end();
}

}  // namespace

Arguments words(const std::string& line) {
  std::istringstream stream(line);
  Arguments args;
  for (std::string word; stream >> word;) args.push_back(word);
  return args;
}

Arguments operator+(Arguments first, const Arguments& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

double Layers::at(const std::string& name, int column, int row) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw std::runtime_error("no band " + name);
  return bands[static_cast<std::size_t>(found - names.begin())]
              [static_cast<std::size_t>(row * width_px + column)];
}

SmallView::SmallView() {
  write_hills(path("hills.tif"));
  write_plain(path("plain.asc"));
}

void SmallView::view(const Arguments& args) const {
  Arguments all = words("hills.tif -q") + args;
  if (!has(args, "--eye") && !has(args, "--eye-xy") && !has(args, "--from-camera"))
    all = all + words("--eye 47.985,6.99,900");
  if (!has(args, "--size") && !has(args, "--from-camera")) all = all + words("--size 64x48");
  const Finished finished = run(all);
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  ASSERT_EQ(finished.out, "");
  ASSERT_EQ(finished.err, "");
}

nlohmann::json SmallView::json(const std::string& name) const {
  return nlohmann::json::parse(bytes(name));
}

Layers SmallView::layers(const std::string& name) const {
  GDALAllRegister();
  const GDALDatasetUniquePtr file(GDALDataset::Open(path(name).c_str()));
  if (!file) throw std::runtime_error("no layers in " + name);
  Layers layers{file->GetRasterXSize(), file->GetRasterYSize(), {}, {}};
  for (GDALRasterBand* band : file->GetBands()) {
    layers.names.emplace_back(band->GetDescription());
    std::vector<double> values(static_cast<std::size_t>(layers.width_px * layers.height_px));
    if (band->RasterIO(GF_Read, 0, 0, layers.width_px, layers.height_px, values.data(),
                       layers.width_px, layers.height_px, GDT_Float64, 0, 0, nullptr) != CE_None)
      throw std::runtime_error("layers unreadable");
    layers.bands.push_back(std::move(values));
  }
  return layers;
}

std::vector<std::string> SmallView::outputs() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
    if (kDems.count(entry.path().filename().string()) == 0)
      names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Rows csv_rows(const std::string& csv) {
  Rows rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back(1);
    bool quoted = false;
    for (const char c : line) {
      if (c == '"') quoted = !quoted;
      if (c == ',' && !quoted)
        rows.back().emplace_back();
      else
        rows.back().back() += c;
    }
  }
  return rows;
}

void expect_refused(const Finished& finished, const std::vector<std::string>& parts) {
  EXPECT_EQ(finished.exit_code, 2) << finished.err;
  EXPECT_EQ(finished.out, "");
  EXPECT_EQ(finished.err.rfind("terrview: ", 0), 0U) << finished.err;
  EXPECT_EQ(finished.err.find('\n'), finished.err.size() - 1) << finished.err;
  EXPECT_TRUE(says(finished.err, parts));
}

}  // namespace terrview
