#include "io/validate/image_colour.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "io/validate/asset.hpp"

namespace facet::io::validate {

namespace {

constexpr uint32_t srgbGamma = 45455, linearGamma = 100000;
constexpr std::array<uint32_t, 8> srgbPrimaries = {31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000};

uint32_t bigEndian(std::span<const uint8_t> b, size_t at) {
  return uint32_t{b[at]} << 24 | uint32_t{b[at + 1]} << 16 | uint32_t{b[at + 2]} << 8 | b[at + 3];
}

}  // namespace

bool ImageColour::isUnusual() const {
  const bool oddGamma = gamma && *gamma != srgbGamma && *gamma != linearGamma;
  return profile || stretched || (!srgb && (primaries || oddGamma));
}

bool ImageColour::hasCurve() const { return srgb || profile || (gamma && *gamma != linearGamma); }

std::string ImageColour::text() const {
  std::string out;
  const auto add = [&](const std::string& part) { out += (out.empty() ? "" : ", ") + part; };
  if (srgb) add("an sRGB chunk");
  if (profile) add("a colour profile");
  if (gamma) add("a gAMA chunk of " + numberText(*gamma / 100000.0));
  if (primaries) add("primaries of its own (cHRM)");
  if (stretched) add("pixels that are not square (pHYs)");
  return "the image has " + out;
}

namespace {

ImageColour ofPng(std::span<const uint8_t> bytes) {
  constexpr size_t signature = 8, around = 12;  // length, type and checksum of a chunk
  ImageColour out;
  out.cutOff = true;
  for (size_t at = signature; at + around <= bytes.size();) {
    const size_t length = bigEndian(bytes, at);
    const std::string_view type(reinterpret_cast<const char*>(bytes.data()) + at + 4, 4);
    if (type == "IDAT") out.cutOff = false;
    if (length > bytes.size() - at - around || type == "IDAT") break;
    const auto data = bytes.subspan(at + 8, length);
    if (type == "sRGB") out.srgb = true;
    if (type == "iCCP") out.profile = true;
    if (type == "gAMA" && length == 4) out.gamma = bigEndian(data, 0);
    if (type == "pHYs" && length == 9) out.stretched = bigEndian(data, 0) != bigEndian(data, 4);
    if (type == "cHRM" && length == 32)
      for (size_t i = 0; i < srgbPrimaries.size(); ++i)
        out.primaries = out.primaries || bigEndian(data, 4 * i) != srgbPrimaries[i];
    at += around + length;
  }
  return out;
}

}  // namespace

ImageColour colourOf(std::span<const uint8_t> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.starts_with("\x89PNG\r\n\x1A\n")) return ofPng(bytes);
  constexpr size_t flags = 20;  // of a WebP's VP8X chunk
  constexpr uint8_t profile = 0x20;
  ImageColour out;
  if (text.starts_with("RIFF") && text.size() > flags && text.substr(12, 4) == "VP8X")
    out.profile = (bytes[flags] & profile) != 0;
  return out;
}

}  // namespace facet::io::validate
