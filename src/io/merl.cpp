#include "io/merl.hpp"

#include <array>
#include <cstring>

#include "io/measured_cells.hpp"

namespace facet::io {

namespace {

constexpr double scale[3] = {1.0 / 1500, 1.15 / 1500, 1.66 / 1500};
constexpr const char* where = "the layout is that of the MERL BRDF database: give one of its .binary files";

std::array<int32_t, 3> dimensionsOf(std::span<const uint8_t> bytes) {
  std::array<int32_t, 3> dimensions{};
  std::memcpy(dimensions.data(), bytes.data(), sizeof dimensions);
  return dimensions;
}

bool known(const std::array<int32_t, 3>& d) {
  return d[0] == optics::merlThetaSteps && d[1] == optics::merlThetaSteps &&
         (d[2] == optics::merlPhiSteps || d[2] == 2 * optics::merlPhiSteps);
}

}  // namespace

bool isMerl(std::span<const uint8_t> bytes) { return bytes.size() >= 12 && known(dimensionsOf(bytes)); }

Result<optics::MeasuredBrdf> decodeMerl(std::span<const uint8_t> bytes, const std::string& name) {
  if (bytes.size() < 12) return fail(name, "byte 0", "the file ends within its twelve bytes of dimensions", where);
  const std::array<int32_t, 3> d = dimensionsOf(bytes);
  if (!known(d)) {
    return fail(name, "byte 0",
                "the dimensions " + std::to_string(d[0]) + " x " + std::to_string(d[1]) + " x " + std::to_string(d[2]) +
                    " are not 90 x 90 x 180 (or 360)",
                where);
  }
  if (bytes.size() != merlBytes(d[2])) {
    return fail(
        name, "",
        "has " + std::to_string(bytes.size()) + " bytes, but its dimensions need " + std::to_string(merlBytes(d[2])),
        bytes.size() < merlBytes(d[2]) ? "it is cut off: copy or download it again" : where);
  }
  optics::MeasuredBrdf brdf{.name = name, .phiSteps = d[2], .values = {}, .counts = {}};
  const size_t cells = optics::cellsOf(brdf.kind, brdf.phiSteps);
  brdf.values.resize(cells);
  const uint8_t* data = bytes.data() + 12;
  storeCells(brdf, [&](size_t i) {
    double value[3];
    for (size_t c = 0; c < 3; ++c) std::memcpy(&value[c], data + 8 * (c * cells + i), 8);
    return glm::dvec3(value[0] * scale[0], value[1] * scale[1], value[2] * scale[2]);
  });
  if (brdf.counts.missing() == cells) return noValidCell(name, brdf.counts);
  return brdf;
}

std::vector<uint8_t> encodeMerl(const optics::MeasuredBrdf& brdf) {
  const size_t cells = brdf.values.size();
  std::vector<uint8_t> bytes(merlBytes(brdf.phiSteps));
  const int32_t dimensions[3] = {optics::merlThetaSteps, optics::merlThetaSteps, brdf.phiSteps};
  std::memcpy(bytes.data(), dimensions, sizeof dimensions);
  for (size_t c = 0; c < 3; ++c) {
    for (size_t i = 0; i < cells; ++i) {
      const double value = brdf.values[i][static_cast<int>(c)] / scale[c];
      std::memcpy(bytes.data() + 12 + 8 * (c * cells + i), &value, 8);
    }
  }
  return bytes;
}

}  // namespace facet::io
