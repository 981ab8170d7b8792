#include "view/measured_panel.hpp"

#include <imgui.h>
#include <imgui/imgui_internal.h>

#include <cmath>
#include <cstdio>

#include "optics/synthetic_brdf.hpp"
#include "view/lobe_panel.hpp"
#include "view/settings_panel.hpp"
#include "view/statistics_panel.hpp"
#include "view/style.hpp"
#include "view/widgets.hpp"

namespace facet::view {

namespace {

constexpr int shownRows = 7;

std::string number(const char* format, double value) {
  char text[48];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

// Its name, and at the right where it is.
void databaseRow(ViewerState& state, const Entry& entry) {
  const bool chosen = state.settings.sources.brdf == entry.source ||
                      (state.shown.measured && state.shown.measured->path == entry.source);
  ImGui::PushID(entry.source.c_str());
  if (ImGui::Selectable("##row", chosen)) chooseBrdf(state, entry.source);
  hint(entry.source.starts_with("builtin:") ? entry.source + "\n" + entry.place : entry.source);
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  const std::string place = entry.place.substr(0, entry.place.find(','));
  const float width = std::min(ImGui::CalcTextSize(place.c_str()).x, 0.45f * (max.x - min.x));
  const float gap = 0.5f * ImGui::GetFontSize(), middle = max.x - width - gap;
  const auto text = [&](float left, float right, const std::string& words, ImGuiCol color) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(color));
    ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), {left, min.y}, {right, max.y}, right, right, words.c_str(),
                              words.c_str() + words.size(), nullptr);
    ImGui::PopStyleColor();
  };
  text(min.x, middle - gap, entry.name, ImGuiCol_Text);
  text(middle, max.x, place, ImGuiCol_TextDisabled);
  ImGui::PopID();
}

void databaseList(ViewerState& state) {
  ImGui::SetNextItemWidth(-1);
  searchField("##databases", "search the databases", state.brdfFilter);
  hint(
      "MERL and UTIA files in the folder that was named at the start, resources/brdf, $XDG_DATA_HOME/facet/brdf and "
      "folders that are browsed, "
      "and built-in ones; drop a file to add it");
  const std::vector<int> found = filtered(state.databases, FileKind::brdf, state.brdfFilter);
  const float height = ImGui::GetTextLineHeightWithSpacing() * static_cast<float>(shownRows);
  if (ImGui::BeginChild("databases", {0, height}, true)) {
    if (found.empty()) ImGui::TextDisabled("none matches");
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(found.size()), ImGui::GetTextLineHeightWithSpacing());
    while (clipper.Step())
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
        databaseRow(state, state.databases[static_cast<size_t>(found[static_cast<size_t>(i)])]);
  }
  ImGui::EndChild();
}

}  // namespace

std::vector<Detail> measuredDetails(const frame::MeasuredFacts& facts, optics::LookUp lookUp) {
  std::vector<Detail> details;
  const bool merl = facts.kind == optics::MeasuredKind::merl, builtin = facts.path.starts_with("builtin:");
  details.push_back({"measured", facts.name});
  details.push_back({"kind", std::string(kindName(facts.kind)) + (merl ? ", isotropic" : ", anisotropic")});
  if (builtin)
    details.push_back({"made from", std::string(optics::findSynthetic(facts.name)->summary)});
  else
    details.push_back({"file", facts.path});
  std::string cells = grouped(facts.cells);
  if (facts.missing > 0) cells += ", " + grouped(facts.missing) + " of them missing";
  details.push_back({"cells", cells});
  if (facts.holes > 0)
    details.push_back({"filled", grouped(facts.holes) + " above the horizon: " +
                                     number("%.2g %% of the light is guessed", 100 * facts.guessed)});
  details.push_back({"look-up", std::string(rowOf(optics::lookUps, lookUp).label)});
  constexpr const char* decodings[] = {"linear, as stored", "through an sRGB curve", "v / 140 through an sRGB curve"};
  if (!merl && !builtin) details.push_back({"numbers", decodings[static_cast<size_t>(facts.source.decode)]});
  const optics::MeasuredProxy& lobe = facts.proxy;
  details.push_back({"lobe", number("alpha %.3g", lobe.alpha.t) + (merl ? "" : number(" and %.3g", lobe.alpha.b)) +
                                 number(", %.0f %% of the light even", 100 * lobe.diffuseShare)});
  return details;
}

