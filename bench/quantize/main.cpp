#include <exception>
#include <iostream>

#include "bench/quantize/quantize_bench.h"
#include "cli/command_line.h"
#include "terrain/error.h"

int main(int argc, char** argv) try {
  return terrview::run_quantize_bench({argv + 1, argv + argc});
} catch (const terrview::NothingToDo&) {
  return 0;
} catch (const terrview::InputError& error) {
  std::cerr << "terrview-bench-quantize: " << error.what() << '\n';
  return 2;
} catch (const std::exception& error) {
  std::cerr << "terrview-bench-quantize: " << error.what() << '\n';
  return 1;
}
