#include "report/lobe_views.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "optics/color.hpp"
#include "optics/plane_lobe.hpp"

namespace facet::report {

namespace {

using optics::LookUp, optics::MeasuredBrdf;

constexpr double radian = optics::pi / 180;  // of a degree

glm::dvec3 towards(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

constexpr const char* evalColumns[] = {"thetaV", "thetaL", "phi", "phiV"};

Result<EvalPoint> pointOf(const std::vector<std::string_view>& words, const std::vector<size_t>& columns) {
  double values[4] = {0, 0, 0, 0};
  for (size_t i = 0; i < columns.size(); ++i) {
    const size_t which = columns[i];
    if (which >= std::size(values)) continue;  // a column that is nothing to us
    const bool polar = which < 2;
    const Result<double> value = parseNumber(i < words.size() ? words[i] : "", polar ? 0 : -360, polar ? 90 : 360);
    if (!value)
      return fail({}, evalColumns[which], value.error().problem,
                  "thetaV,thetaL,phi and perhaps phiV, in degrees: 30,45,180");
    values[which] = *value;
  }
  return EvalPoint{values[0], values[1], values[2], values[3]};
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.back() == '\r' || text.back() == ' ')) text.remove_suffix(1);
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  return text;
}

std::vector<std::string_view> wordsOf(std::string_view line) {
  std::vector<std::string_view> words = split(line, ',');
  for (std::string_view& word : words) {
    word = trimmed(word);
    if (word.size() > 1 && word.front() == '"' && word.back() == '"') word = word.substr(1, word.size() - 2);
  }
  return words;
}

}  // namespace

Result<EvalPoint> parseEvalPoint(std::string_view text) {
  const std::vector<std::string_view> words = wordsOf(text);
  if (words.size() != 3 && words.size() != 4)
    return fail({}, {}, inQuotes(text) + " is not three or four numbers",
                "give thetaV,thetaL,phi and perhaps phiV, in degrees: 30,45,180");
  return pointOf(words, words.size() == 3 ? std::vector<size_t>{0, 1, 2} : std::vector<size_t>{0, 1, 2, 3});
}

Result<std::vector<EvalPoint>> parseEvalPoints(std::string_view text, const std::string& name) {
  std::vector<EvalPoint> points;
  std::vector<size_t> columns;
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);  // as spreadsheets begin UTF-8
  size_t number = 0;
  for (const std::string_view line : split(text, '\n')) {
    ++number;
    const std::vector<std::string_view> words = wordsOf(line);
    if (words.size() == 1 && words[0].empty()) continue;
    const auto place = "line " + std::to_string(number);
    if (columns.empty() && !parseNumber(words[0], -1e9, 1e9)) {
      for (const std::string_view word : words)
        columns.push_back(static_cast<size_t>(std::ranges::find(evalColumns, word) - std::begin(evalColumns)));
      for (size_t i = 0; i < 3; ++i)
        if (std::ranges::count(columns, i) != 1)
          return fail(name, place, std::string("there is not one column ") + evalColumns[i],
                      "name the columns thetaV, thetaL and phi");
      continue;
    }
    if (columns.empty()) columns = words.size() > 3 ? std::vector<size_t>{0, 1, 2, 3} : std::vector<size_t>{0, 1, 2};
    const Result<EvalPoint> point = pointOf(words, columns);
    if (!point) return fail(name, place + ", " + point.error().place, point.error().problem, point.error().remedy);
    points.push_back(*point);
  }
  if (points.empty()) return fail(name, {}, "there are no directions", "give lines of thetaV,thetaL,phi, in degrees");
  return points;
}

Table evalTable() {
  return {.name = "eval",
          .title = "Values of the BRDF",
          .note =
              "f_r [1/sr], linear Rec. 709, of the cell that the directions lie in (nearest) and between the cells. "
              "Polar angles of V and L from the normal, L's azimuth from V's, V's own, in degrees.",
          .columns = {"name", "thetaV", "thetaL", "phi", "phiV", "red", "green", "blue", "nearest red", "nearest green",
                      "nearest blue"},
          .rows = {}};
}

void addEvalRows(Table& table, const MeasuredBrdf& brdf, const std::vector<EvalPoint>& points) {
  for (const EvalPoint& p : points) {
    const glm::dvec3 V = towards(p.thetaV * radian, p.phiV * radian);
    const glm::dvec3 L = towards(p.thetaL * radian, (p.phiV + p.phi) * radian);
    const glm::dvec3 between = optics::measuredBrdf(brdf, V, L, LookUp::interpolated);
    const glm::dvec3 nearest = optics::measuredBrdf(brdf, V, L, LookUp::nearest);
    table.rows.push_back({brdf.name, p.thetaV, p.thetaL, p.phi, p.phiV, between.x, between.y, between.z, nearest.x,
                          nearest.y, nearest.z});
  }
}

