#include "scene/camera.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "base/angle.hpp"

using facet::pi;
using namespace facet::scene;

namespace {

glm::dvec3 ndc(const glm::dmat4& clip, const glm::dvec3& p) {
  const glm::dvec4 c = clip * glm::dvec4(p, 1);
  return glm::dvec3(c) / c.w;
}

Bounds cube(const glm::dvec3& center, double half) { return {center - half, center + half}; }

bool orthonormal(const View& view) {
  return std::abs(glm::dot(view.right, view.up)) < 1e-12 && std::abs(glm::dot(view.up, view.forward)) < 1e-12 &&
         glm::distance(glm::cross(view.right, view.up), -view.forward) < 1e-12 &&
         std::abs(glm::length(view.right) - 1) < 1e-12;
}

}  // namespace

TEST_CASE("The orbit follows the convention of the path-traced references") {
  // theta 25, phi 75, radius 2 around (1, 2, 3), from the formula in degrees.
  const View view = orbitView({25, 75, 2, {1, 2, 3}, 45}, 1, cube({1, 2, 3}, 0.5));
  CHECK(view.eye.x == Approx(1 + 2 * std::sin(75 * pi / 180) * std::sin(25 * pi / 180)));
  CHECK(view.eye.y == Approx(2 + 2 * std::cos(75 * pi / 180)));
  CHECK(view.eye.z == Approx(3 + 2 * std::sin(75 * pi / 180) * std::cos(25 * pi / 180)));
  const glm::dvec3 target = ndc(view.clipFromWorld, {1, 2, 3});
  CHECK(target.x == Approx(0).margin(1e-12));
  CHECK(target.y == Approx(0).margin(1e-12));
  CHECK(orthonormal(view));
  CHECK(view.right.y == 0);
  CHECK(view.up.y > 0);
}

TEST_CASE("Axes: theta 0 looks from +Z, theta 90 from +X, and the poles have an up") {
  const Bounds box = cube(glm::dvec3(0), 1);
  const View front = orbitView({0, 90, 5, {}, 45}, 1, box);
  CHECK(front.eye == glm::dvec3(0, 0, 5));
  CHECK(front.right == glm::dvec3(1, 0, 0));
  CHECK(front.up == glm::dvec3(0, 1, 0));
  CHECK(front.forward == glm::dvec3(0, 0, -1));
  CHECK(orbitView({90, 90, 5, {}, 45}, 1, box).eye == glm::dvec3(5, 0, 0));
  CHECK(orbitView({-90, 90, 5, {}, 45}, 1, box).eye == glm::dvec3(-5, 0, 0));
  CHECK(orbitView({360 * 1000 + 180, 90, 5, {}, 45}, 1, box).eye == glm::dvec3(0, 0, -5));
  const View above = orbitView({0, 0, 5, {}, 45}, 1, box), below = orbitView({0, 180, 5, {}, 45}, 1, box);
  CHECK(above.eye == glm::dvec3(0, 5, 0));
  CHECK(above.up == glm::dvec3(0, 0, -1));
  CHECK(below.eye == glm::dvec3(0, -5, 0));
  CHECK(below.up == glm::dvec3(0, 0, 1));
  CHECK(orthonormal(above));
}

TEST_CASE("Depth is 1 at near, 0 at infinity or far, and falls in between") {
  const glm::dmat4 infinite = perspective(pi / 2, 2, 0.1, std::numeric_limits<double>::infinity());
  CHECK(ndc(infinite, {0, 0, -0.1}).z == Approx(1).epsilon(1e-14));
  CHECK(ndc(infinite, {0, 0, -0.2}).z == Approx(0.5));
  CHECK(ndc(infinite, {0, 0, -1e9}).z == Approx(1e-10));
  CHECK((infinite * glm::dvec4(0, 0, -1, 0)).z == 0);  // the direction itself
  CHECK(ndc(infinite, {2, 1, -1}).x == Approx(1));     // tan 45 degrees, twice as wide
  CHECK(ndc(infinite, {2, 1, -1}).y == Approx(1));

  const glm::dmat4 finite = perspective(pi / 2, 1, 0.5, 100);
  CHECK(ndc(finite, {0, 0, -0.5}).z == Approx(1));
  CHECK(ndc(finite, {0, 0, -100}).z == Approx(0).margin(1e-15));
  CHECK(ndc(finite, {0, 0, -1}).z == Approx((0.5 / 99.5) * (100 - 1)));

  const glm::dmat4 parallel = orthographic(4, 3, -1, 9);
  CHECK(ndc(parallel, {4, -3, 1}) == glm::dvec3(1, -1, 1));
  CHECK(ndc(parallel, {0, 0, -9}).z == Approx(0).margin(1e-15));
  CHECK(ndc(parallel, {0, 0, -4}).z == Approx(0.5));
}

