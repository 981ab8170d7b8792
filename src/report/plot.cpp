#include "report/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "base/text.hpp"
#include "optics/color.hpp"

namespace facet::report {

namespace {

// Told apart also where colours are not (Okabe and Ito 2008), darkened where they would be pale on white.
constexpr std::array<const char*, 8> colors = {"#0072b2", "#d55e00", "#009e73", "#b0468c",
                                               "#7a6a00", "#56a0d0", "#444444", "#e69f00"};
constexpr int legendRow = 18, markForms = 6, scaleWidth = 86;  // [px]

std::string colorOf(const Plot& plot, size_t i) {
  return plot.series[i].color.empty() ? colors[i % colors.size()] : plot.series[i].color;
}

std::string px(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

std::string escaped(std::string_view raw) {
  const std::string text = withValidUtf8(raw).value_or(std::string(raw));  // names of files may be anything
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20) result += c;  // XML knows no control characters
    }
  }
  return result;
}

bool shown(double value, const AxisOptions& axis) { return std::isfinite(value) && (!axis.logarithmic || value > 0); }

struct Range {
  double from = std::numeric_limits<double>::infinity(), to = -std::numeric_limits<double>::infinity();
  bool empty() const { return from > to; }
};

double niceStep(double length, int wanted) {
  const double raw = length / std::max(wanted, 1), power = std::pow(10, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= raw * (1 - 1e-9)) return factor * power;
  return 10 * power;
}

Range wholeTicks(Range range, const AxisOptions& axis) {
  if (axis.from != axis.to) return {std::min(axis.from, axis.to), std::max(axis.from, axis.to)};
  if (range.empty()) return axis.logarithmic ? Range{1, 10} : Range{0, 1};
  if (axis.logarithmic) {
    const auto edge = [](double value, bool up) {
      const double power = std::pow(10, std::floor(std::log10(value) + 1e-9));
      for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
        if (up && factor * power >= value * (1 - 1e-9)) return factor * power;
        if (!up && factor * power > value * (1 + 1e-9)) return (factor == 2 ? 1 : factor == 5 ? 2 : 5) * power;
      }
      return 10 * power;
    };
    Range whole{edge(range.from, false), edge(range.to, true)};
    if (whole.from == whole.to) whole = {whole.from / 10, whole.to * 10};
    return whole;
  }
  if (range.from == range.to) {
    const double half = range.from == 0 ? 1 : std::abs(range.from) / 2;
    range = {range.from - half, range.to + half};
  }
  const double step = niceStep(range.to - range.from, 6);
  return {std::floor(range.from / step + 1e-9) * step, std::ceil(range.to / step - 1e-9) * step};
}

Range dataRange(const Plot& plot, bool ofX) {
  Range range;
  for (const Series& series : plot.series) {
    for (size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
      if (!shown(series.x[i], plot.x) || !shown(series.y[i], plot.y)) continue;
      const double value = ofX ? series.x[i] : series.y[i];
      range = {std::min(range.from, value), std::max(range.to, value)};
    }
  }
  return wholeTicks(range, ofX ? plot.x : plot.y);
}

double along(double value, double from, double to, bool logarithmic) {
  if (logarithmic) return std::log(value / from) / std::log(to / from);
  return (value - from) / (to - from);
}

// The legend stands below the axes, as many entries in a row as fit.
struct Legend {
  std::vector<const Series*> entries;
  size_t columns = 1, rows = 0;
  double columnWidth = 0;
};
Legend legendOf(const Plot& plot) {
  Legend legend;
  size_t longest = 0;
  for (const Series& series : plot.series) {
    if (series.name.empty()) continue;
    legend.entries.push_back(&series);
    longest = std::max(longest, series.name.size());
  }
  if (legend.entries.empty()) return legend;
  legend.columnWidth = 44 + 7.0 * static_cast<double>(longest);
  legend.columns =
      std::clamp<size_t>(static_cast<size_t>((plot.width - 90) / legend.columnWidth), 1, legend.entries.size());
  legend.rows = (legend.entries.size() + legend.columns - 1) / legend.columns;
  return legend;
}

std::string text(double x, double y, const std::string& words, const std::string& attributes) {
  return "<text x=\"" + px(x) + "\" y=\"" + px(y) + "\" " + attributes + ">" + escaped(words) + "</text>\n";
}
std::string line(double x1, double y1, double x2, double y2, const char* color) {
  return "<line x1=\"" + px(x1) + "\" y1=\"" + px(y1) + "\" x2=\"" + px(x2) + "\" y2=\"" + px(y2) + "\" stroke=\"" +
         color + "\"/>\n";
}

