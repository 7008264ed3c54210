// Roots of functions that rise or fall throughout.
#pragma once

namespace terrview {

// The root of f between two points where its signs differ, to the last bits: the Illinois rule of
// false position (Dowell & Jarratt, BIT 11, 1971), with a halving every fourth time.
template <class Function>
[[nodiscard]] double root_between(const Function& f, double low, double high) {
  double f_low = f(low);
  double f_high = f(high);
  int kept = 0;  // -1 where the lower end was kept last, 1 where the higher was
  for (int i = 1; i <= 200; ++i) {
    const double at =
        i % 4 == 0 ? low + (high - low) / 2 : low - f_low * ((high - low) / (f_high - f_low));
    if (!(at > low)) return low;
    if (!(at < high)) return high;
    const double f_at = f(at);
    if (f_at == 0) return at;
    if ((f_at < 0) == (f_low < 0)) {
      low = at;
      f_low = f_at;
      if (kept == 1) f_high /= 2;
      kept = 1;
    } else {
      high = at;
      f_high = f_at;
      if (kept == -1) f_low /= 2;
      kept = -1;
    }
  }
  return low;
}

}  // namespace terrview
