#pragma once

// One pass over JSON text before any parser sees it: how deep it nests (the parsers recurse), and where the members of
// the root object lie, so that parts can be taken out of the text. Not a validator: text without balanced brackets is
// refused, other faults are left to the parser.

#include <cstddef>
#include <optional>
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
  std::vector<JsonMember> members;      // of the root object, in the text's order
  std::vector<std::string> givenTwice;  // keys of these; the later one counts, as for most parsers
  int depth = 0;
  // The objects in the root's array "accessors" that have no "bufferView": index, offset just behind the opening brace.
  struct Object {
    size_t index, begin;
  };
  std::vector<Object> accessorsWithoutView;

  const JsonMember* find(std::string_view key) const;
  size_t elements(std::string_view key) const;  // 0 where the key is missing
};

// Errors (file left empty; place "line 3, column 7"): no object, unbalanced, nested deeper than maxDepth, something
// else than digits where glTF wants a whole number (null is let pass): parsers would take that for zero or for "not
// given" without a word.
Result<JsonOutline> scanJson(std::string_view text, int maxDepth);

// glTF allows whole numbers to be written with a fraction of zero or an exponent (2.0, 3.2), which parsers take for
// numbers of another kind. The text with all of them as digits; nothing where there are none. Blanks fill up, so that
// what follows stays in its place unless an exponent needs more digits.
std::optional<std::string> withWholeNumbers(std::string_view text);

// "line 3, column 7" of a byte offset, both from 1.
std::string lineAndColumn(std::string_view text, size_t offset);

}  // namespace facet::io
