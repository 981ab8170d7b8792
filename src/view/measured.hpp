#pragma once

// Measured BRDFs of the window: which are there, which are being read or fitted.

#include <chrono>
#include <map>
#include <optional>
#include <string>

#include "frame/plan.hpp"
#include "view/file_watch.hpp"
#include "view/loader.hpp"
#include "view/viewer_state.hpp"

namespace facet::view {

// A measured BRDF that waits for its first frame.
struct MeasuredAsked {
  frame::MeasuredSource source;
  std::chrono::steady_clock::time_point since;
};

struct FitAsked {
  frame::MeasuredSource source;
  optics::DiffuseModel diffuse = optics::DiffuseModel::lambert;

  bool operator==(const FitAsked&) const = default;
};

struct MeasuredView {
  frame::MeasuredStore store;
  std::map<std::string, FileWatch> files;  // of those that were read, by path
  frame::MeasuredSource loading;
  std::optional<MeasuredAsked> asked;
  std::optional<FitAsked> fitAsked;  // what is being fitted, or could not be
};

// What is shown; without a name where no measured BRDF is.
frame::MeasuredSource shownMeasured(const frame::Drawable& shown);

// Null where it is not there: it is read then. shown: shownMeasured.
std::shared_ptr<const frame::MeasuredOnGpu> findOrRead(MeasuredView& measured, const frame::MeasuredSource& shown,
                                                       const frame::MeasuredSource& source, Loader& loader);

// The same for the model that is fitted to it; until then the measured BRDF is shown.
std::shared_ptr<const frame::FittedOnGpu> findOrFit(MeasuredView& measured, const frame::MeasuredSource& source,
                                                    optics::DiffuseModel diffuse, Loader& loader);

// The table behind the lobe is read beside the window where the lobe is looked at, and let go where it is not.
void followLobe(ViewerState& state, Loader& loader);
void takeTable(ViewerState& state, TableRead read);

}  // namespace facet::view
