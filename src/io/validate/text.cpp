// The JSON text: whether it is some, whether each key stands once, its encoding.

#include "base/text.hpp"

#include <stdexcept>

#include "io/json_scan.hpp"
#include "io/uri.hpp"
#include "io/validate/checks.hpp"

namespace facet::io::validate {

namespace {

struct TooDeep : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Keys of each object that is open.
class Keys {
 public:
  void open() { open_.emplace_back(); }
  void close() { open_.pop_back(); }
  bool isNew(const std::string& key) { return open_.back().insert(key).second; }

 private:
  std::vector<std::set<std::string>> open_;
};

// "line 1, column 2: the text is faulty while parsing ..." of what the parser throws.
std::string problemOf(std::string what) {
  for (const std::string_view mark : {"syntax error ", "] "})
    if (const size_t found = what.find(mark); found != std::string::npos) {
      what.erase(0, found + mark.size());
      break;
    }
  return "the JSON text is faulty " + what;
}

}  // namespace

bool readJson(Asset& asset, std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF"))
    asset.add(Code::FACET_TEXT_NOT_UTF8, "line 1, column 1", "the text begins with a byte order mark");
  const auto valid = withValidUtf8(text);
  if (valid) asset.add(Code::FACET_TEXT_NOT_UTF8, "", "the text is not all UTF-8");
  const std::string_view source = valid ? std::string_view(*valid) : text;
  Keys keys;
  const auto look = [&](int depth, Json::parse_event_t event, Json& parsed) {
    if (depth > asset.limits.jsonDepth)
      throw TooDeep("nests deeper than " + std::to_string(asset.limits.jsonDepth) + " levels");
    if (event == Json::parse_event_t::object_start) keys.open();
    if (event == Json::parse_event_t::object_end) keys.close();
    if (event == Json::parse_event_t::key && !keys.isNew(parsed.get<std::string>()))
      asset.add(Code::FACET_DUPLICATE_KEY, "", inQuotes(parsed.get<std::string>()) + " is given twice in one object");
    return true;
  };
  try {
    asset.json = Json::parse(source.begin(), source.end(), look);
  } catch (const TooDeep& error) {
    asset.add(Code::INVALID_JSON, "", std::string("the JSON text ") + error.what());
    return false;
  } catch (const Json::parse_error& error) {
    const size_t byte = error.byte > 0 ? error.byte - 1 : 0;
    asset.add(Code::INVALID_JSON, lineAndColumn(source, byte), problemOf(error.what()));
    return false;
  } catch (const Json::exception& error) {
    asset.add(Code::INVALID_JSON, "", problemOf(error.what()));
    return false;
  }
  if (asset.json.is_object()) return true;
  asset.add(Code::TYPE_MISMATCH, "", "the JSON text holds no object");
  return false;
}

}  // namespace facet::io::validate
