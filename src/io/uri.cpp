#include "io/uri.hpp"

#include <array>

#include "base/text.hpp"

namespace facet::io {

namespace {

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

constexpr int8_t invalidDigit = -1, skippedDigit = -2, endDigit = -3;

// RFC 4648, both the ordinary and the URL alphabet.
constexpr std::array<int8_t, 256> makeBase64Table() {
  std::array<int8_t, 256> table{};
  for (auto& entry : table) entry = invalidDigit;
  for (int i = 0; i < 26; ++i) table['A' + i] = static_cast<int8_t>(i), table['a' + i] = static_cast<int8_t>(26 + i);
  for (int i = 0; i < 10; ++i) table['0' + i] = static_cast<int8_t>(52 + i);
  table['+'] = table['-'] = 62;
  table['/'] = table['_'] = 63;
  table['='] = endDigit;
  table[' '] = table['\t'] = table['\r'] = table['\n'] = skippedDigit;
  return table;
}
constexpr std::array<int8_t, 256> base64Table = makeBase64Table();

std::optional<std::vector<uint8_t>> decodeBase64(std::string_view text) {
  std::vector<uint8_t> bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  uint32_t bits = 0;
  int bitCount = 0;
  for (const char c : text) {
    const int8_t digit = base64Table[static_cast<uint8_t>(c)];
    if (digit == invalidDigit) return std::nullopt;
    if (digit == skippedDigit) continue;
    if (digit == endDigit) break;
    bits = bits << 6 | static_cast<uint32_t>(digit);
    bitCount += 6;
    if (bitCount < 8) continue;
    bitCount -= 8;
    bytes.push_back(static_cast<uint8_t>(bits >> bitCount));
  }
  if (bitCount == 6) return std::nullopt;  // a single digit left over holds no byte
  return bytes;
}

}  // namespace

std::string percentDecode(std::string_view uri) {
  std::string text;
  text.reserve(uri.size());
  for (size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] == '%' && i + 2 < uri.size()) {
      const int high = hexDigit(uri[i + 1]), low = hexDigit(uri[i + 2]);
      if (high >= 0 && low >= 0) {
        text += static_cast<char>(high * 16 + low);
        i += 2;
        continue;
      }
    }
    text += uri[i];
  }
  return text;
}

bool hasScheme(std::string_view uri) {
  if (uri.empty() || !isLetter(uri[0])) return false;
  for (const char c : uri.substr(1)) {
    if (c == ':') return true;
    if (!isLetter(c) && !(c >= '0' && c <= '9') && c != '+' && c != '-' && c != '.') return false;
  }
  return false;
}

bool isDataUri(std::string_view uri) {
  constexpr std::string_view scheme = "data:";
  if (uri.size() < scheme.size()) return false;
  for (size_t i = 0; i < scheme.size(); ++i) {
    if ((uri[i] >= 'A' && uri[i] <= 'Z' ? uri[i] - 'A' + 'a' : uri[i]) != scheme[i]) return false;
  }
  return true;
}

std::optional<std::vector<uint8_t>> decodeDataUri(std::string_view uri) {
  if (!isDataUri(uri)) return std::nullopt;
  const size_t comma = uri.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const std::string_view header = uri.substr(0, comma), body = uri.substr(comma + 1);
  const bool base64 = header.ends_with(";base64");
  if (base64 && body.find('%') == std::string_view::npos) return decodeBase64(body);
  const std::string text = percentDecode(body);
  if (base64) return decodeBase64(text);
  return std::vector<uint8_t>(text.begin(), text.end());
}

std::string inQuotes(std::string_view text) { return "\"" + printable(text, 80) + "\""; }

}  // namespace facet::io
