#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "constants.h"
#include "frame/display_pass.hpp"
#include "optics/color.hpp"
#include "support/picture.hpp"

// Light of any unit at the exposure that suits it.

using namespace facet;
using frame::PictureSettings;
using frame::Transport, frame::Visibility;
using test::at, test::emptyScene;
using test::GltfBuilder;

namespace {

// A lamp that shines on a floor, a pane of rough glass before both, a glossy ball; as much light in all as the factor
// says.
io::LoadedModel room(float light) {
  GltfBuilder builder = emptyScene();
  const auto add = [&](const nlohmann::json& material) { return builder.append("materials", material); };
  test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {1, 1}), add(test::material({0.5, 0.6, 0.4, 1}, 0, 0.7)));
  nlohmann::json lamp = test::material({0, 0, 0, 1});
  lamp["emissiveFactor"] = {1, 0.5, 0.1};
  test::addMeshNode(builder, test::addQuad(builder, {-0.8, 0.3}, {-0.2, 0.8}), add(lamp), at(0, 0, 0.4));
  nlohmann::json pane = test::material({1, 0.9, 0.8, 1}, 0, 0.3);
  pane["extensions"] = {{"KHR_materials_transmission", {{"transmissionFactor", 0.8}}}};
  test::addMeshNode(builder, test::addQuad(builder, {-0.6, -0.2}, {0.4, 0.6}), add(pane), at(0, 0, 1));
  nlohmann::json veil = test::material({0.2, 0.3, 0.9, 0.4}, 0, 0.5);
  veil["alphaMode"] = "BLEND";
  test::addMeshNode(builder, test::addQuad(builder, {0.1, -0.9}, {0.9, -0.5}), add(veil), at(0, 0, 0.7));
  test::addMeshNode(builder, test::addSphere(builder, 0.3), add(test::material({0.9, 0.7, 0.5, 1}, 1, 0.25)),
                    at(0.4, -0.3, 0.4));
  test::addOrthographicCamera(builder, 1.2, 1.2);
  io::LoadedModel model = test::loadBuilt(builder);
  for (scene::Material& m : model.model.materials) m.emissiveFactor *= 2 * light;
  scene::Light point;
  point.intensity = 0.7f * light;
  model.model.lights.push_back(point);
  scene::Node node;
  node.light = 0, node.translation = glm::dvec3(0.5, 0.5, 0.8);
  model.model.nodes.push_back(node);
  model.model.scenes[0].nodes.push_back(static_cast<int>(model.model.nodes.size()) - 1);
  return model;
}

// At the exposure that makes it as bright as light of 1 without any.
PictureSettings exposedFor(int stops, frame::Background background) {
  PictureSettings settings = test::bareSettings(24, 24);
  settings.viewpoint.camera = "0";
  settings.sources.environment = "builtin:sky";
  settings.frame.environmentStrength = std::ldexp(0.5f, stops);
  settings.frame.background = background;
  settings.frame.backgroundColor = {0.2f, 0.1f, 0.3f};
  settings.display.exposureStops = static_cast<float>(-stops);
  return settings;
}

struct Case {
  const char* name;
  Transport transport;
  Visibility visibility;
  int samples;
  frame::Background background;
};

frame::Picture inUnit(test::Studio& studio, int stops, const Case& c) {
  PictureSettings settings = exposedFor(stops, c.background);
  settings.quality.transport = c.transport;
  settings.quality.visibility = c.visibility;
  settings.quality.samples = c.samples;
  settings.quality.bounces = 4;
  return studio.render(room(std::ldexp(1.0f, stops)), settings);
}

}  // namespace

TEST_CASE("Brightness: light of any unit gives the picture that its exposure makes alike, to the bit", "[gl]") {
  test::Studio studio;
  using enum frame::Background;
  for (const Case& c : {Case{"one sample", Transport::direct, Visibility::none, 1, transparent},
                        Case{"four samples", Transport::direct, Visibility::none, 4, color},
                        Case{"gathered", Transport::direct, Visibility::none, 8, transparent},
                        Case{"corrected by rays", Transport::direct, Visibility::rays, 4, color},
                        Case{"path traced", Transport::paths, Visibility::automatic, 4, environment}}) {
    // Pairs that are stored alike: four stops below the usual exposure and eight above it the unit is 1 still.
    for (const auto& [known, stops] : {std::pair(4, 17), std::pair(4, 24), std::pair(-8, -20)}) {
      INFO(c.name << ", light times 2^" << stops);
      const frame::Picture expected = inUnit(studio, known, c);
      const frame::Picture got = inUnit(studio, stops, c);
      CHECK(got.statistics.nonFinitePixels == 0);
      size_t differing = 0;
      int most = 0;
      for (size_t i = 0; i < got.display.data.size(); ++i) {
        const int by = std::abs(got.display.data[i] - expected.display.data[i]);
        differing += by > 0, most = std::max(most, by);
      }
      INFO(differing << " values differ, by " << most << " at most");
      CHECK(differing == 0);
      size_t apart = 0;
      for (size_t i = 0; i < got.radiance.pixels.size(); ++i) {
        const glm::vec3 scaled = glm::vec3(expected.radiance.pixels[i]) * std::ldexp(1.0f, stops - known);
        apart += glm::vec3(got.radiance.pixels[i]) != scaled;
      }
      if (c.background != color) CHECK(apart == 0);  // the colour is added as it is
      size_t bright = 0;                             // neither black nor white
      for (const uint8_t value : got.display.data) bright += value > 20 && value < 250;
      CHECK(bright > got.display.data.size() / 3);
    }
  }
}

