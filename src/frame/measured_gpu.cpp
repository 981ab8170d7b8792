#include "frame/measured_gpu.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/log.hpp"
#include "frame/fitted_gpu.hpp"
#include "frame/measured_samples.hpp"
#include "frame/settings.hpp"

namespace facet::frame {

std::shared_ptr<const MeasuredOnGpu> uploadMeasured(MeasuredBytes read) {
  auto made = std::make_shared<MeasuredOnGpu>();
  const auto start = std::chrono::steady_clock::now();
  made->facts = std::move(read.facts);
  made->buffer = gl::Buffer({read.bytes.get(), read.size}, "measured BRDF");
  MeasuredTimes& t = made->facts.times;
  t.uploadMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  const auto text = [](double ms) { return std::to_string(std::lround(ms)) + " ms"; };
  log::debug("measured BRDF " + made->facts.name + ": read and checked " + text(t.readMs) + ", lobe " + text(t.fitMs) +
             ", packed " + text(t.packMs) + ", uploaded " + text(t.uploadMs));
  return made;
}

std::shared_ptr<const MeasuredOnGpu> uploadMeasured(const optics::MeasuredBrdf& brdf) {
  return uploadMeasured(packedBytes(brdf));
}

std::shared_ptr<const MeasuredOnGpu> keptMeasured(MeasuredStore& store, const MeasuredSource& source) {
  const auto known = std::ranges::find_if(store.kept, [&](const auto& kept) { return kept->facts.source == source; });
  if (known == store.kept.end()) return nullptr;
  store.kept.splice(store.kept.begin(), store.kept, known);
  return store.kept.front();
}

void keepMeasured(MeasuredStore& store, std::shared_ptr<const MeasuredOnGpu> made) {
  std::erase_if(store.kept, [&](const auto& kept) { return kept->facts.source == made->facts.source; });
  std::erase_if(store.fits, [&](const auto& fit) { return fit->fitted.source == made->facts.source; });
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

void setMeasured(shading::FrameFeatures& features, const Look& look, optics::MeasuredKind kind,
                 const optics::MeasuredProxy& proxy) {
  features.measured = kind == optics::MeasuredKind::merl ? shading::Measured::merl : shading::Measured::utia;
  features.measuredNearest = look.brdfLookUp == optics::LookUp::nearest;
  features.measuredLightSamples = look.brdfSamples > 0 ? look.brdfSamples : measuredSamples(proxy);
}

}  // namespace facet::frame
