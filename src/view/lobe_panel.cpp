#include "view/lobe_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "optics/plane_lobe.hpp"
#include "view/widgets.hpp"

namespace facet::view {

namespace {

constexpr double radian = optics::pi / 180;
constexpr float steepest = 89;  // of the light [degrees]
constexpr ImU32 channelColors[] = {IM_COL32(224, 84, 72, 255), IM_COL32(88, 168, 84, 255), IM_COL32(84, 136, 228, 255)};

// A half disc: where its centre lies, and how long the largest value is.
struct Drawing {
  ImVec2 centre;
  float radius;
  ImVec2 at(double angle, double length) const {
    return {centre.x + radius * static_cast<float>(length * std::sin(angle)),
            centre.y - radius * static_cast<float>(length * std::cos(angle))};
  }
};

double largest(const optics::PlaneLobe& lobe) {
  double most = 1e-300;
  for (const glm::dvec3& value : lobe.values) most = std::max({most, value.x, value.y, value.z});
  return most;
}

void drawScale(const Drawing& d, double light) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImU32 faint = ImGui::GetColorU32(ImGuiCol_TextDisabled, 0.5f), strong = ImGui::GetColorU32(ImGuiCol_Text);
  list->AddLine(d.at(-optics::pi / 2, 1), d.at(optics::pi / 2, 1), faint);
  for (int degrees = -90; degrees <= 90; degrees += 30) list->AddLine(d.at(0, 0), d.at(degrees * radian, 1), faint);
  list->PathArcTo(d.centre, d.radius, static_cast<float>(-optics::pi), 0, 48);
  list->PathStroke(faint, 0, 1);
  list->AddLine(d.at(-light, 1), d.at(0, 0), strong, 2);
  list->AddCircleFilled(d.at(-light, 1), 0.3f * ImGui::GetFontSize(), strong);
  list->AddLine(d.at(0, 0), d.at(light, 1), strong);
}

void drawLobe(const Drawing& d, const optics::PlaneLobe& lobe, double most, bool fitted) {
  for (int c = 0; c < 3; ++c) {
    std::vector<ImVec2> points;
    for (size_t i = 0; i < lobe.angles.size(); ++i) points.push_back(d.at(lobe.angles[i], lobe.values[i][c] / most));
    const ImU32 color = fitted ? (channelColors[c] & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 120) : channelColors[c];
    ImGui::GetWindowDrawList()->AddPolyline(points.data(), static_cast<int>(points.size()), color, 0,
                                            fitted ? 3.0f : 1.5f);
  }
}

// Of the curve's point that is nearest to the pointer's direction.
std::string valueThere(const optics::PlaneLobe& lobe, double angle) {
  const auto nearest = std::ranges::min_element(lobe.angles, {}, [angle](double a) { return std::abs(a - angle); });
  const auto i = static_cast<size_t>(nearest - lobe.angles.begin());
  const glm::dvec3 f = lobe.values[i] / std::cos(lobe.angles[i]);
  char text[120];
  std::snprintf(text, sizeof text, "at %.1f degrees: f_r %.4g  %.4g  %.4g per steradian", lobe.angles[i] / radian, f.x,
                f.y, f.z);
  return text;
}

// Drags the light; tells the value below the pointer.
void followPointer(LobeView& view, const Drawing& d, const optics::PlaneLobe& lobe) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const double x = mouse.x - d.centre.x, y = d.centre.y - mouse.y;
  if (ImGui::IsItemActive())
    view.theta = std::clamp(static_cast<float>(std::atan2(std::abs(x), std::max(y, 0.0)) / radian), 0.0f, steepest);
  else
    hint(valueThere(lobe, std::atan2(x, std::max(y, 0.0))));
}

void drawing(LobeView& view, const optics::AnalyticBrdf* fitted) {
  using optics::LookUp;
  const double light = view.theta * radian, azimuth = view.phi * radian;
  const optics::PlaneLobe lobe = optics::planeLobe(
      [&](const glm::dvec3& L, const glm::dvec3& V) { return measuredBrdf(*view.table, V, L, LookUp::interpolated); },
      light, azimuth);
  const float width = std::max(ImGui::GetContentRegionAvail().x, 4 * ImGui::GetFontSize());
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const Drawing d{{corner.x + width / 2, corner.y + 0.48f * width}, 0.46f * width};
  ImGui::InvisibleButton("##lobe", {width, 0.5f * width});
  followPointer(view, d, lobe);
  drawScale(d, light);
  optics::PlaneLobe model;
  if (fitted)
    model = optics::planeLobe(
        [&](const glm::dvec3& L, const glm::dvec3& V) { return optics::analyticBrdf(*fitted, V, L); }, light, azimuth);
  const double most = std::max(largest(lobe), fitted ? largest(model) : 0);
  if (fitted) drawLobe(d, model, most, true);
  drawLobe(d, lobe, most, false);
  char scale[64];
  std::snprintf(scale, sizeof scale, "radius: f_r cos %.4g per steradian", most);
  wrappedText(scale + std::string(fitted ? "; wide: the fitted model" : ""));
}

}  // namespace

void lobeSection(ViewerState& state) {
  LobeView& view = state.lobe;
  view.open = section(state.layout, "Lobe", false);
  if (!view.open) return;
  slider(
      "light", view.theta, 0, steepest, "%.1f\xc2\xb0", 45,
      "its angle from the normal; dragged in the drawing, too. What is drawn is f_r cos of directions in the plane of "
      "the light and the normal: the light from the left, its mirror direction on the right");
  if (state.shown.measured->kind == optics::MeasuredKind::utia)
    slider("azimuth", view.phi, 0, 360, "%.0f\xc2\xb0", 0, "of the light, from the tangent");
  if (!view.table)
    ImGui::TextDisabled("%s", view.failed ? "its table could not be read again" : "reading ...");
  else
    drawing(view, state.shown.fit ? &state.shown.fit->fit.model : nullptr);
}

}  // namespace facet::view
