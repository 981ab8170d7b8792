#include "io/json_scan.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <utility>

#include "io/uri.hpp"

namespace facet::io {

namespace {

// Index just behind the closing quotation mark of the string that opens at begin; text.size() + 1 if it never closes.
size_t skipString(std::string_view text, size_t begin) {
  for (size_t i = begin + 1; i < text.size();) {
    const size_t quote = text.find('"', i);
    if (quote == std::string_view::npos) break;
    size_t backslashes = 0;
    while (quote - backslashes > begin + 1 && text[quote - backslashes - 1] == '\\') ++backslashes;
    if (backslashes % 2 == 0) return quote + 1;
    i = quote + 1;
  }
  return text.size() + 1;
}

// The string between its quotation marks with escapes resolved.
std::string stringValue(std::string_view token) {
  if (token.find('\\') == std::string_view::npos) return std::string(token.substr(1, token.size() - 2));
  const auto value = nlohmann::json::parse(token.begin(), token.end(), nullptr, false);
  return value.is_string() ? value.get<std::string>() : std::string(token);
}

bool isDigit(char c) { return c >= '0' && c <= '9'; }

// A number with a fraction or an exponent that stands for a whole number which a double holds exactly; as digits.
std::optional<std::string> digitsOf(std::string_view token) {
  size_t i = token.starts_with('-') ? 1 : 0;
  const auto digits = [&] {
    const size_t begin = i;
    while (i < token.size() && isDigit(token[i])) ++i;
    return i - begin;
  };
  const size_t integer = i, integerDigits = digits();
  if (integerDigits == 0 || (integerDigits > 1 && token[integer] == '0')) return std::nullopt;
  if (i < token.size() && token[i] == '.' && (++i, digits() == 0)) return std::nullopt;
  if (i < token.size() && (token[i] == 'e' || token[i] == 'E')) {
    ++i;
    if (i < token.size() && (token[i] == '+' || token[i] == '-')) ++i;
    if (digits() == 0) return std::nullopt;
  }
  double value = 0;
  const auto [end, code] = std::from_chars(token.data(), token.data() + token.size(), value);
  constexpr double largest = 9007199254740992.0;  // 2^53
  if (i != token.size() || code != std::errc() || value != std::floor(value) || std::abs(value) > largest)
    return std::nullopt;
  if (value == 0 && token.starts_with('-')) return std::nullopt;  // the sign would be lost
  return std::to_string(static_cast<int64_t>(value));
}

// Where tinygltf takes anything else than a whole number for "not given" or zero: the section of the root, how many
// brackets are open (the root's counted), the key.
struct WholeNumberKey {
  std::string_view section;
  size_t depth;
  std::string_view key;
};
constexpr WholeNumberKey wholeNumberKeys[] = {
    {"scene", 1, "scene"},
    {"accessors", 3, "bufferView"},
    {"accessors", 3, "byteOffset"},
    {"accessors", 3, "componentType"},
    {"accessors", 3, "count"},
    {"accessors", 4, "count"},  // sparse
    {"accessors", 5, "bufferView"},
    {"accessors", 5, "byteOffset"},
    {"accessors", 5, "componentType"},
    {"bufferViews", 3, "buffer"},
    {"bufferViews", 3, "byteOffset"},
    {"bufferViews", 3, "byteLength"},
    {"bufferViews", 3, "byteStride"},
    {"bufferViews", 3, "target"},
    {"meshes", 5, "indices"},
    {"meshes", 5, "material"},
    {"meshes", 5, "mode"},
    {"nodes", 3, "camera"},
    {"nodes", 3, "mesh"},
    {"nodes", 3, "skin"},
    {"samplers", 3, "magFilter"},
    {"samplers", 3, "minFilter"},
    {"samplers", 3, "wrapS"},
    {"samplers", 3, "wrapT"},
    {"textures", 3, "sampler"},
    {"textures", 3, "source"},
};
// The same for arrays of them.
constexpr WholeNumberKey wholeNumberLists[] = {{"nodes", 3, "children"}, {"scenes", 3, "nodes"}};

bool isNamed(std::span<const WholeNumberKey> keys, std::string_view section, size_t depth, std::string_view key) {
  return std::ranges::any_of(
      keys, [&](const WholeNumberKey& k) { return k.depth == depth && k.key == key && k.section == section; });
}

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

class Scanner {
 public:
  Scanner(std::string_view text, int maxDepth) : text_(text), maxDepth_(maxDepth) {}

