#include "view/text_fit.hpp"

#include <algorithm>

namespace facet::view {

namespace {

bool startsSign(char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }

// Where the signs of the text begin, and its end.
std::vector<size_t> signs(std::string_view text) {
  std::vector<size_t> at;
  for (size_t i = 0; i < text.size(); ++i)
    if (startsSign(text[i])) at.push_back(i);
  at.push_back(text.size());
  return at;
}

// Of a word that is longer than a line: how much of it goes onto one.
size_t cutWord(std::string_view word, float room, const TextWidth& width) {
  const std::vector<size_t> at = signs(word);
  size_t most = std::min<size_t>(1, at.size() - 1);
  while (most + 1 < at.size() && width(word.substr(0, at[most + 1])) <= room) ++most;
  const size_t end = at[most], nice = word.substr(0, end).find_last_of("/_-");
  return end < word.size() && nice != std::string_view::npos && nice > 0 ? nice + 1 : end;
}

void wrapLine(std::string_view text, float room, const TextWidth& width, std::vector<std::string>& lines) {
  std::string line;
  while (!text.empty()) {
    const size_t begin = std::min(text.find_first_not_of(' '), text.size());
    const size_t end = std::min(text.find(' ', begin), text.size());
    const std::string_view gap = text.substr(0, begin), word = text.substr(begin, end - begin);
    const std::string longer = line.empty() ? std::string(word) : line + std::string(gap) + std::string(word);
    if (width(longer) <= room) {
      line = longer;
      text.remove_prefix(end);
    } else if (!line.empty()) {
      lines.push_back(std::move(line));
      line.clear();
    } else {
      const size_t cut = cutWord(word, room, width);
      lines.emplace_back(word.substr(0, cut));
      text.remove_prefix(begin + cut);
    }
  }
  if (!line.empty() || lines.empty()) lines.push_back(line);
}

}  // namespace

std::string middleCut(const std::string& text, float room, const TextWidth& width) {
  if (width(text) <= room) return text;
  constexpr const char* gap = "\xe2\x80\xa6";
  const std::vector<size_t> at = signs(text);
  const size_t count = at.size() - 1;
  // As many signs as fit, one more of the end than of the beginning.
  for (size_t kept = count; kept-- > 1;) {
    const size_t head = kept / 2, tail = kept - head;
    std::string cut = text.substr(0, at[head]) + gap + text.substr(at[count - tail]);
    if (width(cut) <= room) return cut;
  }
  return gap;
}

std::vector<std::string> wrapped(const std::string& text, float room, const TextWidth& width) {
  std::vector<std::string> lines;
  for (size_t begin = 0; begin <= text.size();) {
    const size_t end = std::min(text.find('\n', begin), text.size());
    std::vector<std::string> own;
    wrapLine(std::string_view(text).substr(begin, end - begin), room, width, own);
    lines.insert(lines.end(), own.begin(), own.end());
    begin = end + 1;
  }
  return lines;
}

}  // namespace facet::view
