#include "view/comparison.hpp"

#include "frame/gather.hpp"
#include "view/viewport.hpp"

namespace facet::view {

std::optional<frame::ShownPair> pairShown(const Viewport& viewport) {
  const frame::Targets& targets = viewport.targets;
  if (viewport.second.pair.shown) return frame::ShownPair{targets.display, viewport.second.targets.display};
  if (viewport.truthView.pair.shown) return frame::ShownPair{viewport.truthView.fast, targets.display};
  return std::nullopt;
}

Result<void> compare(Viewport& viewport, const frame::FrameInput& in, const frame::Targets& targets, float scale,
                     bool last) {
  Comparison& comparison = viewport.comparison;
  const auto now = std::chrono::steady_clock::now();
  const std::optional<frame::ShownPair> pair = pairShown(viewport);
  if ((!frame::comparing(in) && !pair) || (!last && now - comparison.since < std::chrono::milliseconds(500))) return {};
  comparison.since = now;
  comparison.sums.clear();
  Result<frame::ComparisonSums> sums =
      pair ? frame::sumPair(*pair, viewport.programs) : frame::sumComparison(in, targets, scale, viewport.programs);
  if (!sums) return tl::unexpected(sums.error());
  comparison.sums.push_back(std::move(*sums));
  return {};
}

Result<void> showPicture(Viewport& viewport, const frame::FrameInput& in, const frame::Targets& targets, float scale,
                         bool last) {
  viewport.comparison.shown = in.settings.comparison;
  if (Result<void> shown = frame::showPicture(in, targets, scale, viewport.targets, viewport.programs); !shown)
    return shown;
  if (Result<void> shown = showAgainstTruth(viewport); !shown) return shown;
  return compare(viewport, in, targets, scale, last);
}

Result<bool> showAnew(Viewport& viewport, const frame::PictureSettings& settings, const scene::View& view) {
  const Refinement& r = viewport.refinement;
  const bool gathered = r.shown && r.gathering;
  if (gathered && r.gathering->rows != 0) return false;
  const frame::FrameInput in = frame::frameInput(viewport.shown, view, settings);
  viewport.comparison.shown = settings.comparison;
  return frame::showPicture(in, gathered ? r.targets : viewport.targets, gathered ? frame::meanScale(*r.gathering) : 1,
                            viewport.targets, viewport.programs)
      .map([] { return true; });
}

}  // namespace facet::view
