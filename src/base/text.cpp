#include "base/text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace facet {

namespace {

template <class T>
std::string shortest(T value) {
  std::array<char, 64> buffer;
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

// Bytes of the code point at the beginning; 0 where there is none (RFC 3629).
size_t utf8Length(std::string_view text) {
  const auto byte = [&](size_t i) { return static_cast<uint8_t>(i < text.size() ? text[i] : 0); };
  const auto within = [&](size_t i, int low, int high) { return byte(i) >= low && byte(i) <= high; };
  const uint8_t first = byte(0);
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return within(1, 0x80, 0xBF) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF) {
    const bool second = within(1, first == 0xE0 ? 0xA0 : 0x80, first == 0xED ? 0x9F : 0xBF);
    return second && within(2, 0x80, 0xBF) ? 3 : 0;
  }
  if (first >= 0xF0 && first <= 0xF4) {
    const bool second = within(1, first == 0xF0 ? 0x90 : 0x80, first == 0xF4 ? 0x8F : 0xBF);
    return second && within(2, 0x80, 0xBF) && within(3, 0x80, 0xBF) ? 4 : 0;
  }
  return 0;
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

std::optional<std::string> withValidUtf8(std::string_view text) {
  std::string out;
  size_t copied = 0;
  for (size_t i = 0; i < text.size();) {
    const size_t length = utf8Length(text.substr(i));
    if (length > 0) {
      i += length;
      continue;
    }
    out.append(text.substr(copied, i - copied)).append("\xEF\xBF\xBD");
    copied = ++i;
  }
  if (copied == 0) return std::nullopt;
  return out.append(text.substr(copied));
}

std::string printable(std::string_view text, size_t longest) {
  const bool cut = text.size() > longest;
  if (cut) {
    while (longest > 0 && (static_cast<uint8_t>(text[longest]) & 0xC0) == 0x80) --longest;  // not within a character
    text = text.substr(0, longest);
  }
  std::string out = withValidUtf8(text).value_or(std::string(text));
  for (char& c : out)
    if (static_cast<uint8_t>(c) < 0x20 || c == 0x7f) c = c == '\t' ? ' ' : '?';
  return cut ? out + "..." : out;
}

std::string inQuotes(std::string_view text) { return "'" + printable(text, 80) + "'"; }

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
