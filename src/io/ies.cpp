#include "io/ies.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "base/text.hpp"

namespace facet::io {

namespace {

using optics::Photometry;

constexpr size_t mostIntensities = size_t{1} << 22;

// Numbers of a text, with the line of the last one. The first failure stays.
struct Numbers {
  const std::string& name;
  std::string_view rest;
  int line = 1;
  std::optional<Error> failed = {};

  std::string place() const { return "line " + std::to_string(line); }
  void fail(std::string problem, std::string remedy = "get the file again from its maker") {
    if (!failed) failed = Error{name, place(), std::move(problem), std::move(remedy)};
  }
  // Up to a separator: white space or a comma.
  std::string_view word() {
    while (!rest.empty() && std::string_view(" \t\r\n,\f\v").find(rest[0]) != std::string_view::npos) {
      line += rest[0] == '\n' ? 1 : 0;
      rest.remove_prefix(1);
    }
    const std::string_view found = rest.substr(0, rest.find_first_of(" \t\r\n,\f\v"));
    rest.remove_prefix(found.size());
    return found;
  }
  double number(const char* what, double low, double high) {
    if (failed) return low;
    const std::string_view given = word();
    if (given.empty()) {
      fail(std::string("ends before ") + what);
      return low;
    }
    const std::string_view digits = given.substr(given[0] == '+' ? 1 : 0);
    double value = 0;
    const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (code != std::errc() || end != digits.data() + digits.size()) {
      fail(std::string(what) + " is no number: \"" + printable(given, 40) + "\"");
    } else if (!(value >= low && value <= high)) {
      fail(std::string(what) + " is out of range: " + printable(given, 40));
    }
    return failed ? low : value;
  }
  size_t count(const char* what, size_t low, size_t high) {
    const double value = number(what, static_cast<double>(low), static_cast<double>(high));
    if (value != std::floor(value)) fail(std::string(what) + " is no whole number");
    return failed ? low : static_cast<size_t>(value);
  }
  std::vector<float> angles(const char* what, size_t count) {
    std::vector<float> out;
    for (size_t i = 0; i < count && !failed; ++i) {
      out.push_back(static_cast<float>(number(what, -360, 720)));
      if (i > 0 && !(out[i] > out[i - 1])) fail(std::string(what) + " does not rise above the one before");
    }
    return out;
  }
};

// Lines up to and with "TILT=...", whose value it returns.
std::optional<std::string_view> skipHead(Numbers& text) {
  while (!text.rest.empty()) {
    const std::string_view whole = text.rest.substr(0, text.rest.find('\n'));
    text.rest.remove_prefix(std::min(whole.size() + 1, text.rest.size()));
    ++text.line;
    std::string_view trimmed = whole;
    while (!trimmed.empty() && (trimmed[0] == ' ' || trimmed[0] == '\t')) trimmed.remove_prefix(1);
    while (!trimmed.empty() && (trimmed.back() == ' ' || trimmed.back() == '\r' || trimmed.back() == '\t'))
      trimmed.remove_suffix(1);
    if (trimmed.starts_with("TILT=")) return trimmed.substr(5);
  }
  return std::nullopt;
}

// The angles, and the intensities as the file has them: by horizontal angle, then vertical.
struct Measured {
  int type = 1;  // 1 C, 2 B, 3 A
  std::vector<float> vertical, horizontal;
  std::vector<float> candela;
};

// A meridian at an angle: an index of the file's horizontal angles.
struct Meridian {
  float angle;
  size_t from;
};

// Type C, all round; empty where no symmetry explains the angles. closed: by the first once more.
std::vector<Meridian> allRound(const std::vector<float>& given, bool& closed) {
  const float first = given.front(), last = given.back();
  std::vector<Meridian> out;
  const auto take = [&](float sign, float offset, bool backwards, size_t skip) {
    for (size_t i = skip; i < given.size(); ++i) {
      const size_t from = backwards ? given.size() - 1 - i : i;
      out.push_back({offset + sign * given[from], from});
    }
  };
  if (given.size() == 1) return {{0, 0}};
  if (first == 0 && last == 90) {
    take(1, 0, false, 0), take(-1, 180, true, 1), take(1, 180, false, 1), take(-1, 360, true, 1);
  } else if (first == 0 && last == 180) {
    take(1, 0, false, 0), take(-1, 360, true, 1);
  } else if ((first == 90 && last == 270) || (first == -90 && last == 90)) {
    take(1, 0, false, 0), take(-1, first == 90 ? 540 : 180, true, 1);  // the plane of 90 and 270 is the mirror
  } else if (last - first == 360) {
    take(1, 0, false, 0);
  } else if (last - first > 180 && last - first < 360) {
    take(1, 0, false, 0);
    out.push_back({first + 360, 0});
    closed = true;
  }
  return out;
}

// Types A and B; from 0 on: the other side is alike.
std::vector<Meridian> bothSides(const std::vector<float>& given) {
  std::vector<Meridian> out;
  if (given.front() == 0)
    for (size_t i = given.size() - 1; i > 0; --i) out.push_back({-given[i], i});
  for (size_t i = 0; i < given.size(); ++i) out.push_back({given[i], i});
  return out;
}

optics::LightProfile typeC(const Measured& m, const std::vector<Meridian>& meridians) {
  optics::LightProfile p;
  p.polar = m.vertical;
  for (const Meridian& meridian : meridians) {
    p.azimuth.push_back(meridian.angle);
    const float* row = m.candela.data() + meridian.from * m.vertical.size();
    p.candela.insert(p.candela.end(), row, row + m.vertical.size());
  }
  return p;
}

// A: polar angles are of the vertical ones, turned round.
optics::LightProfile typeA(const Measured& m, const std::vector<Meridian>& meridians) {
  optics::LightProfile p = typeC(m, meridians);
  p.photometry = Photometry::a;
  for (float& angle : p.polar) angle = 90 - angle;
  std::ranges::reverse(p.polar);
  for (size_t i = 0; i < p.azimuth.size(); ++i)
    std::reverse(p.candela.begin() + static_cast<ptrdiff_t>(i * p.polar.size()),
                 p.candela.begin() + static_cast<ptrdiff_t>((i + 1) * p.polar.size()));
  return p;
}

// B: polar angles are of the horizontal ones, and so rows are columns.
optics::LightProfile typeB(const Measured& m, const std::vector<Meridian>& meridians) {
  optics::LightProfile p;
  p.photometry = Photometry::b;
  p.azimuth = m.vertical;
  for (size_t i = meridians.size(); i > 0; --i) p.polar.push_back(90 - meridians[i - 1].angle);
  for (size_t v = 0; v < m.vertical.size(); ++v)
    for (size_t i = meridians.size(); i > 0; --i)
      p.candela.push_back(m.candela[meridians[i - 1].from * m.vertical.size() + v]);
  return p;
}

bool within(const std::vector<float>& angles, float low, float high) {
  return angles.front() >= low && angles.back() <= high;
}

Measured readNumbers(Numbers& text, bool tilted, size_t& negative) {
  constexpr double largest = 3e38;
  if (tilted) {  // its geometry, then pairs of angle and factor
    text.number("the lamp's geometry", 1, 3);
    const size_t pairs = text.count("the number of tilt angles", 0, 100000);
    for (size_t i = 0; i < 2 * pairs && !text.failed; ++i) text.number("a tilt's number", -largest, largest);
  }
  Measured m;
  text.number("the number of lamps", -largest, largest);
  text.number("the lumens of a lamp", -largest, largest);
  const double multiplier = text.number("the candela multiplier", 0, largest);
  const size_t verticals = text.count("the number of vertical angles", 2, mostIntensities);
  const size_t horizontals = text.count("the number of horizontal angles", 1, mostIntensities);
  m.type = static_cast<int>(text.count("the photometric type", 1, 3));
  for (const char* what : {"the type of units", "the width", "the length", "the height"})
    text.number(what, -largest, largest);
  const double ballast = text.number("the ballast factor", 0, largest);
  const double lamp = text.number("the ballast-lamp factor", 0, largest);
  text.number("the input watts", -largest, largest);
  if (!text.failed && verticals * horizontals > std::min(mostIntensities, text.rest.size())) {
    text.fail("has " + std::to_string(verticals) + " by " + std::to_string(horizontals) + " intensities, more than " +
              (verticals * horizontals > mostIntensities ? "are read" : "it holds"));
    return m;
  }
  m.vertical = text.angles("a vertical angle", verticals);
  m.horizontal = text.angles("a horizontal angle", horizontals);
  for (size_t i = 0; i < verticals * horizontals && !text.failed; ++i) {
    const double value = text.number("an intensity", -largest, largest);
    const double scaled = std::max(value, 0.0) * multiplier * ballast * lamp;
    negative += value < 0 ? 1 : 0;
    if (!(scaled <= largest)) text.fail("an intensity times its factors is out of range");
    m.candela.push_back(static_cast<float>(scaled));
  }
  return m;
}

std::string angleText(float angle) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), angle).ptr};
}

