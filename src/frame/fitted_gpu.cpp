#include "frame/fitted_gpu.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/log.hpp"
#include "frame/settings.hpp"
#include "layout.h"
#include "optics/color.hpp"

namespace facet::frame {

namespace {

constexpr size_t keptFits = 64;

// To draw samples from: the model's own lobe; the cosine gets about its share of what is reflected.
optics::MeasuredProxy lobeOf(const optics::AnalyticBrdf& model) {
  const double diffuse = optics::luminance(model.albedo), specular = optics::luminance(model.f0);
  return {.alpha = model.alpha,
          .phi = model.phi,
          .diffuse = model.albedo,
          .diffuseShare = diffuse + specular > 0 ? diffuse / (diffuse + specular) : 1};
}

}  // namespace

std::shared_ptr<const FittedOnGpu> uploadFitted(FittedBrdf fitted) {
  const optics::AnalyticBrdf& model = fitted.fit.model;
  layout::MeasuredUniforms head{};
  head.lobe = glm::vec4(model.alpha.t, model.alpha.b, std::cos(model.phi), std::sin(model.phi));
  head.table = glm::vec4(optics::cosineChance(lobeOf(model)), 1, 0, 0);
  const layout::FittedUniforms colors{glm::vec4(glm::vec3(model.f0), optics::roughnessOf(model)),
                                      glm::vec4(glm::vec3(model.f90), 0), glm::vec4(glm::vec3(model.albedo), 0)};
  std::vector<std::byte> bytes(sizeof head + sizeof colors);
  std::memcpy(bytes.data(), &head, sizeof head);
  std::memcpy(bytes.data() + sizeof head, &colors, sizeof colors);
  log::debug("fitted to " + fitted.name + ": read " + std::to_string(std::lround(fitted.readMs)) + " ms, fit " +
             std::to_string(std::lround(fitted.fitMs)) + " ms");
  auto made = std::make_shared<FittedOnGpu>();
  made->fitted = std::move(fitted);
  made->buffer = gl::Buffer(bytes, "fitted BRDF");
  return made;
}

std::shared_ptr<const FittedOnGpu> keptFit(MeasuredStore& store, const MeasuredSource& source,
                                           optics::DiffuseModel diffuse) {
  const auto known = std::ranges::find_if(store.fits, [&](const auto& kept) {
    return kept->fitted.source == source && kept->fitted.fit.model.diffuse == diffuse;
  });
  if (known == store.fits.end()) return nullptr;
  store.fits.splice(store.fits.begin(), store.fits, known);
  return store.fits.front();
}

void keepFit(MeasuredStore& store, std::shared_ptr<const FittedOnGpu> made) {
  store.fits.push_front(std::move(made));
  if (store.fits.size() > keptFits) store.fits.pop_back();
}

Result<std::shared_ptr<const FittedOnGpu>> findFit(MeasuredStore& store, const MeasuredSource& source,
                                                   optics::DiffuseModel diffuse) {
  if (auto kept = keptFit(store, source, diffuse)) return kept;
  Result<FittedBrdf> fitted = fitMeasured(source, diffuse);
  if (!fitted) return tl::unexpected(fitted.error());
  keepFit(store, uploadFitted(std::move(*fitted)));
  return store.fits.front();
}

Notes fitNotes(const FittedBrdf& fitted) {
  const std::string remark = optics::albedoRemark(fitted.fit);
  if (remark.empty()) return {};
  return {
      {Note::Severity::warning, "", "the model that was fitted to " + fitted.name + " is not its shape: " + remark}};
}

void setFitted(DrawOptions& options, BrdfCompare compare) {
  options.features.measuredFitted = compare == BrdfCompare::fit;
  options.compared = compare == BrdfCompare::split || compare == BrdfCompare::difference;
}

}  // namespace facet::frame
