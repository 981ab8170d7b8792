#include "io/utia.hpp"

#include <cstring>

#include "base/srgb.hpp"
#include "io/measured_cells.hpp"

namespace facet::io {

namespace {

double decoded(double value, UtiaDecode decode) {
  if (decode == UtiaDecode::srgb) return linearFromSrgb(value);
  if (decode == UtiaDecode::srgb140) return 100 * linearFromSrgb(value / 140);
  return value;
}

}  // namespace

Result<optics::MeasuredBrdf> decodeUtia(std::span<const uint8_t> bytes, const std::string& name, UtiaDecode decode) {
  if (bytes.size() != utiaBytes) {
    return fail(name, "",
                "has " + std::to_string(bytes.size()) + " bytes, but the .bin files of the UTIA database have " +
                    std::to_string(utiaBytes),
                bytes.size() < utiaBytes ? "copy or download it again" : "give one of them");
  }
  optics::MeasuredBrdf brdf{.name = name, .kind = optics::MeasuredKind::utia, .values = {}, .counts = {}};
  const size_t cells = optics::cellsOf(brdf.kind);
  brdf.values.resize(cells);
  storeCells(brdf, [&](size_t i) {
    glm::dvec3 value;
    for (size_t c = 0; c < 3; ++c) {
      double stored;
      std::memcpy(&stored, bytes.data() + 8 * (c * cells + i), 8);
      value[static_cast<int>(c)] = decoded(stored, decode);
    }
    return value;
  });
  if (brdf.counts.missing() == cells) return noValidCell(name, brdf.counts);
  return brdf;
}

std::vector<uint8_t> encodeUtia(const optics::MeasuredBrdf& brdf) {
  std::vector<uint8_t> bytes(utiaBytes);
  const size_t cells = brdf.values.size();
  for (size_t c = 0; c < 3; ++c) {
    for (size_t i = 0; i < cells; ++i) {
      const double value = brdf.values[i][static_cast<int>(c)];
      std::memcpy(bytes.data() + 8 * (c * cells + i), &value, 8);
    }
  }
  return bytes;
}

}  // namespace facet::io
