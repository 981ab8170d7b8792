#include "scene/builtin_robot.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "base/angle.hpp"
#include "io/sources.hpp"
#include "scene/animation.hpp"
#include "scene/nodes.hpp"
#include "support/shape_measures.hpp"

using namespace facet;
using namespace facet::scene;

namespace {

int nodeCalled(const Model& model, const std::string& name) {
  for (size_t i = 0; i < model.nodes.size(); ++i)
    if (model.nodes[i].name == name) return static_cast<int>(i);
  FAIL("no node " << name);
  return -1;
}

}  // namespace

TEST_CASE("Walk: feet are where they were set down, legs reach them, nothing jumps") {
  const Gait g = robotGait;
  for (const double phase : {0.0, 0.5}) {
    LegAngles before = legAngles(g, 0, phase);
    AnklePlace was = anklePlace(g, 0, phase);
    int down = 0;
    constexpr int steps = 4000;
    for (int i = 1; i <= steps; ++i) {
      const double time = 2 * g.period * i / steps;
      const AnklePlace ankle = anklePlace(g, time, phase);
      const LegAngles legs = legAngles(g, time, phase);
      const double z = bodyZ(g, time) + g.thigh * std::sin(legs.thigh) + g.shin * std::sin(legs.shin);
      const double y = hipHeight(g, time) - g.thigh * std::cos(legs.thigh) - g.shin * std::cos(legs.shin);
      CHECK(z == Approx(ankle.z).margin(1e-9));
      CHECK(y == Approx(ankle.y).margin(1e-9));
      CHECK(legs.shin < legs.thigh);  // knees bend forwards
      CHECK(ankle.y >= g.ankle);
      if (ankle.down && was.down) CHECK(ankle.z == Approx(was.z).margin(1e-12));
      CHECK(std::abs(ankle.z - was.z) < 3 * 2 * g.stride / steps * 2.5);
      CHECK(std::abs(legs.thigh - before.thigh) + std::abs(legs.shin - before.shin) < 0.02);
      down += ankle.down ? 1 : 0;
      before = legs, was = ankle;
    }
    CHECK(down / double(steps) == Approx(g.stance).margin(0.01));
  }
}

TEST_CASE("builtin:robot: its feet do not slip, also between the keys") {
  const Result<io::LoadedModel> loaded = io::loadModel("builtin:robot");
  REQUIRE(loaded);
  CHECK(loaded->notes.empty());
  const Model& model = loaded->model;
  REQUIRE(model.animations.size() == 1);
  CHECK(duration(model.animations[0]) == Approx(robotFilm));
  const int animation[] = {0};
  double slip = 0, above = 0;
  for (const auto& [name, phase] : {std::pair("left ankle", 0.0), std::pair("right ankle", 0.5)}) {
    const int node = nodeCalled(model, name);
    std::map<int, glm::dvec3> first;  // of each stance
    constexpr int steps = 1111;       // no multiple of the keys
    for (int i = 0; i < steps; ++i) {
      const double time = 4.8 * (i + 0.37) / steps;
      const NodeTransforms placed = worldTransforms(model, 0, poseAt(model, animation, time));
      const glm::dvec3 at(placed.worldFromNode[size_t(node)][3]);
      CHECK(at.y > robotGait.ankle - 0.01);
      if (!anklePlace(robotGait, time, phase).down) continue;
      const int stance = static_cast<int>(std::floor(time / robotGait.period + phase));
      const glm::dvec3& there = first.try_emplace(stance, at).first->second;
      slip = std::max(slip, glm::distance(at, there));
      above = std::max(above, std::abs(at.y - robotGait.ankle));
    }
    CHECK(first.size() >= 4);
  }
  INFO("slips by " << slip << " m, off the ground by " << above);
  CHECK(slip < 0.01);
  CHECK(above < 0.005);
}

TEST_CASE("builtin:robot: lamps come on one after another and are out at both ends, the film ends as it begins") {
  const Result<io::LoadedModel> loaded = io::loadModel("builtin:robot");
  REQUIRE(loaded);
  const Model& model = loaded->model;
  const int animation[] = {0};
  const auto burning = [&](double time) {
    const Pose pose = poseAt(model, animation, time);
    int count = 0;
    for (size_t i = 0; i < model.lights.size(); ++i)
      count += pose.lights.of(model.lights, static_cast<int>(i)).intensity > 0.5 ? 1 : 0;
    return count;
  };
  CHECK(model.lights.size() == 8);
  CHECK(burning(0) == 0);
  int before = 0;
  for (const double time : {1.5, 4.0, 8.0, 12.0, 16.0, 20.0, 22.9}) {
    CHECK(burning(time) >= before);
    before = burning(time);
  }
  CHECK(before == 8);
  CHECK(burning(robotFilm) == 0);
  const NodeTransforms start = worldTransforms(model, 0, poseAt(model, animation, 0)),
                       end = worldTransforms(model, 0, poseAt(model, animation, robotFilm));
  const int root = nodeCalled(model, "robot");
  const glm::dmat4 back =
      glm::inverse(end.worldFromNode[size_t(root)]) * end.worldFromNode[size_t(nodeCalled(model, "left ankle"))];
  const glm::dmat4 there =
      glm::inverse(start.worldFromNode[size_t(root)]) * start.worldFromNode[size_t(nodeCalled(model, "left ankle"))];
  for (int c = 0; c < 4; ++c) CHECK(glm::distance(back[c], there[c]) < 1e-4);
  // The camera looks at it, from before it, all the time.
  const int camera = nodeCalled(model, "film");
  for (double time = 0; time < robotFilm; time += 0.7) {
    const NodeTransforms placed = worldTransforms(model, 0, poseAt(model, animation, time));
    const glm::dmat4& view = placed.worldFromNode[size_t(camera)];
    const glm::dvec3 to =
        glm::dvec3(placed.worldFromNode[size_t(root)][3]) + glm::dvec3(0, 1.25, 0) - glm::dvec3(view[3]);
    CHECK(glm::dot(glm::normalize(to), -glm::dvec3(view[2])) > std::cos(2 * pi / 180));
    CHECK(std::abs(view[3].x) < 1.1);
  }
}
