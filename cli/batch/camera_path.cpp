#include "cli/batch/camera_path.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <glm/geometric.hpp>

#include "cli/batch/spline.h"
#include "cli/exact_text.h"
#include "cli/parse.h"
#include "cli/read_file.h"
#include "ingest/exact_ground_map.h"
#include "ingest/gpx_track.h"
#include "terrain/error.h"

namespace terrview {
namespace {

constexpr double kSameTime_s = 1e-6;

// How many numbers a column that moves may have, and which of them are angles.
struct Moving {
  std::size_t fewest;
  std::size_t most;
  std::set<std::size_t> angles;
};

const std::map<std::string, Moving>& moving_columns() {
  static const std::map<std::string, Moving> columns{
      {"eye", {3, 3, {1}}},       {"eye-xy", {3, 3, {}}},   {"look-at", {2, 3, {1}}},
      {"look-at-xy", {2, 3, {}}}, {"heading", {1, 1, {0}}}, {"pitch", {1, 1, {}}},
      {"roll", {1, 1, {0}}},      {"fov", {1, 1, {}}},      {"width", {1, 1, {}}},
      {"sun", {2, 2, {0}}}};
  return columns;
}

// One column of keyframes as curves.
class Track {
 public:
  Track(std::string name, const Moving& kind) : name_(std::move(name)), kind_(kind) {}

  void add(double time_s, const std::string& text) {
    const bool above_ground = text.find('+', text.rfind(',') + 1) != std::string::npos;
    const auto numbers = parse_numbers("column '" + name_ + "':", text, kind_.fewest, kind_.most);
    if (times_s_.empty()) {
      above_ground_ = above_ground;
      values_.resize(numbers.size());
    }
    if (above_ground != above_ground_ || numbers.size() != values_.size())
      throw InputError("column '" + name_ + "': '" + text +
                       "' is of another kind than before: give heights in all keyframes alike");
    times_s_.push_back(time_s);
    for (std::size_t i = 0; i < numbers.size(); ++i) values_[i].push_back(numbers[i]);
  }

  void finish() {
    for (std::size_t i = 0; i < values_.size(); ++i)
      curves_.emplace_back(times_s_, kind_.angles.count(i) > 0 ? unwound(values_[i]) : values_[i],
                           is_over_ground(i) ? Spline::Shape::monotone : Spline::Shape::smooth);
  }

  [[nodiscard]] std::string at(double time_s) const {
    std::string text;
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      double value = curves_[i].at(time_s);
      if (kind_.angles.count(i) > 0) value = std::remainder(value, 360.0);
      text += (i > 0 ? "," : "") + std::string(is_over_ground(i) ? "+" : "") + exact_text(value);
    }
    return text;
  }

 private:
  [[nodiscard]] bool is_over_ground(std::size_t i) const {
    return above_ground_ && i + 1 == values_.size();
  }

