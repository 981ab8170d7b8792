#include "frame/measured_read.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "base/parallel.hpp"
#include "frame/settings.hpp"
#include "io/measured.hpp"
#include "layout.h"

namespace facet::frame {

namespace {

// To the nearest half, of [0, 65504]: a float times 2^-112 has a half's exponent, subnormal ones too.
uint32_t halfBits(float value) {
  const auto bits = std::bit_cast<uint32_t>(value * 0x1p-112f);
  return (bits + 0xfffu + (bits >> 13 & 1u)) >> 13;
}
constexpr glm::uvec2 missingCell(0xbc00, 0x3c000000);  // -1, and 1 for a unit

// The unit: the power of two below the largest channel, as far as that is a half, and its bits.
glm::uvec2 packCell(const glm::vec3& value) {
  const float largest = std::max({value.x, value.y, value.z});
  const int exponent = std::clamp(static_cast<int>(std::bit_cast<uint32_t>(largest) >> 23) - 127, -24, 15);
  const float inverse = std::bit_cast<float>(static_cast<uint32_t>(127 - exponent) << 23);
  const uint32_t unit = exponent >= -14 ? static_cast<uint32_t>(exponent + 15) << 10 : 1u << (exponent + 24);
  const glm::vec3 scaled = glm::min(value * inverse, glm::vec3(65504));
  return {halfBits(scaled.x) | halfBits(scaled.y) << 16, halfBits(scaled.z) | unit << 16};
}

class Clock {
 public:
  // Milliseconds since the last lap.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double ms = std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
    return ms;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

// By slabs, on all cores.
void pack(const optics::MeasuredBrdf& brdf, glm::uvec2* cells) {
  const size_t count = brdf.values.size(), slab = std::max<size_t>(1, count / 32);
  parallelFor((count + slab - 1) / slab, [&](size_t s) {
    for (size_t i = s * slab; i < std::min(count, (s + 1) * slab); ++i)
      cells[i] = brdf.values[i].x < 0 ? missingCell : packCell(brdf.values[i]);
  });
}

}  // namespace

MeasuredBytes packedBytes(const optics::MeasuredBrdf& brdf) {
  MeasuredBytes made;
  Clock clock;
  made.facts.name = brdf.name;
  made.facts.kind = brdf.kind;
  made.facts.cells = brdf.values.size();
  made.facts.missing = brdf.counts.missing();
  made.facts.holes = brdf.guess.holes();
  made.facts.guessed = brdf.guess.energy;
  made.facts.notes = io::measuredNotes(brdf);
  const optics::MeasuredProxy& proxy = made.facts.proxy = optics::fitProxy(brdf);
  made.facts.times.fitMs = clock.lap();
  layout::MeasuredUniforms head;
  made.size = measuredBytes(brdf);
  made.bytes = std::make_unique_for_overwrite<std::byte[]>(made.size);
  pack(brdf, reinterpret_cast<glm::uvec2*>(made.bytes.get() + sizeof head));
  head.lobe = glm::vec4(proxy.alpha.t, proxy.alpha.b, std::cos(proxy.phi), std::sin(proxy.phi));
  head.table = glm::vec4(optics::cosineChance(proxy), 1, brdf.phiSteps, 0);
  std::memcpy(made.bytes.get(), &head, sizeof head);
  made.facts.times.packMs = clock.lap();
  return made;
}

size_t measuredBytes(const optics::MeasuredBrdf& brdf) {
  return sizeof(layout::MeasuredUniforms) + brdf.values.size() * sizeof(glm::uvec2);
}

std::vector<glm::uvec2> packMeasured(const optics::MeasuredBrdf& brdf) {
  std::vector<glm::uvec2> cells(brdf.values.size());
  pack(brdf, cells.data());
  return cells;
}

optics::MeasuredBrdf unpackMeasured(const std::vector<glm::uvec2>& cells, const optics::MeasuredBrdf& like) {
  optics::MeasuredBrdf brdf = like;
  for (size_t i = 0; i < cells.size(); ++i) {
    const glm::vec2 low = glm::unpackHalf2x16(cells[i].x), high = glm::unpackHalf2x16(cells[i].y);
    brdf.values[i] = low.x < 0 ? glm::vec3(optics::missingValue) : high.y * glm::vec3(low, high.x);
  }
  return brdf;
}

MeasuredSource measuredSource(const Sources& sources) { return {sources.brdf, sources.brdfDir, sources.utiaDecode}; }

Result<optics::MeasuredBrdf> readMeasuredTable(const MeasuredSource& source) {
  const Result<std::string> path = io::resolveMeasured(source.name, source.folder);
  if (!path) return tl::unexpected(path.error());
  return io::readMeasured(*path, {.utiaDecode = source.decode});
}

Result<MeasuredBytes> readMeasuredBytes(const MeasuredSource& source) {
  Clock clock;
  const Result<std::string> path = io::resolveMeasured(source.name, source.folder);
  if (!path) return tl::unexpected(path.error());
  const Result<optics::MeasuredBrdf> brdf = io::readMeasured(*path, {.utiaDecode = source.decode});
  if (!brdf) return tl::unexpected(brdf.error());
  const double readMs = clock.lap();
  MeasuredBytes made = packedBytes(*brdf);
  made.facts.source = source;
  made.facts.path = *path;
  made.facts.times.readMs = readMs;
  return made;
}

Result<FittedBrdf> fitMeasured(const MeasuredSource& source, optics::DiffuseModel diffuse) {
  Clock clock;
  const Result<optics::MeasuredBrdf> brdf = readMeasuredTable(source);
  if (!brdf) return tl::unexpected(brdf.error());
  FittedBrdf fitted{.source = source, .name = brdf->name, .kind = brdf->kind, .fit = {}};
  fitted.readMs = clock.lap();
  fitted.fit =
      optics::fitAnalytic(*brdf, optics::fitSamples(*brdf), optics::fitProxy(*brdf), diffuse, optics::FitMetric::log);
  fitted.fitMs = clock.lap();
  return fitted;
}

}  // namespace facet::frame