  Result<JsonOutline> run() {
    size_t i = text_.starts_with("\xEF\xBB\xBF") ? 3 : 0;  // byte order mark
    while (i < text_.size() && isSpace(text_[i])) ++i;
    if (i == text_.size() || text_[i] != '{') return error(i, "does not hold a JSON object");
    for (; i < text_.size(); ++i) {
      if (auto ok = step(i); !ok) return tl::unexpected(ok.error());
      if (open_.empty()) return std::move(outline_);  // what follows is the parser's concern
    }
    return error(text_.size(), "ends inside the JSON text");
  }

 private:
  tl::unexpected<Error> error(size_t offset, std::string problem) const {
    return fail("", lineAndColumn(text_, offset), std::move(problem), "export the model again");
  }

  // Handles the token at i and leaves i on its last byte.
  Result<void> step(size_t& i) {
    const char c = text_[i];
    if (isSpace(c)) return {};
    if (auto ok = checkWholeNumber(i); !ok) return ok;
    if (c != '}' && c != ']' && c != ',' && c != ':') valueStarts(i);
    switch (c) {
      case '"':
        return string(i);
      case '{':
      case '[':
        return opens(i);
      case '}':
      case ']':
        return closes(i);
      case ',':
        expectKey_ = open_.back() == '{';
        if (open_.size() == 1) endMember(i), pendingValue_ = false;
        if (open_.size() == 2) ++commas_;
        return {};
      case ':':
        if (open_.size() == 1 && !outline_.members.empty()) pendingValue_ = !expectKey_;
        return {};
      default:
        return {};
    }
  }

  // Where the value of a key, or an element of its list, has to be one.
  Result<void> checkWholeNumber(size_t i) {
    const char c = text_[i];
    if (i < checkedEnd_ || (numberKey_.empty() && listKey_.empty())) return {};
    if (!numberKey_.empty()) {
      if (c == ':') return {};
      const std::string_view key = std::exchange(numberKey_, {});
      if (isList_ && c == '[') {
        listKey_ = key;
        listDepth_ = open_.size() + 1;
        return {};
      }
      return checkDigits(i, key, !isList_);
    }
    if (open_.size() != listDepth_ || c == ',') return {};
    if (c != ']') return checkDigits(i, listKey_, false);
    listKey_ = {};
    return {};
  }

  Result<void> checkDigits(size_t i, std::string_view key, bool orNull) {
    size_t end = i;
    while (end < text_.size() && !isSpace(text_[end]) && std::string_view(",:{}[]").find(text_[end]) == text_.npos)
      ++end;
    std::string_view token = text_.substr(i, end - i);
    checkedEnd_ = end;
    if (orNull && token == "null") return {};
    if (token.starts_with('-')) token.remove_prefix(1);
    if (!token.empty() && std::ranges::all_of(token, isDigit)) return {};
    return error(i, inQuotes(key) + (orNull ? " is not a whole number" : " is no list of whole numbers"));
  }

  // After its key.
  void expectWholeNumber(std::string_view key) {
    if (open_.size() > 5 || (open_.size() > 1 && (!openMember_ || outline_.members.empty()))) return;
    const std::string_view section = open_.size() == 1 ? key : std::string_view(outline_.members.back().key);
    isList_ = isNamed(wholeNumberLists, section, open_.size(), key);
    if (isList_ || isNamed(wholeNumberKeys, section, open_.size(), key)) numberKey_ = key;
  }

  void valueStarts(size_t i) {
    if (open_.size() == 2) hasElement_ = true;
    if (open_.size() != 1 || !pendingValue_) return;
    outline_.members.back().begin = i;
    pendingValue_ = false;
    openMember_ = true;
    commas_ = 0;
    hasElement_ = false;
  }

  void endMember(size_t i) {
    if (!openMember_) return;
    auto& member = outline_.members.back();
    member.end = i;
    member.elements = hasElement_ && text_[member.begin] == '[' ? commas_ + 1 : 0;
    openMember_ = false;
  }

  Result<void> string(size_t& i) {
    const size_t end = skipString(text_, i);
    if (end > text_.size()) return error(i, "ends inside a JSON string");
    if (expectKey_) {
      expectKey_ = false;
      key(stringOrEmpty(i, end));
      expectWholeNumber(text_.substr(i + 1, end - i - 2));
    }
    i = end - 1;
    return {};
  }

