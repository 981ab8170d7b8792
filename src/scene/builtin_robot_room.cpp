#include "scene/builtin_robot_room.hpp"

#include <cmath>
#include <string>

#include "base/angle.hpp"
#include "scene/make/lsystem.hpp"
#include "scene/make/sweep.hpp"
#include "scene/make/textures.hpp"
#include "scene/png_writer.hpp"

namespace facet::scene {

namespace {

struct Surfaces {
  int brick, plate, concrete, leaf, pot;
};

nlohmann::json textured(GlbWriter& w, const RgbTexels& texels) {
  return {{"index", addPngTexture(w, rgbPng(texels.width, texels.height, texels.rgb))}};
}

Surfaces addSurfaces(GlbWriter& w) {
  constexpr int size = 256;
  constexpr uint32_t seed = 7;
  const auto material = [&](int index) -> nlohmann::json& { return w.gltf["materials"][size_t(index)]; };
  Surfaces m{};
  m.brick = addMaterial(w, "brick", {1, 1, 1}, 0, 0.85);
  material(m.brick)["pbrMetallicRoughness"]["baseColorTexture"] = textured(w, brickColors(size, seed));
  material(m.brick)["normalTexture"] = textured(w, normalTexels(brickHeights(size, seed)));
  m.plate = addMaterial(w, "tread plate", {0.55, 0.56, 0.57}, 1, 0.38);
  material(m.plate)["normalTexture"] = textured(w, normalTexels(treadPlateHeights(size)));
  m.concrete = addMaterial(w, "concrete", {1, 1, 1}, 0, 0.9);
  material(m.concrete)["pbrMetallicRoughness"]["baseColorTexture"] = textured(w, concreteColors(size, seed));
  material(m.concrete)["normalTexture"] = textured(w, normalTexels(concreteHeights(size, seed)));
  m.leaf = addMaterial(w, "plant", {0.10, 0.26, 0.06}, 0, 0.6);
  m.pot = addMaterial(w, "pot", {0.42, 0.20, 0.12}, 0, 0.7);
  return m;
}

constexpr double roomHalf = 3, roomLength = 7, roomHeight = 3.2;
constexpr double corridorHalf = 1.2, corridorLength = 18, corridorHeight = 2.6, doorHalf = 0.8, doorHeight = 2.25;
constexpr int corridorLamps = 6, roomLamps = 2;

Shape walls() {
  Shape s;
  const auto wall = [&](const glm::dvec3& corner, const glm::dvec3& along, double height) {
    append(s, rectangleShape(corner, along, {0, height, 0}));
  };
  wall({-roomHalf, 0, 0}, {0, 0, -roomLength}, roomHeight);
  wall({roomHalf, 0, -roomLength}, {0, 0, roomLength}, roomHeight);
  wall({-roomHalf, 0, -roomLength}, {2 * roomHalf, 0, 0}, roomHeight);
  wall({roomHalf, 0, 0}, {doorHalf - roomHalf, 0, 0}, roomHeight);
  wall({-doorHalf, 0, 0}, {doorHalf - roomHalf, 0, 0}, roomHeight);
  wall({doorHalf, doorHeight, 0}, {-2 * doorHalf, 0, 0}, roomHeight - doorHeight);
  wall({-corridorHalf, 0, corridorLength}, {0, 0, -corridorLength}, corridorHeight);
  wall({corridorHalf, 0, 0}, {0, 0, corridorLength}, corridorHeight);
  wall({corridorHalf, 0, corridorLength}, {-2 * corridorHalf, 0, 0}, corridorHeight);
  wall({-corridorHalf, 0, 0}, {corridorHalf - doorHalf, 0, 0}, corridorHeight);
  wall({doorHalf, 0, 0}, {corridorHalf - doorHalf, 0, 0}, corridorHeight);
  wall({-doorHalf, doorHeight, 0}, {2 * doorHalf, 0, 0}, corridorHeight - doorHeight);
  return s;
}

Shape floors() {
  Shape s = rectangleShape({-roomHalf, 0, 0}, {2 * roomHalf, 0, 0}, {0, 0, -roomLength}, 2);
  append(s, rectangleShape({-corridorHalf, 0, corridorLength}, {2 * corridorHalf, 0, 0}, {0, 0, -corridorLength}, 2));
  return s;
}

Shape ceilings() {
  Shape s = rectangleShape({-roomHalf, roomHeight, -roomLength}, {2 * roomHalf, 0, 0}, {0, 0, roomLength}, 0.5);
  append(s, rectangleShape({-corridorHalf, corridorHeight, 0}, {2 * corridorHalf, 0, 0}, {0, 0, corridorLength}, 0.5));
  return s;
}

// Two along the corridor's ceiling, which rise at its end; their clamps.
Shape pipes() {
  Shape s;
  for (const double x : {-0.95, -0.78}) {
    Path path = {{x, 2.42, 0.05}};
    for (const glm::dvec3& p :
         arcPath({x, 1.92, corridorLength - 0.7}, {1, 0, 0}, {x, 2.42, corridorLength - 0.7}, pi / 2, 12))
      path.push_back(p);
    path.push_back({x, 0, corridorLength - 0.2});
    append(s, sweep(polygonProfile(16, x < -0.9 ? 0.06 : 0.045), floorsAlong(pathFrames(path, {1, 0, 0})),
                    {.smooth = true}));
  }
  for (double z = 1.5; z < corridorLength - 1; z += 1.5)
    append(s, moved(boxShape({0.40, 0.03, 0.05}, 0.006), {-0.87, 2.49, z}));
  return s;
}

Shape doorFrame() {
  Shape s;
  for (const double side : {-1.0, 1.0})
    append(s, moved(boxShape({0.10, doorHeight + 0.05, 0.16}, 0.012),
                    {side * (doorHalf + 0.03), (doorHeight + 0.05) / 2, 0}));
  append(s, moved(boxShape({2 * doorHalf + 0.16, 0.10, 0.16}, 0.012), {0, doorHeight + 0.05, 0}));
  return s;
}

// A bush by chance, of one rule for its tips and one for its stem.
Shape plant() {
  constexpr Rule rules[] = {
      {'A', "[&F\"!A]////[&F\"!A]////[&F\"!A]", 2}, {'A', "F[+&\"!A]//[-&\"!A]", 1}, {'F', "F/", 3}, {'F', "F/F", 1}};
  const std::string word = derive("FA", rules, 5, 11);
  Shape s;
  for (const Branch& branch : branchesOf(word, {.step = 0.16, .angle = 28, .radius = 0.022, .narrowing = 0.75})) {
    std::vector<Floor> stations = floorsAlong(pathFrames(branch.points, {1, 0, 0}));
    for (size_t i = 0; i < stations.size(); ++i) stations[i].scale = glm::dvec2(branch.radii[i]);
    stations.back().scale *= 0.4;
    append(s, sweep(polygonProfile(6, 1), stations, {.smooth = true}));
  }
  return s;
}

glm::dvec3 lampPlace(int lamp) {
  if (lamp < roomLamps) return {0, roomHeight - 0.04, lamp == 0 ? -5.2 : -2.0};
  return {0.15, corridorHeight - 0.04, 1.6 + 3.0 * (lamp - roomLamps)};
}
constexpr glm::dvec3 lampColor(1, 0.82, 0.58);
constexpr double lampGlow = 1.6;
double candelaOf(int lamp) { return lamp < roomLamps ? 20 : 10; }

void addWalls(GlbWriter& w, const Surfaces& m, int steel) {
  const auto thing = [&](const std::string& name, Shape shape, int material) {
    addNode(w, {{"name", name}, {"mesh", addMesh(w, name, addShape(w, shape), material)}});
  };
  thing("walls", walls(), m.brick);
  thing("floors", floors(), m.plate);
  thing("ceilings", ceilings(), m.concrete);
  thing("pipes", pipes(), steel);
  thing("door frame", doorFrame(), steel);
  const int bush = addMesh(
      w, "plant",
      {{moved(plant(), {0, 0.30, 0}), m.leaf},
       {turnedShape(
            {{0, 0}, {0.15, 0}, {0.21, 0.30}, {0.23, 0.30}, {0.23, 0.34}, {0.19, 0.34}, {0.18, 0.29}, {0, 0.29}}, 24,
            false),
        m.pot}});
  addNode(w, nodeAt("plant", {-2.2, 0, -6.1}, bush));
}

std::vector<RoomLamp> addLamps(GlbWriter& w, int dark) {
  std::vector<RoomLamp> lamps;
  const nlohmann::json housing = addShape(w, moved(boxShape({0.34, 0.06, 0.70}, 0.012), {0, 0.02, 0}));
  const nlohmann::json tube = addShape(w, moved(boxShape({0.26, 0.03, 0.62}, 0.010), {0, -0.02, 0}));
  for (int i = 0; i < roomLamps + corridorLamps; ++i) {
    const std::string name = "lamp " + std::to_string(i + 1);
    const int material = addMaterial(w, name, {0.8, 0.8, 0.8}, 0, 0.5);
    setGlow(w, material, lampColor, lampGlow);
    const int mesh = addMesh(w, name, {{housing, dark}, {tube, material}});
    const glm::dvec3 place = lampPlace(i);
    const int node = addNode(w, nodeAt(name, place, mesh));
    const int light = addLight(w, name, candelaOf(i));
    w.gltf["extensions"]["KHR_lights_punctual"]["lights"][size_t(light)]["color"] = {lampColor.r, lampColor.g,
                                                                                     lampColor.b};
    nlohmann::json below = nodeAt(name + " light", {0, -0.12, 0});
    below["extensions"]["KHR_lights_punctual"]["light"] = light;
    addChild(w, node, below);
    lamps.push_back({place.z, light, material, candelaOf(i), lampColor});
  }
  return lamps;
}

}  // namespace

std::vector<RoomLamp> addRobotRoom(GlbWriter& w, int steel, int dark) {
  addWalls(w, addSurfaces(w), steel);
  return addLamps(w, dark);
}

}  // namespace facet::scene
