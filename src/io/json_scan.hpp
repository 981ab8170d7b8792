#pragma once

// One pass over JSON text before any parser sees it: how deep it nests (the parsers recurse), and where the members of
// the root object lie, so that parts can be taken out of the text. Not a validator: text without balanced brackets is
// refused, other faults are left to the parser.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace facet::io {

struct JsonMember {
  std::string key;
  size_t begin = 0, end = 0;  // the value's bytes in the text
  size_t elements = 0;        // of an array
};

struct JsonOutline {
  std::vector<JsonMember> members;  // of the root object, in the text's order
  int depth = 0;
  // The objects in the root's array "accessors" that have no "bufferView": index, offset just behind the opening brace.
  struct Object {
    size_t index, begin;
  };
  std::vector<Object> accessorsWithoutView;

  const JsonMember* find(std::string_view key) const;
  size_t elements(std::string_view key) const;  // 0 where the key is missing
};

// Errors (file left empty; place "line 3, column 7"): no object, unbalanced, nested deeper than maxDepth, a key of the
// root given twice.
Result<JsonOutline> scanJson(std::string_view text, int maxDepth);

// "line 3, column 7" of a byte offset, both from 1.
std::string lineAndColumn(std::string_view text, size_t offset);

}  // namespace facet::io
