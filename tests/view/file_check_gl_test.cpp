#include <algorithm>

#include "support/broken_gltf.hpp"
#include "support/temporary_folder.hpp"
#include "view/panel.hpp"
#include "view/viewer.hpp"

using namespace facet;

namespace {

std::string brokenModel(const nlohmann::json& edits) {
  nlohmann::json json = nlohmann::json::parse(test::everything().text());
  for (const auto& [pointer, value] : edits.items()) json[nlohmann::json::json_pointer(pointer)] = value;
  return json.dump();
}

size_t indexOf(const io::validate::Report& report, const std::string& place) {
  const auto found = std::ranges::find(report.findings, place, &io::validate::Finding::place);
  REQUIRE(found != report.findings.end());
  return static_cast<size_t>(found - report.findings.begin());
}

}  // namespace

TEST_CASE("what is wrong with a file: looked for once it is asked, and a finding leads to its node", "[gl]") {
  const test::TemporaryFolder folder;
  test::Viewer viewer;
  view::FileCheck& check = viewer.state.fileCheck;
  const std::string text = brokenModel({{"/accessors/16/max/0", 3}, {"/materials/1/alphaCutoff", -1}});
  viewer.load(folder.write("m.gltf", text).string());
  CHECK_FALSE(check.report);  // nobody has asked
  check.wanted = true;
  viewer.settle();
  REQUIRE(check.report);
  REQUIRE(*check.report);
  CHECK((*check.report)->count(io::validate::Severity::error) == 2);

  view::PanelResult result;
  view::chooseFinding(viewer.state, result, indexOf(**check.report, "/accessors/16/max/0"));
  CHECK(viewer.state.selection.node == 5);
  CHECK(viewer.state.selection.reveal);
  view::chooseFinding(viewer.state, result, indexOf(**check.report, "/materials/1/alphaCutoff"));
  CHECK(viewer.state.selection.node == 5);

  // Another model: looked through as well, as long as the list is open.
  viewer.load(folder.write("n.gltf", brokenModel({{"/nodes/3/colour", 1}})).string());
  REQUIRE(check.report);
  CHECK((*check.report)->findings.size() == 1);
  check.wanted = false;
  viewer.load(folder.write("o.gltf", brokenModel({})).string());
  CHECK_FALSE(check.report);
}
