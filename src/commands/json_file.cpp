#include "commands/json_file.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

namespace facet::commands {

namespace {

using nlohmann::json;

constexpr uint64_t largestFile = uint64_t{64} << 20;  // bytes; a million jobs of 64 characters

std::string lineAndColumn(std::string_view text, size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const size_t column = before.size() - (before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1);
  return "line " + std::to_string(line) + ", column " + std::to_string(std::max<size_t>(column, 1));
}

// "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error while ...": without what leads.
std::string parserProblem(std::string_view what) {
  for (const std::string_view lead : {"] ", ": "}) {
    const size_t end = what.find(lead);
    if (end != std::string_view::npos) what.remove_prefix(end + lead.size());
  }
  return "not JSON: " + std::string(what);
}

}  // namespace

Result<json> parseJson(std::string_view text, const std::string& name) {
  try {
    return json::parse(text);
  } catch (const json::parse_error& error) {
    return fail(name, lineAndColumn(text, error.byte), parserProblem(error.what()));
  } catch (const json::out_of_range& error) {  // a number beyond double
    return fail(name, {}, parserProblem(error.what()));
  }
}

Result<std::string> readJsonText(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return fail(file.string(), {}, "there is no such file");
  if (!std::filesystem::is_regular_file(file, error)) return fail(file.string(), {}, "this is no regular file");
  if (std::filesystem::file_size(file, error) > largestFile || error) {
    return fail(file.string(), {}, "the file is larger than 64 MiB", "split it");
  }
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream) return fail(file.string(), {}, "the file cannot be read");
  return text;
}

}  // namespace facet::commands
