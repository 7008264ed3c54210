// What random fields and skies cost on one thread, by processor time.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace terrview {

// The median processor seconds of a few calls.
[[nodiscard]] double seconds_of(const std::function<void()>& work);

// Prints millions of vertices a second of every form of the field, beside a plain sum of value
// noise of the same size, for root cells divided `levels` times.
void print_field_rates(const std::vector<int>& levels);

// Prints how the power of each kind of field along diagonals compares with that along axes.
void print_spectrum();

// Prints the cost and the error of clouds in perspective, by subdivision and pixel by pixel.
void print_perspective();

// Prints what the sky of a view costs beside the ground under it. `args` as for `terrview view`.
void print_view(const std::vector<std::string>& args);

}  // namespace terrview
