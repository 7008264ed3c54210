#include <exception>
#include <iostream>

#include "bench/bench_command.h"
#include "terrain/error.h"

int main(int argc, char** argv) try {
  return terrview::run_bench({argv + 1, argv + argc});
} catch (const terrview::InputError& error) {
  std::cerr << "terrview-bench: " << error.what() << '\n';
  return 2;
} catch (const std::exception& error) {
  std::cerr << "terrview-bench: " << error.what() << '\n';
  return 1;
}
