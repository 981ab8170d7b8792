#include "view/measured.hpp"

namespace facet::view {

frame::MeasuredSource shownMeasured(const frame::Drawable& shown) {
  const auto& measured = shown.inputs.list.measured;
  return measured ? measured->facts.source : frame::MeasuredSource{};
}

std::shared_ptr<const frame::MeasuredOnGpu> findOrRead(MeasuredView& measured, const frame::MeasuredSource& shown,
                                                       const frame::MeasuredSource& source, Loader& loader) {
  const bool asked = measured.asked && measured.asked->source == source;
  if (shown != source && !asked) measured.asked = MeasuredAsked{source, std::chrono::steady_clock::now()};
  auto found = frame::keptMeasured(measured.store, source);
  if (found) return found;
  if (!loader.measured.running() || measured.loading != source) startMeasured(loader, source);
  measured.loading = source;
  return nullptr;
}

std::shared_ptr<const frame::FittedOnGpu> findOrFit(MeasuredView& measured, const frame::MeasuredSource& source,
                                                    optics::DiffuseModel diffuse, Loader& loader) {
  auto found = frame::keptFit(measured.store, source, diffuse);
  const FitAsked wanted{source, diffuse};
  if (found || measured.fitAsked == wanted) return found;
  startFit(loader, wanted.source, wanted.diffuse);
  measured.fitAsked = wanted;
  return nullptr;
}

void followLobe(ViewerState& state, Loader& loader) {
  LobeView& lobe = state.lobe;
  if (!lobe.open || !state.shown.measured) {
    lobe.table.reset(), lobe.source = {};
    lobe.failed = false;
    loader.table.forget();
    return;
  }
  if (lobe.source == state.shown.measured->source) return;
  lobe.source = state.shown.measured->source;
  lobe.table.reset();
  lobe.failed = false;
  startTable(loader, lobe.source);
}

void takeTable(ViewerState& state, TableRead read) {
  if (!(read.source == state.lobe.source)) return;
  state.lobe.failed = !read.table;
  if (!read.table) return complain(state, read.table.error());
  state.lobe.table = *read.table;
}

}  // namespace facet::view