  std::string name_;
  const Moving& kind_;
  bool above_ground_ = false;
  std::vector<double> times_s_;
  std::vector<std::vector<double>> values_;  // by component
  std::vector<Spline> curves_;
};

std::vector<double> times_of(const JobTable& keyframes, double frames_per_s) {
  std::vector<double> times_s;
  for (const JobRow& row : keyframes.rows) {
    if (!row.error.empty()) throw InputError("keyframes: " + row.error);
    const std::string time = row.text("time");
    const std::string frame = row.text("frame");
    if (time.empty() == frame.empty())
      throw InputError("keyframes: give each a time in seconds or a frame, and not both");
    times_s.push_back(time.empty() ? (parse_number("frame", frame) - 1) / frames_per_s
                                   : parse_number("time", time));
    if (times_s.size() > 1 && !(times_s.back() > times_s[times_s.size() - 2]))
      throw InputError("keyframes: their times do not increase: sort them");
  }
  return times_s;
}

// '_' counts as '-' in names of options.
std::string option_name(std::string column) {
  std::replace(column.begin(), column.end(), '_', '-');
  return column;
}

// Columns that only step: what this keyframe sets.
void set_steps(const JobRow& keyframe, JobRow& row) {
  static const std::set<std::string> kOwn{"time", "frame", "lat", "lon", "alt"};
  for (const auto& [column, cell] : keyframe.cells)
    if (moving_columns().count(option_name(column)) == 0 && kOwn.count(column) == 0)
      row.cells[column] = cell;
}

int frame_count(double duration_s, double frames_per_s) {
  constexpr double kMost = 1e6;
  const double count = std::floor((duration_s + kSameTime_s) * frames_per_s) + 1;
  if (!(count <= kMost)) throw InputError("--path: more than a million frames: give --duration");
  return static_cast<int>(count);
}

double distance_m(const GeoPoint& a, const GeoPoint& b) {
  return glm::length(ground_from_geographic(a, b));
}

bool is_timed(const std::vector<TrackPoint>& points) {
  return std::all_of(points.begin(), points.end(),
                     [](const TrackPoint& point) { return point.time_s.has_value(); });
}

// Points that the track moves between, each with when it is there: a second a metre without times.
struct Course {
  std::vector<double> when;
  std::vector<GeoPoint> places;
  double length_m = 0;
};

Course course_of(const std::vector<TrackPoint>& points, bool by_time) {
  Course course;
  for (const TrackPoint& point : points) {
    if (!course.places.empty()) {
      const double step_m = distance_m(course.places.back(), point.place);
      const bool stands = by_time ? *point.time_s <= course.when.back() : step_m < 1e-3;
      if (stands) continue;
      course.length_m += step_m;
    }
    course.when.push_back(by_time ? *point.time_s : course.length_m);
    course.places.push_back(point.place);
  }
  if (course.places.size() < 2) throw InputError("--path: the track does not move: give another");
  return course;
}

JobTable keyframes_of(const Course& course, double duration_s, double lift_m) {
  JobTable table{{"time", "eye"}, {}};
  const double scale = duration_s / (course.when.back() - course.when.front());
  for (std::size_t i = 0; i < course.places.size(); ++i) {
    const GeoPoint& at = course.places[i];
    JobRow& row = table.rows.emplace_back();
    row.cells["time"] = {exact_text((course.when[i] - course.when.front()) * scale)};
    row.cells["eye"] = {exact_text(at.latitude_deg) + "," + exact_text(at.longitude_deg) + ",+" +
                        exact_text(lift_m)};
  }
  return table;
}

// Each looks at where the camera will be in three seconds; the last ones as far as it goes.
void aim_ahead(JobTable& frames, double frames_per_s) {
  constexpr double kAhead_s = 3;
  const auto ahead = static_cast<std::size_t>(std::ceil(kAhead_s * frames_per_s));
  const auto place = [&](std::size_t i) {
    return *parse_eye(frames.rows[i].text("eye")).geographic;
  };
  frames.columns.emplace_back("heading");
  std::string heading = "0";
  for (std::size_t i = 0; i < frames.rows.size(); ++i) {
    const std::size_t later = std::min(i + ahead, frames.rows.size() - 1);
    const glm::dvec2 way_m = ground_from_geographic(place(i), place(later));
    if (glm::length(way_m) > 1e-3)
      heading = exact_text(std::atan2(way_m.x, way_m.y) * 180 / std::numbers::pi);
    frames.rows[i].cells["heading"] = {heading};
  }
}

JobTable frames_of_track(const std::vector<TrackPoint>& points, const PathOptions& options) {
  constexpr double kUsualDuration_s = 20;
  constexpr double kUsualLift_m = 2;
  const Course course = course_of(points, is_timed(points) && !options.speed_m_per_s);
  const double duration_s = options.speed_m_per_s ? course.length_m / *options.speed_m_per_s
                                                  : options.duration_s.value_or(kUsualDuration_s);
  PathOptions timed = options;
  timed.duration_s.reset();
  JobTable frames = frames_of_keyframes(
      keyframes_of(course, duration_s, options.lift_m.value_or(kUsualLift_m)), timed);
  if (options.aims) aim_ahead(frames, options.frames_per_s);
  return frames;
}

std::map<std::string, Track> tracks_of(const JobTable& keyframes,
                                       const std::vector<double>& times_s) {
  std::map<std::string, Track> tracks;
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    for (const auto& [column, cell] : keyframes.rows[i].cells) {
      const auto kind = moving_columns().find(option_name(column));
      if (kind == moving_columns().end()) continue;
      tracks.try_emplace(column, column, kind->second)
          .first->second.add(times_s[i], keyframes.rows[i].text(column));
    }
  }
  for (auto& [column, track] : tracks) track.finish();
  return tracks;
}

}  // namespace

JobTable frames_of_keyframes(const JobTable& keyframes, const PathOptions& options) {
  std::vector<double> times_s = times_of(keyframes, options.frames_per_s);
  if (options.duration_s && times_s.size() > 1) {
    const double first_s = times_s.front();
    const double scale = *options.duration_s / (times_s.back() - first_s);
    for (double& time_s : times_s) time_s = (time_s - first_s) * scale;
  }
  const std::map<std::string, Track> tracks = tracks_of(keyframes, times_s);
  JobTable frames;
  for (const std::string& column : keyframes.columns)
    if (column != "time" && column != "frame") frames.columns.push_back(column);
  const int count = frame_count(options.duration_s.value_or(times_s.back() - times_s.front()),
                                options.frames_per_s);
  JobRow steps;
  std::size_t next = 0;
  for (int i = 0; i < count; ++i) {
    const double time_s = times_s.front() + i / options.frames_per_s;
    for (; next < times_s.size() && times_s[next] <= time_s + kSameTime_s; ++next)
      set_steps(keyframes.rows[next], steps);
    JobRow& row = frames.rows.emplace_back(steps);
    for (const auto& [column, track] : tracks) row.cells[column] = {track.at(time_s)};
  }
  return frames;
}

JobTable read_camera_path(const std::string& path, const PathOptions& options) {
  const std::string text = read_file(path);
  const bool is_xml = text.find_first_not_of(" \t\r\n\xef\xbb\xbf") == text.find('<') &&
                      text.find('<') != std::string::npos;
  if (is_xml) return frames_of_track(read_gpx_track(path), options);
  if (options.speed_m_per_s) throw InputError("--speed: is of a GPX track: give --duration");
  if (options.lift_m) throw InputError("--lift: is of a GPX track: give the keyframes' eyes +H");
  return frames_of_keyframes(parse_job_table(text, path), options);
}

}  // namespace terrview