TEST_CASE("Scenes of any size and place are framed: the sphere touches the edge, nothing is clipped") {
  const double size = GENERATE(1e-6, 1.0, 1e6);
  const double away = GENERATE(0.0, 1e6);
  const double aspect = GENERATE(0.5, 1.0, 2.0);
  CAPTURE(size, away, aspect);
  const Bounds box = cube(glm::dvec3(away, -away, 2 * away), size);
  const OrbitCamera orbit = frameBounds(box, 45, aspect);
  const View view = orbitView(orbit, aspect, box);
  const double sphere = size * std::sqrt(3.0);

  // The picture's narrower half angle is the sphere's.
  const double half = std::atan(std::tan(pi / 8) * std::min(1.0, aspect));
  CHECK(sphere / orbit.radius == Approx(std::sin(half)).epsilon(1e-3));
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p = glm::mix(box.min, box.max, glm::dvec3(corner & 1, (corner >> 1) & 1, corner >> 2));
    const glm::dvec3 c = ndc(view.clipFromWorld, p);
    CHECK(std::abs(c.x) <= 1.001);
    CHECK(std::abs(c.y) <= 1.001);
    CHECK(c.z <= 1);
    CHECK(c.z > 1e-3);  // relative precision: near is not absurdly small
  }
  CHECK(float(view.clipFromView[3][2]) > 0.0f);
}

TEST_CASE("An eye inside the scene still sees what is close") {
  const Bounds box = cube(glm::dvec3(0), 1e6);
  const View view = orbitView({0, 90, 1, {}, 45}, 1, box);
  CHECK(view.zNear == Approx(1e-6));
  CHECK(ndc(view.clipFromWorld, {0, 0, 0.999}).z == Approx(1e-3));
  // Moving in through the box's wall, near doesn't jump.
  const View outside = orbitView({0, 90, 1 + 1e-9, {}, 45}, 1, cube(glm::dvec3(0), 1));
  const View inside = orbitView({0, 90, 1 - 1e-9, {}, 45}, 1, cube(glm::dvec3(0), 1));
  CHECK(outside.zNear == Approx(inside.zNear).epsilon(1e-6));
}

TEST_CASE("What is flat is looked at from its side, points and nothing have a frame") {
  const OrbitCamera solid = frameBounds(cube(glm::dvec3(0), 1));
  CHECK(solid.theta == 30);
  CHECK(solid.phi == 75);
  const OrbitCamera chart = frameBounds({{-1, -1, 0}, {1, 1, 0.1}});
  CHECK(chart.theta == 0);
  CHECK(chart.phi == 90);
  CHECK(frameBounds({{-1, 0, -1}, {1, 0, 1}}).phi == 55);

  CHECK(frameBounds(Bounds{}).radius == Approx(1 / std::sin(pi / 8)));
  CHECK(frameBounds(Bounds{}).target == glm::dvec3(0));
  CHECK(frameBounds(cube({1, 2, 3}, 0)).radius == Approx(0.5 / std::sin(pi / 8)));
  const View point = orbitView(frameBounds(cube(glm::dvec3(1e6), 0)), 1, cube(glm::dvec3(1e6), 0));
  CHECK(point.zNear > 1);
  const View nothing = orbitView(frameBounds(Bounds{}), 1, Bounds{});
  CHECK(nothing.zNear > 0);
  CHECK(std::isfinite(nothing.clipFromWorld[3][2]));
}