TEST_CASE("Brightness: a filament of 200,000 nit has its value at -18 stops, and in a file of radiance", "[gl]") {
  GltfBuilder builder = emptyScene();
  nlohmann::json filament = test::material({0, 0, 0, 1});
  filament["emissiveFactor"] = {1, 0.5, 0.1};
  filament["extensions"] = {{"KHR_materials_emissive_strength", {{"emissiveStrength", 2e5}}}};
  test::addMeshNode(builder, test::addQuad(builder, {-2, -2}, {2, 2}), builder.append("materials", filament));
  test::addOrthographicCamera(builder, 1, 1);
  const io::LoadedModel model = test::loadBuilt(builder);
  test::Studio studio;
  PictureSettings settings = test::bareSettings(4, 4);
  settings.viewpoint.camera = "0";
  settings.display = {-18, optics::ToneMapper::none, {}};
  const glm::dvec3 radiance(2e5, 1e5, 2e4);
  struct Way {
    Transport transport;
    Visibility visibility;
    int samples;
  };
  for (const Way& c : {Way{Transport::direct, Visibility::none, 1}, Way{Transport::direct, Visibility::none, 4},
                       Way{Transport::direct, Visibility::rays, 4}, Way{Transport::paths, Visibility::none, 4}}) {
    settings.quality.transport = c.transport, settings.quality.visibility = c.visibility;
    settings.quality.samples = c.samples;
    studio.display = true;
    const frame::Picture shown = studio.render(model, settings);
    for (int i = 0; i < 3; ++i) {
      INFO("samples " << c.samples << ", component " << i);
      const double expected = 255 * optics::encodeSRGB(radiance[i] * std::exp2(-18));
      CHECK(double(shown.display.data[static_cast<size_t>(i)]) == Approx(expected).margin(0.6));
      CHECK(double(shown.radiance.pixels[0][i]) == Approx(radiance[i]).epsilon(1e-3));
    }
    studio.display = false;
    for (const float stops : {-18.0f, 0.0f, 20.0f}) {  // a file knows no exposure
      settings.display.exposureStops = stops;
      const frame::Picture file = studio.render(model, settings);
      for (int i = 0; i < 3; ++i) CHECK(double(file.radiance.pixels[0][i]) == Approx(radiance[i]).epsilon(1e-6));
      CHECK(file.statistics.clampedPixels == 0);
    }
    settings.display.exposureStops = -18;
  }
}

TEST_CASE("Brightness: what rays correct in a file of radiance is not cut either", "[gl]") {
  test::Studio studio;
  studio.display = false;
  const Case rays{"rays", Transport::direct, Visibility::rays, 4, frame::Background::transparent};
  const auto ofFile = [&](float light) {
    PictureSettings settings = exposedFor(0, rays.background);
    settings.quality.visibility = rays.visibility, settings.quality.samples = rays.samples;
    settings.frame.environmentStrength = 0;
    return studio.render(room(light), settings);
  };
  const frame::Picture dim = ofFile(1), bright = ofFile(0x1p20f);
  CHECK(dim.statistics.frame.rays > 0);
  float largest = 0, apart = 0;
  for (size_t i = 0; i < dim.radiance.pixels.size(); ++i) {
    const glm::vec3 expected = glm::vec3(dim.radiance.pixels[i]) * 0x1p20f;
    const glm::vec3 by = glm::abs(glm::vec3(bright.radiance.pixels[i]) - expected) / glm::max(expected, 1e3f);
    apart = std::max({apart, by.x, by.y, by.z});
    largest = std::max(largest, bright.radiance.pixels[i].x);
  }
  CHECK(largest > 10 * layout::maxHalf);
  CHECK(apart < 1e-4f);
}

namespace {

frame::Display exposed(float stops) {
  frame::Display display;
  display.exposureStops = stops;
  return display;
}

}  // namespace

TEST_CASE("Brightness: the unit is 1 for usual exposures and for channels, else a power of two", "[gl]") {
  for (const float stops : {-4.0f, -1.5f, 0.0f, 8.0f}) CHECK(frame::radianceUnit(exposed(stops), 0) == 1);
  CHECK(frame::radianceUnit(exposed(-17), 0) == 8192);
  CHECK(frame::radianceUnit(exposed(17), 0) == std::exp2(-9.0f));
  for (float stops = -32; stops <= 32; stops += 0.25f) {
    const float unit = frame::radianceUnit(exposed(stops), 0);
    CHECK(std::exp2(std::round(std::log2(unit))) == unit);
    CHECK(layout::maxHalf * unit * std::exp2(stops) >= 4094);  // the largest half is white
    CHECK(unit * std::exp2(stops) * 0x1p-24f < 0x1p-15f);      // halves are a tenth of a step of 8 bits apart at most
    CHECK(frame::radianceUnit(exposed(stops), 1) == 1);
  }
}
