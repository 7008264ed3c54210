// The results as a table to read and as a figure.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "bench/bench_result.h"

namespace terrview {

// The results of one view, kind of ray by kind of ray: speeds also over that of Embree's best
// there.
void print_view(std::ostream& out, const std::vector<BenchResult>& results);

// Tests per ray beside those of Coquillart 1984; nothing where no result is of the thesis's grid.
void print_thesis(std::ostream& out, const std::vector<BenchResult>& results);

// From file to PNG; nothing where no result is of that.
void print_to_png(std::ostream& out, const std::vector<BenchResult>& results);

// The time of a ray on the curved Earth over that on a flat one, tracks all but straight and bent;
// nothing where not measured.
void print_earth(std::ostream& out, const std::vector<BenchResult>& results);

// Speed against error, SVG: one panel per DEM and view, one mark per contender, primary rays, the
// fewest threads measured, a flat Earth. Logarithmic axes; an error of zero stands in a column of
// its own.
[[nodiscard]] std::string figure_svg(const BenchRun& run);

// A Markdown page with the tables of a run in place of what stands between its two comments
// "terrview-bench --page: begin" and "end"; empty where it lacks them.
[[nodiscard]] std::string page_with_tables(const std::string& page, const BenchRun& run);

}  // namespace terrview
