#include "cli/camera_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>

#include <nlohmann/json.hpp>

#include "terrain/error.h"

namespace terrview {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(Projection projection) {
  switch (projection) {
    case Projection::perspective:
      return "perspective";
    case Projection::cylindrical:
      return "cylindrical";
    case Projection::orthographic:
      return "orthographic";
  }
  return "";
}

// Reads the members of one camera file; the command line's values stay.
class CameraReader {
 public:
  CameraReader(std::string path, const Json& json) : path_(std::move(path)), json_(json) {}

  void number(const char* key, std::optional<double>& value) const {
    if (!value && json_.contains(key)) value = number_at(json_, key);
  }

  void eye(std::optional<EyePlace>& place) const {
    if (place || !json_.contains("eye")) return;
    const Json& eye = json_.at("eye");
    EyePlace found;
    found.height_m = number_at(eye, "height_m");
    if (eye.contains("latitude"))
      found.geographic =
          check_geo_point(path_, number_at(eye, "latitude"), number_at(eye, "longitude"));
    else
      found.projected = glm::dvec2(number_at(eye, "x"), number_at(eye, "y"));
    place = found;
  }

  void size(std::optional<glm::ivec2>& size_px) const {
    if (size_px || !json_.contains("size_px")) return;
    const Json& size = whole_numbers("size_px", 2);
    size_px = {side_px(size[0]), side_px(size[1])};
  }

  void crop(std::optional<PixelRect>& rect) const {
    if (rect || !json_.contains("crop_px")) return;
    const Json& numbers = whole_numbers("crop_px", 4);
    std::array<int, 4> crop{};
    for (std::size_t i = 0; i < crop.size(); ++i) {
      const auto number = numbers[i].get<std::int64_t>();
      if (number < 0 || number > std::numeric_limits<int>::max())
        refuse("crop_px", "numbers from 0 up");
      crop[i] = static_cast<int>(number);
    }
    rect = PixelRect{{crop[0], crop[1]}, {crop[2], crop[3]}};
  }

  void shift(std::optional<glm::dvec2>& value) const {
    if (value || !json_.contains("shift")) return;
    const Json& shares = json_.at("shift");
    if (!shares.is_array() || shares.size() != 2 || !shares[0].is_number() ||
        !shares[1].is_number())
      refuse("shift", "two numbers");
    value = glm::dvec2(shares[0].get<double>(), shares[1].get<double>());
  }

  void projection(std::optional<Projection>& value) const {
    if (value || !json_.contains("projection")) return;
    for (const Projection candidate :
         {Projection::perspective, Projection::cylindrical, Projection::orthographic}) {
      if (json_.at("projection") == name_of(candidate)) value = candidate;
    }
    if (!value) refuse("projection", "perspective, cylindrical or orthographic");
  }

  void earth(std::optional<EarthModel>& value) const {
    if (value || !json_.contains("earth")) return;
    if (json_.at("earth") != "curved" && json_.at("earth") != "flat")
      refuse("earth", "curved or flat");
    value = json_.at("earth") == "flat" ? EarthModel::flat : EarthModel::curved;
  }

 private:
  [[noreturn]] void refuse(const std::string& key, const std::string& wanted) const {
    throw InputError("'" + path_ + "': " + key + ": give " + wanted);
  }

  [[nodiscard]] const Json& whole_numbers(const char* key, std::size_t count) const {
    const Json& numbers = json_.at(key);
    const bool whole = numbers.is_array() && numbers.size() == count &&
                       std::all_of(numbers.begin(), numbers.end(),
                                   [](const Json& number) { return number.is_number_integer(); });
    if (!whole) refuse(key, count == 2 ? "two whole numbers" : "four whole numbers");
    return numbers;
  }

  [[nodiscard]] int side_px(const Json& number) const {
    const auto side = number.get<std::int64_t>();
    if (side < 1 || side > std::numeric_limits<int>::max()) refuse("size_px", "numbers above 0");
    return static_cast<int>(side);
  }

  [[nodiscard]] double number_at(const Json& object, const char* key) const {
    if (!object.is_object() || !object.contains(key) || !object.at(key).is_number())
      refuse(key, "a number");
    const double value = object.at(key).get<double>();
    if (!std::isfinite(value)) refuse(key, "a finite number");
    return value;
  }

  std::string path_;
  const Json& json_;
};

Json read_json(const std::string& path) {
  std::ifstream stream(path);
  if (!stream) throw InputError("'" + path + "': cannot be read: check its name");
  Json json;
  try {
    json = Json::parse(stream);
  } catch (const Json::parse_error& error) {
    throw InputError("'" + path + "': not JSON (byte " + std::to_string(error.byte) +
                     "): give a file that --camera wrote");
  } catch (const Json::out_of_range&) {
    throw InputError("'" + path + "': a number is too large: give a file that --camera wrote");
  }
  if (!json.is_object())
    throw InputError("'" + path + "': holds no camera: give a file that --camera wrote");
  return json;
}

}  // namespace

Json camera_json(const ResolvedView& view) {
  Json eye;
  if (view.eye.geographic) {
    eye["latitude"] = view.eye.geographic->latitude_deg;
    eye["longitude"] = view.eye.geographic->longitude_deg;
  } else if (view.eye.projected) {
    eye["x"] = view.eye.projected->x;
    eye["y"] = view.eye.projected->y;
  }
  eye["height_m"] = view.eye.height_m;
  Json json;
  json["eye"] = eye;
  json["heading"] = view.heading_deg;
  json["pitch"] = view.pitch_deg;
  json["roll"] = view.roll_deg;
  json["projection"] = name_of(view.projection);
  if (view.projection == Projection::orthographic)
    json["width_m"] = view.width_m;
  else
    json["fov"] = view.fov_deg;
  if (view.shift != glm::dvec2(0)) json["shift"] = {view.shift.x, view.shift.y};
  json["size_px"] = {view.size_px.x, view.size_px.y};
  if (view.crop)
    json["crop_px"] = {view.crop->first_px.x, view.crop->first_px.y, view.crop->size_px.x,
                       view.crop->size_px.y};
  json["earth"] = view.earth == EarthModel::flat ? "flat" : "curved";
  if (view.earth == EarthModel::curved) json["refraction"] = view.refraction;
  json["z_scale"] = view.z_scale;
  return json;
}

void apply_camera_file(ViewOptions& options) {
  const Json json = read_json(options.from_camera);
  const CameraReader reader(options.from_camera, json);
  reader.eye(options.eye);
  reader.projection(options.projection);
  const bool level = options.projection == Projection::cylindrical;
  // An aim on the command line replaces the file's.
  if (!options.look_at && !options.heading_deg) {
    reader.number("heading", options.heading_deg);
    if (!level) reader.number("pitch", options.pitch_deg);
  }
  if (!level) reader.number("roll", options.roll_deg);
  reader.number("fov", options.fov_deg);
  reader.number("width_m", options.width_m);
  if (options.projection != Projection::orthographic) reader.shift(options.shift);
  // A crop is one of the file's picture.
  if (!options.size_px) reader.crop(options.crop);
  reader.size(options.size_px);
  reader.earth(options.earth);
  if (options.earth != EarthModel::flat) reader.number("refraction", options.refraction);
  reader.number("z_scale", options.z_scale);
}

}  // namespace terrview
