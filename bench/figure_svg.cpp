#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <sstream>
#include <utility>

#include "bench/contender.h"
#include "bench/report.h"

namespace terrview {
namespace {

constexpr double kPanelWide = 300;
constexpr double kPanelHigh = 220;
constexpr double kMarginLeft = 52;
constexpr double kMarginTop = 64;
constexpr double kGap = 26;  // between panels, for the titles
constexpr double kZeroColumn = 34;
constexpr double kLegendLine = 18;
constexpr int kPanelsInRow = 3;
// Okabe and Ito's colours, told apart by most eyes.
constexpr std::array<const char*, 7> kColors{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                             "#56b4e9", "#e69f00", "#000000"};

struct Point {
  double x;
  double y;
};

std::string key_of(const BenchResult& result) {
  return result.contender + " (" + result.surface.value_or("") + ")";
}

// Powers of ten from one end of an axis to the other.
struct Decades {
  int least;
  int largest;

  void take_in(double value) {
    least = std::min(least, static_cast<int>(std::floor(std::log10(value))));
    largest = std::max(largest, static_cast<int>(std::ceil(std::log10(value))));
  }
  // Of `value` on the way from the least to the largest.
  [[nodiscard]] double share(double value) const {
    return (std::log10(value) - least) / (largest - least);
  }
};

struct Axes {
  Decades error{-6, -5};
  Decades speed{0, 1};  // Mray/s

  [[nodiscard]] double x(double value) const {
    return value > 0 ? kZeroColumn + error.share(value) * (kPanelWide - kZeroColumn)
                     : kZeroColumn / 2;
  }
  [[nodiscard]] double y(double value) const { return (1 - speed.share(value)) * kPanelHigh; }
};

std::string escape(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&') {
      safe += "&amp;";
    } else if (c == '<') {
      safe += "&lt;";
    } else {
      safe += c;
    }
  }
  return safe;
}

void text(std::ostream& svg, Point at, const char* anchor, const std::string& words) {
  svg << "<text x='" << at.x << "' y='" << at.y << "' text-anchor='" << anchor << "'>"
      << escape(words) << "</text>\n";
}

void line(std::ostream& svg, Point from, Point to) {
  svg << "<path d='M" << from.x << ' ' << from.y << 'L' << to.x << ' ' << to.y
      << "' stroke='#ddd'/>\n";
}

std::string power_of_ten(int exponent) {
  if (exponent >= -2 && exponent <= 3) {
    std::ostringstream words;
    words << std::pow(10.0, exponent);
    return words.str();
  }
  return "1e" + std::to_string(exponent);
}

// A shape for each family, a colour within it.
struct Mark {
  std::size_t order;  // in the legend
  std::size_t shape;
  std::size_t color;
};

std::size_t shape_of(const BenchResult& result) {
  if (result.contender.starts_with("embree-grid")) return 2;
  return result.contender.starts_with("embree") ? 1 : 0;
}

// Outlines, to show what lies behind.
void draw_mark(std::ostream& svg, const Mark& mark, Point at) {
  const std::string paint = std::string("' fill='none' stroke-width='1.8' stroke='") +
                            kColors[mark.color % kColors.size()] + "'/>\n";
  const double r = 4.5;
  switch (mark.shape) {
    case 0:
      svg << "<circle cx='" << at.x << "' cy='" << at.y << "' r='" << r << paint;
      break;
    case 1:
      svg << "<rect x='" << at.x - r << "' y='" << at.y - r << "' width='" << 2 * r << "' height='"
          << 2 * r << paint;
      break;
    default:
      svg << "<path d='M" << at.x << ' ' << at.y - r << 'l' << r << ' ' << 2 * r << 'h' << -2 * r
          << 'z' << paint;
  }
}

void draw_axes(std::ostream& svg, const Axes& axes, const std::string& title) {
  svg << "<rect width='" << kPanelWide << "' height='" << kPanelHigh
      << "' fill='none' stroke='#888'/>\n";
  for (int e = axes.speed.least; e <= axes.speed.largest; ++e) {
    const double y = axes.y(std::pow(10.0, e));
    line(svg, {0, y}, {kPanelWide, y});
    text(svg, {-5, y + 3}, "end", power_of_ten(e));
  }
  line(svg, {kZeroColumn, 0}, {kZeroColumn, kPanelHigh});
  text(svg, {kZeroColumn / 2, kPanelHigh + 13}, "middle", "exact");
  const int step = axes.error.largest - axes.error.least > 6 ? 2 : 1;
  for (int e = axes.error.largest; e > axes.error.least; e -= step) {
    const double x = axes.x(std::pow(10.0, e));
    line(svg, {x, 0}, {x, kPanelHigh});
    text(svg, {x, kPanelHigh + 13}, "middle", power_of_ten(e));
  }
  text(svg, {0, -7}, "start", title);
}

