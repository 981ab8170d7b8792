#include <array>

#include "gl/texture.hpp"
#include "ibl/taps.hpp"
#include "layout.h"
#include "selftest/numerics_grid.hpp"

namespace facet::selftest {

namespace {

// Filters have at least 8 bits of fraction, so that values may be off by 1/512 of what neighbours differ by along each
// axis.
constexpr double filterStep = 1.0 / 512;

using Node = std::function<glm::dvec3(int x, int y)>;

// Bilinear between nodes that lie at the ends and evenly between them, x by sqrt(NoV).
glm::dvec3 between(const Node& node, int size, double NoV, double perceptualRoughness) {
  const double x = std::sqrt(std::clamp(NoV, 0.0, 1.0)) * (size - 1);
  const double y = std::clamp(perceptualRoughness, 0.0, 1.0) * (size - 1);
  const int i = std::min(static_cast<int>(x), size - 2), j = std::min(static_cast<int>(y), size - 2);
  const glm::dvec3 low = glm::mix(node(i, j), node(i + 1, j), x - i);
  return glm::mix(low, glm::mix(node(i, j + 1), node(i + 1, j + 1), x - i), y - j);
}

std::vector<glm::vec4> placesIn(int size) {
  std::vector<glm::vec4> inputs;
  const double last = size - 1;
  for (const double x : {0.0, 0.5, 1.0, 3.3, last - 1, last - 0.4, last})
    for (const double y : {0.0, 0.5, 2.0, 2.7, last - 0.1, last})
      inputs.emplace_back(std::pow(x / last, 2), y / last, 0, 0);
  inputs.emplace_back(-1, -1, 0, 0);  // clamped
  inputs.emplace_back(2, 2, 0, 0);
  return inputs;
}

// Of a table whose values tell their place, and differ by 1 at most from one node to the next.
Check checkTable(const std::string& name, const std::string& chunk, const std::string& body, int unit, int size,
                 const Node& node, int components) {
  Check check = absoluteCheck(name, chunk, body, {"NoV", "perceptualRoughness"});
  check.inputs = placesIn(size);
  check.bind = [=]() -> std::shared_ptr<const void> {
    auto texture = std::make_shared<gl::Texture>(
        gl::TextureDescription{.format = GL_RGBA32F, .width = size, .height = size}, "known table");
    texture->filterLinear();
    std::vector<glm::vec4> texels;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) texels.emplace_back(glm::vec3(node(x, y)), 0);
    glTextureSubImage2D(texture->id(), 0, 0, 0, size, size, GL_RGBA, GL_FLOAT, texels.data());
    texture->bind(static_cast<GLuint>(unit));
    return texture;
  };
  check.twin = [=](CheckVectors in) {
    const glm::dvec3 value = between(node, size, in[0].x, in[0].y);
    CheckValues values;
    for (int c = 0; c < components; ++c) values.push_back(value[c]);
    return values;
  };
  check.tolerance = 3 * filterStep;
  check.reason = "filters may round shares to 8 bits, of neighbours that differ by 1 along each axis";
  check.clamped = "NoV and roughness to [0, 1]";
  return check;
}

Check checkTap(int taps, int tap) {
  Check check =
      absoluteCheck("lookUpTap, " + std::to_string(tap + 1) + " of " + std::to_string(taps), "image_light.glsl",
                    "out0.xyz = lookUpTap(" + std::to_string(tap) + ", in0.x, in0.y);", {"NoV", "perceptualRoughness"});
  check.probe.defines = {{"IMAGE_LIGHT_MODEL", std::to_string(3 + taps)}};
  check.inputs = placesIn(layout::tapsTableSize);
  const Node node = [=](int x, int y) {
    const ibl::Tap at = ibl::tapAt(taps, tap, x, y);
    return glm::dvec3(at.tilt, at.perceptualRoughness, at.weight);
  };
  check.bind = []() -> std::shared_ptr<const void> {
    auto texture = std::make_shared<gl::Texture>(ibl::tapsTexture());
    texture->bind(layout::tapsUnit);
    return texture;
  };
  check.twin = [=](CheckVectors in) { return valuesOf(between(node, layout::tapsTableSize, in[0].x, in[0].y)); };
  check.tolerance = 2 * filterStep;
  check.reason = "filters may round shares to 8 bits, of neighbours that differ by less than 1";
  check.clamped = "NoV and roughness to [0, 1]";
  return check;
}

}  // namespace

std::vector<Check> lookUpChecks() {
  const Node node = [](int x, int y) { return glm::dvec3(x, 0.5 * y, std::sin(x + 0.7 * y) / 2); };
  return {checkTable("lookUpDfg", "dfg_table.glsl", "out0.xyz = lookUpDfg(in0.x, in0.y);", layout::dfgUnit, 8, node, 3),
          checkTable("lookUpSheenAlbedo", "sheen_table.glsl", "out0.x = lookUpSheenAlbedo(in0.x, in0.y);",
                     layout::sheenAlbedoUnit, 8, node, 1),
          checkTap(1, 0), checkTap(2, 1), checkTap(3, 2)};
}

}  // namespace facet::selftest