std::vector<Detail> fitDetails(const frame::FittedBrdf& fitted) {
  const optics::AnalyticBrdf& model = fitted.fit.model;
  const auto rgb = [](const glm::dvec3& c) {
    return number("%.3f  ", c.r) + number("%.3f  ", c.g) + number("%.3f", c.b);
  };
  std::vector<Detail> details;
  details.push_back({"fitted", modelName(model.diffuse)});
  details.push_back({"roughness", number("%.3f", optics::roughnessOf(model))});
  if (fitted.kind == optics::MeasuredKind::merl) {
    details.push_back({"alpha", number("%.4f", model.alpha.t)});
  } else {
    const double degrees = std::fmod(std::round(model.phi * 180 / 3.14159265358979), 180);
    details.push_back({"alpha", number("%.4f", model.alpha.t) + number(" at %.0f\xc2\xb0", degrees) +
                                    number(", %.4f across", model.alpha.b)});
    details.push_back({"anisotropy", number("%.3f", optics::anisotropyStrength(model.alpha))});
  }
  details.push_back({"f0", rgb(model.f0)});
  details.push_back({"f90", rgb(model.f90)});
  details.push_back({"albedo", rgb(model.albedo)});
  details.push_back({"fit error", number("%.4f, RMS of ln(1 + f cos)", fitted.fit.error)});
  details.push_back({"albedo error", number("%.1f %%", 100 * fitted.fit.albedoError) +
                                         number(" at %.0f\xc2\xb0", fitted.fit.albedoErrorAngle)});
  details.push_back({"took", milliseconds(fitted.fitMs) + ", beside the window"});
  return details;
}

namespace {

void comparisonChoice(ViewerState& state) {
  frame::PictureSettings& settings = state.settings;
  using frame::BrdfCompare;
  chooseEnum("picture of", settings.comparison.brdfCompare, frame::brdfComparisons, BrdfCompare::none,
             "the table, the analytic model that comes closest to it, or both");
  if (settings.comparison.brdfCompare == BrdfCompare::none) return;
  diffuseChoice(settings);
  if (settings.comparison.brdfCompare == BrdfCompare::split)
    slider("divider", settings.comparison.brdfSplit, 0, 1, "%.3f", 0.5f,
           "in widths of the picture; can be dragged there, too");
  if (settings.comparison.brdfCompare == BrdfCompare::difference)
    slider("factor", settings.comparison.brdfDifferenceScale, 0, 100, "%.1f", 4, "on the difference of display values",
           ImGuiSliderFlags_Logarithmic);
  if (state.fitting) ImGui::TextDisabled("fitting ...");
}

void fitTable(const ShownScene& shown) {
  if (!shown.fit || !beginDetails("fit")) return;
  for (const Detail& row : fitDetails(*shown.fit)) detail(row.name, row.value);
  if (shown.comparison) {
    detail("pictures", comparisonText(*shown.comparison));
    hint(
        "root mean square of the colours on the screen, measured against fitted, over the pixels that differ at all; "
        "what both pictures are still off by for want of samples is in it");
  }
  ImGui::EndTable();
}

}  // namespace

void measuredChoice(ViewerState& state) {
  databaseList(state);
  frame::PictureSettings& settings = state.settings;
  chooseEnum("look-up", settings.look.brdfLookUp, optics::lookUps, optics::LookUp::interpolated, "in the table");
  const std::optional<frame::MeasuredFacts>& shown = state.shown.measured;
  if (shown && shown->kind == optics::MeasuredKind::utia && !shown->path.starts_with("builtin:")) {
    chooseEnum("UTIA's numbers", settings.sources.utiaDecode, io::utiaDecodes, io::UtiaDecode::raw,
               "what they are is disputed: an albedo above 1 (facet brdf) is wrong");
  }
  comparisonChoice(state);
  if (!shown || !beginDetails("measured")) return;
  for (const Detail& row : measuredDetails(*shown, settings.look.brdfLookUp)) {
    detail(row.name, row.value);
    if (row.name == "lobe") hint("that samples of the environment are drawn from; fitted to the table");
  }
  const frame::MeasuredTimes& t = shown->times;
  detail("took", milliseconds(t.readMs + t.fitMs + t.packMs + t.uploadMs));
  hint("read and checked " + milliseconds(t.readMs) + ", lobe " + milliseconds(t.fitMs) + ", packed " +
       milliseconds(t.packMs) + ", all beside the window; uploaded " + milliseconds(t.uploadMs));
  ImGui::EndTable();
  fitTable(state.shown);
  lobeSection(state);
}

}  // namespace facet::view
