#include "frame/list_notes.hpp"

#include <algorithm>
#include <sstream>

#include "frame/shadow_maps.hpp"
#include "scene/geometry.hpp"

namespace facet::frame {

namespace {

void noteUnlit(const DrawList& list, const ibl::Needs& needs, Notes& notes) {
  if (std::ranges::all_of(list.classes(), [](const auto* draws) { return draws->empty(); })) {
    notes.push_back({Note::Severity::warning, "", "the scene draws nothing"});
    return;
  }
  const auto lit = [](const Draw& draw) { return !shading::usesFeature(draw.key, shading::Feature::unlit); };
  const bool anyLit =
      std::ranges::any_of(list.classes(), [&](const auto* draws) { return std::ranges::any_of(*draws, lit); });
  const bool glows = list.features.paths && std::ranges::any_of(list.materials, [](const scene::Material& m) {
                       return m.emissiveFactor * m.emissiveStrength != glm::vec3(0);
                     });
  const bool environment = needs.irradiance || needs.samples || needs.texels;
  if (anyLit && !environment && !glows && list.lights.empty() && list.features.channel == 0)
    notes.push_back(
        {Note::Severity::warning, "",
         "nothing lights the scene: it has no lights and there is no environment; choose one, or the demo lights",
         Setting::environment});
}

// What the chosen models do not reach.
void noteModels(const DrawList& list, Notes& notes) {
  const auto any = [&](auto test) {
    return std::ranges::any_of(list.classes(), [&](const auto* draws) { return std::ranges::any_of(*draws, test); });
  };
  const auto warn = [&](const char* text, Setting about) {
    notes.push_back({Note::Severity::warning, "", text, about});
  };
  const optics::Models& models = list.features.models;
  if (models.distribution != optics::NormalDistribution::ggx || models.masking != optics::Masking::smith) {
    if (!any([](const Draw& d) { return d.key.distribution != 0 || d.key.masking != 0; }))
      warn(
          "the distribution of normals and the masking term change nothing: they are for point, spot and directional "
          "lights, and none shines",
          Setting::models);
    else if (list.features.environment && !list.features.paths)
      warn(
          "the distribution of normals and the masking term are for point, spot and directional lights: GGX reflects "
          "the environment",
          Setting::models);
  }
  if (models.fresnel == optics::FresnelModel::schlick) return;
  const bool sampled = list.features.imageLightSamples != 0 || list.features.paths;
  if (!any([](const Draw& d) { return d.key.fresnel != 0; }))
    warn(
        "the Fresnel term changes nothing: exact is for dielectrics and for metals whose index is known, f82 for the "
        "latter, under point, spot and directional lights, or with more than 4 samples",
        Setting::fresnel);
  else if (list.features.environment && !sampled)
    warn(
        "the chosen Fresnel term is for point, spot and directional lights: the environment's tables are Schlick's; "
        "more than 4 samples do without them",
        Setting::samples);
}

// Which draws do not show the measured BRDF, or not as it was meant.
void noteMeasured(const DrawList& list, Notes& notes) {
  size_t unlit = 0, levelled = 0;
  for (const std::vector<Draw>* draws : list.classes())
    for (const Draw& draw : *draws) {
      if (!shading::isMeasured(draw.key)) ++unlit;
      if (shading::usesFeature(draw.key, shading::Feature::utiaBrdf) && draw.primitive->tangents.empty()) ++levelled;
    }
  const auto warn = [&](const std::string& text) {
    notes.push_back({Note::Severity::warning, "", text, Setting::brdf});
  };
  if (list.features.channel == 0 && unlit > 0)
    warn("measured BRDF: " + std::to_string(unlit) +
         " draws keep their own look, because they are unlit or have no normals");
  if (levelled > 0)
    warn("measured BRDF: " + std::to_string(levelled) +
         " draws have no tangents: the BRDF's azimuths begin at their level direction");
}

void noteSize(const DrawList& list, Notes& notes) {
  const auto warn = [&](const char* what, const SizeRange& sizes) {
    std::ostringstream text;
    text << what << ": its radius is " << list.bounds.radius() << " m, and 32-bit floats do for " << sizes.least
         << " to " << sizes.most << " m; give it another scale";
    notes.push_back({Note::Severity::warning, "", text.str()});
  };
  if (!drawnSizes.holds(list.bounds))
    warn("the scene cannot be drawn right", drawnSizes);
  else if (!list.untraced.empty() && !tracedSizes.holds(list.bounds))
    warn("light is not traced, and nothing stands in its way, in a scene of this size", tracedSizes);
}

// What rays do not meet.
void notePaths(const DrawList& list, Notes& notes) {
  size_t thin = 0;
  for (const std::vector<Draw>* draws : list.classes())
    thin += static_cast<size_t>(
        std::ranges::count_if(*draws, [](const Draw& d) { return !scene::hasTriangles(d.primitive->topology); }));
  if (thin > 0)
    notes.push_back({Note::Severity::warning, "",
                     "path tracing: " + std::to_string(thin) +
                         " draws of lines or points are missing, because rays do not meet them"});
}

void noteShadows(const DrawList& list, Notes& notes) {
  const int without = lightsWithoutMap(list);
  if (without > 0)
    notes.push_back({Note::Severity::warning, "",
                     std::to_string(without) + (without == 1 ? " light casts" : " lights cast") +
                         " no shadow in the drawn picture: there is room for " +
                         std::to_string(layout::mostShadowMaps) + " shadow maps, six for a point light"});
}

}  // namespace

Notes listNotes(const DrawList& list, const ibl::Needs& needs) {
  Notes notes;
  noteUnlit(list, needs, notes);
  noteSize(list, notes);
  if (list.features.measured != shading::Measured::none)
    noteMeasured(list, notes);
  else
    noteModels(list, notes);
  if (list.features.paths) notePaths(list, notes);
  if (list.features.shadows) noteShadows(list, notes);
  return notes;
}

}  // namespace facet::frame
