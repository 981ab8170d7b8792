#pragma once

// Measured BRDFs of the window: which are there, which are being read or fitted.

#include <chrono>
#include <map>
#include <optional>
#include <string>

#include "frame/fitted_gpu.hpp"
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

// Asks the loader for the measured BRDF of the request where it is not there. True where it is. built: what is shown.
bool provideMeasured(MeasuredView& measured, const ListRequest& built, Loader& loader, ListRequest& request);

// The same for the model that is fitted to it, where the settings want one; until then the measured BRDF is shown.
void provideFit(MeasuredView& measured, const frame::PictureSettings& settings, Loader& loader, ListRequest& request);

}  // namespace facet::view