TEST_CASE("A glTF camera: position, orientation, planes, scale and mirroring of its node do not matter") {
  Camera camera;
  camera.fovY = pi / 2;
  camera.zNear = 0.5;
  camera.zFar = 50;
  const glm::dmat4 node = glm::scale(
      glm::rotate(glm::translate(glm::dmat4(1), glm::dvec3(1, 2, 3)), -pi / 2, glm::dvec3(0, 1, 0)),  // -Z to +X
      glm::dvec3(-3, 3, 1e-5));
  const View view = cameraView(camera, node, 1, {});
  CHECK(view.eye == glm::dvec3(1, 2, 3));
  CHECK(glm::distance(view.forward, glm::dvec3(1, 0, 0)) < 1e-12);
  CHECK(glm::distance(view.right, glm::dvec3(0, 0, 1)) < 1e-12);
  CHECK(orthonormal(view));
  CHECK(ndc(view.clipFromWorld, {1.5, 2, 3}).z == Approx(1));
  CHECK(ndc(view.clipFromWorld, {51, 2, 3}).z == Approx(0).margin(1e-12));
  CHECK(ndc(view.clipFromWorld, {2, 3, 4}).x == Approx(1));
  CHECK(ndc(view.clipFromWorld, {2, 3, 4}).y == Approx(1));

  SECTION("a camera wider than the picture is contained") {
    camera.aspectRatio = 2;
    const View wide = cameraView(camera, glm::dmat4(1), 1, {});
    CHECK(ndc(wide.clipFromWorld, {2, 0, -1}).x == Approx(1));
    CHECK(ndc(wide.clipFromWorld, {0, 2, -1}).y == Approx(1));
    const View tall = cameraView(camera, glm::dmat4(1), 3, {});
    CHECK(ndc(tall.clipFromWorld, {0, 1, -1}).y == Approx(1));
    CHECK(ndc(tall.clipFromWorld, {3, 0, -1}).x == Approx(1));
  }
  SECTION("orthographic") {
    camera.perspective = false;
    camera.xMag = 4, camera.yMag = 1, camera.zNear = 0, camera.zFar = 10;
    const View parallel = cameraView(camera, glm::dmat4(1), 2, {});
    CHECK(parallel.orthographic);
    CHECK(ndc(parallel.clipFromWorld, {4, 2, 0}) == glm::dvec3(1, 1, 1));
    CHECK(ndc(parallel.clipFromWorld, {0, 0, -10}).z == Approx(0).margin(1e-15));
    camera.zFar = std::numeric_limits<double>::infinity();
    const View far = cameraView(camera, glm::dmat4(1), 2, cube({0, 0, -100}, 1));
    CHECK(ndc(far.clipFromWorld, {1, 1, -101}).z > 0);
  }
  SECTION("a collapsed node gives a defined view") {
    const View view0 = cameraView(camera, glm::dmat4(0), 1, {});
    CHECK(view0.forward == glm::dvec3(0, 0, -1));
    CHECK(orthonormal(view0));
    glm::dmat4 parallelAxes(1);
    parallelAxes[1] = parallelAxes[2];
    CHECK(orthonormal(cameraView(camera, parallelAxes, 1, {})));
  }
}

TEST_CASE("An orbit survives the way to a view and back") {
  const OrbitCamera orbit{-130, 20, 3, {1, 2, 3}, 30};
  const Bounds box = cube(orbit.target, 1);
  const OrbitCamera back = orbitFromView(orbitView(orbit, 1, box), box);
  CHECK(back.theta == Approx(-130));
  CHECK(back.phi == Approx(20));
  CHECK(back.radius == Approx(3));
  CHECK(glm::distance(back.target, orbit.target) < 1e-12);
  CHECK(back.fovY == Approx(30));
  CHECK(back.roll == 0);
  CHECK(orbitFromView(orbitView({40, 0, 3, {}, 30}, 1, box), box).theta == Approx(40));

  OrbitCamera rolled = orbit;
  rolled.roll = -100, rolled.up = {0, 0, 1};
  const OrbitCamera again = orbitFromView(orbitView(rolled, 1, box), box, {.up = {0, 0, 1}});
  CHECK(again.theta == Approx(-130));
  CHECK(again.phi == Approx(20));
  CHECK(again.roll == Approx(-100));
  rolled.orthographic = true;
  const OrbitCamera parallel = orbitFromView(orbitView(rolled, 1, box), box, {.fovY = 60, .up = {0, 0, 1}});
  CHECK(parallel.orthographic);
  CHECK(parallel.roll == Approx(-100));
  CHECK(heightAtTarget(parallel) == Approx(heightAtTarget(rolled)));
}

