#include "view/browser.hpp"

#include <catch2/catch.hpp>
#include <cstring>
#include <thread>

#include "support/temporary_folder.hpp"

using namespace facet;
using view::FileKind;

namespace {

// Until what it looks for is listed; what is to be opened then.
std::string listed(view::Browser& browser, view::ViewerState& state) {
  for (int i = 0; i < 1000 && !view::collect(browser); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  return view::takeDropped(browser, state);
}

}  // namespace

TEST_CASE("browser: a dropped folder says what it holds, whatever was searched, and its only model is opened") {
  const test::TemporaryFolder folder;
  view::Browser browser;
  browser.maker = std::make_unique<view::ThumbnailMaker>(folder.file("missing"), DiskCache{}, [] {});
  view::ViewerState state;
  std::filesystem::create_directory(folder.path() / "chairs");
  const std::string chair = folder.write("chairs/chair.glb", std::string("x"));
  folder.write("chairs/dawn.hdr", std::string("x"));
  std::strcpy(browser.query, "lamp");
  view::dropFolder(browser, folder.file("chairs/"));
  CHECK(std::string(browser.query).empty());
  CHECK(listed(browser, state) == chair);
  CHECK(state.status.text == folder.file("chairs") + ": 1 model, 1 environment, 0 measured BRDFs");
  CHECK(browser.cursor == chair);
  CHECK(browser.showCursor);
  CHECK(view::takeDropped(browser, state).empty());  // once

  folder.write("chairs/stool.glb", std::string("x"));
  view::dropFolder(browser, folder.file("chairs"));
  CHECK(listed(browser, state).empty());
  CHECK(state.status.text == folder.file("chairs") + ": 2 models, 1 environment, 0 measured BRDFs");
  CHECK_FALSE(state.status.isError);

  std::filesystem::create_directory(folder.path() / "empty");
  view::dropFolder(browser, folder.file("empty"));
  CHECK(listed(browser, state).empty());
  CHECK(state.status.isError);
  CHECK(state.status.text.starts_with(folder.file("empty") + ": holds nothing that can be shown; "));

  // One that is merely browsed opens nothing.
  view::browseFolder(browser, folder.file("chairs"));
  CHECK(listed(browser, state).empty());
}

TEST_CASE("browser: the model that has been opened is scrolled into sight") {
  view::Browser browser;
  view::noteOpened(browser, FileKind::model, "builtin:poster");
  CHECK(browser.cursor == "builtin:poster");
  CHECK(browser.showCursor);
  browser.showCursor = false;
  view::noteOpened(browser, FileKind::environment, "builtin:sky");
  CHECK(browser.cursor == "builtin:poster");
  CHECK_FALSE(browser.showCursor);
}
