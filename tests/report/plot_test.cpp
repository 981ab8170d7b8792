#include "report/plot.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <regex>

using namespace facet::report;
using facet::Origin;

namespace {

// Well-formed as far as a picture needs it: tags nest, attributes are quoted, text holds no bare & or <.
bool wellFormed(const std::string& xml) {
  std::vector<std::string> open;
  static const std::regex tag(R"(<(/?)([A-Za-z]+)((?:\s+[A-Za-z0-9:-]+="[^"<]*")*)\s*(/?)>)");
  size_t at = 0;
  for (auto i = std::sregex_iterator(xml.begin(), xml.end(), tag); i != std::sregex_iterator(); ++i) {
    const std::string between = xml.substr(at, static_cast<size_t>(i->position()) - at);
    if (between.find('<') != std::string::npos) return false;
    at = static_cast<size_t>(i->position() + i->length());
    if ((*i)[1].length() > 0) {
      if (open.empty() || open.back() != (*i)[2]) return false;
      open.pop_back();
    } else if ((*i)[4].length() == 0) {
      open.push_back((*i)[2]);
    }
  }
  static const std::regex bare("&(?!(amp|lt|gt|quot);)");
  return open.empty() && xml.find('<', at) == std::string::npos && !std::regex_search(xml, bare);
}

size_t count(const std::string& text, const std::string& part) {
  size_t n = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("plot: ticks at 1, 2, 5 and at powers of ten") {
  CHECK(ticks(0, 1, false, 5) == std::vector<double>{0, 0.2, 0.4, 0.6000000000000001, 0.8, 1});
  CHECK(ticks(-3, 17, false, 4) == std::vector<double>{0, 5, 10, 15});
  CHECK(ticks(1, 1000, true) == std::vector<double>{1, 10, 100, 1000});
  CHECK(ticks(1, 10, true) == std::vector<double>{1, 2, 5, 10});
  CHECK(ticks(1e-30, 1e30, true, 5).size() <= 12);
  CHECK(ticks(1, 1, false).empty());
  CHECK(ticks(0, 1, true).empty());
  CHECK(ticks(0, std::numeric_limits<double>::infinity(), false).empty());
  CHECK(tickText(0.05) == "0.05");
  CHECK(tickText(1e-6) == "1e-6");
  CHECK(tickText(2e7) == "2e7");
  CHECK(tickText(-200) == "-200");
}

TEST_CASE("plot: points stand where they must, linear and logarithmic") {
  const Plot plot{.title = "a < b & \"c\"",
                  .x = {.label = "x", .logarithmic = true},
                  .y = {.label = "y"},
                  .series = {{.name = "one", .x = {1, 10, 100}, .y = {0, 1, 2}, .dots = true, .marked = {1}},
                             {.name = "two", .x = {1, 100}, .y = {2, 0}, .labels = {"first"}}},
                  .zones = {{10, 100, "zone"}}};
  const PlotFrame frame = frameOf(plot);
  CHECK(frame.xFrom == 1);
  CHECK(frame.xTo == 100);
  CHECK(frame.yFrom == 0);
  CHECK(frame.yTo == 2);
  CHECK(frame.x(10, true) == Approx((frame.left + frame.right) / 2));
  CHECK(frame.y(1, false) == Approx((frame.top + frame.bottom) / 2));
  CHECK(frame.y(2, false) == frame.top);
  const std::string picture = svg({plot}, {});
  CHECK(wellFormed(picture));
  CHECK(count(picture, "<polyline") == 2);
  char middle[64];
  std::snprintf(middle, sizeof middle, "cx=\"%.2f\" cy=\"%.2f\"", frame.x(10, true), frame.y(1, false));
  CHECK(count(picture, middle) == 2);  // the dot and its ring
  CHECK(count(picture, "a &lt; b &amp; &quot;c&quot;") == 2);
  CHECK(count(picture, ">first</text>") == 1);
  CHECK(count(picture, ">zone</text>") == 1);
  CHECK(count(picture, ">two</text>") == 1);
}

TEST_CASE("plot: what cannot be drawn parts the line, nothing at all is said") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Plot gap{.title = "t",
                 .y = {.logarithmic = true},
                 .series = {{.name = "s", .x = {0, 1, 2, 3, 4}, .y = {1, 2, 0, nan, 5}}}};
  const std::string parted = svg({gap}, {});
  CHECK(count(parted, "<polyline") == 2);
  CHECK(wellFormed(parted));
  CHECK(parted.find("nan") == std::string::npos);
  const std::string nothing =
      svg({Plot{.title = "t", .x = {}, .y = {.logarithmic = true}, .series = {}, .zones = {}}}, {});
  CHECK(wellFormed(nothing));
  CHECK(count(nothing, "no data") == 1);
  const std::string single = svg({Plot{.title = "t", .series = {{.name = "s", .x = {3}, .y = {3}, .dots = true}}}}, {});
  CHECK(wellFormed(single));
  CHECK(single.find("nan") == std::string::npos);
  CHECK(single.find("inf") == std::string::npos);
}