// Symmetries unfolded.
Result<optics::LightProfile> unfolded(const Measured& m, const std::string& name, const std::string& place,
                                      Notes& notes) {
  const std::string range = angleText(m.horizontal.front()) + " to " + angleText(m.horizontal.back());
  if (m.type == 1) {
    if (!within(m.vertical, 0, 180))
      return fail(name, "", "its vertical angles are not within 0 to 180 degrees", "get the file again from its maker");
    bool closed = false;
    const std::vector<Meridian> meridians = allRound(m.horizontal, closed);
    if (meridians.empty())
      return fail(name, "", "its horizontal angles go from " + range + " degrees: no symmetry fills the rest",
                  "use one that ends at 0, 90, 180 or 360");
    if (meridians.size() * m.vertical.size() > mostIntensities)
      return fail(name, "", "has more intensities than are read", "use a coarser one");
    if (closed)
      notes.push_back({Note::Severity::warning, place,
                       name + ": its horizontal angles go from " + range + " degrees: the rest is interpolated"});
    return typeC(m, meridians);
  }
  if (!within(m.vertical, -90, 90) || !within(m.horizontal, -90, 90) || m.horizontal.size() < 2)
    return fail(name, "", "its angles are not within -90 to 90 degrees, two of each at least",
                "get the file again from its maker");
  return m.type == 2 ? typeB(m, bothSides(m.horizontal)) : typeA(m, bothSides(m.horizontal));
}

}  // namespace

