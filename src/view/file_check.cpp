#include "view/file_check.hpp"

#include <algorithm>

#include "base/log.hpp"
#include "io/validate/validate.hpp"
#include "view/inspector.hpp"
#include "view/loader.hpp"
#include "view/panel.hpp"
#include "view/style.hpp"
#include "view/text_fit.hpp"
#include "view/viewer_state.hpp"
#include "view/widgets.hpp"

namespace facet::view {

namespace {

using io::validate::Finding;
using io::validate::Severity;

ImU32 colorOf(Severity severity) {
  return severity == Severity::error ? errorColor : severity == Severity::warning ? warningColor : quietColor;
}

std::string countText(const io::validate::Report& report) {
  const size_t errors = report.count(Severity::error), warnings = report.count(Severity::warning);
  const size_t others = report.findings.size() - errors - warnings;
  if (report.findings.empty()) return "nothing";
  return std::to_string(errors) + (errors == 1 ? " error, " : " errors, ") + std::to_string(warnings) +
         (warnings == 1 ? " warning, " : " warnings, ") + std::to_string(others) + " more";
}

void findingRow(ViewerState& state, PanelResult& result, const Finding& finding, size_t index) {
  const std::string text = (finding.place.empty() ? std::string() : finding.place + ": ") + finding.text;
  ImGui::PushID(static_cast<int>(index));
  ImGui::PushStyleColor(ImGuiCol_Text, colorOf(severity(finding.code)));
  const std::string shown = middleCut(text, ImGui::GetContentRegionAvail().x, textWidth);
  const bool chosen = state.fileCheck.chosen == static_cast<int>(index);
  if (ImGui::Selectable((shown + "###finding").c_str(), chosen)) chooseFinding(state, result, index);
  ImGui::PopStyleColor();
  hint(text + "; " + remedy(finding.code) + "\n" + io::validate::severityNames[size_t(severity(finding.code))] + " " +
       name(finding.code));
  ImGui::PopID();
}

void findingList(ViewerState& state, PanelResult& result, const io::validate::Report& report) {
  constexpr size_t mostRows = 12;
  const float row = ImGui::GetTextLineHeightWithSpacing();
  const auto rows = static_cast<float>(std::min(report.findings.size(), mostRows));
  if (ImGui::BeginChild("findings", {0, rows * row + ImGui::GetStyle().ItemSpacing.y})) {
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(report.findings.size()), row);
    while (clipper.Step())
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
        findingRow(state, result, report.findings[static_cast<size_t>(i)], static_cast<size_t>(i));
  }
  ImGui::EndChild();
}

}  // namespace

void followFileCheck(ViewerState& state, Loader& loader) {
  FileCheck& check = state.fileCheck;
  if (check.of != state.shown.content) check = {.wanted = check.wanted};
  if (!check.wanted || check.of || !state.shown.content) return;
  check.of = state.shown.content;
  loader.fileCheck.start([of = check.of, source = state.shown.model, outside = loader.allowOutside]() -> FileChecked {
    try {
      return {of, io::validateModel(source, {.allowOutside = outside})};
    } catch (const std::bad_alloc&) {
      return {of, fail(source, "", "there is not enough memory to check it", "use a smaller model")};
    }
  });
}

void takeFileCheck(ViewerState& state, FileChecked checked) {
  if (checked.of != state.fileCheck.of) return;
  if (checked.report) log::debug("checked: " + state.shown.model + ": " + countText(*checked.report));
  state.fileCheck.report = std::move(checked.report);
}

void chooseFinding(ViewerState& state, PanelResult& result, size_t finding) {
  const Finding& chosen = (*state.fileCheck.report)->findings[finding];
  state.fileCheck.chosen = static_cast<int>(finding);
  const scene::Model& model = *state.shown.content;
  const bool isNode = chosen.node >= 0 && static_cast<size_t>(chosen.node) < model.nodes.size();
  const bool isMaterial = chosen.material >= 0 && static_cast<size_t>(chosen.material) < model.materials.size();
  selectNode(state, isNode ? chosen.node : -1);
  state.selection.reveal = isNode;
  if (isNode) state.tree.kind = TreeKind::nodes;
  if (!isNode && isMaterial) {
    state.tree.kind = TreeKind::materials;
    state.selection.material = chosen.material;
    result.describeMaterial = true;
  }
  log::debug(std::string("finding chosen: ") + name(chosen.code) + ", node " + std::to_string(state.selection.node));
}

void fileCheckSection(ViewerState& state, PanelResult& result) {
  FileCheck& check = state.fileCheck;
  std::string title = "What is wrong here";
  if (check.report && *check.report) title += " (" + std::to_string((*check.report)->findings.size()) + ")";
  check.wanted = section(state.layout, (title + "###validation").c_str(), false);
  if (!check.wanted) return;
  if (!check.report)
    ImGui::TextDisabled(state.shown.content ? "the file is being looked through" : "nothing is shown");
  else if (!*check.report)
    wrappedText(describe(check.report->error()));
  else {
    ImGui::TextDisabled("%s", countText(**check.report).c_str());
    if (!(*check.report)->findings.empty()) findingList(state, result, **check.report);
  }
}

}  // namespace facet::view
