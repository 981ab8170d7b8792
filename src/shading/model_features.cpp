#include "shading/model_features.hpp"

#include <algorithm>
#include <cstdio>

#include "optics/fresnel.hpp"
#include "optics/presets.hpp"

namespace facet::shading {

namespace {

bool hasDielectric(const scene::Material& m) {
  return m.specularGlossiness || m.metallicFactor < 1 || m.metallicRoughness;
}

// Zero where the choice is what the automatic one means for all that the draw shows.
uint8_t energyIndex(const FeatureInput& in, const VariantKey& key) {
  const optics::EnergyModel usual = optics::EnergyModel::automatic;
  optics::EnergyModel chosen = in.frame.models.energy;
  // Where light is sampled: against path-traced rough metals under a sun, Kulla and Conty's lobe is nearer than a
  // scaled one, 3.3 / 255 in the place of 4.6, for 1.2 times the time. It has no table for a grain.
  const bool paths = usesFeature(key, Feature::paths), grain = usesFeature(key, Feature::anisotropy);
  if (chosen == usual && (in.frame.imageLightSamples != 0 || paths) && !grain) chosen = optics::EnergyModel::kullaConty;
  // Of paths all light is distant.
  if (paths) return static_cast<uint8_t>(chosen == usual ? optics::EnergyModel::fdezAguera : chosen);
  // Lobes other than GGX with Smith's term have no compensation; what they leave for the base has.
  const bool lights = usesFeature(key, Feature::punctualLights) &&
                      ((key.distribution == 0 && key.masking == 0) || hasDielectric(in.material));
  const bool distant = usesFeature(key, Feature::environment) || usesFeature(key, Feature::transmission) ||
                       usesFeature(key, Feature::diffuseTransmission);
  const bool differs = (lights && optics::lightEnergy(chosen) != optics::lightEnergy(usual)) ||
                       (distant && optics::distantEnergy(chosen) != optics::distantEnergy(usual));
  return differs ? static_cast<uint8_t>(chosen) : 0;
}

std::string vec3Text(const glm::dvec3& v) {
  char text[128];
  std::snprintf(text, sizeof text, "vec3(%.9g, %.9g, %.9g)", v.x, v.y, v.z);
  return text;
}

}  // namespace

void setModels(const FeatureInput& in, VariantKey& key) {
  const bool paths = usesFeature(key, Feature::paths);
  const bool lights = usesFeature(key, Feature::punctualLights) || paths;  // the lobes themselves are evaluated
  const bool environment = usesFeature(key, Feature::environment);
  const bool sampled = key.imageLightSamples != 0;
  const scene::Material& m = in.material;
  const optics::Models& models = in.frame.models;
  if ((lights || environment) && hasDielectric(m)) key.diffuse = static_cast<uint8_t>(models.diffuse);
  if (usesFeature(key, Feature::diffuseRoughness)) key.diffuse = static_cast<uint8_t>(optics::DiffuseModel::eon);
  if (lights && !usesFeature(key, Feature::anisotropy)) {  // a grain is GGX's
    const auto own = static_cast<int>(m.microfacets) - static_cast<int>(scene::Microfacets::ggx);
    key.distribution = static_cast<uint8_t>(own >= 0 ? own : static_cast<int>(models.distribution));
    const auto* masking = rowOfWord(optics::maskings, m.masking);
    key.masking = static_cast<uint8_t>(masking ? masking->value : models.masking);
  }
  key.energy = energyIndex(in, key);
  if (environment && !sampled && models.imageLight != optics::usualLookUp)
    key.imageLight = static_cast<uint8_t>(models.imageLight);
  if (!(lights || sampled) || models.fresnel == optics::FresnelModel::schlick) return;
  const optics::MetalPreset* metal =
      m.metallicFactor > 0 && !m.specularGlossiness ? optics::findMetal(m.conductor) : nullptr;
  if (metal) key.conductor = static_cast<uint8_t>(metal - optics::metalPresets().data() + 1);
  if (metal || (models.fresnel == optics::FresnelModel::exact && hasDielectric(m)))
    key.fresnel = static_cast<uint8_t>(models.fresnel);
}

void addModelDefines(const VariantKey& key, std::vector<Define>& defines) {
  const auto add = [&](const char* name, uint8_t value) {
    if (value != 0) defines.push_back({name, std::to_string(value)});
  };
  add("DIFFUSE_MODEL", key.diffuse);
  add("FRESNEL_MODEL", key.fresnel);
  add("NDF_MODEL", key.distribution);
  add("MASKING_MODEL", key.masking);
  add("IMAGE_LIGHT_MODEL", key.imageLight);
  add("ENERGY_MODEL", key.energy);
  if (key.conductor == 0) return;
  const optics::MetalPreset& metal = optics::metalPresets()[key.conductor - 1u];
  defines.push_back({"CONDUCTOR_F0", vec3Text(metal.f0())});
  defines.push_back({"CONDUCTOR_ETA", vec3Text(metal.eta)});
  defines.push_back({"CONDUCTOR_K", vec3Text(metal.k)});
  defines.push_back({"CONDUCTOR_TINT", vec3Text(optics::tintFromF82(metal.f0(), metal.f82()))});
}

void addModelNames(const VariantKey& key, std::string& name) {
  const auto add = [&](uint8_t value, const auto& rows, const char* of = "") {
    if (value != 0) name += (name.empty() ? "" : ", ") + (of + std::string(rows[value].label));
  };
  add(key.diffuse, optics::diffuseModels);
  add(key.fresnel, optics::fresnelModels);
  add(key.distribution, optics::distributions);
  add(key.masking, optics::maskings);
  add(key.imageLight, optics::imageLights);
  add(key.energy, optics::energyModels, "energy: ");
  if (key.conductor != 0) name += " of " + std::string(optics::metalPresets()[key.conductor - 1u].name);
}

int imageLightTaps(const VariantKey& key) {
  if (!usesFeature(key, Feature::environment) || key.imageLightSamples != 0) return 0;
  // A grain has look-ups of its own.
  if (usesFeature(key, Feature::anisotropy) && !usesFeature(key, Feature::clearcoat)) return 0;
  const auto lookUp = static_cast<optics::ImageLight>(key.imageLight);
  return optics::tapsOf(lookUp == optics::ImageLight::automatic ? optics::usualLookUp : lookUp);
}

}  // namespace facet::shading
