#include "report/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace facet::report {

namespace {

// Told apart also where colours are not (Okabe and Ito 2008), darkened where they would be pale on white.
constexpr std::array<const char*, 8> colors = {"#0072b2", "#d55e00", "#009e73", "#b0468c",
                                               "#7a6a00", "#56a0d0", "#444444", "#e69f00"};
constexpr int legendRow = 18;

std::string colorOf(const Plot& plot, size_t i) {
  return plot.series[i].color.empty() ? colors[i % colors.size()] : plot.series[i].color;
}

std::string px(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

std::string escaped(std::string_view text) {
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
    for (const double rise : {6.0, -4.0, 18.0, -16.0, 30.0, -28.0, 42.0, -40.0})
      for (const bool before : {right, !right}) {
        const Box box = boxAt(before, rise);
        const bool inside =
            box.left > frame_.left && box.right < frame_.right && box.top > frame_.top && box.bottom < frame_.bottom;
        if (!inside || std::ranges::any_of(taken_, [&](const Box& other) { return other.meets(box); })) continue;
        taken_.push_back(box);
        return write(x, y, words, before, rise);
      }
    return write(x, y, words, right, 6);
  }

 private:
  static std::string write(double x, double y, const std::string& words, bool before, double rise) {
    return text(before ? x - 8 : x + 8, y - rise, words,
                std::string("text-anchor=\"") + (before ? "end" : "start") + "\" font-size=\"11\"");
  }

  const PlotFrame& frame_;
  std::vector<Box> taken_;
};

std::string dots(const Plot& plot, const PlotFrame& frame, const Series& series, const std::string& color,
                 Labels& labels) {
  std::string out;
  for (size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    const bool ring = std::find(series.marked.begin(), series.marked.end(), i) != series.marked.end();
    const std::string label = i < series.labels.size() ? series.labels[i] : std::string();
    if (!shown(series.x[i], plot.x) || !shown(series.y[i], plot.y)) continue;
    if (!ring && !series.dots && label.empty()) continue;
    const double x = frame.x(series.x[i], plot.x.logarithmic), y = frame.y(series.y[i], plot.y.logarithmic);
    const std::string at = "cx=\"" + px(x) + "\" cy=\"" + px(y) + "\"";
    if (ring) out += "<circle " + at + " r=\"6.5\" fill=\"none\" stroke=\"#222222\" stroke-width=\"1.3\"/>\n";
    out += "<circle " + at + " r=\"3.2\" fill=\"" + color + "\">";
    const std::string where = tickText(series.x[i]) + ", " + tickText(series.y[i]);
    out += "<title>" + escaped((label.empty() ? series.name : label) + ": " + where) + "</title></circle>\n";
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
    if (series.dots || !series.line)
      out += "<circle cx=\"" + px(x + 12) + "\" cy=\"" + px(y - 4) + "\" r=\"3.2\" fill=\"" + color + "\"/>\n";
    out += text(x + 30, y, series.name, "text-anchor=\"start\"");
    ++place;
  }
  return out;
}

std::string drawn(const Plot& plot, const std::string& clip) {
  const PlotFrame frame = frameOf(plot);
  std::string out = text(frame.left, 23, plot.title, "font-size=\"15\" font-weight=\"bold\"");
  out += axes(plot, frame);
  out += "<clipPath id=\"" + clip + "\"><rect x=\"" + px(frame.left) + "\" y=\"" + px(frame.top) + "\" width=\"" +
         px(frame.right - frame.left) + "\" height=\"" + px(frame.bottom - frame.top) + "\"/></clipPath>\n";
  std::string curves, points;
  Labels labels(plot, frame);
  for (size_t i = 0; i < plot.series.size(); ++i) {
    const std::string color = colorOf(plot, i);
    if (plot.series[i].line) curves += curve(plot, frame, plot.series[i], color);
    points += dots(plot, frame, plot.series[i], color, labels);
  }
  out += "<g clip-path=\"url(#" + clip + ")\">\n" + curves + "</g>\n" + points;
  if (curves.empty() && points.empty())
    out += text((frame.left + frame.right) / 2, (frame.top + frame.bottom) / 2, "no data", "text-anchor=\"middle\"");
  return out + legendText(plot, frame);
}

}  // namespace

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
  return {68, std::max(plot.width, 320) - 22.0, 38, std::max(plot.height, 200) - below, x.from, x.to, y.from, y.to};
}

std::string svg(const Plot& plot) { return svg(std::vector{plot}); }

std::string svg(const std::vector<Plot>& plots) {
  const auto heightOf = [](const Plot& plot) { return std::max(plot.height, 200); };
  int width = 320, height = 0;
  for (const Plot& plot : plots) {
    width = std::max(width, plot.width);
    height += heightOf(plot);
  }
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + std::to_string(width) + " " +
                    std::to_string(height) + "\" width=\"" + std::to_string(width) + "\" height=\"" +
                    std::to_string(height) +
                    "\" style=\"max-width:100%;height:auto\" font-family=\"sans-serif\" font-size=\"13\" "
                    "fill=\"#222222\" role=\"img\">\n";
  if (!plots.empty()) out += "<title>" + escaped(plots.front().title) + "</title>\n";
  out += "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  int top = 0;
  for (size_t i = 0; i < plots.size(); ++i) {
    out += "<g transform=\"translate(0," + std::to_string(top) + ")\">\n" +
           drawn(plots[i], "axes" + std::to_string(i)) + "</g>\n";
    top += heightOf(plots[i]);
  }
  return out + "</svg>\n";
}

}  // namespace facet::report
