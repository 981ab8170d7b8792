#include "io/validate/formats.hpp"

#include <algorithm>

#include "io/validate/elements.hpp"

namespace facet::io::validate {

namespace {

constexpr int byte = 5120, ubyte = 5121, ushort = 5123;

bool isInteger(int componentType) { return componentType >= byte && componentType <= ushort; }
bool isSigned(int componentType) { return componentType == byte || componentType == 5122; }
bool isUnsigned(int componentType) { return componentType == ubyte || componentType == ushort; }

bool isPlain(const Accessor& a) { return isFloat(a.componentType) && !a.normalized; }

// Floats, or integers that stand for 0 to 1.
bool isUnitRange(const Accessor& a) { return isPlain(a) || (isUnsigned(a.componentType) && a.normalized); }

bool isVector(const Accessor& a, std::string_view type) { return a.type == type; }

bool isBaseFormat(std::string_view stem, bool quantized, const Accessor& a) {
  const bool plain = isPlain(a), integer = quantized && isInteger(a.componentType);
  const bool signedUnit = quantized && isSigned(a.componentType) && a.normalized;
  if (stem == "POSITION") return isVector(a, "VEC3") && (plain || integer);
  if (stem == "NORMAL") return isVector(a, "VEC3") && (plain || signedUnit);
  if (stem == "TANGENT") return isVector(a, "VEC4") && (plain || signedUnit);
  if (stem == "TEXCOORD") return isVector(a, "VEC2") && (isUnitRange(a) || integer);
  if (stem == "COLOR") return (isVector(a, "VEC3") || isVector(a, "VEC4")) && isUnitRange(a);
  if (stem == "JOINTS") return isVector(a, "VEC4") && isUnsigned(a.componentType) && !a.normalized;
  if (stem == "WEIGHTS") return isVector(a, "VEC4") && isUnitRange(a);
  return true;
}

bool isTargetFormat(std::string_view stem, bool quantized, const Accessor& a) {
  const bool plain = isPlain(a), signedUnit = isSigned(a.componentType) && a.normalized;
  const bool unit = isUnitRange(a) || signedUnit;
  if (stem == "POSITION") return isVector(a, "VEC3") && (plain || (quantized && isSigned(a.componentType)));
  if (stem == "NORMAL" || stem == "TANGENT") return isVector(a, "VEC3") && (plain || (quantized && signedUnit));
  if (stem == "TEXCOORD") return isVector(a, "VEC2") && (unit || (quantized && isSigned(a.componentType)));
  if (stem == "COLOR") return (isVector(a, "VEC3") || isVector(a, "VEC4")) && unit;
  return true;
}

}  // namespace

bool isAttributeFormat(const Asset& asset, std::string_view attribute, bool target, const Accessor& a) {
  const bool quantized = asset.extensionsUsed.contains("KHR_mesh_quantization");
  if (a.componentType == 5130 && !asset.extensionsUsed.contains("KHR_accessor_float64")) return false;
  const std::string_view stem = attribute.substr(0, attribute.find('_'));
  return target ? isTargetFormat(stem, quantized, a) : isBaseFormat(stem, quantized, a);
}

bool isAnimationFormat(std::string_view path, const Accessor& a) {
  const bool unit = isPlain(a) || (isInteger(a.componentType) && a.normalized);
  if (path == "translation" || path == "scale") return isVector(a, "VEC3") && isPlain(a);
  if (path == "rotation") return isVector(a, "VEC4") && unit;
  if (path == "weights") return isVector(a, "SCALAR") && unit;
  return true;
}

std::string formatText(const Accessor& a) {
  const char* words = "unknown numbers";
  switch (a.componentType) {
    case 5120:
      words = "bytes";
      break;
    case 5121:
      words = "unsigned bytes";
      break;
    case 5122:
      words = "shorts";
      break;
    case 5123:
      words = "unsigned shorts";
      break;
    case 5125:
      words = "unsigned 32-bit integers";
      break;
    case 5126:
      words = "floats";
      break;
    case 5130:
      words = "doubles";
      break;
    default:
      break;
  }
  return a.type + " of " + (a.normalized ? "normalized " : "") + words;
}

}  // namespace facet::io::validate