TEST_CASE("An orthographic orbit shows at every depth what the perspective shows at the target") {
  OrbitCamera orbit{35, 70, 3, {1, 2, 3}, 50};
  const Bounds box = cube({1, 2, 3}, 5);  // the eye is within
  const View perspective = orbitView(orbit, 1.5, box);
  orbit.orthographic = true;
  const View view = orbitView(orbit, 1.5, box);
  CHECK(view.orthographic);
  CHECK(view.eye == perspective.eye);
  const double half = 3 * std::tan(25 * pi / 180);
  CHECK(heightAtTarget(orbit) == Approx(2 * half));
  CHECK(radiusForHeight(2 * half, 50) == Approx(3));
  const glm::dvec3 corner = orbit.target + view.right * (1.5 * half) + view.up * half;
  CHECK(ndc(perspective.clipFromWorld, corner).x == Approx(1));
  for (const double along : {-8.6, 0.0, 8.6}) {  // also behind the eye
    const glm::dvec3 seen = ndc(view.clipFromWorld, corner + view.forward * along);
    CHECK(seen.x == Approx(1));
    CHECK(seen.y == Approx(1));
    CHECK((seen.z > 0 && seen.z < 1));
  }
  CHECK(ndc(view.clipFromWorld, orbit.target - view.forward).z > ndc(view.clipFromWorld, orbit.target).z);
  // What frames the scene touches the nearer edges.
  const Bounds ball = cube({1, 2, 3}, 1);
  for (const double aspect : {0.5, 2.0})
    CHECK(heightAtTarget(frameBounds(ball, aspect, orbit)) * std::min(aspect, 1.0) == Approx(2 * std::sqrt(3.0)));
  const View nothing = orbitView(orbit, 1, Bounds{});
  CHECK((nothing.zNear < 3 && nothing.zFar > 3));
}

TEST_CASE("Another axis is up: the orbit's angles are about it") {
  const auto back = [](const glm::dvec3& up, double theta, double phi) {
    OrbitCamera orbit;
    orbit.theta = theta, orbit.phi = phi, orbit.up = up;
    const View view = orbitView(orbit, 1, Bounds{});
    CHECK(orthonormal(view));
    return -view.forward;
  };
  CHECK(back({0, 0, 1}, 0, 90) == glm::dvec3(0, -1, 0));
  CHECK(back({0, 0, 1}, 90, 90) == glm::dvec3(1, 0, 0));
  CHECK(back({0, 0, 7}, 0, 0) == glm::dvec3(0, 0, 1));
  CHECK(back({1, 0, 0}, 0, 90) == glm::dvec3(0, 0, 1));
  CHECK(back({-1, 0, 0}, 0, 0) == glm::dvec3(-1, 0, 0));
  CHECK(back({0, -1, 0}, 0, 90) == glm::dvec3(0, 0, 1));
  CHECK(back({0, -1, 0}, 0, 0) == glm::dvec3(0, -1, 0));
  for (const glm::dvec3& up : {glm::dvec3(1, 2, -3), glm::dvec3(0.1, -5, 0.2), glm::dvec3(0, 0, -1)}) {
    const glm::dmat3 frame = uprightFrame(up);
    CHECK(glm::distance(frame[1], glm::normalize(up)) < 1e-12);
    CHECK(glm::determinant(frame) == Approx(1));
    CHECK(glm::dot(frame[0], frame[2]) == Approx(0).margin(1e-12));
    OrbitCamera level;
    level.theta = 20, level.phi = 60, level.up = up;
    CHECK(glm::dot(orbitView(level, 1, Bounds{}).right, up) == Approx(0).margin(1e-12));
  }
  CHECK(uprightFrame({0, 3, 0}) == glm::dmat3(1));
  CHECK(uprightFrame(glm::dvec3(0)) == glm::dmat3(1));
  // What is flat is so along that axis.
  OrbitCamera like;
  like.up = {0, 0, 1};
  CHECK(frameBounds({{-1, -1, 0}, {1, 1, 0.1}}, 1, like).phi == 55);  // a floor
  CHECK(frameBounds({{-1, 0, -1}, {1, 0, 1}}, 1, like).phi == 90);    // a chart, seen from -Y
}

TEST_CASE("A roll turns the picture counterclockwise about its middle") {
  OrbitCamera orbit{0, 90, 2, {}, 90};
  const glm::dvec3 right(1, 0, 0);
  const auto seen = [&](double roll) {
    orbit.roll = roll;
    const View view = orbitView(orbit, 1, Bounds{});
    CHECK(orthonormal(view));
    return ndc(view.clipFromWorld, right);
  };
  CHECK(seen(0).x == Approx(0.5));
  CHECK(seen(90).x == 0);
  CHECK(seen(90).y == Approx(0.5));
  CHECK(seen(30).x == Approx(0.5 * std::cos(pi / 6)));
  CHECK(seen(30).y == Approx(0.25));
  CHECK(seen(-90).y == Approx(-0.5));
  // Axes that are not level have one; level ones have none, to the last bit.
  const View view = orbitView({70, 40, 1, {}, 45}, 1, Bounds{});
  CHECK(turnedTo({}, view.right, view.up).roll == 0);
  CHECK(turnedTo({}, view.up, -view.right).roll == Approx(-90));
}
