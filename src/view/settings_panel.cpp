#include "view/settings_panel.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <span>

#include "frame/choose.hpp"
#include "ibl/choice.hpp"
#include "io/sources.hpp"
#include "optics/presets.hpp"
#include "scene/usage.hpp"
#include "shading/features.hpp"
#include "view/beside_panel.hpp"
#include "view/camera_panel.hpp"
#include "view/edit_panel.hpp"
#include "view/error_view.hpp"
#include "view/measured_panel.hpp"
#include "view/playback.hpp"
#include "view/statistics_panel.hpp"
#include "view/style.hpp"
#include "view/widgets.hpp"

namespace facet::view {

namespace {

const frame::PictureSettings usual;

// ---- Environment and lights -----------------------------------------------------------------------------------------

// Of an OpenEXR file; what it holds besides is told by its notes.
void layerField(ViewerState& state) {
  frame::Sources& sources = state.settings.sources;
  io::LayeredSource shown = io::splitLayer(sources.environment.empty() ? state.shown.environment : sources.environment);
  if (!shown.file.ends_with(".exr") && !shown.file.ends_with(".EXR")) return;
  const bool entered = enteredField("layer", "the picture's own", shown.layer);
  hint("of a file with several; Enter takes it");
  if (!entered) return;
  sources.environment = io::withLayer(shown.file, shown.layer);
  offerEnvironment(state, sources.environment);
}

void environmentSection(ViewerState& state) {
  if (!section(state.layout, "Environment and lights")) return;
  frame::PictureSettings& settings = state.settings;
  const std::string& wanted =
      settings.sources.environment.empty() ? state.shown.environment : settings.sources.environment;
  if (beginList("map", shortName(wanted))) {
    for (const std::string& source : state.environments) {
      ImGui::PushID(source.c_str());
      if (ImGui::Selectable(shortName(source).c_str(), source == wanted)) settings.sources.environment = source;
      hint(source);
      ImGui::PopID();
    }
    ImGui::EndCombo();
  } else {
    hint(withKeys("what lights the scene from afar; drop a .hdr or .exr\nnext built-in one", state.keys,
                  Command::nextEnvironment));
  }
  layerField(state);
  slider("rotation", settings.frame.environmentRotationDeg, -180, 180, "%.0f\xc2\xb0",
         usual.frame.environmentRotationDeg, "of the environment, about +Y");
  slider("strength", settings.frame.environmentStrength, 0, 10, "%.2f", usual.frame.environmentStrength,
         "factor on the environment's radiance", ImGuiSliderFlags_Logarithmic);
  using frame::Background;
  static constexpr Choice<Background> backgrounds[] = {
      {Background::environment, "", "environment"},
      {Background::transparent, "", "transparent", "screenshots get an alpha channel"},
      {Background::color, "", "colour"}};
  chooseEnum("background", settings.frame.background, backgrounds, usual.frame.background, "what is behind the model");
  if (settings.frame.background == frame::Background::environment)
    slider("blur", settings.frame.backgroundBlur, 0, 1, "%.2f", usual.frame.backgroundBlur,
           "the environment behind the model, as a surface of that roughness reflects it;\nits light stays as it is");
  if (settings.frame.background == frame::Background::color)
    editColor("background colour", settings.frame.backgroundColor, usual.frame.backgroundColor, "as it is shown");
  ImGui::Checkbox("floor", &settings.frame.ground);
  hint("below the scene, seen by nothing but its shadow and what it reflects");
  chooseEnum("lights", settings.look.lights, frame::lightChoices, usual.look.lights,
             "point, spot and directional lights");
  ImGui::TextDisabled(state.shown.sceneLights == 1 ? "the file has %d light" : "the file has %d lights",
                      state.shown.sceneLights);
  slider("occlusion", settings.frame.occlusion, 0, 1, "%.2f", usual.frame.occlusion,
         "strength of the materials' occlusion textures");
}

// ---- Material -------------------------------------------------------------------------------------------------------

// A variant whose name is taken by another, or missing, is called by its index.
void variantChoice(ViewerState& state) {
  const std::vector<std::string>& variants = state.shown.variants;
  if (variants.empty()) return;
  const char* own = "the file's own";
  const auto current = static_cast<size_t>(state.shown.variant);
  if (!beginList("variant", current < variants.size() ? variants[current] : own)) {
    hint("KHR_materials_variants");
    return;
  }
  if (ImGui::Selectable(own, state.shown.variant < 0)) state.settings.look.variant.clear();
  for (size_t i = 0; i < variants.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    const bool first = std::ranges::find(variants, variants[i]) == variants.begin() + static_cast<ptrdiff_t>(i);
    if (ImGui::Selectable(variants[i].c_str(), i == current))
      state.settings.look.variant =
          first && variants[i] != "variant " + std::to_string(i) ? variants[i] : std::to_string(i);
    ImGui::PopID();
  }
  ImGui::EndCombo();
}

template <class Preset>
void presetRows(MaterialChoice& material, std::span<const Preset> presets) {
  for (const Preset& preset : presets) {
    const std::string name(preset.name);
    if (ImGui::Selectable(name.c_str(), name == material.preset)) choosePreset(material, name);
    hint(presetText(name));
  }
}

void presetChoice(MaterialChoice& material) {
  if (!beginList("substance", material.preset.empty() ? "none" : material.preset)) {
    hint(material.preset.empty() ? "metals and dielectrics with published figures" : presetText(material.preset));
    return;
  }
  if (ImGui::Selectable("none", material.preset.empty())) choosePreset(material, {});
  ImGui::TextDisabled("metals");
  presetRows(material, optics::metalPresets());
  ImGui::TextDisabled("dielectrics");
  presetRows(material, optics::dielectricPresets());
  ImGui::EndCombo();
}

// Those that the model's materials have, and what is left out anyway.
void layerChoice(ViewerState& state) {
  if (!state.shown.content) return;
  uint32_t& without = state.settings.look.without;
  for (const scene::Effect effect : scene::effects) {
    const bool there = std::ranges::any_of(state.shown.content->materials,
                                           [&](const scene::Material& m) { return scene::has(m, effect); });
    bool kept = !(without & scene::bitOf(effect));
    if (!there && kept) continue;
    if (ImGui::Checkbox((std::string(scene::name(effect)) + "##layer").c_str(), &kept)) without ^= scene::bitOf(effect);
    hint("of the file's materials; off: as if none had it");
  }
}

void materialSection(ViewerState& state) {
  MaterialChoice& material = state.settings.look.material;
  MaterialSource source = materialSource(state.settings);
  if (!section(state.layout, "Material", source != MaterialSource::file || !state.shown.variants.empty())) return;
  variantChoice(state);
  static constexpr Choice<MaterialSource> sources[] = {
      {MaterialSource::file, "", "the file's", "each surface has the material that the file gives it"},
      {MaterialSource::one, "", "one for everything", "in place of the file's"},
      {MaterialSource::measured, "", "measured", "a BRDF of MERL's or UTIA's kind in the place of all materials"}};
  if (chooseEnum("source", source, sources, MaterialSource::file, "where materials come from"))
    chooseMaterialSource(state, source);
  if (source == MaterialSource::file) layerChoice(state);
  if (source == MaterialSource::measured) measuredChoice(state);
  if (source != MaterialSource::one) return;
  const MaterialChoice plain;
  presetChoice(material);
  editColor("base colour", material.baseColor, plain.baseColor, "of a metal: what it reflects straight on");
  slider("metallic", material.metallic, 0, 1, "%.2f", plain.metallic, "0 dielectric, 1 metal");
  slider("roughness", material.perceptualRoughness, 0, 1, "%.2f", plain.perceptualRoughness,
         "perceptual; its square is the width of the microfacets' distribution");
  slider("ior", material.ior, 1, 3, "%.3f", plain.ior, "index of refraction of the dielectric");
  materialLayers(state.settings);
}

// ---- Rendering ------------------------------------------------------------------------------------------------------

// Has anything in the model what the channel shows?
bool anywhere(const scene::Model* model, int channel) {
  if (!model) return false;
  for (const scene::Mesh& mesh : model->meshes)
    for (const scene::Primitive& primitive : mesh.primitives)
      if (shading::hasChannel(channel, scene::materialOf(*model, primitive), primitive)) return true;
  return false;
}

// What the model does not have is left out.
void channelChoice(frame::PictureSettings& settings, const scene::Model* model) {
  const int chosen = std::max(0, shading::channelIndex(settings.look.channel));
  if (beginList("show", std::string(shading::channels[chosen].label))) {
    for (const Choice<int>& row : shading::channels) {
      if (row.value != chosen && !anywhere(model, row.value)) continue;
      if (ImGui::Selectable(std::string(row.label).c_str(), row.value == chosen))
        settings.look.channel = shading::channelSetting(row.value);
      if (!row.note.empty()) hint(std::string(row.note));
    }
    ImGui::EndCombo();
    return;
  }
  if (resetAsked()) settings.look.channel = usual.look.channel;
  resettableHint("the picture, or what goes into it: of that what the model has");
}

// Of what is shown in false colours.
void rangeChoice(ViewerState& state) {
  const std::optional<frame::RangeShown>& shown = state.shown.range;
  if (!shown) return;
  std::optional<glm::dvec2>& range = state.settings.display.range;
  glm::vec2 ends(static_cast<float>(shown->range.from), static_cast<float>(shown->range.to));
  if (ImGui::InputFloat2(shown->unit.empty() ? "range" : ("range, " + shown->unit).c_str(), &ends.x, "%.5g",
                         ImGuiInputTextFlags_EnterReturnsTrue) &&
      ends.x < ends.y && (!shown->range.logarithmic || ends.x > 0))
    range = ends;
  if (resetAsked()) range.reset();
  resettableHint("what the darkest and the brightest colour stand for");
}

void samplesChoice(frame::PictureSettings& settings) {
  if (beginList("samples", std::to_string(settings.quality.samples))) {
    for (const int samples : {1, 2, 4, 16, 64, 256, 1024})
      if (ImGui::Selectable(std::to_string(samples).c_str(), samples == settings.quality.samples))
        settings.quality.samples = samples;
    ImGui::EndCombo();
    return;
  }
  if (resetAsked()) settings.quality.samples = 256;
  hint("a pixel; more than 4 are gathered while the picture rests, until it has converged\nright click: reset");
}

// Drawn beside the window.
void largePictureChoice(ViewerState& state, PanelResult& result) {
  constexpr int most = 16384;
  int size[2] = {state.largeWidth, state.largeHeight};
  if (ImGui::InputInt2("size##large", size))
    state.largeWidth = std::clamp(size[0], 1, most), state.largeHeight = std::clamp(size[1], 1, most);
  hint("of a picture as a file, in pixels");
  ImGui::BeginDisabled(state.shown.model.empty());
  if (ImGui::Button(state.largePictureRuns ? "not at all##large" : "picture of this size##large"))
    result.largePicture = true;
  ImGui::EndDisabled();
  hint("drawn by a process of its own, as the copied command draws it, into the folder in which facet was started");
}

void pictureSection(ViewerState& state, PanelResult& result) {
  if (!section(state.layout, "Picture")) return;
  frame::PictureSettings& settings = state.settings;
  slider("exposure", settings.display.exposureStops, -8, 8, "%+.1f stops", usual.display.exposureStops,
         "each stop doubles the light, before tone mapping");
  chooseEnum("tone mapper", settings.display.toneMapper, optics::toneMappers, usual.display.toneMapper,
             "how radiance becomes what a screen can show");
  if (shading::showsLight(std::max(0, shading::channelIndex(settings.look.channel)))) {
    ImGui::Checkbox("false colours", &settings.display.falseColors);
    if (resetAsked()) settings.display.falseColors = usual.display.falseColors;
    resettableHint("luminance as a colour that stands for a number, in the tone mapper's place; magenta: no number");
  }
  channelChoice(settings, state.shown.content.get());
  rangeChoice(state);
  chooseEnum("light", settings.quality.transport, frame::transports, usual.quality.transport,
             "how it gets to a surface while the picture rests");
  if (frame::tracesPaths(settings)) {
    auto bounces = static_cast<float>(settings.quality.bounces);
    slider("bounces", bounces, 0, 64, "%.0f", static_cast<float>(usual.quality.bounces),
           "surfaces that a path leaves at most");
    settings.quality.bounces = static_cast<int>(std::lround(bounces));
    chooseEnum("caustics", settings.quality.caustics, frame::causticsChoices, usual.quality.caustics,
               "light by way of mirrors and glass");
  }
  if (settings.quality.transport == frame::Transport::direct)
    chooseEnum("visibility", settings.quality.visibility, frame::visibilities, usual.quality.visibility,
               "while the picture rests; rays are of pictures that the command line writes");
  if (settings.quality.transport == frame::Transport::direct)
    chooseEnum("blending", settings.quality.blending, frame::blendings, usual.quality.blending,
               "in which order blended surfaces lie over one another");
  samplesChoice(settings);
  chooseEnum("texture filter", settings.quality.textureFilter, frame::textureFilters, usual.quality.textureFilter,
             "how slanted textures are read in pictures of at most 4 samples");
  largePictureChoice(state, result);
}

void overlaySection(ViewerState& state) {
  if (!section(state.layout, "Overlays", false)) return;
  for (const Choice<frame::Overlay>& choice : frame::overlayChoices) {
    bool shown = state.settings.overlays.has(choice.value);
    if (ImGui::Checkbox((std::string(choice.label) + "##overlay").c_str(), &shown))
      state.settings.overlays.shown ^= frame::Overlays::bitOf(choice.value);
    hint(std::string(choice.note));
    if (shown && choice.value == frame::Overlay::grid && state.shown.gridSpacing)
      ImGui::SameLine(), ImGui::TextDisabled("%.3g m", *state.shown.gridSpacing);
  }
  if (!state.shown.overlayRemark.empty()) ImGui::TextWrapped("%s", state.shown.overlayRemark.c_str());
  ImGui::Checkbox("in screenshots, too", &state.overlaysInPictures);
  hint("and in what \"copy command\" copies");
}

void modelsSection(ViewerState& state) {
  if (!section(state.layout, "Reflection models", false)) return;
  frame::PictureSettings& settings = state.settings;
  diffuseChoice(settings);
  chooseEnum("environment", settings.look.models.imageLight, optics::imageLights, usual.look.models.imageLight,
             "how a pixel looks the environment's reflection up");
  chooseEnum("energy", settings.look.models.energy, optics::energyModels, usual.look.models.energy,
             "light that leaves a rough surface after many bounces");
  ImGui::TextDisabled("of the lights:");
  chooseEnum("Fresnel", settings.look.models.fresnel, optics::fresnelModels, usual.look.models.fresnel,
             "what an interface reflects by angle; of the environment only with more than 4 samples");
  chooseEnum("microfacets", settings.look.models.distribution, optics::distributions, usual.look.models.distribution,
             "their distribution; the environment is reflected by GGX");
  chooseEnum("masking", settings.look.models.masking, optics::maskings, usual.look.models.masking,
             "how microfacets hide each other");
}

// ---- Accuracy -------------------------------------------------------------------------------------------------------

// An error to keep to, or as many samples as are chosen.
void budgetChoice(frame::PictureSettings& settings) {
  bool kept = settings.quality.maxError.has_value();
  if (ImGui::Checkbox("keep to an error", &kept)) settings.quality.maxError = kept ? std::optional(0.01) : std::nullopt;
  hint(
      "the resting picture takes as many samples as its estimated error needs, the chosen number at most; the light "
      "tables are made to that error, too");
  if (!settings.quality.maxError) return;
  auto percent = static_cast<float>(100 * *settings.quality.maxError);
  ImGui::SetNextItemWidth(-FLT_MIN);
  if (numberedSlider("##error", percent, 0.1f, 10, "%.2g %%", ImGuiSliderFlags_Logarithmic))
    settings.quality.maxError = std::clamp(std::round(static_cast<double>(percent) * 100) / 1e4, 1e-4, 1.0);
  hint("root mean square of what one sees, in per cent of white");
}

void seedChoice(frame::PictureSettings& settings) {
  int& seed = settings.quality.seed;
  ImGui::InputInt("seed", &seed);
  hint("of the numbers that samples are drawn with: another one gives independent noise");
  if (resetAsked()) seed = usual.quality.seed;
  seed = std::clamp(seed, 0, frame::largestSeed);
}

// Each pixel's error, and what its colours mean.
void errorChoice(ViewerState& state) {
  ImGui::Checkbox("show each pixel's error", &state.errorsShown);
  hint(
      "its standard error on the screen, of the colour channel that is off most, as far as the samples tell it: in "
      "colours over the picture, never in screenshots");
  if (!state.errorsShown) return;
  if (!frame::converges(state.settings)) return ImGui::TextDisabled("known with more than 4 samples");
  if (state.shown.compared) return ImGui::TextDisabled("not while two pictures are compared");
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetTextLineHeight();
  constexpr int steps = layout::errorStopCount - 1;
  for (int i = 0; i < steps; ++i) {
    const auto color = [](int stop) {
      const glm::vec4& c = errorStops[stop];
      return ImGui::GetColorU32(ImVec4(c.r, c.g, c.b, 1));
    };
    const float left = corner.x + width * static_cast<float>(i) / steps, right = left + width / steps;
    ImGui::GetWindowDrawList()->AddRectFilledMultiColor({left, corner.y}, {right, corner.y + height}, color(i),
                                                        color(i + 1), color(i + 1), color(i));
  }
  ImGui::Dummy({width, height});
  for (int i = 0; i <= steps; ++i) {
    char text[16];
    std::snprintf(text, sizeof text, "%.2g", leastError * std::pow(largestError / leastError, double(i) / steps));
    const float wide = textWidth(text), middle = width * static_cast<float>(i) / steps - wide / 2;
    if (i > 0) ImGui::SameLine();
    ImGui::SetCursorScreenPos({corner.x + std::clamp(middle, 0.0f, width - wide), ImGui::GetCursorScreenPos().y});
    ImGui::TextUnformatted(text);
  }
  ImGui::TextDisabled("of 255");
}

void accuracySection(ViewerState& state) {
  if (!section(state.layout, "Accuracy")) return;
  budgetChoice(state.settings);
  if (frame::converges(state.settings)) seedChoice(state.settings);
  errorChoice(state);
  truthChoice(state);
  if (!beginDetails("accuracy")) return;
  const RefinementStatus& r = state.refinement;
  const bool shows = r.shown > 0;
  detail("picture",
         shows ? std::to_string(r.shown) + " samples a pixel, " +
                     (frame::tracesPaths(state.settings) ? "path traced" : "environment sampled")
               : std::to_string(std::min(state.settings.quality.samples, 4)) + " samples a pixel, light tables");
  if (r.wanted > 0) detail("gathered", std::to_string(r.gathered) + " of " + std::to_string(r.wanted));
  char error[48] = "not known";
  if (r.error >= 0) std::snprintf(error, sizeof error, "%s %.2f/255", shows ? "up to" : "about", r.error);
  detail("its error", error);
  hint(
      "root mean square of the colours on the screen: the first half of the samples against the second; 'up to' is not "
      "below the true error in four of five pictures, and 0.8 to 1.5 of it in nine of ten");
  detail("light tables", byteText(state.shown.statistics.tableBytes));
  constexpr const char* parts[] = {"irradiance", "reflections", "DFG"};
  for (const ibl::Candidate* chosen : state.shown.statistics.methods) {
    char text[96];
    std::snprintf(text, sizeof text, "%s: %.2g %%", chosen->name.data(), 100 * chosen->error);
    detail(parts[static_cast<size_t>(chosen->part)], text);
  }
  ImGui::EndTable();
}

// ---- The file, the window -------------------------------------------------------------------------------------------

void animationSection(ViewerState& state) {
  if (state.shown.animations.empty() || !section(state.layout, "Animation", false)) return;
  const AnimationName* current = chosenAnimation(state);
  if (beginList("animation", current ? current->label : "at rest")) {
    if (ImGui::Selectable("at rest", !current)) chooseAnimation(state, "");
    for (const AnimationName& animation : state.shown.animations)
      if (ImGui::Selectable((animation.label + "##" + animation.option).c_str(), &animation == current))
        chooseAnimation(state, animation.option);
    ImGui::EndCombo();
  }
  auto speed = static_cast<float>(state.playback.speed);
  if (slider("speed##animation", speed, -2, 4, "%.2g x", 1, "negative: backwards"))
    state.playback.speed = static_cast<double>(speed);
  ImGui::Checkbox("loop##animation", &state.playback.loop);
}

void notesSection(PanelLayout& layout, const ShownScene& shown) {
  if (shown.warnings.empty() && shown.infos.empty()) return;
  const size_t count = shown.warnings.size() + shown.infos.size();
  const std::string title = "Notes (" + std::to_string(count) + ")###notes";
  if (!section(layout, title.c_str(), !shown.warnings.empty())) return;
  const auto list = [](const std::vector<std::string>& lines, ImU32 color) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    for (const std::string& line : lines) ImGui::TextWrapped("%s", line.c_str());
    ImGui::PopStyleColor();
  };
  list(shown.warnings, warningColor);
  list(shown.infos, quietColor);
}

void windowSection(ViewerState& state) {
  if (!section(state.layout, "Window", false)) return;
  static constexpr Choice<Theme> themes[] = {{Theme::dark, "", "dark"}, {Theme::light, "", "light"}};
  chooseEnum("theme", state.preferences.theme, themes, Theme::dark, "of the panels; the picture stays as it is");
  static constexpr float scales[] = {0, 0.75f, 1, 1.25f, 1.5f, 1.75f, 2, 2.5f, 3, 4};
  const auto label = [](float scale) {
    return scale == 0 ? std::string("the monitor's") : std::to_string(static_cast<int>(scale * 100 + 0.5f)) + " %";
  };
  if (beginList("size", label(state.preferences.scale))) {
    for (const float scale : scales)
      if (ImGui::Selectable(label(scale).c_str(), scale == state.preferences.scale)) state.preferences.scale = scale;
    ImGui::EndCombo();
  } else {
    if (resetAsked()) state.preferences.scale = 0;
    hint("of letters and controls\nright click: reset");
  }
  ImGui::Checkbox("play animations on opening", &state.preferences.playOnOpening);
  hint("the first one of a model, as soon as it is shown");
  ImGui::Checkbox("start with what was shown last", &state.preferences.startWithLast);
  hint("where facet is started without a model");
  if (ImGui::Button("reset layout")) {
    state.layout = {};
    state.browserVisible = state.settingsVisible = state.timelineVisible = true;
  }
  hint("widths of the panels, what of them is hidden or folded");
}

}  // namespace

void diffuseChoice(frame::PictureSettings& settings) {
  chooseEnum("diffuse", settings.look.models.diffuse, optics::diffuseModels, usual.look.models.diffuse,
             "of lights and environment, and of fitted models");
}

void settingsPanel(ViewerState& state, PanelResult& result) {
  ImGui::PushItemWidth(-7.5f * ImGui::GetFontSize());
  cameraSection(state, result);
  environmentSection(state);
  materialSection(state);
  modelSection(state);
  pictureSection(state, result);
  overlaySection(state);
  modelsSection(state);
  accuracySection(state);
  animationSection(state);
  notesSection(state.layout, state.shown);
  fileCheckSection(state, result);
  statisticsSection(state);
  windowSection(state);
  ImGui::PopItemWidth();
}

}  // namespace facet::view
