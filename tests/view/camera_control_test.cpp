#include "view/camera_control.hpp"

#include <catch2/catch.hpp>

using namespace facet;
using scene::OrbitCamera;

namespace {

constexpr double width = 640, height = 480;

OrbitCamera example() {
  OrbitCamera camera;
  camera.theta = 37;
  camera.phi = 62;
  camera.radius = 3.5;
  camera.target = {1, -2, 0.5};
  camera.fovY = 40;
  return camera;
}

// Where a world point is seen, in pixels from the top left.
glm::dvec2 pixelOf(const OrbitCamera& camera, const glm::dvec3& p) {
  const scene::View view = scene::orbitView(camera, width / height, {});
  const glm::dvec4 clip = view.clipFromWorld * glm::dvec4(p, 1);
  return {(clip.x / clip.w * 0.5 + 0.5) * width, (0.5 - clip.y / clip.w * 0.5) * height};
}

// The point at the target's depth that is seen at this pixel.
glm::dvec3 pointAt(const OrbitCamera& camera, const glm::dvec2& pixel) {
  const scene::View view = scene::orbitView(camera, width / height, {});
  const double perPixel = 2 * camera.radius * std::tan(glm::radians(camera.fovY) / 2) / height;
  return camera.target + view.right * ((pixel.x - width / 2) * perPixel) -
         view.up * ((pixel.y - height / 2) * perPixel);
}

scene::Bounds box(double half) { return {glm::dvec3(-half), glm::dvec3(half)}; }

}  // namespace

TEST_CASE("camera control: a pan keeps the point at the target's depth under the pointer") {
  for (const double phi : {0.0, 62.0, 180.0}) {
    OrbitCamera camera = example();
    camera.phi = phi;
    const glm::dvec2 from(100, 400), drag(173, -91);
    const glm::dvec3 held = pointAt(camera, from);
    CHECK(glm::distance(pixelOf(camera, held), from) < 1e-9);
    const OrbitCamera panned = view::panned(camera, drag, height);
    CHECK(glm::distance(pixelOf(panned, held), from + drag) < 1e-9);
    CHECK(panned.radius == camera.radius);
    CHECK(panned.theta == camera.theta);
    CHECK(panned.phi == camera.phi);
  }
}

TEST_CASE("camera control: an orbit turns half around over the window's height and stops at the poles") {
  const OrbitCamera camera = example();
  CHECK(view::orbited(camera, {height, 0}, height).theta == Approx(37 - 180));
  CHECK(view::orbited(camera, {0, height / 6}, height).phi == Approx(62 - 30));
  CHECK(view::orbited(camera, {0, 10 * height}, height).phi == 0);
  CHECK(view::orbited(camera, {0, -10 * height}, height).phi == 180);
  CHECK(view::orbited(camera, {-height, 0}, height).theta == Approx(37 - 180));  // 217 is wrapped
  const OrbitCamera far = view::orbited(camera, {1e6, 0}, height);
  CHECK(std::abs(far.theta) <= 180);
  CHECK(far.target == camera.target);
  // The scene follows the pointer: what is before the target moves to the right.
  const glm::dvec3 before = camera.target + 0.1 * glm::normalize(view::eyeOf(camera) - camera.target);
  CHECK(pixelOf(view::orbited(camera, {20, 0}, height), before).x > width / 2 + 1);
  CHECK(pixelOf(view::orbited(camera, {0, 20}, height), before).y > height / 2 + 1);
}

TEST_CASE("camera control: zoom is a factor of 0.9 a step within the scene's limits") {
  const view::RadiusLimits limits = view::radiusLimits(box(2));
  const double radius = std::sqrt(12.0);
  CHECK(limits.min == Approx(1e-3 * radius));
  CHECK(limits.max == Approx(1e2 * radius));
  const OrbitCamera camera = example();
  CHECK(view::zoomed(camera, 1, limits).radius == Approx(3.5 * 0.9));
  CHECK(view::zoomed(view::zoomed(camera, 3, limits), -3, limits).radius == Approx(3.5));
  CHECK(view::zoomed(camera, 1e6, limits).radius == limits.min);
  CHECK(view::zoomed(camera, -1e6, limits).radius == limits.max);
  CHECK(view::radiusLimits({}).max == 100);
  CHECK(view::radiusLimits({glm::dvec3(7), glm::dvec3(7)}).min == 1e-3);
}

TEST_CASE("camera control: zooming to the pointer keeps what is there, at every depth, in place") {
  const view::RadiusLimits limits = view::radiusLimits(box(2));
  for (const bool orthographic : {false, true})
    for (const double steps : {3.0, -2.0}) {
      OrbitCamera camera = example();
      camera.orthographic = orthographic, camera.roll = 25, camera.up = {1, 1, 3};
      const glm::dvec2 pixel(520, 61), size(width, height);
      const OrbitCamera nearer = view::zoomedAt(camera, steps, limits, pixel, size);
      CHECK(nearer.radius == Approx(3.5 * std::pow(0.9, steps)));
      const view::PixelRay ray = view::rayThrough(scene::orbitView(camera, width / height, box(2)), pixel, size);
      for (const double along : {2.0, 5.0, 9.0})
        CHECK(glm::distance(pixelOf(nearer, ray.origin + along * ray.direction), pixel) < 1e-6);
      CHECK(view::zoomedAt(camera, steps, limits, 0.5 * size, size).target == camera.target);
    }
  // Where it can come no nearer, it does not drift.
  OrbitCamera close = example();
  close.radius = limits.min;
  CHECK(view::zoomedAt(close, 1, limits, {0, 0}, {width, height}).target == close.target);
}