std::string axes(const Plot& plot, const PlotFrame& frame) {
  std::string out;
  for (const Zone& zone : plot.zones) {
    const double from = std::clamp(frame.x(zone.from, plot.x.logarithmic), frame.left, frame.right);
    const double to = std::clamp(frame.x(zone.to, plot.x.logarithmic), frame.left, frame.right);
    out += "<rect x=\"" + px(std::min(from, to)) + "\" y=\"" + px(frame.top) + "\" width=\"" + px(std::abs(to - from)) +
           "\" height=\"" + px(frame.bottom - frame.top) + "\" fill=\"#eeeeee\"/>\n";
    if (zone.label.empty()) continue;
    const double half = 3.2 * static_cast<double>(zone.label.size());  // of the word, about
    out += text(std::clamp((from + to) / 2, frame.left + half, std::max(frame.right - half, frame.left + half)),
                frame.top + 14, zone.label, "text-anchor=\"middle\" fill=\"#555555\" font-size=\"11\"");
  }
  const int wantedX = std::max(2, plot.width / 110), wantedY = std::max(2, plot.height / 65);
  for (const double tick : ticks(frame.xFrom, frame.xTo, plot.x.logarithmic, wantedX)) {
    const double x = frame.x(tick, plot.x.logarithmic);
    out += line(x, frame.top, x, frame.bottom, "#dddddd");
    out += text(x, frame.bottom + 17, tickText(tick), "text-anchor=\"middle\"");
  }
  for (const double tick : ticks(frame.yFrom, frame.yTo, plot.y.logarithmic, wantedY)) {
    const double y = frame.y(tick, plot.y.logarithmic);
    out += line(frame.left, y, frame.right, y, "#dddddd");
    out += text(frame.left - 7, y + 4, tickText(tick), "text-anchor=\"end\"");
  }
  out += line(frame.left, frame.bottom, frame.right, frame.bottom, "#222222");
  out += line(frame.left, frame.top, frame.left, frame.bottom, "#222222");
  out += text((frame.left + frame.right) / 2, frame.bottom + 36, plot.x.label, "text-anchor=\"middle\"");
  const std::string middle = px((frame.top + frame.bottom) / 2);
  out += "<text transform=\"translate(16," + middle + ") rotate(-90)\" text-anchor=\"middle\">" +
         escaped(plot.y.label) + "</text>\n";
  return out;
}

std::string colorText(double share) {
  const glm::dvec3 color = optics::falseColor(share);
  char text[16];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", static_cast<int>(std::lround(255 * color.r)),
                static_cast<int>(std::lround(255 * color.g)), static_cast<int>(std::lround(255 * color.b)));
  return text;
}

std::string rectangle(double x, double y, double width, double height, const std::string& color) {
  return "<rect x=\"" + px(x) + "\" y=\"" + px(y) + "\" width=\"" + px(width) + "\" height=\"" + px(height) +
         "\" fill=\"" + color + "\"/>\n";
}

std::pair<double, double> scaleOf(const HeatMap& map) {
  if (map.from != map.to) return {map.from, map.to};
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const double value : map.values)
    if (std::isfinite(value)) least = std::min(least, value), most = std::max(most, value);
  if (!(least <= most)) return {0, 1};
  return least < most ? std::pair{least, most} : std::pair{least, least + 1};
}

std::string cells(const Plot& plot, const PlotFrame& frame) {
  const HeatMap& map = plot.map;
  if (map.values.empty()) return {};
  const auto [from, to] = scaleOf(map);
  const double width = (frame.right - frame.left) / static_cast<double>(map.columns);
  const double height = (frame.bottom - frame.top) / static_cast<double>(map.rows);
  std::string out = "<g shape-rendering=\"crispEdges\">\n";
  for (size_t i = 0; i < map.values.size(); ++i) {
    if (!std::isfinite(map.values[i])) continue;
    const double x = frame.left + width * static_cast<double>(i % map.columns);
    const double y = frame.bottom - height * static_cast<double>(i / map.columns + 1);
    out += rectangle(x, y, width, height, colorText((map.values[i] - from) / (to - from)));
  }
  constexpr int steps = 32;
  const double x = frame.right + 16, step = (frame.bottom - frame.top) / steps;
  for (int i = 0; i < steps; ++i)
    out += rectangle(x, frame.bottom - (i + 1) * step, 12, step, colorText((i + 0.5) / steps));
  out += "</g>\n";
  for (const double tick : ticks(from, to, false, 4))
    out += text(x + 16, frame.bottom - (tick - from) / (to - from) * (frame.bottom - frame.top) + 4, tickText(tick),
                "text-anchor=\"start\" font-size=\"11\"");
  return out + text(x + 12, frame.top - 6, map.label, "text-anchor=\"middle\" font-size=\"11\"");
}

