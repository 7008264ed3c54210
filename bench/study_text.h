// What reports and studies share: lines of text, and processor time.
#pragma once

#include <array>
#include <cstdio>
#include <ctime>
#include <ostream>
#include <string>

namespace terrview {

// Of printf, up to 199 characters.
template <class... Values>
[[nodiscard]] std::string format(const char* pattern, Values... values) {
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(), pattern, values...);
  return text.data();
}

template <class... Values>
void print_line(std::ostream& out, const char* pattern, Values... values) {
  out << format(pattern, values...) << '\n';
  out.flush();
}

// Of the calling thread.
inline double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace terrview
