#include "frame/visibility.hpp"

#include <catch2/catch.hpp>
#include <random>

using namespace facet;
using frame::Draw;

namespace {

// A list of unit boxes around the given points: one instanced draw.
frame::DrawList boxes(const std::vector<glm::dvec3>& centers) {
  frame::DrawList list;
  Draw draw;
  draw.instanceCount = static_cast<uint32_t>(centers.size());
  list.opaque.push_back(draw);
  for (const glm::dvec3& center : centers) {
    list.instances.emplace_back();
    list.instanceBounds.push_back({center - 0.5, center + 0.5});
    list.bounds.add(center - 0.5), list.bounds.add(center + 0.5);
  }
  return list;
}

// From +Z at z = 10 towards the origin: 90 degrees, so that at depth d one sees d to each side.
scene::View lookingDown(double aspect = 1) {
  return scene::orbitView({.radius = 10, .fovY = 90}, aspect, {glm::dvec3(-1), glm::dvec3(1)});
}

std::vector<uint32_t> visible(const frame::DrawList& list, const scene::View& view, const frame::ClipRows& rows = {}) {
  return frame::visibleDraws(list, view, rows, 0).instances;
}

using Indices = std::vector<uint32_t>;

}  // namespace

TEST_CASE("Visibility: what lies outside the frustum is left out, what touches it stays, nearest first") {
  const frame::DrawList list = boxes({{0, 0, 0},      // at 10 m
                                      {10.4, 0, 0},   // its left half within the right edge
                                      {11.1, 0, 0},   // beyond: the edge is at 10.5 where the box is farthest
                                      {0, 0, 11},     // behind the eye
                                      {0, -10.4, 0},  // across the lower edge
                                      {0, 0, 5}});    // nearer
  CHECK(visible(list, lookingDown()) == Indices{5, 0, 1, 4});
  const frame::VisibleDraws seen = frame::visibleDraws(list, lookingDown(), {}, 0);
  CHECK(seen.culled == 2);
  REQUIRE(seen.opaque.size() == 1);
  CHECK(seen.opaque[0].firstInstance == 0);
  CHECK(seen.opaque[0].instanceCount == 4);
  // A wider picture sees more.
  CHECK(visible(list, lookingDown(2)).size() == 5);
  // A margin of a tenth of the half width brings the third in.
  CHECK(frame::visibleDraws(list, lookingDown(), {}, 0.1).instances.size() == 5);
}

TEST_CASE("Visibility: rows of a picture see their own part only") {
  const frame::DrawList list = boxes({{0, 5, 0}, {0, -5, 0}, {0, 0, 0}});
  CHECK(visible(list, lookingDown(), {0.2, 1}) == Indices{0});
  CHECK(visible(list, lookingDown(), {-1, -0.2}) == Indices{1});
  CHECK(visible(list, lookingDown(), {-0.2, 0.2}) == Indices{2});
}

TEST_CASE("Visibility: orthographic views, and bounds that say nothing") {
  const scene::Bounds all{glm::dvec3(-100), glm::dvec3(100)};
  scene::Camera camera;
  camera.perspective = false;
  camera.xMag = 2, camera.yMag = 1, camera.zNear = 1, camera.zFar = 20;
  const scene::View view = scene::cameraView(camera, glm::dmat4(1), 2, all);
  frame::DrawList list = boxes({{2.4, 0, -5}, {2.6, 0, -5}, {0, 1.6, -5}, {0, 0, -21}, {0, 0, 0}});
  CHECK(visible(list, view) == Indices{0});
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  list.instanceBounds[1] = {};
  list.instanceBounds[2] = {glm::dvec3(-inf), glm::dvec3(inf)};
  list.instanceBounds[3] = {glm::dvec3(nan), glm::dvec3(nan)};
  CHECK(visible(list, view).size() == 4);
}