  // Keys matter in the root and in its accessors only.
  std::string stringOrEmpty(size_t begin, size_t end) const {
    return open_.size() == 1 || inAccessor() ? stringValue(text_.substr(begin, end - begin)) : std::string();
  }

  // Brackets may open where no member's value does: text that no parser takes has come here, too.
  bool inAccessor() const {
    return open_.size() == 3 && open_[1] == '[' && openMember_ && outline_.members.back().key == "accessors";
  }

  void key(std::string name) {
    if (open_.size() == 1) {
      if (!keys_.insert(name).second) {
        outline_.givenTwice.push_back(name);
        if (name == "accessors") outline_.accessorsWithoutView.clear();
      }
      outline_.members.push_back({std::move(name), 0, 0, 0});
    } else if (inAccessor() && name == "bufferView") {
      accessorHasView_ = true;
    }
  }

  Result<void> opens(size_t i) {
    open_.push_back(text_[i]);
    expectKey_ = text_[i] == '{';
    outline_.depth = std::max(outline_.depth, static_cast<int>(open_.size()));
    if (outline_.depth > maxDepth_) {
      return error(i, "the JSON text nests deeper than " + std::to_string(maxDepth_) + " levels");
    }
    if (open_.size() == 3 && inAccessor() && text_[i] == '{') {
      accessorBegin_ = i + 1;
      accessorHasView_ = false;
    }
    return {};
  }

  Result<void> closes(size_t i) {
    if (open_.back() != (text_[i] == '}' ? '{' : '[')) return error(i, "the JSON text's brackets do not match");
    if (open_.size() == 3 && inAccessor() && text_[i] == '}' && !accessorHasView_) {
      outline_.accessorsWithoutView.push_back({commas_, accessorBegin_});
    }
    if (open_.size() == 1) endMember(i);
    open_.pop_back();
    expectKey_ = false;
    return {};
  }

  std::string_view text_;
  int maxDepth_;
  JsonOutline outline_;
  std::set<std::string> keys_;
  std::string open_;  // brackets that are open, outermost first
  bool expectKey_ = false, pendingValue_ = false, openMember_ = false;
  bool hasElement_ = false, accessorHasView_ = false;
  size_t commas_ = 0, accessorBegin_ = 0;
  std::string_view numberKey_, listKey_;  // whose value comes, whose list is open
  bool isList_ = false;                   // of numberKey_
  size_t listDepth_ = 0, checkedEnd_ = 0;
};

}  // namespace

const JsonMember* JsonOutline::find(std::string_view key) const {
  const auto found = std::find_if(members.rbegin(), members.rend(), [&](const JsonMember& m) { return m.key == key; });
  return found == members.rend() || found->end <= found->begin ? nullptr : &*found;
}

size_t JsonOutline::elements(std::string_view key) const {
  const JsonMember* member = find(key);
  return member ? member->elements : 0;
}

Result<JsonOutline> scanJson(std::string_view text, int maxDepth) { return Scanner(text, maxDepth).run(); }

std::optional<std::string> withWholeNumbers(std::string_view text) {
  std::string out;
  size_t copied = 0;
  for (size_t i = 0; i < text.size();) {
    if (text[i] == '"') {
      i = skipString(text, i);
      continue;
    }
    if (!isDigit(text[i]) && text[i] != '-') {
      ++i;
      continue;
    }
    const size_t begin = i;
    bool other = false;  // than digits
    for (; i < text.size() && (isDigit(text[i]) || std::string_view("+-.eE").find(text[i]) != text.npos); ++i)
      other = other || (i > begin && !isDigit(text[i]));
    if (!other) continue;
    const auto digits = digitsOf(text.substr(begin, i - begin));
    if (!digits) continue;
    out.append(text.substr(copied, begin - copied)).append(*digits);
    out.append(i - begin - std::min(i - begin, digits->size()), ' ');
    copied = i;
  }
  if (copied == 0) return std::nullopt;
  return out.append(text.substr(copied));
}

std::string lineAndColumn(std::string_view text, size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const size_t start = before.rfind('\n');
  const size_t column = before.size() - (start == std::string_view::npos ? 0 : start + 1) + 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

}  // namespace facet::io
