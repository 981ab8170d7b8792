#include "scene/builtin_marbles.hpp"

#include <array>
#include <cmath>
#include <string>

#include "base/angle.hpp"
#include "base/hash.hpp"
#include "base/parallel.hpp"
#include "scene/glb_writer.hpp"
#include "scene/png_writer.hpp"
#include "scene/shapes.hpp"

namespace facet::scene {

namespace {

constexpr int edge = 1024;
constexpr size_t setCount = 8;

using Texels = std::vector<uint8_t>;  // indices into a palette, edge x edge
using Palette = std::array<glm::dvec3, 256>;

// [0, 1)
double chance(uint32_t of) { return mixedBits(of) / 4294967296.0; }

std::vector<uint8_t> png(const Texels& texels, const Palette& colors) {
  std::array<glm::u8vec3, 256> rounded;
  for (size_t i = 0; i < colors.size(); ++i) rounded[i] = glm::u8vec3(glm::clamp(colors[i] * 255.0 + 0.5, 0.0, 255.0));
  return palettePng(edge, edge, texels, rounded);
}

// Bricks in courses of 32 texels, mortar between them; a grain of single texels and of eight over all.
struct Masonry {
  Texels stones;   // 0: mortar; else 16 brick (1 to 15) + grain
  Texels normals;  // 16 y + x, of slopes -1 to 1
};
Masonry masonry() {
  Masonry m;
  m.stones.resize(size_t(edge) * edge), m.normals.resize(m.stones.size());
  for (int y = 0; y < edge; ++y)
    for (int x = 0; x < edge; ++x) {
      const int course = y / 32, along = (x + course % 2 * 32) % edge;
      const int inX = along % 64, inY = y % 32;
      const bool mortar = inX < 3 || inY < 3;
      const uint32_t brick = mixedBits(uint32_t(course * 64 + along / 64)) % 15 + 1;
      const uint32_t fine = mixedBits(uint32_t(y * edge + x)),
                     coarse = mixedBits(uint32_t(y / 8 * edge + x / 8) + 7919);
      const size_t at = size_t(y) * edge + size_t(x);
      m.stones[at] = mortar ? 0 : uint8_t(16 * brick + (fine % 8 + coarse % 9));
      const auto slope = [&](int in, int length, uint32_t noise) {
        const int bevel = in < 3 ? 0 : in < 7 ? -4 : in >= length - 4 ? 4 : 0;
        return uint32_t(7 + bevel + int(noise % 3));
      };
      m.normals[at] = uint8_t(16 * slope(inY, 32, fine >> 8) + slope(inX, 64, fine >> 16));
    }
  return m;
}

struct Palettes {
  Palette baseColor, metallicRoughness, emissive;
};
Palettes palettes(uint32_t set) {
  Palettes p;
  const double hue = 2 * pi * set / double(setCount);
  for (uint32_t i = 0; i < 256; ++i) {
    const uint32_t brick = i / 16;
    const double grain = i % 16 / 15.0, own = chance(64 * set + brick);
    const glm::dvec3 color = 0.55 + 0.35 * glm::cos(hue + own - 2 * pi / 3 * glm::dvec3(0, 1, 2));
    p.baseColor[i] = i < 16 ? glm::dvec3(0.75) : color * (0.6 + 0.4 * grain);
    const bool metal = brick != 0 && chance(64 * set + brick + 1024) < 0.3;
    p.metallicRoughness[i] = {1, i < 16 ? 0.9 : 0.25 + 0.4 * own + 0.2 * grain, metal ? 1 : 0};
    p.emissive[i] = brick == set % 15 + 1 ? glm::dvec3(0.5, 0.35, 0.1) * grain : glm::dvec3(0);
  }
  return p;
}

Palette slopes() {
  Palette p;
  for (uint32_t i = 0; i < 256; ++i)
    p[i] = 0.5 + 0.5 * glm::normalize(glm::dvec3((i % 16 - 8.0) / 8, (i / 16 - 8.0) / 8, 1));
  return p;
}

struct Ellipsoid {
  glm::dvec3 center, radii;
};
// Eighty, eight in a row and two metres apart; every fifth is a core within the one before it.
Ellipsoid ellipsoid(uint32_t i) {
  const bool core = i % 5 == 4;
  const uint32_t place = i - i / 5 - (core ? 1 : 0);
  const auto jitter = [&](uint32_t k) { return chance(8 * place + k) - 0.5; };
  const glm::dvec3 center(2.0 * (place % 8) - 7 + jitter(0), 2.0 * (place / 8) - 9 + jitter(1), 4 * jitter(2));
  const glm::dvec3 radii(1.0 + 0.5 * jitter(3), 0.95 + 0.5 * jitter(4), 0.9 + 0.5 * jitter(5));
  return {center, radii * (core ? 0.7 : 1.0)};
}

}  // namespace

std::vector<uint8_t> marbles() {
  constexpr size_t kinds = 3;
  const Masonry drawn = masonry();
  std::array<std::vector<uint8_t>, setCount * kinds> images;
  parallelFor(images.size(), [&](size_t i) {
    const Palettes p = palettes(uint32_t(i / kinds));
    images[i] = png(drawn.stones, i % kinds == 0 ? p.baseColor : i % kinds == 1 ? p.metallicRoughness : p.emissive);
  });
  const std::vector<uint8_t> normals = png(drawn.normals, slopes());

  GlbWriter w = startGlb();
  std::array<std::array<int, kinds + 1>, setCount> textures;
  for (size_t set = 0; set < setCount; ++set) {
    for (size_t kind = 0; kind < kinds; ++kind) textures[set][kind] = addPngTexture(w, images[set * kinds + kind]);
    textures[set][kinds] = addPngTexture(w, normals);
  }
  const nlohmann::json sphere = addShape(w, sphereShape(27, 50));
  for (uint32_t i = 0; i < 100; ++i) {
    const Ellipsoid e = ellipsoid(i);
    const std::string name = "marble " + std::to_string(i + 1);
    const auto& [baseColor, metallicRoughness, emissive, normal] = textures[i % setCount];
    const int material = addMaterial(w, name, {1, 1, 1}, 1, 1);
    nlohmann::json& m = w.gltf["materials"][size_t(material)];
    m["pbrMetallicRoughness"]["baseColorTexture"]["index"] = baseColor;
    m["pbrMetallicRoughness"]["metallicRoughnessTexture"]["index"] = metallicRoughness;
    m["normalTexture"]["index"] = normal;
    m["emissiveTexture"]["index"] = emissive;
    m["emissiveFactor"] = {1, 1, 1};
    addNode(w, {{"name", name},
                {"mesh", addMesh(w, name, sphere, material)},
                {"translation", {e.center.x, e.center.y, e.center.z}},
                {"scale", {e.radii.x, e.radii.y, e.radii.z}}});
  }
  return glb(w);
}

}  // namespace facet::scene
