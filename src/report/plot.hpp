#pragma once

// Line and scatter plots as SVG: one picture, no scripts, no fonts of its own, dark on white. It scales with the width
// that it is given (viewBox), so that it can be read on narrow screens, too.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/origin.hpp"

namespace facet::report {

// A series' points are circles, squares, triangles ... in turn and have one of eight colours: 24 series are told apart.
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

// Of the line through the logarithms of its points: -0.5 where y falls by N^-1/2. Not finite: fewer than two points.
double logSlope(const Series& series);

// A zone of x that is told apart by its ground, with a word at its top.
struct Zone {
  double from = 0, to = 0;
  std::string label = {};
};

// Values over the whole of both axes as colours, from dark to bright (viridis) with a scale beside them; what is not
// finite is left out.
struct HeatMap {
  size_t columns = 0, rows = 0;     // 0: none
  std::vector<double> values = {};  // row by row from below
  double from = 0, to = 0;          // the scale; equal: the values' own range
  std::string label = {};           // of the scale
};

struct Plot {
  std::string title = {};
  AxisOptions x = {}, y = {};
  std::vector<Series> series = {};
  std::vector<Zone> zones = {};
  HeatMap map = {};
  int width = 720, height = 440;  // [px] before scaling; at least 320 x 200
};

// Several below each other in one picture: XML, UTF-8. No data in range: axes from 0 to 1 (1 to 10), and a word that
// says so. Below stands where the figures come from, and all of it in <metadata>; nothing where the origin names no
// version.
std::string svg(const std::vector<Plot>& plots, const Origin& origin);

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
