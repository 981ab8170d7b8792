#include "view/lobe_panel.hpp"

#include <imgui.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "optics/plane_lobe.hpp"
#include "optics/synthetic_brdf.hpp"

using namespace facet;

namespace {

// A panel of that width with the section alone, drawn once.
void drawPanel(view::ViewerState& state, ImVec2 mouse, bool down) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {300, 400};
  io.DeltaTime = 0.02f;
  io.MousePos = mouse;
  io.MouseDown[0] = down;
  ImGui::NewFrame();
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({300, 400});
  ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoDecoration);
  view::lobeSection(state);
  ImGui::End();
  ImGui::Render();
}

}  // namespace

TEST_CASE("lobe panel: the light is where the pointer drags it, on either side, and never below the horizon") {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  unsigned char* pixels;
  int width, height;
  ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);

  const optics::SyntheticBrdf* brdf = optics::findSynthetic("plastic-0.5");
  view::ViewerState state;
  state.layout.sections["Lobe"] = true;
  state.shown.measured = frame::MeasuredFacts{};
  drawPanel(state, {-1, -1}, false);  // without a table there is nothing to drag
  CHECK(state.lobe.open);
  CHECK(state.lobe.theta == 45);
  state.lobe.table =
      std::make_shared<const optics::MeasuredBrdf>(optics::makeMeasured(brdf->formula, brdf->kind, brdf->name));
  drawPanel(state, {-1, -1}, false);

  // Of the half disc the lines alone say where it is: its middle is the panel's, some way down.
  const float middle = 150;
  const auto dragTo = [&](ImVec2 from, ImVec2 to) {
    drawPanel(state, from, false);
    drawPanel(state, from, true);
    drawPanel(state, to, true);
    drawPanel(state, to, false);
  };
  dragTo({100, 120}, {middle, 60});
  CHECK(state.lobe.theta == Approx(0).margin(1));
  dragTo({100, 120}, {20, 390});
  CHECK(state.lobe.theta == Approx(89));
  dragTo({100, 120}, {60, 100});
  const float left = state.lobe.theta;
  CHECK(left > 20);
  CHECK(left < 85);
  dragTo({100, 120}, {2 * middle - 60, 100});
  CHECK(state.lobe.theta == Approx(left).margin(0.5));
  ImGui::DestroyContext();
}

TEST_CASE("plane lobe: of a formula its values, the mirror direction among its angles") {
  const optics::AnalyticBrdf& formula = optics::findSynthetic("utia-brushed")->formula;
  const auto f = [&](const glm::dvec3& V, const glm::dvec3& L) { return optics::analyticBrdf(formula, V, L); };
  const double theta = 0.5, phi = 1.1;
  const optics::PlaneLobe lobe = optics::planeLobe(f, theta, phi);
  REQUIRE(lobe.angles.size() == lobe.values.size());
  const glm::dvec3 V(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
  double nearest = 1;
  for (size_t i = 0; i < lobe.angles.size(); ++i) {
    if (i > 0) CHECK(lobe.angles[i] > lobe.angles[i - 1]);
    CHECK(std::abs(lobe.angles[i]) < optics::pi / 2);
    nearest = std::min(nearest, std::abs(lobe.angles[i] - theta));
    if (i % 20 != 0) continue;
    const double a = -lobe.angles[i];  // V's own side is negative
    const glm::dvec3 L(std::sin(a) * std::cos(phi), std::sin(a) * std::sin(phi), std::cos(a));
    CHECK(lobe.values[i].x == Approx(f(V, L).x * L.z).epsilon(1e-9));
  }
  CHECK(nearest == 0);
}
