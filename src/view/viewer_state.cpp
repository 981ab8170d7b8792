#include "view/viewer_state.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <set>

#include "base/log.hpp"
#include "frame/choose.hpp"
#include "optics/presets.hpp"
#include "options/camera_text.hpp"
#include "scene/animation.hpp"
#include "scene/builtin_environments.hpp"
#include "scene/builtin_scenes.hpp"
#include "view/truth_view.hpp"

namespace facet::view {

std::string presetText(std::string_view name) {
  char figures[128] = "";
  std::string_view source;
  if (const optics::MetalPreset* metal = optics::findMetal(name)) {
    const glm::dvec3 f0 = metal->f0();
    std::snprintf(figures, sizeof figures, "F at normal incidence %.3f, %.3f, %.3f at %.0f, %.0f, %.0f nm", f0.r, f0.g,
                  f0.b, metal->wavelengthNm.r, metal->wavelengthNm.g, metal->wavelengthNm.b);
    source = metal->source;
  } else if (const optics::DielectricPreset* dielectric = optics::findDielectric(name)) {
    std::snprintf(figures, sizeof figures, "index of refraction %.4g, F at normal incidence %.4f", dielectric->ior,
                  dielectric->f0());
    source = dielectric->source;
  } else {
    return {};
  }
  return std::string(figures) + "\n" + std::string(source);
}

std::string refinementText(const RefinementStatus& status) {
  if (status.lightPreview) return "the light is a preview and sharpens";
  if (status.wanted == 0 || status.gathered == 0) return {};
  std::string text = std::to_string(status.gathered) + " of " + std::to_string(status.wanted) + " samples";
  if (status.gathered == status.wanted) text = std::to_string(status.wanted) + " samples";
  const std::string end = status.softened ? ", caustics softened" : "";
  if (status.error < 0) return text + end;
  if (status.error < 0.005) return text + ", error below 0.01/255" + end;
  char error[48];
  std::snprintf(error, sizeof error, ", error %s %.*f/255", status.shown > 0 ? "up to" : "about",
                status.error < 1 ? 2 : 1, status.error);
  return text + error + end;
}

void say(ViewerState& state, const std::string& text) {
  state.status = {text, false};
  log::debug(text);
}

void complain(ViewerState& state, const Error& error) {
  state.status = {describe(error), true};
  log::error(state.status.text);
}

void note(ViewerState& state, const std::string& text, bool isError) {
  constexpr size_t most = 100;
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char time[16];
  std::strftime(time, sizeof time, "%H:%M:%S", &local);
  state.messages.push_back({time, text, isError});
  if (state.messages.size() > most) state.messages.erase(state.messages.begin());
}

void noteProblem(ViewerState& state) {
  const auto last = std::ranges::find_if(state.messages.rbegin(), state.messages.rend(), &Message::isError);
  const bool known = last != state.messages.rend() && !last->past && last->text == state.status.text;
  if (state.status.isError && !known) note(state, state.status.text, true);
}

std::string messageCount(const std::vector<Message>& messages) {
  const auto count = [&](bool isError) {
    return std::ranges::count_if(messages, [&](const Message& m) { return !m.past && m.isError == isError; });
  };
  const auto words = [](ptrdiff_t n, const char* word) {
    return n == 0 ? std::string() : std::to_string(n) + " " + word + (n == 1 ? "" : "s");
  };
  const std::string problems = words(count(true), "problem"), warnings = words(count(false), "warning");
  return problems + (problems.empty() || warnings.empty() ? "" : ", ") + warnings;
}

MaterialSource materialSource(const frame::PictureSettings& settings) {
  if (!settings.sources.brdf.empty()) return MaterialSource::measured;
  return settings.look.material.on ? MaterialSource::one : MaterialSource::file;
}

void chooseBrdf(ViewerState& state, const std::string& source) {
  state.settings.sources.brdf = state.lastBrdf = source;
  state.settings.look.material.on = false;
}

void chooseMaterialSource(ViewerState& state, MaterialSource source) {
  if (!state.settings.sources.brdf.empty()) state.lastBrdf = state.settings.sources.brdf;
  state.settings.sources.brdf.clear();
  state.settings.look.material.on = source == MaterialSource::one;
  if (source != MaterialSource::measured) return;
  if (!state.lastBrdf.empty()) return chooseBrdf(state, state.lastBrdf);
  chooseBrdf(state, state.databases.empty() ? "builtin:plastic-0.2" : state.databases.front().source);
}

std::string modelName(optics::DiffuseModel diffuse) {
  return "GGX + " + std::string(rowOf(optics::diffuseModels, diffuse).label);
}

std::string comparisonText(const frame::ComparisonFigures& figures) {
  char text[128];
  std::snprintf(text, sizeof text, "RMS %.2f/255 where they differ (%.0f %% of the picture), %.0f/255 at most",
                figures.rms, 100 * figures.share, figures.largest);
  return text;
}

const char* kindName(optics::MeasuredKind kind) { return kind == optics::MeasuredKind::merl ? "MERL" : "UTIA"; }

frame::PictureSettings commandSettings(const ViewerState& state) {
  frame::PictureSettings settings = frame::restingSettings(gatheredSettings(state));
  settings.sources.environment = state.shown.environment;
  if (!state.overlaysInPictures) settings.overlays = {};
  if (shading::showsLight(std::max(0, shading::channelIndex(settings.look.channel)))) {
    const std::optional<frame::MeasuredFacts>& measured = state.shown.measured;
    settings.sources.brdf = measured ? measured->source.name : std::string();
    if (measured)
      settings.sources.brdfDir = measured->source.folder, settings.sources.utiaDecode = measured->source.decode;
  }
  if (!settings.viewpoint.camera.empty()) return settings;
  settings.viewpoint.orbit = frame::Orbit{state.camera.theta, state.camera.phi, state.camera.radius};
  settings.viewpoint.target = state.camera.target;
  settings.viewpoint.fovYDeg = state.camera.fovY;
  settings.viewpoint.projection =
      state.camera.orthographic ? frame::Projection::orthographic : frame::Projection::perspective;
  settings.viewpoint.up = state.camera.up;
  settings.viewpoint.rollDeg = state.camera.roll;
  return settings;
}

Result<scene::View> viewOf(const ViewerState& state, const scene::Model& model, const frame::DrawList& list) {
  const double aspect = frame::aspectOf(state.settings.frame);
  if (!state.settings.viewpoint.camera.empty())
    return frame::chooseView(state.settings.viewpoint, aspect, state.shown.model, model, list, list.bounds);
  return scene::orbitView(state.camera, aspect, list.bounds);
}

double framingAspect(const ViewerState& state) {
  constexpr double leastShare = 0.3;  // else it would be seen from far off for the sake of a panel
  const double width = state.settings.frame.width;
  const double seen = width - 2 * std::max(state.coveredLeft, state.coveredRight);
  return std::max(seen, leastShare * width) / state.settings.frame.height;
}

void freeCamera(ViewerState& state, const scene::View& view) {
  if (state.settings.viewpoint.camera.empty()) return;
  state.settings.viewpoint.camera.clear();
  state.camera = scene::orbitFromView(view, state.shown.bounds, state.camera);
}

Result<void> goToCamera(ViewerState& state, std::string_view text) {
  const Result<frame::Viewpoint> wanted = options::viewpointOf(text);
  if (!wanted) return tl::unexpected(wanted.error());
  state.settings.viewpoint = {};
  state.settings.viewpoint.camera = wanted->camera;
  if (wanted->camera.empty())
    state.camera = frame::chooseOrbit(*wanted, framingAspect(state), state.shown.model, state.shown.bounds);
  else
    state.settings.viewpoint.fovYDeg = wanted->fovYDeg;
  return {};
}

std::vector<std::string> builtinEnvironmentSources() {
  std::vector<std::string> sources;
  for (const scene::BuiltinEnvironment& environment : scene::builtinEnvironments())
    sources.push_back("builtin:" + std::string(environment.name));
  sources.emplace_back("none");
  return sources;
}

void offerEnvironment(ViewerState& state, const std::string& source) {
  if (std::ranges::find(state.environments, source) != state.environments.end()) return;
  state.environments.insert(std::ranges::find(state.environments, "none"), source);
}

std::vector<AnimationName> animationNames(const scene::Model& model) {
  std::vector<AnimationName> names;
  AnimationName all{"all", "all at once", 0};
  for (size_t i = 0; i < model.animations.size(); ++i) {
    const std::string& name = model.animations[i].name;
    const auto same = std::ranges::count(model.animations, name, &scene::Animation::name);
    const std::string index = std::to_string(i);
    names.push_back({name.empty() || name == "all" || same > 1 ? index : name,
                     name.empty() ? "animation " + index : name, scene::duration(model.animations[i])});
    all.duration = std::max(all.duration, names.back().duration);
  }
  if (names.size() > 1) names.push_back(all);
  return names;
}

std::string animationOption(const scene::Model& model, const std::string& wanted) {
  const Result<std::vector<int>> chosen = scene::chooseAnimations(model, wanted);
  if (!chosen) return wanted;
  if (chosen->empty()) return {};
  return chosen->size() == 1 ? animationNames(model)[static_cast<size_t>(chosen->front())].option : "all";
}

std::string nextEnvironment(const std::string& current) {
  const auto builtin = scene::builtinEnvironments();
  const auto same = [&](const scene::BuiltinEnvironment& e) { return "builtin:" + std::string(e.name) == current; };
  const auto found = std::ranges::find_if(builtin, same);
  const auto next = found == builtin.end() || std::next(found) == builtin.end() ? builtin.begin() : std::next(found);
  return "builtin:" + std::string(next->name);
}

int variantCount(const frame::DrawList& list) {
  std::set<shading::VariantKey> keys;
  for (const std::vector<frame::Draw>* draws : list.classes())
    for (const frame::Draw& draw : *draws) keys.insert(draw.key);
  return static_cast<int>(keys.size());
}

}  // namespace facet::view
