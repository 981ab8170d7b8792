#pragma once

// What is wrong with the file that is shown, by the letter (io/validate): looked for beside the window, and only once
// the list of it is open.

#include <memory>
#include <optional>
#include <string>

#include "base/error.hpp"
#include "io/validate/findings.hpp"
#include "scene/model.hpp"

namespace facet::view {

struct Loader;
struct PanelResult;
struct ViewerState;

struct FileChecked {
  std::shared_ptr<const scene::Model> of;
  Result<io::validate::Report> report;
};

struct FileCheck {
  bool wanted = false;                                      // the list is open
  std::shared_ptr<const scene::Model> of = {};              // which model is or is being checked
  std::optional<Result<io::validate::Report>> report = {};  // nothing: not yet
  int chosen = -1;                                          // finding
};

// Starts what is wanted and not there: after another model or a change of the file, too.
void followFileCheck(ViewerState& state, Loader& loader);
void takeFileCheck(ViewerState& state, FileChecked checked);

// Its node, else its material, is selected and shown in the tree.
void chooseFinding(ViewerState& state, PanelResult& result, size_t finding);

// The section of the settings.
void fileCheckSection(ViewerState& state, PanelResult& result);

}  // namespace facet::view
