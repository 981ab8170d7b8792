#pragma once

// What "copy command" copies, run by a shell.

#include <fstream>
#include <iterator>

#include "base/text.hpp"
#include "io/image.hpp"
#include "options/picture_options.hpp"
#include "support/command.hpp"
#include "support/temporary_folder.hpp"
#include "view/viewer.hpp"

namespace facet::test {

// Its picture has the bytes of the one on the screen.
inline void checkCopiedCommand(const Viewer& viewer, const TemporaryFolder& folder) {
  io::Pixels shown = viewer.display();
  if (viewer.viewport.overlay.shown && viewer.state.overlaysInPictures)
    frame::layOver(viewer.viewport.overlay.targets, 0, shown);
  REQUIRE(io::writePng(folder.file("window.png"), shown));
  const std::string line =
      options::commandLine(view::commandSettings(viewer.state), viewer.state.shown.model, folder.file("command.png"));
  INFO(line);
  REQUIRE(line.starts_with("facet render "));
  const Outcome outcome = runShell(shellWord(facetPath()) + line.substr(5));
  INFO(outcome.text);
  REQUIRE(outcome.status == 0);
  const auto bytes = [&](const char* name) {
    std::ifstream stream(folder.file(name), std::ios::binary);
    return std::vector<char>(std::istreambuf_iterator<char>(stream), {});
  };
  CHECK(bytes("window.png").size() > 200);
  CHECK(bytes("command.png") == bytes("window.png"));
}

}  // namespace facet::test
