#pragma once

// What targets have in common.

#include <cstdio>
#include <span>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "base/text.hpp"
#include "fuzz/targets.hpp"

namespace facet::fuzz {

using Input = std::span<const uint8_t>;

inline std::string_view textOf(Input bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

// An error is a sentence about something, in UTF-8.
inline void demandSentence(const Error& error) {
  demand(!error.problem.empty(), "an error says what is wrong");
  const std::string text = describe(error);
  demand(!withValidUtf8(text), ("an error is UTF-8: " + text).c_str());
  demand(text.size() < 4096, ("an error is one sentence: " + text).c_str());
}

// Whether there is a result; what went wrong otherwise is held to be a sentence.
template <class T>
bool good(const Result<T>& result) {
  if (!result) demandSentence(result.error());
  return result.has_value();
}

}  // namespace facet::fuzz
