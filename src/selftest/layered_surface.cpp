#include "selftest/layered_surface.hpp"

namespace facet::selftest {

const char* const layeredSurfaceText = R"(
  Surface s = makeSurface(vec3(0.0, 0.0, 1.0), V, baseColor, metallic, perceptualRoughness, 1.0);
  s.dielectricF90 = 0.8;
  s.coloredInterface = true;
  s.dielectricF0 = vec3(0.05, 0.1, 0.2) * 0.8;
  s.dfg = vec3(dfg.xy, 0.0);
  s.grain.T = vec3(1.0, 0.0, 0.0);
  s.grain.B = vec3(0.0, 1.0, 0.0);
  s.grain.alpha = alphaFromAnisotropy(s.alpha, layers.w);
  setFilm(s, layers.z, 1.4, 350.0);
  s.sheen.color = vec3(0.9, 0.3, 0.5);
  s.sheen.perceptualRoughness = layers.y;
  s.sheen.alpha = layers.y * layers.y;
  s.sheen.albedoV = sheenAlbedo.x;
  s.sheen.albedoL = sheenAlbedo.y;
  s.coat.N = vec3(0.28, 0.0, 0.96);
  s.coat.NoV = clamp(dot(s.coat.N, s.V), minNoV, 1.0);
  s.coat.weight = layers.x;
  s.coat.perceptualRoughness = 0.3;
  s.coat.alpha = 0.09;
  s.coat.dfg = vec3(dfg.zw, 0.0);
)";
const std::vector<std::string> layerNames = {"coat", "sheenRoughness", "film", "anisotropy"};
std::vector<std::string> aroundLayers(std::vector<std::string> before, const std::vector<std::string>& after) {
  before.insert(before.end(), layerNames.begin(), layerNames.end());
  before.insert(before.end(), after.begin(), after.end());
  return before;
}
const std::vector<shading::Define> allLayers = {
    {"HAS_DIELECTRIC_SPECULAR"}, {"HAS_CLEARCOAT"}, {"HAS_SHEEN"}, {"HAS_ANISOTROPY"}, {"HAS_IRIDESCENCE"}};

optics::Surface layeredSurface(const glm::dvec3& baseColor, double metallic, double perceptualRoughness,
                               const glm::dvec4& layers) {
  optics::Surface surface{baseColor, metallic, perceptualRoughness};
  surface.f90 = float(0.8);
  surface.f0 = glm::dvec3(float(0.05), float(0.1), float(0.2)) * surface.f90;
  surface.coloredInterface = true;
  surface.grain = {layers.w, {1, 0, 0}};
  surface.film = {layers.z, float(1.4), 350};
  surface.sheen = {{float(0.9), float(0.3), 0.5}, layers.y};
  surface.coat = {layers.x, float(0.3), {float(0.28), 0, float(0.96)}};
  return surface;
}

}  // namespace facet::selftest