using Panel = std::pair<std::string, std::vector<const BenchResult*>>;

std::vector<Panel> panels_of(const BenchRun& run) {
  int threads = run.results.empty() ? 1 : run.results[0].threads;
  for (const BenchResult& result : run.results) threads = std::min(threads, result.threads);
  std::vector<Panel> panels;
  for (const BenchResult& result : run.results) {
    if (result.rays != "primary" || result.threads != threads || !result.max_rel_error) continue;
    if (result.contender == kCurvedWay || result.contender == kBentWay) continue;
    const std::string title = result.dem + ", " + result.view;
    if (panels.empty() || panels.back().first != title) panels.push_back({title, {}});
    panels.back().second.push_back(&result);
  }
  return panels;
}

Axes axes_of(const std::vector<Panel>& panels) {
  Axes axes;
  for (const Panel& panel : panels)
    for (const BenchResult* result : panel.second) {
      const double error = *result->max_rel_error;
      if (error > 0 && std::isfinite(error)) axes.error.take_in(error);
      axes.speed.take_in(result->mrays_per_s);
    }
  return axes;
}

std::map<std::string, Mark> marks_of(const std::vector<Panel>& panels) {
  std::map<std::string, Mark> marks;
  std::array<std::size_t, 3> colors_used{};
  for (const Panel& panel : panels)
    for (const BenchResult* result : panel.second) {
      const std::size_t shape = shape_of(*result);
      const Mark mark{marks.size(), shape, colors_used[shape]};
      if (marks.try_emplace(key_of(*result), mark).second) ++colors_used[shape];
    }
  return marks;
}

void draw_legend(std::ostream& svg, const std::map<std::string, Mark>& marks, double top) {
  for (const auto& [name, mark] : marks) {
    const Point at{kMarginLeft + static_cast<double>(mark.order % 4) * 245,
                   top + static_cast<double>(mark.order / 4) * kLegendLine};
    draw_mark(svg, mark, at);
    text(svg, {at.x + 10, at.y + 4}, "start", name);
  }
}

}  // namespace

std::string figure_svg(const BenchRun& run) {
  const std::vector<Panel> panels = panels_of(run);
  const std::map<std::string, Mark> marks = marks_of(panels);
  const Axes axes = axes_of(panels);
  const double column = kPanelWide + kMarginLeft;
  const double row = kPanelHigh + 2 * kGap;
  const double rows = std::ceil(static_cast<double>(panels.size()) / kPanelsInRow);
  const double legend_top = kMarginTop + rows * row;
  const double wide = kPanelsInRow * column + kGap;
  const double high =
      legend_top + (std::ceil(static_cast<double>(marks.size()) / 4) + 1) * kLegendLine;
  std::ostringstream svg;
  svg << "<svg xmlns='http://www.w3.org/2000/svg' width='" << wide << "' height='" << high
      << "' font-family='sans-serif' font-size='11'>\n"
      << "<rect width='100%' height='100%' fill='white'/>\n";
  text(svg, {kMarginLeft, 20}, "start",
       "Speed (Mray/s, upwards) against the largest relative error of the distance (to the right)");
  text(svg, {kMarginLeft, 36}, "start",
       run.machine.value("cpu", "") + ", primary rays, " + run.date.substr(0, 10));
  for (std::size_t i = 0; i < panels.size(); ++i) {
    svg << "<g transform='translate("
        << kMarginLeft + static_cast<double>(i % kPanelsInRow) * column << ' '
        << kMarginTop + static_cast<double>(i / kPanelsInRow) * row << ")'>\n";
    draw_axes(svg, axes, panels[i].first);
    for (const BenchResult* result : panels[i].second)
      draw_mark(svg, marks.at(key_of(*result)),
                {axes.x(*result->max_rel_error), axes.y(result->mrays_per_s)});
    svg << "</g>\n";
  }
  draw_legend(svg, marks, legend_top);
  svg << "</svg>\n";
  return svg.str();
}

}  // namespace terrview
