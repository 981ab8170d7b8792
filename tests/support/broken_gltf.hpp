#pragma once

// A model with one of nearly everything and nothing wrong, to be broken, and what is found in it then.

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "support/gltf_builder.hpp"

namespace facet::test {

GltfBuilder everything();

// "CODE /place" of each finding, sorted; of all codes.
std::vector<std::string> findings(const std::string& text);

// The model's JSON with values put at JSON pointers ({"/scene": 4}); "[removed]" takes a member away.
std::vector<std::string> findingsAfter(const std::string& edits);

struct Break {
  const char* edits;
  std::vector<std::string> found;
};
void check(const std::vector<Break>& breaks);

}  // namespace facet::test