Table sliceTable(const Slices& slices) {
  Table table{.name = "slices",
              .title = "Slices of the BRDF",
              .note =
                  "f_r [1/sr] by angle in degrees: thetaH at theta_d = 1, phi_d = 90; thetaD at theta_h = 1, phi_d = "
                  "90; inPlane: polar angle of L in the plane of V, which is at 45, the mirror direction at +45.",
              .columns = {"slice", "curve", "angle [degrees]", "value"},
              .rows = {}};
  const std::pair<const char*, const Plot*> all[] = {
      {"thetaH", &slices.thetaH}, {"thetaD", &slices.thetaD}, {"inPlane", &slices.inPlane}};
  for (const auto& [name, plot] : all)
    for (const Series& series : plot->series)
      for (size_t i = 0; i < series.x.size(); ++i)
        table.rows.push_back({std::string(name), series.name, series.x[i], series.y[i]});
  return table;
}

namespace {

// f_r NoL, luminance; L's azimuth counted from V's.
double lobe(const MeasuredBrdf& brdf, double thetaV, double thetaL, double phi) {
  const glm::dvec3 V = towards(thetaV, 0), L = towards(thetaL, phi);
  return optics::luminance(optics::measuredBrdf(brdf, V, L, LookUp::interpolated)) * std::max(L.z, 0.0);
}

Plot planeLobes(const MeasuredBrdf& brdf) {
  Plot plot{.title = brdf.name + ": lobes in the plane of view, relative to their largest",
            .x = {.label = "V on the left, the mirror direction on the right", .from = -1, .to = 1},
            .y = {.label = "along the normal", .from = 0, .to = 1},
            .height = 460};
  for (const double thetaV : {15.0, 45.0, 75.0}) {
    Series series{.name = "V at " + tickText(thetaV) + " degrees"};
    const optics::PlaneLobe lobe = optics::planeLobe(
        [&](const glm::dvec3& V, const glm::dvec3& L) { return measuredBrdf(brdf, V, L, LookUp::interpolated); },
        thetaV * radian, 0);
    std::vector<double> values;
    for (const glm::dvec3& value : lobe.values) values.push_back(optics::luminance(value));
    const double most = std::max(*std::ranges::max_element(values), 1e-300);
    for (size_t i = 0; i < values.size(); ++i) {
      series.x.push_back(values[i] / most * std::sin(lobe.angles[i]));
      series.y.push_back(values[i] / most * std::cos(lobe.angles[i]));
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

// Rings and ribs, seen from the side and from above; the height is compressed to its cube root, so that the broad part
// of a narrow lobe is seen.
Plot solidLobe(const MeasuredBrdf& brdf) {
  constexpr double thetaV = 45 * radian;
  Plot plot{.title = brdf.name + ": the lobe for V at 45 degrees as a solid, cube root of f_r NoL",
            .x = {.label = "in the plane of view", .from = -1.2, .to = 1.2},
            .y = {.label = "seen from 25 degrees above", .from = -0.6, .to = 1.2},
            .height = 540};
  double most = 1e-300;
  for (int t = 0; t < 90; ++t)
    for (int p = 0; p <= 180; p += 2) most = std::max(most, lobe(brdf, thetaV, t * radian, p * radian));
  const auto projected = [&](Series& series, double theta, double phi) {
    const glm::dvec3 d = std::cbrt(lobe(brdf, thetaV, theta, phi) / most) * towards(theta, phi);
    constexpr double above = 25 * radian;
    series.x.push_back(-d.x);  // V on the left
    series.y.push_back(d.z * std::cos(above) + d.y * std::sin(above));
  };
  for (int t = 6; t < 90; t += 6) {
    Series ring{.color = "#0072b2"};
    for (int p = 0; p <= 360; p += 3) projected(ring, t * radian, p * radian);
    plot.series.push_back(std::move(ring));
  }
  for (int p = 0; p < 360; p += 15) {
    Series rib{.color = "#d55e00"};
    for (double t = 0; t < 89.5; t += 1) projected(rib, t * radian, p * radian);
    plot.series.push_back(std::move(rib));
  }
  return plot;
}

}  // namespace

std::vector<Plot> lobePlots(const MeasuredBrdf& brdf) { return {planeLobes(brdf), solidLobe(brdf)}; }

}  // namespace facet::report
