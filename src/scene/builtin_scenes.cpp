#include "scene/builtin_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "base/angle.hpp"
#include "base/parallel.hpp"
#include "optics/presets.hpp"
#include "scene/builtin_marbles.hpp"
#include "scene/builtin_robot.hpp"
#include "scene/builtin_tutorial.hpp"
#include "scene/glb_writer.hpp"
#include "scene/shapes.hpp"

namespace facet::scene {

namespace {

const std::array<BuiltinScene, 10> scenes = {{
    {"poster", "a golden trefoil among spheres of many materials", "builtin:studio", {-20, 75, 7.3, {0, 0.82, 0}, 35}},
    {"spheres",
     "roughness (to the right) by metallic (upwards) under four point lights",
     "builtin:studio",
     {0, 90, 9.2, {0, 0, 0}, 45}},
    {"tutorial",
     "the spheres of learnopengl.com, by its formulas (its picture: reinhard-power, nothing hides light)",
     "none",
     {0, 90, 8, {0, 0, 0}, 45}},
    {"furnace",
     "white metal and white dielectric, roughness 0 to 1: invisible if no energy is lost",
     "builtin:white",
     {0, 90, 14, {0, 0, 0}, 45}},
    {"crowd", "100,000 nodes that share one mesh, for measuring", "builtin:studio", {30, 60, 95, {0, 0, 0}, 45}},
    {"palette", "1,000 materials on as many meshes, for measuring", "builtin:studio", {0, 90, 51, {0, 0, 0}, 45}},
    {"marbles",
     "100 textured ellipsoids of small triangles, seen from far, for measuring",
     "builtin:studio",
     {20, 75, 40, {0, 0, 0}, 45}},
    {"robot",
     "a robot grown from rules walks through a room into a corridor (animation walk, camera film)",
     "none",
     {24, 82, 4.3, {0, 1.0, -4.9}, 42}},
    {"ndf",
     "GGX above, Beckmann, Blinn below; roughness 0.15 to 1 to the right, under one point light",
     "none",
     {0, 90, 8.6, {0, 0, 0}, 45}},
    {"metals",
     "the twelve metals of the presets, with their complex index",
     "builtin:studio",
     {0, 90, 6, {0, 0, 0}, 45}},
}};

std::string label(const char* format, double a, double b) {
  char text[64];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

nlohmann::json placed(const std::string& name, int mesh, const glm::dvec3& at, double scale) {
  return {{"name", name}, {"mesh", mesh}, {"translation", {at.x, at.y, at.z}}, {"scale", {scale, scale, scale}}};
}

std::vector<uint8_t> spheres() {
  constexpr int side = 7;
  GlbWriter w = startGlb();
  const nlohmann::json sphere = addShape(w, sphereShape(32, 64));
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const double metallic = double(row) / (side - 1), perceptualRoughness = double(column) / (side - 1);
      const std::string name = label("metallic %.2f, roughness %.2f", metallic, perceptualRoughness);
      const int material = addMaterial(w, name, {0.80, 0.12, 0.07}, metallic, perceptualRoughness);
      const glm::dvec3 at(column - (side - 1) / 2.0, row - (side - 1) / 2.0, 0);
      addNode(w, placed(name, addMesh(w, name, sphere, material), at, 0.43));
    }
  // At the grid's centre each gives 100 cd / (2 * 4.5^2 + 6^2) m^2 = 1.3 lx on a surface that faces it.
  for (const glm::dvec2 corner : {glm::dvec2(-4.5, 4.5), {4.5, 4.5}, {-4.5, -4.5}, {4.5, -4.5}})
    addPointLight(w, label("light at x %.1f, y %.1f", corner.x, corner.y), glm::dvec3(corner, 6), 100);
  return glb(w);
}

std::vector<uint8_t> furnace() {
  constexpr int steps = 11;
  GlbWriter w = startGlb();
  const nlohmann::json sphere = addShape(w, sphereShape(64, 128));
  for (const double metallic : {1.0, 0.0})
    for (int i = 0; i < steps; ++i) {
      const double perceptualRoughness = double(i) / (steps - 1);
      const std::string name = label("metallic %.0f, roughness %.1f", metallic, perceptualRoughness);
      const int material = addMaterial(w, name, {1, 1, 1}, metallic, perceptualRoughness);
      const glm::dvec3 at(i - (steps - 1) / 2.0, metallic - 0.5, 0);
      addNode(w, placed(name, addMesh(w, name, sphere, material), at, 0.45));
    }
  return glb(w);
}

// 100 nodes of 1000 children each, a grid of 50 x 40 x 50 places 1 m apart.
std::vector<uint8_t> crowd() {
  GlbWriter w = startGlb();
  const int clay = addMaterial(w, "clay", {0.55, 0.30, 0.20}, 0, 0.7);
  const int mesh = addMesh(w, "pebble", addShape(w, sphereShape(6, 8)), clay);
  constexpr int groups = 100, members = 1000;
  for (int group = 0; group < groups; ++group) {
    nlohmann::json children = nlohmann::json::array();
    for (int i = 0; i < members; ++i) children.push_back(groups + group * members + i);
    addNode(w, {{"translation", {group % 10 * 5 - 22.5, 0, group / 10 * 5 - 22.5}}, {"children", children}});
  }
  for (int i = 0; i < groups * members; ++i) {
    const int place = i % members;
    w.gltf["nodes"].push_back({{"mesh", mesh},
                               {"translation", {place % 5 - 2, place / 25 - 19.5, place / 5 % 5 - 2}},
                               {"scale", {0.35, 0.35, 0.35}}});
  }
  return glb(w);
}

// Hue to the right, lightness upwards; every second row of metal.
std::vector<uint8_t> palette() {
  constexpr int columns = 40, rows = 25;
  GlbWriter w = startGlb();
  const nlohmann::json sphere = addShape(w, sphereShape(12, 16));
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double hue = 2 * pi * column / columns, light = 0.1 + 0.8 * row / (rows - 1);
      const glm::dvec3 color = light * (0.5 + 0.5 * glm::cos(hue - 2 * pi / 3 * glm::dvec3(0, 1, 2)));
      const std::string name = label("column %.0f, row %.0f", column, row);
      const int material = addMaterial(w, name, color, row % 2, 0.1 + 0.8 * column / (columns - 1));
      const glm::dvec3 at(column - (columns - 1) / 2.0, row - (rows - 1) / 2.0, 0);
      addNode(w, placed(name, addMesh(w, name, sphere, material), at, 0.45));
    }
  return glb(w);
}

// What glTF has no words for: read by our loader alone.
void setModels(GlbWriter& w, int material, nlohmann::json models) {
  constexpr const char* extension = "FACET_materials_models";
  useExtension(w, extension);
  w.gltf["materials"][size_t(material)]["extensions"][extension] = std::move(models);
}

std::vector<uint8_t> distributions() {
  constexpr int steps = 6;
  GlbWriter w = startGlb();
  const nlohmann::json sphere = addShape(w, sphereShape(64, 128));
  double y = 1;
  for (const char* microfacets : {"ggx", "beckmann", "blinn"}) {
    for (int i = 0; i < steps; ++i) {
      const double perceptualRoughness = 0.15 + 0.17 * i;
      const std::string name = microfacets + label(", roughness %.2f", perceptualRoughness, 0);
      const int material = addMaterial(w, name, {0.9, 0.9, 0.9}, 1, perceptualRoughness);
      setModels(w, material, {{"microfacets", microfacets}});
      addNode(w, placed(name, addMesh(w, name, sphere, material), {i - (steps - 1) / 2.0, y, 0}, 0.45));
    }
    y -= 1;
  }
  addPointLight(w, "the light", {-4, 5, 8}, 150);
  return glb(w);
}

std::vector<uint8_t> metals() {
  constexpr int columns = 4;
  GlbWriter w = startGlb();
  const nlohmann::json sphere = addShape(w, sphereShape(48, 96));
  int i = 0;
  for (const optics::MetalPreset& metal : optics::metalPresets()) {
    const std::string name(metal.name);
    const int material = addMaterial(w, name, metal.f0(), 1, 0.2);
    setModels(w, material, {{"conductor", name}});
    const glm::dvec3 at(i % columns - (columns - 1) / 2.0, 1 - i / columns, 0);
    addNode(w, placed(name, addMesh(w, name, sphere, material), at, 0.45));
    ++i;
  }
  return glb(w);
}

// ---- poster ---------------------------------------------------------------------------------------------------------

struct Ball {
  const char* name;
  double x, z, radius;  // rests on the ground
  glm::dvec3 baseColor;
  double metallic, perceptualRoughness;
};

constexpr std::array<Ball, 9> balls = {{
    {"ruby lacquer", -1.62, 0.62, 0.46, {0.52, 0.012, 0.022}, 0, 0.06},
    {"brushed steel", 1.55, 0.35, 0.52, {0.66, 0.67, 0.70}, 1, 0.34},
    {"plaster", -1.38, -1.10, 0.62, {0.82, 0.79, 0.74}, 0, 0.92},
    {"deep blue glaze", 1.62, -1.25, 0.72, {0.012, 0.045, 0.30}, 0, 0.12},
    {"chrome", -0.66, 1.42, 0.27, {0.80, 0.81, 0.82}, 1, 0.02},
    {"copper", 0.62, 1.50, 0.31, {0.95, 0.56, 0.42}, 1, 0.20},
    {"jade", 1.30, 1.42, 0.17, {0.05, 0.36, 0.20}, 0, 0.25},
    {"amber", -0.10, 1.72, 0.13, {0.90, 0.36, 0.02}, 0, 0.10},
    {"anodised violet", -1.25, 1.58, 0.15, {0.35, 0.12, 0.62}, 1, 0.28},
}};

constexpr double knotScale = 0.80, knotTube = 0.29;  // tube radius before scaling
constexpr double knotTilt = 14;                      // degrees, leaning back

// The knot stands on the ground: turned so that one lobe points up, leaning back, lowest point at y = 0.
struct KnotPlace {
  glm::dmat3 rotation;
  glm::dvec3 translation;
};

KnotPlace placeKnot() {
  const double roll = pi / 2, tilt = -knotTilt * pi / 180;
  const glm::dmat3 rollZ(std::cos(roll), std::sin(roll), 0, -std::sin(roll), std::cos(roll), 0, 0, 0, 1);
  const glm::dmat3 tiltX(1, 0, 0, 0, std::cos(tilt), std::sin(tilt), 0, -std::sin(tilt), std::cos(tilt));
  KnotPlace place{tiltX * rollZ, glm::dvec3(0)};
  double lowest = 0;
  for (int i = 0; i < 1000; ++i) lowest = std::min(lowest, (place.rotation * torusKnotPoint(i / 1000.0)).y);
  place.translation = {0, (knotTube - lowest) * knotScale, -0.25};
  return place;
}

// Share of the sky that a level point sees past spheres above the ground. One sphere of radius r, centre at distance d
// and height h, takes (h / d) (r / d)^2 of the cosine-weighted hemisphere: the exact form factor while it lies wholly
// above the horizon. Several are combined as if independent.
struct Occluder {
  glm::dvec3 center;
  double radius;
  double weight;  // exponent: 1 for a sphere; a tube of spheres a step s apart counts as s 2r / (pi r^2) each
};

std::vector<Occluder> posterOccluders(const KnotPlace& knot) {
  std::vector<Occluder> occluders;
  for (const Ball& ball : balls) occluders.push_back({{ball.x, ball.radius, ball.z}, ball.radius, 1});
  constexpr int steps = 48;
  for (int i = 0; i < steps; ++i) {
    const double t = double(i) / steps, radius = knotTube * knotScale;
    const glm::dvec3 here = knot.rotation * torusKnotPoint(t) * knotScale + knot.translation;
    const double step = glm::distance(torusKnotPoint(t), torusKnotPoint(t + 1.0 / steps)) * knotScale;
    occluders.push_back({here, radius, 2 * step / (pi * radius)});
  }
  return occluders;
}

void occlude(Shape& ground, const std::vector<Occluder>& occluders) {
  ground.colors.resize(ground.positions.size());
  constexpr size_t block = 1024;
  const size_t count = ground.positions.size();
  parallelFor((count + block - 1) / block, [&](size_t b) {
    for (size_t i = b * block; i < std::min(count, (b + 1) * block); ++i) {
      double open = 1;
      for (const Occluder& o : occluders) {
        const glm::dvec3 to = o.center - glm::dvec3(ground.positions[i]);
        const double d2 = std::max(glm::dot(to, to), o.radius * o.radius);
        const double taken = std::min(to.y * o.radius * o.radius / (d2 * std::sqrt(d2)), 0.999);
        open *= o.weight == 1 ? 1 - taken : std::pow(1 - taken, o.weight);
      }
      ground.colors[i] = glm::vec4(glm::vec3(float(open)), 1);
    }
  });
}

std::vector<uint8_t> poster() {
  GlbWriter w = startGlb();
  const KnotPlace knot = placeKnot();
  const glm::dquat turn = glm::quat_cast(knot.rotation);
  const int gold = addMaterial(w, "polished gold", {1.00, 0.76, 0.33}, 1, 0.11);
  const int knotMesh = addMesh(w, "trefoil", addShape(w, torusKnotShape(knotTube, 420, 48)), gold);
  nlohmann::json knotNode = placed("trefoil", knotMesh, knot.translation, knotScale);
  knotNode["rotation"] = {turn.x, turn.y, turn.z, turn.w};
  addNode(w, knotNode);

  const nlohmann::json sphere = addShape(w, sphereShape(48, 96));
  for (const Ball& ball : balls) {
    const int material = addMaterial(w, ball.name, ball.baseColor, ball.metallic, ball.perceptualRoughness);
    const int mesh = addMesh(w, ball.name, sphere, material);
    addNode(w, placed(ball.name, mesh, {ball.x, ball.radius, ball.z}, ball.radius));
  }

  Shape ground = discShape(2.9, 0.10, 110, 200);
  occlude(ground, posterOccluders(knot));
  const int stone = addMaterial(w, "stone", {0.36, 0.355, 0.35}, 0, 0.6);
  addNode(w, {{"name", "turntable"}, {"mesh", addMesh(w, "turntable", addShape(w, ground), stone)}});
  return glb(w);
}

}  // namespace

