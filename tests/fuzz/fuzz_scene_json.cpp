#include "tests/fuzz/fuzz_scene.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  terrview::fuzz_scene(data, size, "scene.json", terrview::parse_json_scene);
  return 0;
}
