// terrview-sky-bench [DEM --eye LAT,LON,ALT ...]: what fields and skies cost; with the arguments of
// a view, its sky beside its ground.
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "bench/sky/field_bench.h"

int main(int argc, char** argv) try {
  const std::vector<std::string> args(argv + 1, argv + argc);
  terrview::print_field_rates({8, 9, 10, 11});
  terrview::print_spectrum();
  terrview::print_perspective();
  if (!args.empty()) terrview::print_view(args);
} catch (const std::exception& error) {
  std::cerr << "terrview-sky-bench: " << error.what() << '\n';
  return 1;
}