TEST_CASE("plot: words beside points keep clear of each other and of points") {
  Plot plot{.title = "t", .x = {.from = 0, .to = 10}, .y = {.from = 0, .to = 10}};
  Series series{.name = "s", .line = false, .dots = true};
  for (const double x : {5.0, 5.02, 5.1, 5.1, 9.8, 9.9}) {
    series.x.push_back(x), series.y.push_back(5);
    series.labels.push_back("a word of some length");
  }
  plot.series = {series};
  const std::string picture = svg({plot}, {});
  static const std::regex word(
      R"re(<text x="([0-9.]+)" y="([0-9.]+)" text-anchor="(start|end)" font-size="11">a word)re");
  struct Word {
    double left, right, y;
  };
  std::vector<Word> words;
  for (auto i = std::sregex_iterator(picture.begin(), picture.end(), word); i != std::sregex_iterator(); ++i) {
    const double x = std::stod((*i)[1]), width = 6 * 21;
    const bool start = (*i)[3] == "start";
    words.push_back({start ? x : x - width, start ? x + width : x, std::stod((*i)[2])});
  }
  REQUIRE(words.size() == 6);
  const PlotFrame frame = frameOf(plot);
  for (size_t i = 0; i < words.size(); ++i) {
    CHECK(words[i].right < frame.right);
    for (size_t j = 0; j < i; ++j) {
      const bool apart =
          words[i].right < words[j].left || words[j].right < words[i].left || std::abs(words[i].y - words[j].y) >= 11;
      CHECK(apart);
    }
  }
}

TEST_CASE("plot: a range that is given is kept, and what lies outside is cut off") {
  const Plot plot{.title = "t",
                  .x = {.from = 0, .to = 90},
                  .y = {.from = 0, .to = 1},
                  .series = {{.name = "s", .x = {0, 90}, .y = {0, 5}}},
                  .zones = {}};
  CHECK(frameOf(plot).xTo == 90);
  CHECK(frameOf(plot).yTo == 1);
  CHECK(svg({plot}, {}).find("clip-path=\"url(#axes0)\"") != std::string::npos);
}

TEST_CASE("plot: several in one picture, each with its own frame") {
  const Plot one{.title = "one", .series = {{.name = "s", .x = {0, 1}, .y = {0, 1}, .color = "#aa0000"}}};
  Plot two = one;
  two.title = "two";
  two.height = 300;
  const std::string picture = svg({one, two}, {});
  CHECK(wellFormed(picture));
  CHECK(picture.find("viewBox=\"0 0 720 740\"") != std::string::npos);
  CHECK(picture.find("translate(0,440)") != std::string::npos);
  CHECK(count(picture, "<polyline") == 2);
  CHECK(count(picture, "url(#axes1)") == 1);
  CHECK(count(picture, "stroke=\"#aa0000\"") == 4);
}

TEST_CASE("plot: twelve series are told apart by form and colour, in the legend too") {
  Plot plot{.title = "t"};
  for (int i = 0; i < 12; ++i)
    plot.series.push_back(
        {.name = "series " + std::to_string(i), .x = {0.0 + i}, .y = {1}, .line = false, .dots = true});
  const std::string picture = svg({plot}, {});
  CHECK(wellFormed(picture));
  static const std::regex mark(
      R"re(<(circle|polygon) (?:cx="[0-9.]+" cy="[0-9.]+" (r="[0-9.]+")|points="([^"]+)") fill="(#[0-9a-f]+)"(?: stroke="(#[0-9a-f]+)")?)re");
  std::map<std::string, int> looks;  // form and colour
  for (auto i = std::sregex_iterator(picture.begin(), picture.end(), mark); i != std::sregex_iterator(); ++i) {
    std::string corners = (*i)[3];
    const auto commas = std::count(corners.begin(), corners.end(), ',');
    // Corners are told apart by where the first one lies from the second.
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    std::sscanf(corners.c_str(), "%lf,%lf %lf,%lf", &x0, &y0, &x1, &y1);
    char look[96];
    std::snprintf(look, sizeof look, "%s %s %d %.1f %.1f %s %s", (*i)[1].str().c_str(), (*i)[2].str().c_str(),
                  static_cast<int>(commas), x1 - x0, y1 - y0, (*i)[4].str().c_str(), (*i)[5].str().c_str());
    ++looks[look];
  }
  CHECK(looks.size() == 12);
  for (const auto& [look, times] : looks) CHECK(times == 2);  // the point, and the legend's
}

TEST_CASE("plot: a map of cells with its scale, and where the figures come from") {
  const Plot plot{.title = "t",
                  .map = {.columns = 2, .rows = 2, .values = {0, 1, std::nan(""), 0.5}, .label = "A"},
                  .width = 400,
                  .height = 300};
  const Origin origin{.version = "1.2",
                      .commit = "abc",
                      .renderer = "a <b>",
                      .driver = {},
                      .date = "2026-01-02T03:04:05Z",
                      .command = "facet report x"};
  const std::string picture = svg({plot}, origin);
  CHECK(wellFormed(picture));
  CHECK(count(picture, "fill=\"#440154\"") == 1);  // the least; the scale has its middles
  CHECK(count(picture, "fill=\"#fde725\"") == 1);  // the most
  CHECK(count(picture, "no data") == 0);
  CHECK(picture.find("facet 1.2 abc") != std::string::npos);
  CHECK(picture.find("command: facet report x") != std::string::npos);
  CHECK(picture.find("renderer: a &lt;b&gt;") != std::string::npos);
}

TEST_CASE("plot: the slope of a power is its exponent") {
  Series series;
  for (const double n : {1.0, 4.0, 16.0, 64.0}) series.x.push_back(n), series.y.push_back(3 / std::sqrt(n));
  CHECK(logSlope(series) == Approx(-0.5).epsilon(1e-12));
}
