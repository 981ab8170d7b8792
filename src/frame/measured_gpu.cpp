#include "frame/measured_gpu.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "base/log.hpp"
#include "io/measured.hpp"
#include "layout.h"

namespace facet::frame {

namespace {

// To the nearest half, of [0, 65504]: a float times 2^-112 has a half's exponent, subnormal ones too.
uint32_t halfBits(float value) {
  const auto bits = std::bit_cast<uint32_t>(value * 0x1p-112f);
  return (bits + 0xfffu + (bits >> 13 & 1u)) >> 13;
}
constexpr uint32_t missingHalf = 0xbc00;  // -1

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

std::vector<std::byte> bufferOf(const optics::MeasuredBrdf& brdf, const optics::MeasuredProxy& proxy) {
  const PackedBrdf packed = packMeasured(brdf);
  layout::MeasuredUniforms head;
  head.lobe = glm::vec4(proxy.alpha.t, proxy.alpha.b, std::cos(proxy.phi), std::sin(proxy.phi));
  head.table = glm::vec4(optics::cosineChance(proxy), packed.scale, brdf.phiSteps, 0);
  std::vector<std::byte> bytes(measuredBytes(brdf));
  std::memcpy(bytes.data(), &head, sizeof head);
  std::memcpy(bytes.data() + sizeof head, packed.cells.data(), bytes.size() - sizeof head);
  return bytes;
}

std::shared_ptr<MeasuredOnGpu> upload(const optics::MeasuredBrdf& brdf) {
  auto made = std::make_shared<MeasuredOnGpu>();
  Clock clock;
  made->name = brdf.name;
  made->kind = brdf.kind;
  made->proxy = optics::fitProxy(brdf);
  made->times.fitMs = clock.lap();
  const std::vector<std::byte> bytes = bufferOf(brdf, made->proxy);
  made->times.packMs = clock.lap();
  made->buffer = gl::Buffer(bytes, "measured BRDF");
  made->times.uploadMs = clock.lap();
  return made;
}

}  // namespace

PackedBrdf packMeasured(const optics::MeasuredBrdf& brdf) {
  float largest = 0;
  for (const glm::vec3& value : brdf.values) largest = std::max({largest, value.x, value.y, value.z});
  PackedBrdf packed;
  if (largest > 0) packed.scale = std::ldexp(1.0f, std::max(std::ilogb(largest) - 14, -100));
  const float inverse = 1 / packed.scale;
  packed.cells.resize(brdf.values.size());
  for (size_t i = 0; i < brdf.values.size(); ++i) {
    const glm::vec3& value = brdf.values[i];
    packed.cells[i] = value.x < 0 ? glm::uvec2(missingHalf, 0)
                                  : glm::uvec2(halfBits(value.x * inverse) | halfBits(value.y * inverse) << 16,
                                               halfBits(value.z * inverse));
  }
  return packed;
}

optics::MeasuredBrdf unpackMeasured(const PackedBrdf& packed, const optics::MeasuredBrdf& like) {
  optics::MeasuredBrdf brdf = like;
  for (size_t i = 0; i < packed.cells.size(); ++i) {
    const glm::vec2 low = glm::unpackHalf2x16(packed.cells[i].x), high = glm::unpackHalf2x16(packed.cells[i].y);
    brdf.values[i] = low.x < 0 ? glm::vec3(optics::missingValue) : packed.scale * glm::vec3(low, high.x);
  }
  return brdf;
}

MeasuredSource measuredSource(const PictureSettings& settings) {
  return {settings.brdf, settings.brdfDir, settings.utiaDecode};
}

std::shared_ptr<const MeasuredOnGpu> uploadMeasured(const optics::MeasuredBrdf& brdf) { return upload(brdf); }

size_t measuredBytes(const optics::MeasuredBrdf& brdf) {
  return sizeof(layout::MeasuredUniforms) + brdf.values.size() * sizeof(glm::uvec2);
}

Result<std::shared_ptr<const MeasuredOnGpu>> findMeasured(MeasuredStore& store, const MeasuredSource& source,
                                                          Notes& notes) {
  const auto known = std::ranges::find_if(store.kept, [&](const auto& kept) { return kept->source == source; });
  if (known != store.kept.end()) {
    store.kept.splice(store.kept.begin(), store.kept, known);
  } else {
    Clock clock;
    const Result<std::string> path = io::resolveMeasured(source.name, source.folder);
    if (!path) return tl::unexpected(path.error());
    const Result<optics::MeasuredBrdf> brdf = io::readMeasured(*path, {.utiaDecode = source.decode});
    if (!brdf) return tl::unexpected(brdf.error());
    const double readMs = clock.lap();
    const std::shared_ptr<MeasuredOnGpu> made = upload(*brdf);
    made->source = source;
    made->notes = io::measuredNotes(*brdf);
    made->times.readMs = readMs;
    const MeasuredTimes& t = made->times;
    const auto text = [](double ms) { return std::to_string(std::lround(ms)) + " ms"; };
    log::debug("measured BRDF " + made->name + ": read and checked " + text(t.readMs) + ", lobe " + text(t.fitMs) +
               ", packed " + text(t.packMs) + ", uploaded " + text(t.uploadMs));
    store.kept.push_front(made);
    size_t bytes = 0;
    for (auto kept = store.kept.begin(); kept != store.kept.end();) {
      bytes += (*kept)->buffer.bytes();
      kept = bytes > measuredBudget && kept != store.kept.begin() ? store.kept.erase(kept) : std::next(kept);
    }
  }
  const MeasuredOnGpu& found = *store.kept.front();
  notes.insert(notes.end(), found.notes.begin(), found.notes.end());
  return store.kept.front();
}

void setMeasured(shading::FrameFeatures& features, const PictureSettings& settings, optics::MeasuredKind kind) {
  features.measured = kind == optics::MeasuredKind::merl ? shading::Measured::merl : shading::Measured::utia;
  features.measuredNearest = settings.brdfLookUp == optics::LookUp::nearest;
}

}  // namespace facet::frame
