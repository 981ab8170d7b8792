#include "commands/shard.hpp"

#include "base/text.hpp"

namespace facet::commands {

Result<Shard> parseShard(const std::string& text) {
  const std::vector<std::string_view> parts = split(text, '/');
  const std::string remedy = "give I/N such as 2/4, I from 1 to N";
  if (parts.size() != 2) return fail({}, "--shard", inQuotes(text) + " is no shard", remedy);
  const Result<int> count = parseWhole(parts[1], 1, 1'000'000);
  if (!count) return fail({}, "--shard", inQuotes(text) + " is no shard", remedy);
  const Result<int> index = parseWhole(parts[0], 1, *count);
  if (!index) return fail({}, "--shard", inQuotes(text) + " is no shard", remedy);
  return Shard{*index, *count};
}

}  // namespace facet::commands
