#include "base/text.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace facet {

namespace {

template <class T>
std::string shortest(T value) {
  std::array<char, 64> buffer;
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

}  // namespace

std::string number(int value) { return shortest(value); }
std::string number(float value) { return shortest(value); }
std::string number(double value) { return shortest(value); }

Result<double> parseNumber(std::string_view text, double min, double max) {
  const std::string remedy = "give a number from " + number(min) + " to " + number(max);
  const std::string_view digits = text.starts_with('+') && !text.starts_with("+-") ? text.substr(1) : text;
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (end != digits.data() + digits.size() || error == std::errc::invalid_argument || std::isnan(value)) {
    return fail({}, {}, inQuotes(text) + " is not a number", remedy);
  }
  if (error == std::errc::result_out_of_range || value < min || value > max) {
    return fail({}, {}, std::string(text) + " is out of range", remedy);
  }
  return value;
}

Result<int> parseWhole(std::string_view text, int min, int max) {
  const std::string remedy = "give a whole number from " + number(min) + " to " + number(max);
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || error == std::errc::invalid_argument) {
    return fail({}, {}, inQuotes(text) + " is not a whole number", remedy);
  }
  if (error == std::errc::result_out_of_range || value < min || value > max) {
    return fail({}, {}, std::string(text) + " is out of range", remedy);
  }
  return value;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (size_t at = 0; at != std::string_view::npos;) {
    const size_t end = text.find(separator, at);
    parts.push_back(text.substr(at, end == std::string_view::npos ? end : end - at));
    at = end == std::string_view::npos ? end : end + 1;
  }
  return parts;
}

std::string inQuotes(std::string_view text) { return "'" + std::string(text) + "'"; }

std::string shellWord(std::string_view text) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./@%";
  if (!text.empty() && text.find_first_not_of(plain) == std::string_view::npos) return std::string(text);
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

std::string pointerToken(std::string_view key) {
  std::string token;
  for (const char c : key) token += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return token;
}

}  // namespace facet
