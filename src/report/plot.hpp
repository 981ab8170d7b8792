#pragma once

// Line and scatter plots as SVG: one picture, no scripts, no fonts of its own, dark on white. It scales with the width
// that it is given (viewBox), so that it can be read on narrow screens, too.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace facet::report {

// Points in the order in which the line joins them. One that is not finite, or not positive on a logarithmic axis, is
// left out and parts the line.
struct Series {
  std::string name = {};  // in the legend; empty: not there
  std::vector<double> x = {}, y = {};
  bool line = true;
  bool dots = false;
  bool dashed = false;
  std::string color = {};           // as CSS has it; empty: the next of eight
  std::vector<size_t> marked = {};  // indices of points with a ring around them, a Pareto front for instance
  // Beside the points, and what a browser shows under the pointer; may be shorter.
  std::vector<std::string> labels = {};
};

struct AxisOptions {
  std::string label = {};
  bool logarithmic = false;
  // Where both are equal: the data's own range, widened to whole ticks.
  double from = 0, to = 0;
};

// A zone of x that is told apart by its ground, with a word at its top.
struct Zone {
  double from = 0, to = 0;
  std::string label = {};
};

struct Plot {
  std::string title = {};
  AxisOptions x = {}, y = {};
  std::vector<Series> series = {};
  std::vector<Zone> zones = {};
  int width = 720, height = 440;  // [px] before scaling; at least 320 x 200
};

// XML, UTF-8. No data in range: axes from 0 to 1 (1 to 10), and a word that says so.
std::string svg(const Plot& plot);
// Several below each other in one picture.
std::string svg(const std::vector<Plot>& plots);

// Positions of ticks within [from, to]: linear ones at 1, 2 or 5 times a power of ten, about `wanted` of them;
// logarithmic ones at powers of ten, with 2 and 5 between where the range spans less than two of them. from < to;
// logarithmic: from > 0.
std::vector<double> ticks(double from, double to, bool logarithmic, int wanted = 6);
// "0.05", "200", "1e-6": at most four significant digits, powers of ten short.
std::string tickText(double value);

// Where a value lies in the picture's plane of `plot`, as svg() puts it [px]; what tests and overlays need.
struct PlotFrame {
  double left, right, top, bottom;  // of the axes [px]
  double xFrom, xTo, yFrom, yTo;    // of the data
  double x(double value, bool logarithmic) const;
  double y(double value, bool logarithmic) const;
};
PlotFrame frameOf(const Plot& plot);

}  // namespace facet::report
