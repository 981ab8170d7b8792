#include "options/camera_path.hpp"

#include <catch2/catch.hpp>

#include "frame/settings.hpp"

using namespace facet;
using frame::Viewpoint;

namespace {

std::vector<Viewpoint> parsed(const std::string& text) {
  auto path = options::parseCameraPath(text, "p.txt");
  if (!path) FAIL(describe(path.error()));
  return std::move(*path);
}

}  // namespace

TEST_CASE("camera path: it goes through its keys, azimuths the shorter way, distances by factors") {
  const auto keys = parsed(
      "# from the front\n--orbit 350,90,1 --target 0,0,0 --fov-y 30\n\n"
      "--orbit 10,60,4 --target 2,0,0 --fov-y 50  # nearer\nfacet render x.glb --orbit 20,60,4 --target 2,4,0 --fov-y "
      "50\n");
  REQUIRE(keys.size() == 3);
  const auto near = [](double got, double expected) { CHECK(got == Approx(expected).margin(1e-9)); };
  const auto turned = [](double degrees) { return std::remainder(degrees, 360); };
  for (size_t i = 0; i < keys.size(); ++i) {
    const Viewpoint at = options::alongPath(keys, double(i) / 2);
    near(turned(at.orbit->thetaDeg - keys[i].orbit->thetaDeg), 0);
    near(at.orbit->phiDeg, keys[i].orbit->phiDeg);
    near(*at.orbit->radius, *keys[i].orbit->radius);
    near(glm::distance(*at.target, *keys[i].target), 0);
    near(*at.fovYDeg, *keys[i].fovYDeg);
  }
  // Halfway between the first two, by hand: p0 = p1, so (p1 + p2) / 2 + (slope1 - slope2) / 8.
  const Viewpoint half = options::alongPath(keys, 0.25);
  near(turned(half.orbit->thetaDeg), 0 + (10 - 15) / 8.0);
  near(half.orbit->phiDeg, 75 + (-15 + 15) / 8.0);
  near(*half.orbit->radius, std::exp((std::log(4) / 2) + (std::log(4) / 2 - std::log(4) / 2) / 8));
  near(half.target->x, 1 + (1 - 1) / 8.0);
  near(half.target->y, 0 - 2 / 8.0);
}

TEST_CASE("camera path: of two keys it is straight, beyond the ends it stays") {
  const auto keys = parsed("--orbit 0,90,1\n--orbit 90,45,1");
  const Viewpoint third = options::alongPath(keys, 1 / 3.0);
  // With slopes of half the difference at both ends.
  const double t = 1 / 3.0,
               share = 3 * t * t - 2 * t * t * t + (t * t * t - 2 * t * t + t) / 2 + (t * t * t - t * t) / 2;
  CHECK(third.orbit->thetaDeg == Approx(90 * share));
  CHECK(options::alongPath(keys, 2).orbit->thetaDeg == Approx(90));
  CHECK(options::alongPath(keys, -1).orbit->thetaDeg == Approx(0).margin(1e-12));
}

TEST_CASE("camera path: what is wrong is told with its line") {
  const auto says = [](const std::string& text, const std::string& sentence) {
    const auto path = options::parseCameraPath(text, "p.txt");
    REQUIRE_FALSE(path);
    CHECK(describe(path.error()) == sentence);
  };
  says("", "p.txt: has 0 cameras; a way needs two, one a line.");
  says("--orbit 0,90,1\n", "p.txt: has 1 cameras; a way needs two, one a line.");
  says("--orbit 0,90,1\n\n--target 0,0,0",
       "p.txt: line 3: there is no --orbit; copy a camera in the window, such as "
       "--orbit 30,75,2 --target 0,0,0.");
  says("--orbit 0,90,1\n--orbit 0,90,1 --fov-y 30",
       "p.txt: line 2: differs from the first camera in --fov-y; give it in each line, or in none.");
  says("--orbit 0,90,1\n--orbit 0,90",
       "p.txt: line 2: differs from the first camera in radius in --orbit; give it in each line, or in none.");
  says("--orbit 0,90,1\nhello",
       "p.txt: line 2: there is no camera in this text: 'hello'; copy one such as --orbit 30,75,2 --target 0,0,0.");
}