TEST_CASE("camera control: a trackball turns as an orbit does near the horizon, and goes over the poles") {
  OrbitCamera camera = example();
  camera.phi = 90;
  const OrbitCamera aside = view::tumbled(camera, {48, 0}, height), up = view::tumbled(camera, {0, 48}, height);
  CHECK(aside.theta == Approx(view::orbited(camera, {48, 0}, height).theta));
  CHECK(aside.phi == Approx(90));
  CHECK(aside.roll == Approx(0).margin(1e-6));
  CHECK(up.phi == Approx(view::orbited(camera, {0, 48}, height).phi));
  CHECK(up.theta == Approx(camera.theta));
  // Over the pole the horizon is upside down; a whole turn comes back.
  OrbitCamera over = camera;
  for (int i = 0; i < 12; ++i) over = view::tumbled(over, {0, 50}, height);  // 225 degrees
  CHECK(over.phi == Approx(135));
  CHECK(std::abs(over.roll) == Approx(180));
  for (int i = 0; i < 12; ++i) over = view::tumbled(over, {0, -50}, height);
  CHECK(glm::distance(view::eyeOf(over), view::eyeOf(camera)) < 1e-9);
  CHECK(over.roll == Approx(0).margin(1e-6));
  CHECK(view::tumbled(camera, {0, 0}, height) == camera);
}

TEST_CASE("camera control: a roll turns the picture, and drags follow the pointer in it") {
  OrbitCamera camera = view::rolled(view::rolled(example(), 170), 40);
  CHECK(camera.roll == -150);
  camera.roll = 90;
  const glm::dvec3 before = camera.target + 0.1 * glm::normalize(view::eyeOf(camera) - camera.target);
  const glm::dvec2 right = pixelOf(view::orbited(camera, {20, 0}, height), before);
  CHECK(right.x > width / 2 + 1);
  CHECK(right.y == Approx(height / 2).margin(1));
  const glm::dvec3 held = pointAt(camera, {100, 400});
  CHECK(glm::distance(pixelOf(view::panned(camera, {30, 11}, height), held), {130, 411}) < 1e-9);
  CHECK(view::seenFrom(camera, view::ViewFrom::top).roll == 0);
  CHECK(view::framedAll(camera, box(1), 1).roll == 90);
}

TEST_CASE("camera control: looking keeps the eye and turns towards the pointer") {
  const OrbitCamera camera = example();
  const OrbitCamera looked = view::looked(camera, {60, 30}, height);
  CHECK(glm::distance(view::eyeOf(looked), view::eyeOf(camera)) < 1e-12);
  CHECK(looked.theta == Approx(37 - 5));
  CHECK(looked.phi == Approx(62 - 2.5));
  // What was in the middle is now to the left and above: we look to the right and down.
  const glm::dvec2 seen = pixelOf(looked, camera.target);
  CHECK(seen.x < width / 2 - 20);
  CHECK(seen.y < height / 2 - 10);
}

TEST_CASE("camera control: flying moves eye and target along the camera's axes") {
  const OrbitCamera camera = example();
  const OrbitCamera flown = view::flown(camera, {0, 0, 1.25});
  CHECK(flown.radius == camera.radius);
  const glm::dvec3 forward = glm::normalize(camera.target - view::eyeOf(camera));
  CHECK(glm::distance(view::eyeOf(flown), view::eyeOf(camera) + 1.25 * forward) < 1e-12);
  CHECK(pixelOf(view::flown(camera, {1, 0, 0}), camera.target).x < width / 2 - 1);
  CHECK(pixelOf(view::flown(camera, {0, 1, 0}), camera.target).y > height / 2 + 1);
}

TEST_CASE("camera control: framing all keeps the direction and shows the whole sphere around the bounds") {
  OrbitCamera camera = example();
  const OrbitCamera framed = view::framedAll(camera, {{9, 9, 9}, {11, 11, 11}}, width / height);
  CHECK(framed.theta == camera.theta);
  CHECK(framed.phi == camera.phi);
  CHECK(framed.fovY == camera.fovY);
  CHECK(framed.target == glm::dvec3(10));
  CHECK(framed.radius == Approx(std::sqrt(3.0) / std::sin(glm::radians(20.0))));
}

