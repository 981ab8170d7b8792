#pragma once

// A list split over many machines, the same way on each.

#include <cstddef>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace facet::commands {

// "2/4": the second of four.
struct Shard {
  int index = 1, count = 1;
};
Result<Shard> parseShard(const std::string& text);

// Every count-th item from the index-th on: neighbours, which tend to cost alike, go to different shards.
template <class T>
std::vector<T> shardOf(const std::vector<T>& items, const Shard& shard) {
  std::vector<T> mine;
  for (size_t i = static_cast<size_t>(shard.index - 1); i < items.size(); i += static_cast<size_t>(shard.count))
    mine.push_back(items[i]);
  return mine;
}

}  // namespace facet::commands
