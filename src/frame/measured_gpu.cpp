#include "frame/measured_gpu.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "base/log.hpp"
#include "base/parallel.hpp"
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

// To the halves of all cells; returns their scale. By slabs, on all cores.
float pack(const optics::MeasuredBrdf& brdf, glm::uvec2* cells) {
  const size_t count = brdf.values.size(), slab = std::max<size_t>(1, count / 32);
  const size_t slabs = (count + slab - 1) / slab;
  const auto each = [&](const auto& work) {
    parallelFor(slabs, [&](size_t s) { work(s, s * slab, std::min(count, (s + 1) * slab)); });
  };
  std::vector<float> largests(slabs, 0.0f);
  each([&](size_t s, size_t first, size_t last) {
    float largest = 0;
    for (size_t i = first; i < last; ++i)
      largest = std::max({largest, brdf.values[i].x, brdf.values[i].y, brdf.values[i].z});
    largests[s] = largest;
  });
  const float largest = *std::ranges::max_element(largests);
  const float scale = largest > 0 ? std::ldexp(1.0f, std::max(std::ilogb(largest) - 14, -100)) : 1;
  const float inverse = 1 / scale;
  each([&](size_t, size_t first, size_t last) {
    for (size_t i = first; i < last; ++i) {
      const glm::vec3& value = brdf.values[i];
      cells[i] = value.x < 0 ? glm::uvec2(missingHalf, 0)
                             : glm::uvec2(halfBits(value.x * inverse) | halfBits(value.y * inverse) << 16,
                                          halfBits(value.z * inverse));
    }
  });
  return scale;
}

MeasuredBytes bytesOf(const optics::MeasuredBrdf& brdf) {
  MeasuredBytes made;
  Clock clock;
  made.facts.name = brdf.name;
  made.facts.kind = brdf.kind;
  made.facts.cells = brdf.values.size();
  made.facts.missing = brdf.counts.missing();
  made.facts.notes = io::measuredNotes(brdf);
  const optics::MeasuredProxy& proxy = made.facts.proxy = optics::fitProxy(brdf);
  made.facts.times.fitMs = clock.lap();
  layout::MeasuredUniforms head;
  made.size = measuredBytes(brdf);
  made.bytes = std::make_unique_for_overwrite<std::byte[]>(made.size);
  const float scale = pack(brdf, reinterpret_cast<glm::uvec2*>(made.bytes.get() + sizeof head));
  head.lobe = glm::vec4(proxy.alpha.t, proxy.alpha.b, std::cos(proxy.phi), std::sin(proxy.phi));
  head.table = glm::vec4(optics::cosineChance(proxy), scale, brdf.phiSteps, 0);
  std::memcpy(made.bytes.get(), &head, sizeof head);
  made.facts.times.packMs = clock.lap();
  return made;
}

}  // namespace

size_t measuredBytes(const optics::MeasuredBrdf& brdf) {
  return sizeof(layout::MeasuredUniforms) + brdf.values.size() * sizeof(glm::uvec2);
}

PackedBrdf packMeasured(const optics::MeasuredBrdf& brdf) {
  PackedBrdf packed;
  packed.cells.resize(brdf.values.size());
  packed.scale = pack(brdf, packed.cells.data());
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

Result<MeasuredBytes> readMeasuredBytes(const MeasuredSource& source) {
  Clock clock;
  const Result<std::string> path = io::resolveMeasured(source.name, source.folder);
  if (!path) return tl::unexpected(path.error());
  const Result<optics::MeasuredBrdf> brdf = io::readMeasured(*path, {.utiaDecode = source.decode});
  if (!brdf) return tl::unexpected(brdf.error());
  const double readMs = clock.lap();
  MeasuredBytes made = bytesOf(*brdf);
  made.facts.source = source;
  made.facts.path = *path;
  made.facts.times.readMs = readMs;
  return made;
}

std::shared_ptr<const MeasuredOnGpu> uploadMeasured(MeasuredBytes read) {
  auto made = std::make_shared<MeasuredOnGpu>();
  Clock clock;
  made->facts = std::move(read.facts);
  made->buffer = gl::Buffer({read.bytes.get(), read.size}, "measured BRDF");
  MeasuredTimes& t = made->facts.times;
  t.uploadMs = clock.lap();
  const auto text = [](double ms) { return std::to_string(std::lround(ms)) + " ms"; };
  log::debug("measured BRDF " + made->facts.name + ": read and checked " + text(t.readMs) + ", lobe " + text(t.fitMs) +
             ", packed " + text(t.packMs) + ", uploaded " + text(t.uploadMs));
  return made;
}

std::shared_ptr<const MeasuredOnGpu> uploadMeasured(const optics::MeasuredBrdf& brdf) {
  return uploadMeasured(bytesOf(brdf));
}

std::shared_ptr<const MeasuredOnGpu> keptMeasured(MeasuredStore& store, const MeasuredSource& source) {
  const auto known = std::ranges::find_if(store.kept, [&](const auto& kept) { return kept->facts.source == source; });
  if (known == store.kept.end()) return nullptr;
  store.kept.splice(store.kept.begin(), store.kept, known);
  return store.kept.front();
}

void keepMeasured(MeasuredStore& store, std::shared_ptr<const MeasuredOnGpu> made) {
  std::erase_if(store.kept, [&](const auto& kept) { return kept->facts.source == made->facts.source; });
  store.kept.push_front(std::move(made));
  size_t bytes = 0;
  for (auto kept = store.kept.begin(); kept != store.kept.end();) {
    bytes += (*kept)->buffer.bytes();
    kept = bytes > measuredBudget && kept != store.kept.begin() ? store.kept.erase(kept) : std::next(kept);
  }
}

Result<std::shared_ptr<const MeasuredOnGpu>> findMeasured(MeasuredStore& store, const MeasuredSource& source,
                                                          Notes& notes) {
  std::shared_ptr<const MeasuredOnGpu> found = keptMeasured(store, source);
  if (!found) {
    Result<MeasuredBytes> read = readMeasuredBytes(source);
    if (!read) return tl::unexpected(read.error());
    found = uploadMeasured(std::move(*read));
    keepMeasured(store, found);
  }
  notes.insert(notes.end(), found->facts.notes.begin(), found->facts.notes.end());
  return found;
}

void setMeasured(shading::FrameFeatures& features, const PictureSettings& settings, optics::MeasuredKind kind) {
  features.measured = kind == optics::MeasuredKind::merl ? shading::Measured::merl : shading::Measured::utia;
  features.measuredNearest = settings.brdfLookUp == optics::LookUp::nearest;
}

}  // namespace facet::frame