TEST_CASE("camera control: views along the axes look at the target from that side, at the same distance") {
  const OrbitCamera camera = example();
  const auto check = [&](view::ViewFrom side, const glm::dvec3& from, const glm::dvec3& up) {
    const OrbitCamera seen = view::seenFrom(camera, side);
    CHECK(seen.target == camera.target);
    CHECK(glm::distance(view::eyeOf(seen), camera.target + from * camera.radius) < 1e-12);
    CHECK(glm::distance(scene::orbitView(seen, 1, {}).up, up) < 1e-12);
  };
  check(view::ViewFrom::front, {0, 0, 1}, {0, 1, 0});
  check(view::ViewFrom::back, {0, 0, -1}, {0, 1, 0});
  check(view::ViewFrom::right, {1, 0, 0}, {0, 1, 0});
  check(view::ViewFrom::left, {-1, 0, 0}, {0, 1, 0});
  check(view::ViewFrom::top, {0, 1, 0}, {0, 0, -1});
  check(view::ViewFrom::bottom, {0, -1, 0}, {0, 0, 1});
}

TEST_CASE("camera control: a turntable goes round the target about +Y and keeps the height of the eye") {
  const OrbitCamera camera = example();
  const OrbitCamera turned = view::turntable(camera, 2, 30);
  CHECK(turned.theta == Approx(97));
  CHECK(view::eyeOf(turned).y == Approx(view::eyeOf(camera).y));
  CHECK(turned.radius == camera.radius);
  const OrbitCamera round = view::turntable(camera, 12, 30);
  CHECK(round.theta == Approx(37));  // a whole turn
  CHECK(view::turntable(camera, 1e6, -30).theta >= -180);
}

TEST_CASE("camera control: a framed part smaller than the limits is not thrown back by the wheel") {
  const view::RadiusLimits limits = view::radiusLimits(box(2));
  OrbitCamera camera = example();
  camera.radius = limits.min / 10;
  CHECK(view::zoomed(camera, 1, limits).radius == camera.radius);
  CHECK(view::zoomed(camera, -1, limits).radius == Approx(camera.radius / 0.9));
}

TEST_CASE("camera control: flight is as fast as what is looked at is large") {
  OrbitCamera camera = example();
  const double radius = box(2).radius();
  camera.radius = 100;
  CHECK(view::flightSpeed(camera, box(2)) == Approx(0.7 * radius));
  camera.radius = radius / 10;
  CHECK(view::flightSpeed(camera, box(2)) == Approx(0.07 * radius));
  camera.radius = 0;
  CHECK(view::flightSpeed(camera, box(2)) == Approx(0.007 * radius));
  camera.radius = 0.5;
  CHECK(view::flightSpeed(camera, {}) == Approx(0.35));
}

TEST_CASE("camera control: near never clips what one looks at, from afar, close up and inside") {
  const scene::Bounds bounds = box(2);
  const double radius = bounds.radius();
  // Zoomed in on a point of the surface, down to a thousandth of the scene: from the target to the eye everything that
  // is farther from the eye than a hundredth of the way is in front of near, and depth tells a millionth apart.
  for (const double r : {100.0, 10.0, 1.0, 0.1, 1e-2, 1e-3}) {
    OrbitCamera camera = example();
    camera.target = {2, 0.3, -0.2};
    camera.radius = r * radius;
    const scene::View view = scene::orbitView(camera, 1.5, bounds);
    INFO("radius " << r);
    CHECK(view.zNear > 0);
    CHECK(view.zNear <= 0.01 * camera.radius);
    const auto depth = [&](double distance) {
      const glm::dvec4 clip = view.clipFromView * glm::dvec4(0, 0, -distance, 1);
      return static_cast<float>(clip.z / clip.w);
    };
    CHECK(depth(camera.radius) < depth(camera.radius * (1 - 1e-6)));
    CHECK(depth(camera.radius) > 0);
    CHECK(depth(bounds.radius() * 1e3) > 0);
  }
  // Flown into the scene: what is a hundred-thousandth of its size before the eye is seen still.
  OrbitCamera inside = example();
  inside.target = {0.1, 0.1, 0.1};
  inside.radius = radius;
  inside = view::flown(inside, {0, 0, radius * 0.99});
  const scene::View view = scene::orbitView(inside, 1.5, bounds);
  CHECK(view.zNear <= 1e-5 * radius);
}

TEST_CASE("camera control: the ray through a pixel meets what is seen there") {
  const OrbitCamera camera = example();
  const glm::dvec2 size(width, height);
  const scene::View view = scene::orbitView(camera, width / height, box(9));
  for (const glm::dvec2& pixel : {glm::dvec2(320, 240), glm::dvec2(3, 470), glm::dvec2(600, 20)}) {
    const view::PixelRay ray = view::rayThrough(view, pixel, size);
    CHECK(glm::length(ray.direction) == Approx(1));
    CHECK(glm::distance(pixelOf(camera, ray.origin + 2.5 * ray.direction), pixel) < 1e-6);
  }
  scene::Camera lens;
  lens.perspective = false;
  lens.xMag = lens.yMag = 2;
  lens.zNear = 0.5, lens.zFar = 10;
  const scene::View flat = scene::cameraView(lens, glm::dmat4(1), 1, box(9));
  const view::PixelRay ray = view::rayThrough(flat, {75, 25}, {100, 100});
  CHECK(glm::distance(ray.origin, {1, 1, -0.5}) < 1e-12);
  CHECK(ray.direction == glm::dvec3(0, 0, -1));
}
