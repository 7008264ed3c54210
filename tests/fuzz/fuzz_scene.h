// What the fuzzers of scene files share.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string>

#include "cli/scene/scene_file.h"
#include "terrain/error.h"

namespace terrview {

// Reads `size` bytes at `data`. Ends the program if a complaint is not one line that names the
// file.
template <class Parse>
void fuzz_scene(const std::uint8_t* data, std::size_t size, const std::string& name, Parse parse) {
  try {
    static_cast<void>(parse(std::string(reinterpret_cast<const char*>(data), size), name));
  } catch (const InputError& error) {
    const std::string said = error.what();
    if (said.find('\n') != std::string::npos || said.rfind(name, 0) != 0) std::abort();
  }
}

}  // namespace terrview