std::string curve(const Plot& plot, const PlotFrame& frame, const Series& series, const std::string& color) {
  std::string points, out;
  const auto flush = [&] {
    if (points.empty()) return;
    out += "<polyline points=\"" + points + "\" fill=\"none\" stroke=\"" + color + "\" stroke-width=\"1.8\"" +
           (series.dashed ? " stroke-dasharray=\"6 4\"" : "") + "/>\n";
    points.clear();
  };
  for (size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    if (!shown(series.x[i], plot.x) || !shown(series.y[i], plot.y)) {
      flush();
      continue;
    }
    points += (points.empty() ? "" : " ") + px(frame.x(series.x[i], plot.x.logarithmic)) + "," +
              px(frame.y(series.y[i], plot.y.logarithmic));
  }
  flush();
  return out;
}

// A series' mark around a point, about as large for the eye in each form.
std::string mark(size_t series, double x, double y, const std::string& color, const std::string& title) {
  const auto polygon = [&](std::initializer_list<std::pair<double, double>> corners) {
    std::string points;
    for (const auto& [dx, dy] : corners) points += (points.empty() ? "" : " ") + px(x + dx) + "," + px(y + dy);
    return "<polygon points=\"" + points + "\"";
  };
  std::string shape, attributes = " fill=\"" + color + "\"";
  switch (series % markForms) {
    case 0:
      shape = "<circle cx=\"" + px(x) + "\" cy=\"" + px(y) + "\" r=\"3.2\"";
      break;
    case 1:
      shape = polygon({{-3, -3}, {3, -3}, {3, 3}, {-3, 3}});
      break;
    case 2:
      shape = polygon({{0, -4}, {3.8, 2.8}, {-3.8, 2.8}});
      break;
    case 3:
      shape = polygon({{0, -4.4}, {4.4, 0}, {0, 4.4}, {-4.4, 0}});
      break;
    case 4:
      shape = polygon({{0, 4}, {3.8, -2.8}, {-3.8, -2.8}});
      break;
    default:
      shape = "<circle cx=\"" + px(x) + "\" cy=\"" + px(y) + "\" r=\"3\"";
      attributes = " fill=\"#ffffff\" stroke=\"" + color + "\" stroke-width=\"1.8\"";
      break;
  }
  return shape + attributes + ">" + (title.empty() ? "" : "<title>" + escaped(title) + "</title>") +
         (shape.starts_with("<circle") ? "</circle>\n" : "</polygon>\n");
}

struct Box {
  double left, right, top, bottom;  // [px]
  bool meets(const Box& o) const { return left < o.right && o.left < right && top < o.bottom && o.top < bottom; }
};

// Places for words beside their points, clear of each other and of all points where there is room.
class Labels {
 public:
  Labels(const Plot& plot, const PlotFrame& frame) : frame_(frame) {
    for (const Series& series : plot.series)
      for (size_t i = 0; series.dots && i < std::min(series.x.size(), series.y.size()); ++i) {
        if (!shown(series.x[i], plot.x) || !shown(series.y[i], plot.y)) continue;
        const double x = frame.x(series.x[i], plot.x.logarithmic), y = frame.y(series.y[i], plot.y.logarithmic);
        taken_.push_back({x - 7, x + 7, y - 7, y + 7});
      }
  }

  std::string place(double x, double y, const std::string& words) {
    const bool right = x > (frame_.left + 3 * frame_.right) / 4;  // there the word stands before its point
    const double width = 6.2 * static_cast<double>(words.size());
    const auto boxAt = [&](bool before, double rise) {
      const double from = before ? x - 8 - width : x + 8;
      return Box{from, from + width, y - rise - 10, y - rise + 2};
    };
    for (const double rise : {6.0, -4.0, 18.0, -16.0, 30.0, -28.0, 42.0, -40.0, 54.0, -52.0})
      for (const bool before : {right, !right}) {
        const Box box = boxAt(before, rise);
        const bool inside =
            box.left > frame_.left && box.right < frame_.right && box.top > frame_.top && box.bottom < frame_.bottom;
        if (!inside || std::ranges::any_of(taken_, [&](const Box& other) { return other.meets(box); })) continue;
        taken_.push_back(box);
        return write(x, y, words, before, rise);
      }
    return {};  // the pointer shows it
  }

