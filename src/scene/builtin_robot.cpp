#include "scene/builtin_robot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <string>

#include "base/angle.hpp"
#include "scene/builtin_robot_room.hpp"
#include "scene/glb_writer.hpp"
#include "scene/make/sweep.hpp"

namespace facet::scene {

namespace {

using Json = nlohmann::json;

struct Paints {
  int orange, dark, steel, rubber, eyes;
};

Paints addPaints(GlbWriter& w) {
  Paints m{};
  m.orange = addMaterial(w, "orange paint", {0.80, 0.26, 0.03}, 0, 0.35);
  useExtension(w, "KHR_materials_clearcoat");
  w.gltf["materials"][size_t(m.orange)]["extensions"]["KHR_materials_clearcoat"] = {{"clearcoatFactor", 0.8},
                                                                                    {"clearcoatRoughnessFactor", 0.08}};
  m.dark = addMaterial(w, "graphite paint", {0.045, 0.048, 0.055}, 0, 0.45);
  m.steel = addMaterial(w, "steel", {0.62, 0.61, 0.59}, 1, 0.28);
  m.rubber = addMaterial(w, "rubber", {0.025, 0.025, 0.025}, 0, 0.8);
  m.eyes = addMaterial(w, "eyes", {0.02, 0.02, 0.02}, 0, 0.1);
  setGlow(w, m.eyes, {0.25, 0.85, 1}, 4);
  return m;
}

// ---- The robot ------------------------------------------------------------------------------------------------------

constexpr double hipAcross = 0.115, shoulderAcross = 0.275, shoulderHeight = 0.44, headHeight = 0.58;
constexpr double upperArm = 0.29, forearm = 0.27;

// Hangs from its joint: (depth below it, radius) from the joint down, swept with chamfered edges.
Shape limb(const std::vector<glm::dvec2>& outline) {
  std::vector<glm::dvec2> heights;
  for (auto place = outline.rbegin(); place != outline.rend(); ++place) heights.emplace_back(-place->x, place->y);
  return sweep(polygonProfile(8, 1, 0.5), tower(heights));
}

Shape ball(double radius) {
  std::vector<glm::dvec2> outline;
  constexpr int steps = 8;
  for (int i = 0; i <= steps; ++i) {
    const double angle = pi * i / steps;
    outline.emplace_back(i == 0 || i == steps ? 0 : radius * std::sin(angle), -radius * std::cos(angle));
  }
  return turnedShape(outline, 16, true);
}

// A spring around the Y axis, from 0 up.
Shape spring(double radius, double height, double turns, double wire) {
  const Path path = helixPath(radius, height / turns, turns, int(turns * 16));
  return sweep(polygonProfile(6, wire), floorsAlong(pathFrames(path, {0, 1, 0})), {.smooth = true});
}

struct Robot {
  int root, hips, torso, head;
  std::array<int, 2> thigh, shin, foot, arm, elbow;  // left, right
};

Robot addRobot(GlbWriter& w, const Paints& m) {
  const Gait& g = robotGait;
  const int pelvis = addMesh(
      w, "pelvis",
      {{moved(boxShape({0.26, 0.12, 0.20}, 0.03), {0, 0.03, 0}), m.dark}, {moved(ball(0.075), {0, 0.10, 0}), m.steel}});
  Shape chest = sweep(rectangleProfile(0.24, 0.36, 0.06),
                      tower({{0.08, 0.62}, {0.12, 0.72}, {0.30, 1.0}, {0.46, 1.05}, {0.52, 0.8}, {0.54, 0.5}}));
  const int torso = addMesh(w, "torso",
                            {{std::move(chest), m.orange},
                             {moved(boxShape({0.17, 0.10, 0.03}, 0.008), {0, 0.36, 0.125}), m.dark},
                             {moved(spring(0.052, 0.10, 5, 0.010), {0, 0.0, 0}), m.steel}});
  Shape skull = sweep(rectangleProfile(0.20, 0.22, 0.05),
                      tower({{0.03, 0.55}, {0.06, 0.85}, {0.10, 1}, {0.20, 1}, {0.25, 0.8}, {0.27, 0.45}}));
  Shape eyes = moved(ball(0.026), {-0.05, 0.155, 0.092});
  append(eyes, moved(ball(0.026), {0.05, 0.155, 0.092}));
  const int head = addMesh(w, "head",
                           {{std::move(skull), m.orange},
                            {std::move(eyes), m.eyes},
                            {moved(spring(0.035, 0.07, 4, 0.008), {0, -0.03, 0}), m.steel},
                            {moved(limb({{-0.14, 0.004}, {0, 0.006}}), {0.07, 0.25, -0.02}), m.steel}});
  const int thigh =
      addMesh(w, "thigh",
              {{limb({{0.04, 0.055}, {0.07, 0.075}, {0.34, 0.058}, {0.38, 0.045}}), m.orange}, {ball(0.065), m.steel}});
  const int shin =
      addMesh(w, "shin",
              {{limb({{0.03, 0.042}, {0.06, 0.058}, {0.20, 0.062}, {0.38, 0.040}}), m.orange}, {ball(0.055), m.steel}});
  const int foot = addMesh(w, "foot",
                           {{moved(boxShape({0.11, 0.05, 0.27}, 0.015), {0, -g.ankle + 0.045, 0.045}), m.dark},
                            {moved(boxShape({0.12, 0.02, 0.29}, 0.006), {0, -g.ankle + 0.010, 0.045}), m.rubber},
                            {ball(0.045), m.steel}});
  const int upper =
      addMesh(w, "upper arm",
              {{limb({{0.03, 0.040}, {0.06, 0.052}, {0.24, 0.042}, {0.26, 0.034}}), m.orange}, {ball(0.058), m.steel}});
  const int lower = addMesh(w, "forearm",
                            {{limb({{0.03, 0.034}, {0.06, 0.046}, {0.20, 0.040}, {0.25, 0.030}}), m.orange},
                             {ball(0.044), m.steel},
                             {moved(boxShape({0.05, 0.09, 0.07}, 0.012), {0, -0.29, 0}), m.dark}});

  Robot r{};
  r.root = addNode(w, nodeAt("robot", {0, 0, robotStart}));
  r.hips = addChild(w, r.root, nodeAt("hips", {0, g.hip, 0}, pelvis));
  r.torso = addChild(w, r.hips, nodeAt("torso", {0, 0.06, 0}, torso));
  r.head = addChild(w, r.torso, nodeAt("head", {0, headHeight, 0}, head));
  for (size_t side = 0; side < 2; ++side) {
    const std::string name = side == 0 ? "left " : "right ";
    const double out = side == 0 ? 1 : -1;  // it looks along +Z: its left is +X
    r.thigh[side] = addChild(w, r.hips, nodeAt(name + "hip", {out * hipAcross, 0, 0}, thigh));
    r.shin[side] = addChild(w, r.thigh[side], nodeAt(name + "knee", {0, -g.thigh, 0}, shin));
    r.foot[side] = addChild(w, r.shin[side], nodeAt(name + "ankle", {0, -g.shin, 0}, foot));
    r.arm[side] = addChild(w, r.torso, nodeAt(name + "shoulder", {out * shoulderAcross, shoulderHeight, 0}, upper));
    r.elbow[side] = addChild(w, r.arm[side], nodeAt(name + "elbow", {0, -upperArm, 0}, lower));
  }
  return r;
}

// ---- The film -------------------------------------------------------------------------------------------------------

constexpr int keysPerPeriod = 48;
constexpr double cameraAhead = 3.1, cameraHeight = 1.25, cameraArm = 0.42;

struct Rig {
  int base, turning, arm;
};
Rig addCamera(GlbWriter& w) {
  w.gltf["cameras"].push_back(
      {{"name", "film"}, {"type", "perspective"}, {"perspective", {{"yfov", 0.82}, {"znear", 0.05}, {"zfar", 60}}}});
  Rig rig{};
  rig.base = addNode(w, nodeAt("rig", {0, cameraHeight, robotStart + cameraAhead}));
  rig.turning = addChild(w, rig.base, nodeAt("first joint", {0, 0, 0}));
  rig.arm = addChild(w, rig.turning, nodeAt("second joint", {cameraArm, 0, 0}));
  Json camera = nodeAt("film", {0, 0, 0});
  camera["camera"] = 0;
  addChild(w, rig.arm, camera);
  return rig;
}

// 0 to 1: a tube that flickers once when it comes on, as the robot is near; all go out at the end, so that the film
// begins as it ends.
double lampShare(const RoomLamp& lamp, double time) {
  const double arrival = (lamp.z - robotStart - 5.0) * robotGait.period / robotGait.stride;
  const double since = time - std::max(arrival, 0.4);
  const double on = since < 0 ? 0 : since < 0.1 ? since / 0.1 * 0.7 : since < 0.25 ? 0.15 : std::min(1.0, since / 0.45);
  return on * std::clamp((robotFilm - 0.1 - time) / 0.8, 0.0, 1.0);
}

class Film {
 public:
  explicit Film(int count) : count_(count) {}
  void rotation(int node, double angle, const glm::dvec3& axis) {
    const glm::dquat q = glm::angleAxis(angle, axis);
    add(node, "rotation", {q.x, q.y, q.z, q.w}, 4);
  }
  void translation(int node, const glm::dvec3& t) { add(node, "translation", {t.x, t.y, t.z, 0}, 3); }
  void pointer(const std::string& path, const glm::dvec3& value, int width) {
    add(-1, path, {value.x, value.y, value.z, 0}, width);
  }
  std::vector<Track> tracks() {
    std::vector<Track> all;
    for (auto& [key, track] : tracks_) all.push_back(std::move(track));
    return all;
  }

