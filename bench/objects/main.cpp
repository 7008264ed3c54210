// terrview-bench-objects [BOXES]: the rectangle map in the thesis's scenes, and the maps of objects
// beside other ways on cities of BOXES boxes; tables of Markdown.
#include <charconv>
#include <exception>
#include <iostream>
#include <string_view>

#include "bench/objects/city_bench.h"
#include "bench/objects/thesis_scenes.h"
#include "terrain/error.h"

namespace {

int parse_boxes(std::string_view text) {
  int boxes = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), boxes);
  constexpr int kMost = 10000000;
  if (error != std::errc() || end != text.data() + text.size() || boxes < 1 || boxes > kMost)
    throw terrview::InputError(std::string(text) + ": not a number of boxes from 1 to 10000000");
  return boxes;
}

}  // namespace

int main(int argc, char** argv) try {
  terrview::City city;
  if (argc > 1) city.boxes = parse_boxes(argv[1]);
  terrview::write_thesis_table(std::cout);
  terrview::write_city_tables(city, std::cout);
  city.relief_m = 300;
  terrview::write_city_tables(city, std::cout);
  city.relief_m = 0;
  city.apart = 8;
  terrview::write_city_tables(city, std::cout);
} catch (const terrview::InputError& error) {
  std::cerr << "terrview-bench-objects: " << error.what() << '\n';
  return 2;
} catch (const std::exception& error) {
  std::cerr << "terrview-bench-objects: " << error.what() << '\n';
  return 1;
}