 private:
  static std::string write(double x, double y, const std::string& words, bool before, double rise) {
    return text(before ? x - 8 : x + 8, y - rise, words,
                std::string("text-anchor=\"") + (before ? "end" : "start") + "\" font-size=\"11\"");
  }

  const PlotFrame& frame_;
  std::vector<Box> taken_;
};

std::string dots(const Plot& plot, const PlotFrame& frame, size_t index, Labels& labels) {
  const Series& series = plot.series[index];
  const std::string color = colorOf(plot, index);
  std::string out;
  for (size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    const bool ring = std::find(series.marked.begin(), series.marked.end(), i) != series.marked.end();
    const std::string label = i < series.labels.size() ? series.labels[i] : std::string();
    if (!shown(series.x[i], plot.x) || !shown(series.y[i], plot.y)) continue;
    if (!ring && !series.dots && label.empty()) continue;
    const double x = frame.x(series.x[i], plot.x.logarithmic), y = frame.y(series.y[i], plot.y.logarithmic);
    const std::string at = "cx=\"" + px(x) + "\" cy=\"" + px(y) + "\"";
    if (ring) out += "<circle " + at + " r=\"6.5\" fill=\"none\" stroke=\"#222222\" stroke-width=\"1.3\"/>\n";
    const std::string where = tickText(series.x[i]) + ", " + tickText(series.y[i]);
    out += mark(index, x, y, color, (label.empty() ? series.name : label) + ": " + where);
    if (!label.empty()) out += labels.place(x, y, label);
  }
  return out;
}

std::string legendText(const Plot& plot, const PlotFrame& frame) {
  const Legend legend = legendOf(plot);
  std::string out;
  size_t place = 0;
  for (size_t i = 0; i < plot.series.size(); ++i) {
    const Series& series = plot.series[i];
    if (series.name.empty()) continue;
    const double x = frame.left + static_cast<double>(place % legend.columns) * legend.columnWidth;
    const double y = frame.bottom + 58 + legendRow * static_cast<double>(place / legend.columns);
    const std::string color = colorOf(plot, i);
    if (series.line)
      out += "<line x1=\"" + px(x) + "\" y1=\"" + px(y - 4) + "\" x2=\"" + px(x + 24) + "\" y2=\"" + px(y - 4) +
             "\" stroke=\"" + color + "\" stroke-width=\"2.2\"" + (series.dashed ? " stroke-dasharray=\"6 4\"" : "") +
             "/>\n";
    if (series.dots || !series.line) out += mark(i, x + 12, y - 4, color, "");
    out += text(x + 30, y, series.name, "text-anchor=\"start\"");
    ++place;
  }
  return out;
}

std::string drawn(const Plot& plot, const std::string& clip) {
  const PlotFrame frame = frameOf(plot);
  std::string out = text(frame.left, 23, plot.title, "font-size=\"15\" font-weight=\"bold\"");
  out += cells(plot, frame);
  out += axes(plot, frame);
  out += "<clipPath id=\"" + clip + "\"><rect x=\"" + px(frame.left) + "\" y=\"" + px(frame.top) + "\" width=\"" +
         px(frame.right - frame.left) + "\" height=\"" + px(frame.bottom - frame.top) + "\"/></clipPath>\n";
  std::string curves, points;
  Labels labels(plot, frame);
  for (size_t i = 0; i < plot.series.size(); ++i) {
    const std::string color = colorOf(plot, i);
    if (plot.series[i].line) curves += curve(plot, frame, plot.series[i], color);
    points += dots(plot, frame, i, labels);
  }
  out += "<g clip-path=\"url(#" + clip + ")\">\n" + curves + "</g>\n" + points;
  if (curves.empty() && points.empty() && plot.map.values.empty())
    out += text((frame.left + frame.right) / 2, (frame.top + frame.bottom) / 2, "no data", "text-anchor=\"middle\"");
  return out + legendText(plot, frame);
}

}  // namespace

double logSlope(const Series& series) {
  double n = 0, x1 = 0, y1 = 0, x2 = 0, xy = 0;
  for (size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    if (!(series.x[i] > 0 && series.y[i] > 0)) continue;
    const double x = std::log(series.x[i]), y = std::log(series.y[i]);
    n += 1, x1 += x, y1 += y, x2 += x * x, xy += x * y;
  }
  return (n * xy - x1 * y1) / (n * x2 - x1 * x1);
}