 private:
  void add(int node, const std::string& path, const glm::dvec4& value, int width) {
    Track& track = tracks_[{node, path}];
    if (track.values.empty()) track = {node, path, width, {}}, track.values.reserve(size_t(count_ * width));
    for (int i = 0; i < width; ++i) track.values.push_back(float(value[i]));
  }
  int count_;
  std::map<std::pair<int, std::string>, Track> tracks_;
};

void poseRobot(Film& film, const Robot& r, double time) {
  const Gait& g = robotGait;
  constexpr glm::dvec3 X(1, 0, 0), Y(0, 1, 0);
  film.translation(r.root, {0, 0, robotStart + bodyZ(g, time)});
  film.translation(r.hips, {0, hipHeight(g, time), 0});
  for (size_t side = 0; side < 2; ++side) {
    const double phase = side == 0 ? 0 : 0.5;
    const LegAngles legs = legAngles(g, time, phase);
    film.rotation(r.thigh[side], -legs.thigh, X);  // about +X what hangs down goes to -Z
    film.rotation(r.shin[side], legs.thigh - legs.shin, X);
    film.rotation(r.foot[side], legs.shin, X);
    const double swing = 0.42 * std::cos(2 * pi * (time / g.period + phase - g.stance / 2 + 0.25));
    film.rotation(r.arm[side], swing + 0.05, X);
    film.rotation(r.elbow[side], -0.45 - 0.25 * std::max(0.0, swing), X);
  }
  const double twist = 0.10 * std::cos(2 * pi * (time / g.period - g.stance / 2 + 0.25));
  film.rotation(r.torso, twist, Y);
  film.rotation(r.head, -twist + 0.12 * std::sin(2 * pi * time / 8), Y);
}

void poseCamera(Film& film, const Rig& rig, double time) {
  constexpr glm::dvec3 Y(0, 1, 0);
  const double turn = 2 * pi * time / 12;
  film.translation(rig.base, {0, cameraHeight, robotStart + bodyZ(robotGait, time) + cameraAhead});
  film.rotation(rig.turning, turn, Y);
  // Against the first joint, and as much as it takes to look at the robot.
  const double x = cameraArm * std::cos(turn), z = cameraAhead - cameraArm * std::sin(turn);
  film.rotation(rig.arm, -turn + std::atan2(x, z), Y);
}

}  // namespace

std::vector<uint8_t> robot() {
  GlbWriter w = startGlb();
  const Paints paints = addPaints(w);
  const Robot body = addRobot(w, paints);
  const std::vector<RoomLamp> lamps = addRobotRoom(w, paints.steel, paints.dark);
  const Rig rig = addCamera(w);

  const int count = int(std::lround(robotFilm / robotGait.period)) * keysPerPeriod;
  std::vector<float> times;
  Film film(count + 1);
  for (int i = 0; i <= count; ++i) {
    const double time = robotFilm * i / count;
    times.push_back(float(time));
    poseRobot(film, body, time);
    poseCamera(film, rig, time);
    for (const RoomLamp& lamp : lamps) {
      const double share = lampShare(lamp, time);
      film.pointer("/extensions/KHR_lights_punctual/lights/" + std::to_string(lamp.light) + "/intensity",
                   glm::dvec3(share * lamp.candela), 1);
      film.pointer("/materials/" + std::to_string(lamp.material) + "/emissiveFactor", share * lamp.color, 3);
    }
  }
  addAnimation(w, "walk", times, film.tracks());
  return glb(w);
}

}  // namespace facet::scene
