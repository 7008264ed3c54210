#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <sstream>
#include <utility>

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
// Powers of ten shown.
constexpr int kLeastError = -9;
constexpr int kLargestError = 1;
constexpr int kLeastSpeed = -2;  // Mray/s
constexpr int kLargestSpeed = 4;

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

double clamped_log(double value, int least, int largest) {
  return std::clamp(std::log10(value), static_cast<double>(least), static_cast<double>(largest));
}

Point place(const BenchResult& result) {
  const double error = result.max_rel_error.value_or(0);
  const double share = (clamped_log(error, kLeastError, kLargestError) - kLeastError) /
                       (kLargestError - kLeastError);
  const double up = (clamped_log(result.mrays_per_s, kLeastSpeed, kLargestSpeed) - kLeastSpeed) /
                    (kLargestSpeed - kLeastSpeed);
  return {error > 0 ? kZeroColumn + share * (kPanelWide - kZeroColumn) : kZeroColumn / 2,
          (1 - up) * kPanelHigh};
}

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

// Shape and colour tell the contenders apart, so that neither has to do it alone.
void mark(std::ostream& svg, std::size_t which, Point at) {
  const std::string paint =
      std::string("' fill='") + kColors[which % kColors.size()] + "' fill-opacity='0.85'/>\n";
  const double r = 4.5;
  switch (which / kColors.size() % 3) {
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

void axes(std::ostream& svg, const std::string& title) {
  svg << "<rect width='" << kPanelWide << "' height='" << kPanelHigh
      << "' fill='none' stroke='#888'/>\n";
  for (int e = kLeastSpeed; e <= kLargestSpeed; ++e) {
    const double y =
        kPanelHigh * (kLargestSpeed - e) / static_cast<double>(kLargestSpeed - kLeastSpeed);
    line(svg, {0, y}, {kPanelWide, y});
    text(svg, {-5, y + 3}, "end", power_of_ten(e));
  }
  line(svg, {kZeroColumn, 0}, {kZeroColumn, kPanelHigh});
  text(svg, {kZeroColumn / 2, kPanelHigh + 13}, "middle", "exact");
  for (int e = kLeastError + 1; e <= kLargestError; e += 2) {
    const double x = kZeroColumn + (kPanelWide - kZeroColumn) * (e - kLeastError) /
                                       static_cast<double>(kLargestError - kLeastError);
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
    const std::string title = result.dem + ", " + result.view;
    if (panels.empty() || panels.back().first != title) panels.push_back({title, {}});
    panels.back().second.push_back(&result);
  }
  return panels;
}

std::map<std::string, std::size_t> marks_of(const std::vector<Panel>& panels) {
  std::map<std::string, std::size_t> marks;
  for (const Panel& panel : panels)
    for (const BenchResult* result : panel.second) marks.try_emplace(key_of(*result), marks.size());
  return marks;
}

void legend(std::ostream& svg, const std::map<std::string, std::size_t>& marks, double top) {
  for (const auto& [name, which] : marks) {
    const Point at{kMarginLeft + static_cast<double>(which % 4) * 245,
                   top + static_cast<double>(which / 4) * kLegendLine};
    mark(svg, which, at);
    text(svg, {at.x + 10, at.y + 4}, "start", name);
  }
}

}  // namespace

std::string figure_svg(const BenchRun& run) {
  const std::vector<Panel> panels = panels_of(run);
  const std::map<std::string, std::size_t> marks = marks_of(panels);
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
       run.machine.value("cpu", "") + ", primary rays, " + run.date.substr(0, 10) + ", " +
           run.command);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    svg << "<g transform='translate("
        << kMarginLeft + static_cast<double>(i % kPanelsInRow) * column << ' '
        << kMarginTop + static_cast<double>(i / kPanelsInRow) * row << ")'>\n";
    axes(svg, panels[i].first);
    for (const BenchResult* result : panels[i].second)
      mark(svg, marks.at(key_of(*result)), place(*result));
    svg << "</g>\n";
  }
  legend(svg, marks, legend_top);
  svg << "</svg>\n";
  return svg.str();
}

}  // namespace terrview
