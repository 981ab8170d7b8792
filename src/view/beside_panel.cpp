#include "view/beside_panel.hpp"

#include "view/second_model.hpp"
#include "view/widgets.hpp"

namespace facet::view {

namespace {

// What the way of showing both has to be set, and the figures. id: of the controls; first: of the two.
void besideControls(BesideWish& wish, const char* id, const std::string& first, const ShownScene& shown,
                    const char* explanation) {
  ImGui::PushID(id);
  if (wish.how == Beside::split)
    slider("divider", wish.split, 0, 1, "%.3f", BesideWish{}.split,
           "in widths of the picture; can be dragged there, too");
  if (wish.how == Beside::difference)
    slider("factor", wish.scale, 0, 100, "%.1f", BesideWish{}.scale, "on the difference of display values",
           ImGuiSliderFlags_Logarithmic);
  if (first.empty() || !shown.comparison) {
    ImGui::TextDisabled("waits for the picture to rest");
  } else {
    ImGui::TextWrapped("%s: %s", first.c_str(), comparisonText(*shown.comparison).c_str());
    hint(explanation);
  }
  ImGui::PopID();
}

}  // namespace

void truthChoice(ViewerState& state) {
  chooseEnum("against truth", state.truth.how, besideChoices, Beside::off,
             "the picture that is drawn while something moves, beside the path-traced one: light that is blocked or "
             "comes by way of other surfaces is the difference. Never in screenshots");
  if (state.truth.how == Beside::off) return;
  if (!state.settings.look.channel.empty()) return ImGui::TextDisabled("of light, not of a channel");
  if (state.shown.compared || besideSecond(state)) return ImGui::TextDisabled("not while two pictures are compared");
  besideControls(state.truth, "truth", state.shown.fastMethod, state.shown,
                 "root mean square of the colours on the screen, fast against traced, over the pixels that differ at "
                 "all; the noise of the traced one is in it");
}

void secondModelChoice(ViewerState& state) {
  std::vector<std::string>& with = state.settings.sources.with;
  for (const std::string& other : with) ImGui::TextWrapped("with it: %s", other.c_str());
  if (!with.empty() && ImGui::Button("take out##with")) with.pop_back();
  if (!with.empty()) hint("the last one of them");
  if (state.secondModel.empty()) {
    ImGui::TextDisabled("beside it: none");
    hint(
        "Shift and a click in the browser show another model beside this one, as `facet A.glb B.glb` does; Control and "
        "a click put it into the same scene, as `--with B.glb` does");
    return;
  }
  ImGui::TextWrapped("beside it: %s", state.secondModel.c_str());
  if (ImGui::Button("close it")) return state.secondModel.clear();
  chooseEnum("both##second", state.second.how, besideChoices, Beside::split,
             "under the same light, through the same camera, of 4 samples a pixel. Screenshots are of the first alone");
  if (state.second.how == Beside::off) return;
  if (state.shown.flip) {
    ImGui::Text("FLIP %.4f", *state.shown.flip);
    hint("how different both look side by side, from 0 to 1, mean over the picture (Andersson et al. 2020)");
  }
  besideControls(state.second, "second", state.shown.second.empty() ? "" : "apart", state.shown,
                 "root mean square of the colours on the screen over the pixels that differ at all");
}

}  // namespace facet::view