std::vector<double> ticks(double from, double to, bool logarithmic, int wanted) {
  std::vector<double> result;
  if (!(from < to) || !std::isfinite(from) || !std::isfinite(to) || (logarithmic && from <= 0)) return result;
  if (logarithmic) {
    const double first = std::floor(std::log10(from) + 1e-9), last = std::ceil(std::log10(to) - 1e-9);
    const bool dense = std::log10(to / from) < 2;
    const double stride = std::max(1.0, std::ceil((last - first) / std::max(2 * wanted, 1)));
    for (double power = first; power <= last; power += stride) {
      for (const double factor : {1.0, 2.0, 5.0}) {
        const double value = factor * std::pow(10, power);
        if ((factor == 1 || dense) && value >= from * (1 - 1e-9) && value <= to * (1 + 1e-9)) result.push_back(value);
      }
    }
    return result;
  }
  const double step = niceStep(to - from, wanted);
  for (double k = std::ceil(from / step - 1e-9); k * step <= to + 1e-9 * step; ++k)
    result.push_back(k == 0 ? 0 : k * step);
  return result;
}

std::string tickText(double value) {
  char number[32];
  std::snprintf(number, sizeof number, "%.4g", value);
  std::string result = number;
  const size_t e = result.find('e');
  if (e == std::string::npos) return result;
  const int power = std::atoi(result.c_str() + e + 1);
  return result.substr(0, e) + "e" + std::to_string(power);
}

double PlotFrame::x(double value, bool logarithmic) const {
  return left + (right - left) * along(value, xFrom, xTo, logarithmic);
}
double PlotFrame::y(double value, bool logarithmic) const {
  return bottom - (bottom - top) * along(value, yFrom, yTo, logarithmic);
}

PlotFrame frameOf(const Plot& plot) {
  const Range x = dataRange(plot, true), y = dataRange(plot, false);
  const double below = 50 + legendRow * static_cast<double>(legendOf(plot).rows);
  const double beside = plot.map.values.empty() ? 22 : scaleWidth;
  return {68, std::max(plot.width, 320) - beside, 38, std::max(plot.height, 200) - below, x.from, x.to, y.from, y.to};
}

namespace {

// Where figures come from, for the eye: in short lines below the plots.
std::vector<std::string> footer(const Origin& origin, int width) {
  if (origin.version.empty()) return {};
  std::vector<std::string> parts = {"facet " + origin.version + " " + origin.commit};
  for (const std::string* part : {&origin.renderer, &origin.environment, &origin.model, &origin.date})
    if (!part->empty()) parts.push_back(*part);
  const size_t longest = static_cast<size_t>(width - 90) / 6;
  std::vector<std::string> lines = {""};
  for (const std::string& part : parts) {
    if (!lines.back().empty() && lines.back().size() + part.size() + 3 > longest) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " · ") + part;
  }
  return lines;
}

std::string metadata(const Origin& origin) {
  if (origin.version.empty()) return {};
  std::string out = "<metadata>\n";
  for (const auto& [name, value] : originFields(origin))
    if (!value.empty()) out.append(name).append(": ").append(escaped(value)).append("\n");
  return out + "</metadata>\n";
}

}  // namespace

std::string svg(const std::vector<Plot>& plots, const Origin& origin) {
  const auto heightOf = [](const Plot& plot) { return std::max(plot.height, 200); };
  constexpr int footerRow = 15;
  int width = 320, height = 0;
  for (const Plot& plot : plots) {
    width = std::max(width, plot.width);
    height += heightOf(plot);
  }
  const std::vector<std::string> lines = footer(origin, width);
  const int whole = height + (lines.empty() ? 0 : footerRow * static_cast<int>(lines.size()) + 8);
  const std::string size = std::to_string(width) + " " + std::to_string(whole);
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + size + "\" width=\"" +
                    std::to_string(width) + "\" height=\"" + std::to_string(whole) +
                    "\" style=\"max-width:100%;height:auto\" font-family=\"sans-serif\" font-size=\"13\" "
                    "fill=\"#222222\" role=\"img\">\n";
  if (!plots.empty()) out += "<title>" + escaped(plots.front().title) + "</title>\n";
  out += metadata(origin);
  out += "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  int top = 0;
  for (size_t i = 0; i < plots.size(); ++i) {
    out += "<g transform=\"translate(0," + std::to_string(top) + ")\">\n" +
           drawn(plots[i], "axes" + std::to_string(i)) + "</g>\n";
    top += heightOf(plots[i]);
  }
  for (size_t i = 0; i < lines.size(); ++i)
    out += text(68, top + footerRow * static_cast<double>(i) + 10, lines[i], "font-size=\"10.5\" fill=\"#666666\"");
  return out + "</svg>\n";
}

}  // namespace facet::report
