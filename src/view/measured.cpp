#include "view/measured.hpp"

namespace facet::view {

bool provideMeasured(MeasuredView& measured, const ListRequest& built, Loader& loader, ListRequest& request) {
  const bool asked = measured.asked && measured.asked->source == request.brdf;
  if (built.brdf != request.brdf && !asked)
    measured.asked = MeasuredAsked{request.brdf, std::chrono::steady_clock::now()};
  request.measured = frame::keptMeasured(measured.store, request.brdf);
  if (request.measured) return true;
  if (!loader.measured.running() || measured.loading != request.brdf) startMeasured(loader, request.brdf);
  measured.loading = request.brdf;
  return false;
}

void provideFit(MeasuredView& measured, const frame::PictureSettings& settings, Loader& loader, ListRequest& request) {
  if (settings.display.brdfCompare == frame::BrdfCompare::none) return;
  request.fitted = frame::keptFit(measured.store, request.brdf, settings.look.models.diffuse);
  request.compared = request.fitted && settings.display.brdfCompare != frame::BrdfCompare::fit;
  const FitAsked wanted{request.brdf, settings.look.models.diffuse};
  if (request.fitted || measured.fitAsked == wanted) return;
  startFit(loader, wanted.source, wanted.diffuse);
  measured.fitAsked = wanted;
}

}  // namespace facet::view
