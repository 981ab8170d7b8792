#pragma once

// What validation finds in a file, by the names and severities of Khronos' glTF-Validator (codes.inc).

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace facet::io::validate {

enum class Severity : uint8_t { error, warning, info, hint };
inline constexpr std::array severityNames = {"error", "warning", "info", "hint"};

enum class Code : uint16_t {
#define CODE(name, severity, remedy) name,
#include "io/validate/codes.inc"
#undef CODE
};

const char* name(Code code);
Severity severity(Code code);
const char* remedy(Code code);  // what to do, no full stop

struct Finding {
  Code code;
  std::string place;             // JSON pointer; "byte 12" of a .glb's container; empty: the file
  std::string text;              // what is wrong, no full stop
  int node = -1, material = -1;  // where it can be seen: indices in the file; -1: nowhere, or not known
};

// Texels of a texture a metre of a primitive's surface, in the mesh's own units: what a twentieth, a half and all but a
// twentieth of the area have less than.
struct TexelDensity {
  std::string place, texture;
  double low = 0, middle = 0, high = 0;
};

struct Report {
  std::vector<Finding> findings;  // worst first, then as they lie in the file
  size_t leftOut = 0;             // found, but beyond mostFindings
  std::vector<TexelDensity> densities = {};
  uint64_t textureBytes = 0;  // of all images as 8-bit RGBA with mip levels

  size_t count(Severity severity) const;
};
inline constexpr size_t mostFindings = 10000;

}  // namespace facet::io::validate
