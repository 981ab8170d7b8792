#include "io/json_scan.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

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
        if (open_.size() == 1) endMember(i);
        if (open_.size() == 2) ++commas_;
        return {};
      case ':':
        if (open_.size() == 1 && !outline_.members.empty()) pendingValue_ = true;
        return {};
      default:
        return {};
    }
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
      if (auto ok = key(i, stringOrEmpty(i, end)); !ok) return ok;
    }
    i = end - 1;
    return {};
  }

  // Keys matter in the root and in its accessors only.
  std::string stringOrEmpty(size_t begin, size_t end) const {
    return open_.size() == 1 || inAccessor() ? stringValue(text_.substr(begin, end - begin)) : std::string();
  }

  bool inAccessor() const { return open_.size() == 3 && open_[1] == '[' && outline_.members.back().key == "accessors"; }

  Result<void> key(size_t i, std::string name) {
    if (open_.size() == 1) {
      if (!keys_.insert(name).second) return error(i, "the key " + inQuotes(name) + " is given twice");
      outline_.members.push_back({std::move(name), 0, 0, 0});
    } else if (inAccessor() && name == "bufferView") {
      accessorHasView_ = true;
    }
    return {};
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
};

}  // namespace

const JsonMember* JsonOutline::find(std::string_view key) const {
  const auto found = std::find_if(members.begin(), members.end(), [&](const JsonMember& m) { return m.key == key; });
  return found == members.end() || found->end <= found->begin ? nullptr : &*found;
}

size_t JsonOutline::elements(std::string_view key) const {
  const JsonMember* member = find(key);
  return member ? member->elements : 0;
}

Result<JsonOutline> scanJson(std::string_view text, int maxDepth) { return Scanner(text, maxDepth).run(); }

std::string lineAndColumn(std::string_view text, size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const size_t start = before.rfind('\n');
  const size_t column = before.size() - (start == std::string_view::npos ? 0 : start + 1) + 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

}  // namespace facet::io
