// The rectangle map beside a uniform grid and Embree on cities of random boxes.
#pragma once

#include <ostream>

namespace terrview {

struct CityBenchOptions {
  int boxes = 100000;
  double relief_m = 0;
  int repetitions = 5;  // medians are taken of these
};

// Tables of Markdown: time and memory of building, then speed beside error for each view, one
// thread.
void write_city_tables(const CityBenchOptions& options, std::ostream& out);

}  // namespace terrview