Result<optics::LightProfile> readIes(std::span<const uint8_t> bytes, const std::string& name, const std::string& place,
                                     Notes& notes) {
  Numbers text{name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}};
  if (text.rest.starts_with("\xEF\xBB\xBF")) text.rest.remove_prefix(3);
  const bool known = text.rest.starts_with("IESNA") || text.rest.starts_with("IES:LM-63");
  const std::optional<std::string_view> tilt = skipHead(text);
  if (!tilt)
    return fail(name, "", "has no line TILT=, so it is no IES file (LM-63)", "name a light profile that is one");
  if (!known)
    notes.push_back({Note::Severity::info, place, name + ": has no first line that names LM-63: read as of 1986"});
  if (*tilt != "NONE") notes.push_back({Note::Severity::info, place, name + ": its tilt of the lamp is not looked at"});
  size_t negative = 0;
  const Measured measured = readNumbers(text, *tilt == "INCLUDE", negative);
  if (text.failed) return tl::unexpected(*text.failed);
  if (negative > 0)
    notes.push_back({Note::Severity::warning, place,
                     name + ": " + std::to_string(negative) + " intensities are negative: they count as 0"});
  Result<optics::LightProfile> profile = unfolded(measured, name, place, notes);
  if (!profile) return profile;
  const auto rises = [](const std::vector<float>& angles) { return std::ranges::is_sorted(angles, std::less_equal{}); };
  if (!rises(profile->polar) || !rises(profile->azimuth))
    return fail(name, "", "has angles that cannot be told apart", "use a coarser one");
  profile->name = name;
  profile->mostCandela = *std::ranges::max_element(profile->candela);
  return profile;
}

}  // namespace facet::io
