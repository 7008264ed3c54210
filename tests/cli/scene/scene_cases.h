// Scene files in tests.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cli/scene/scene_file.h"
#include "terrain/error.h"
#include "tests/ingest/test_raster.h"

namespace terrview {

// What is said against a JSON scene called s.json; empty: nothing.
inline std::string refusal_of_scene(const std::string& text) {
  try {
    static_cast<void>(parse_json_scene(text, "s.json"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// It is refused in one line that begins with the file's name and has `why` in it.
inline void expect_scene_refused(const std::string& text, const std::string& why) {
  const std::string said = refusal_of_scene(text);
  EXPECT_NE(said.find(why), std::string::npos) << said << "\n, not " << why;
  EXPECT_EQ(said.rfind("s.json:", 0), 0U) << said;
  EXPECT_EQ(said.find('\n'), std::string::npos) << said;
}

// A scene of one solid on the spot.
inline std::string scene_of_solid(const std::string& members, const std::string& more = "") {
  return "{\"solids\": [{\"at-xy\": [0, 0, 0], " + members + "}]" + more + "}";
}

inline std::string sample_scene(const std::string& name) {
  return read_text(std::string(TERRVIEW_SOURCE_DIR "/samples/scenes/") + name);
}

inline const std::vector<std::string>& json_samples() {
  static const std::vector<std::string> names{"bridge-and-dome.json", "materials.json",
                                              "mirror-front.json"};
  return names;
}

}  // namespace terrview
