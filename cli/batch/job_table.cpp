#include "cli/batch/job_table.h"

#include <algorithm>
#include <set>
#include <span>

#include <nlohmann/json.hpp>

#include "cli/batch/csv.h"
#include "cli/read_file.h"
#include "terrain/error.h"

namespace terrview {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kForm =
    ": give CSV with a line of column names, a JSON array of objects, or GeoJSON points";

void set_cell(JobRow& row, const std::string& column, std::vector<std::string> values) {
  std::erase(values, "");
  if (!values.empty()) row.cells[column] = std::move(values);
}

void add_columns(JobTable& table, const Json& object, std::set<std::string>& known) {
  for (const auto& [key, value] : object.items())
    if (known.insert(key).second) table.columns.push_back(key);
}

std::string cell_text(const Json& value) {
  if (value.is_null()) return "";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

void set_json_cell(JobRow& row, const std::string& column, const Json& value) {
  std::vector<std::string> values;
  for (const Json& one : value.is_array() ? value : Json::array({value}))
    values.push_back(cell_text(one));
  set_cell(row, column, values);
}

JobRow row_of(const Json& object) {
  JobRow row;
  for (const auto& [column, value] : object.items()) set_json_cell(row, column, value);
  return row;
}

JobTable from_csv(std::string_view text, const std::string& name) {
  const std::vector<CsvRecord> records = parse_csv(text, name);
  if (records.empty()) throw InputError("'" + name + "': is empty" + kForm);
  JobTable table;
  table.columns = records.front().cells;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const auto before = table.columns.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(table.columns.begin(), before, table.columns[i]) != before)
      throw InputError("'" + name + "': two columns are called '" + table.columns[i] +
                       "': rename one");
  }
  for (const CsvRecord& record : std::span(records).subspan(1)) {
    JobRow& row = table.rows.emplace_back();
    if (record.cells.size() != table.columns.size())
      row.error = "line " + std::to_string(record.line) + " has " +
                  std::to_string(record.cells.size()) + " cells for " +
                  std::to_string(table.columns.size()) +
                  " columns: quote a cell that has commas in it";
    for (std::size_t i = 0; i < std::min(record.cells.size(), table.columns.size()); ++i)
      set_cell(row, table.columns[i], {record.cells[i]});
  }
  return table;
}

JobTable from_objects(const Json& objects, const std::string& name) {
  JobTable table;
  std::set<std::string> known;
  for (const Json& object : objects) {
    if (!object.is_object()) throw InputError("'" + name + "': a row that is no object" + kForm);
    add_columns(table, object, known);
    table.rows.push_back(row_of(object));
  }
  return table;
}

// The properties, and the coordinates where they do not say otherwise.
Json flat_feature(const Json& feature) {
  Json object = Json::object();
  const auto properties = feature.find("properties");
  if (properties != feature.end() && properties->is_object()) object = *properties;
  const auto geometry = feature.find("geometry");
  if (geometry == feature.end() || !geometry->is_object() ||
      geometry->value("type", Json()) != "Point")
    return object;
  const Json at = geometry->value("coordinates", Json::array());
  if (!at.is_array() || at.size() < 2) return object;
  const char* const names[] = {"lon", "lat", "alt"};
  for (std::size_t i = 0; i < std::min<std::size_t>(at.size(), 3); ++i)
    if (!object.contains(names[i])) object[names[i]] = at[i];
  return object;
}

JobTable from_geojson(const Json& json, const std::string& name) {
  const auto crs = json.find("crs");
  if (crs != json.end() && !crs->is_null()) {
    const std::string text = crs->dump();
    if (text.find("CRS84") == std::string::npos && text.find("4326") == std::string::npos)
      throw InputError("'" + name +
                       "': is not in WGS 84: make it so with ogr2ogr -t_srs EPSG:4326");
  }
  Json objects = Json::array();
  for (const Json& feature : json.at("features"))
    objects.push_back(feature.is_object() ? flat_feature(feature) : feature);
  return from_objects(objects, name);
}

JobTable from_json(std::string_view text, const std::string& name) {
  const Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (json.is_discarded()) throw InputError("'" + name + "': is broken JSON" + kForm);
  if (json.is_array()) return from_objects(json, name);
  if (json.value("type", Json()) == "FeatureCollection" && json.contains("features") &&
      json["features"].is_array())
    return from_geojson(json, name);
  throw InputError("'" + name + "': is JSON but no table" + kForm);
}

void place_eye(JobRow& row) {
  const std::string lat = row.text("lat");
  const std::string lon = row.text("lon");
  if (lat.empty() || lon.empty() || row.cells.count("eye") || row.cells.count("eye-xy")) return;
  const std::string alt = row.text("alt");
  row.cells["eye"] = {lat + "," + lon + "," + (alt.empty() ? "+2" : alt)};
}

// What is not UTF-8 could not be said again in JSON.
void check_utf8(std::string_view text, const std::string& name) {
  try {
    static_cast<void>(Json(std::string(text)).dump());
  } catch (const Json::type_error&) {
    throw InputError("'" + name + "': is not UTF-8: convert it with iconv -t UTF-8");
  }
}

}  // namespace

std::string JobRow::text(const std::string& column) const {
  const auto cell = cells.find(column);
  if (cell == cells.end()) return "";
  std::string all;
  for (const std::string& value : cell->second) all += (all.empty() ? "" : ",") + value;
  return all;
}

JobTable parse_job_table(std::string_view text, const std::string& name) {
  check_utf8(text, name);
  const std::size_t first = text.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  const bool is_json =
      first != std::string_view::npos && (text[first] == '[' || text[first] == '{');
  JobTable table = is_json ? from_json(text.substr(first), name) : from_csv(text, name);
  if (table.rows.empty()) throw InputError("'" + name + "': has no rows" + kForm);
  for (JobRow& row : table.rows) place_eye(row);
  return table;
}

JobTable read_job_table(const std::string& path) { return parse_job_table(read_file(path), path); }

}  // namespace terrview