std::span<const BuiltinScene> builtinScenes() { return scenes; }

const BuiltinScene* findBuiltinScene(std::string_view name) {
  constexpr std::string_view prefix = "builtin:";
  if (name.starts_with(prefix)) name.remove_prefix(prefix.size());
  const auto found = std::find_if(scenes.begin(), scenes.end(), [&](const BuiltinScene& s) { return s.name == name; });
  return found == scenes.end() ? nullptr : &*found;
}

Result<std::vector<uint8_t>> builtinScene(std::string_view name) {
  const BuiltinScene* scene = findBuiltinScene(name);
  if (!scene) {
    std::string known;
    for (const BuiltinScene& s : scenes) known += (known.empty() ? "" : ", ") + std::string(s.name);
    return fail(std::string(name), "", "there is no such built-in scene", "choose one of " + known);
  }
  if (scene->name == "spheres") return spheres();
  if (scene->name == "tutorial") return tutorial();
  if (scene->name == "furnace") return furnace();
  if (scene->name == "crowd") return crowd();
  if (scene->name == "palette") return palette();
  if (scene->name == "marbles") return marbles();
  if (scene->name == "robot") return robot();
  if (scene->name == "ndf") return distributions();
  if (scene->name == "metals") return metals();
  return poster();
}

}  // namespace facet::scene