TEST_CASE("Visibility: no point within the picture is ever left out") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> spread(-30, 30), angle(0, 360), tilt(1, 179);
  int inside = 0;
  for (int i = 0; i < 3000; ++i) {
    const glm::dvec3 center(spread(random), spread(random), spread(random));
    const scene::View view =
        scene::orbitView({.theta = angle(random), .phi = tilt(random), .radius = 20, .target = {1, 2, 3}, .fovY = 40},
                         1.5, {glm::dvec3(-30), glm::dvec3(30)});
    const glm::dvec4 clip = view.clipFromWorld * glm::dvec4(center, 1);
    const bool within = std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w && clip.z <= clip.w;
    inside += within;
    frame::DrawList list = boxes({center});
    list.instanceBounds[0] = {center, center};
    CHECK(visible(list, view).size() == (within ? 1 : 0));
  }
  CHECK(inside > 100);
}

TEST_CASE("Visibility: opaque draws go by program, then front to back, blended ones from behind") {
  frame::DrawList list = boxes({{0, 0, 0}, {0, 0, 5}, {0, 0, -5}});
  list.opaque.clear();
  for (uint32_t i = 0; i < 3; ++i) {
    Draw draw;
    draw.firstInstance = draw.firstBounds = i;
    draw.material = i == 2 ? 0 : 1;
    list.opaque.push_back(draw);
    list.blended.push_back(draw);
  }
  const frame::VisibleDraws seen = frame::visibleDraws(list, lookingDown(), {}, 0);
  CHECK(seen.instances == Indices{0, 1, 2, 0, 1, 2});
  REQUIRE(seen.opaque.size() == 3);
  CHECK(seen.opaque[0].firstInstance == 1);  // the nearest, then what has its material
  CHECK(seen.opaque[1].firstInstance == 0);
  CHECK(seen.opaque[2].material == 0);
  REQUIRE(seen.blended.size() == 3);
  CHECK(seen.blended[0].firstInstance == 5);
  CHECK(seen.blended[1].firstInstance == 3);
  CHECK(seen.blended[2].firstInstance == 4);
}

TEST_CASE("Visibility: blended draws are behind what transmits unless nearer than the nearest box of that") {
  frame::DrawList list = boxes({{0, 0, 0}, {0, 0, 0.4}, {0, 0, 0.6}, {0, 0, -5}});
  list.opaque.clear();
  for (uint32_t i = 0; i < 4; ++i) {
    Draw draw;
    draw.firstInstance = draw.firstBounds = i;
    (i == 0 ? list.transmitting : list.blended).push_back(draw);
  }
  frame::VisibleDraws seen = frame::visibleDraws(list, lookingDown(), {}, 0);
  REQUIRE(seen.transmitting.size() == 1);
  REQUIRE(seen.blended.size() == 3);
  CHECK(seen.blendedBehind == 2);  // the one within the box too
  list.transmitting.clear();
  CHECK(frame::visibleDraws(list, lookingDown(), {}, 0).blendedBehind == 0);
}

TEST_CASE("Visibility: a shell is drawn before its core, what surrounds the eye after what it holds") {
  frame::DrawList list = boxes({{0, 0, 0.2}, {0, 0, 0}, {0, 0, 3}});
  list.instanceBounds[1] = {glm::dvec3(-2), glm::dvec3(2)};    // around the first, whose centre is nearer
  list.instanceBounds[2] = {glm::dvec3(-30), glm::dvec3(30)};  // a room
  list.opaque.clear();
  for (uint32_t i = 0; i < 3; ++i) {
    Draw draw;
    draw.firstInstance = draw.firstBounds = i;
    draw.material = static_cast<int>(i);
    list.opaque.push_back(draw);
  }
  const frame::VisibleDraws seen = frame::visibleDraws(list, lookingDown(), {}, 0);
  REQUIRE(seen.opaque.size() == 3);
  CHECK(seen.opaque[0].material == 1);
  CHECK(seen.opaque[1].material == 0);
  CHECK(seen.opaque[2].material == 2);
}
