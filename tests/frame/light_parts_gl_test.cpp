#include <algorithm>
#include <catch2/catch.hpp>
#include <iostream>

#include "support/picture.hpp"

using namespace facet;
using frame::PictureSettings, frame::Visibility;
using nlohmann::json;
using test::at, test::emptyScene, test::material, test::unlit;
using test::GltfBuilder;

namespace {

constexpr const char* parts[] = {
    "emitted",        "lightsDiffuse", "lightsSpecular", "environmentDiffuse", "environmentSpecular",
    "interreflected", "background"};

// A coat and a sheen over a half metal that glows, glass, a leaf that light comes through, a pane, what is unlit,
// before a wall; a lamp.
GltfBuilder everything() {
  GltfBuilder b = emptyScene();
  const auto ball = [&](json m, double x, double y) {
    test::addMeshNode(b, test::addSphere(b, 0.4, 12, 24), b.append("materials", std::move(m)), at(x, y, 0));
  };
  json layered = material({0.8, 0.3, 0.2, 1}, 0.5, 0.4);
  layered["emissiveFactor"] = {0.1, 0.2, 0.3};
  layered["extensions"]["KHR_materials_clearcoat"] = {{"clearcoatFactor", 0.7}, {"clearcoatRoughnessFactor", 0.1}};
  layered["extensions"]["KHR_materials_sheen"] = {{"sheenColorFactor", {0.3, 0.3, 0.6}}, {"sheenRoughnessFactor", 0.5}};
  ball(layered, -1, 0.5);
  json glass = material({0.9, 1, 0.9, 1}, 0, 0.1);
  glass["extensions"]["KHR_materials_transmission"] = {{"transmissionFactor", 0.9}};
  ball(glass, 0, 0.5);
  json leaf = material({0.2, 0.7, 0.1, 1}, 0, 0.6);
  leaf["extensions"]["KHR_materials_diffuse_transmission"] = {{"diffuseTransmissionFactor", 0.5}};
  ball(leaf, 1, 0.5);
  ball(material({1, 0.8, 0.3, 1}, 1, 0.3), -1, -0.5);
  ball(unlit({0.3, 0.1, 0.4, 1}), 0, -0.5);
  json pane = material({0.5, 0.5, 1, 0.4}, 0, 0.2);
  pane["alphaMode"] = "BLEND";
  ball(pane, 1, -0.5);
  test::addMeshNode(b, test::addQuad(b, {-0.7, -1}, {1.2, 0.6}), b.append("materials", material({0.6, 0.6, 0.6, 1})),
                    at(0, 0, -0.6));
  b.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "point"}, {"intensity", 12}, {"color", {1, 0.8, 0.6}}}};
  json lamp = at(0.5, 1.5, 2);
  lamp["extensions"]["KHR_lights_punctual"]["light"] = 0;
  b.json["scenes"][0]["nodes"].push_back(b.append("nodes", lamp));
  test::addOrthographicCamera(b, 1.6, 1.2);
  return b;
}

struct Sum {
  double off = 0, of = 0;  // largest difference, and radiance
  std::map<std::string, double> means;
};

Sum sumOfParts(const io::LoadedModel& model, PictureSettings settings) {
  test::Studio studio;
  studio.display = false;
  frame::LoadedScene scene = test::sceneOf(model);
  const frame::Picture whole = studio.render(scene, settings);
  std::vector<glm::dvec3> sum(whole.radiance.pixels.size(), glm::dvec3(0));
  Sum out;
  for (const char* part : parts) {
    settings.look.channel = part;
    const frame::Picture picture = studio.render(scene, settings);
    REQUIRE(picture.radiance.pixels.size() == sum.size());
    for (size_t i = 0; i < sum.size(); ++i) {
      const glm::dvec3 value(picture.radiance.pixels[i]);
      sum[i] += value;
      out.means[part] += (value.x + value.y + value.z) / (3.0 * static_cast<double>(sum.size()));
    }
  }
  for (size_t i = 0; i < sum.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double value = static_cast<double>(whole.radiance.pixels[i][c]);
      out.of = std::max(out.of, value);
      out.off = std::max(out.off, std::abs(sum[i][c] - value) / std::max(1.0, value));
    }
  return out;
}

PictureSettings partSettings() {
  PictureSettings settings = test::bareSettings(48, 36);
  settings.viewpoint.camera = "0";
  settings.sources.environment = "builtin:sky";  // with a sun
  settings.frame.background = frame::Background::environment;
  return settings;
}

}  // namespace

TEST_CASE("Parts of the light add up to the picture, and each is there", "[gl]") {
  const io::LoadedModel model = test::loadBuilt(everything());
  PictureSettings settings = partSettings();
  const auto [samples, visibility] =
      GENERATE(table<int, Visibility>({{1, Visibility::none}, {4, Visibility::screen}, {8, Visibility::none}}));
  settings.quality.samples = samples;
  settings.quality.visibility = visibility;
  const Sum sum = sumOfParts(model, settings);
  std::cout << "parts of the light: off by " << 255 * sum.off << " / 255 of radiances up to " << sum.of << "\n";
  CHECK(sum.off < 1.0 / 255);
  CHECK(sum.of > 1);
  for (const auto& [part, mean] : sum.means) {
    INFO(part << " " << mean);
    if (part == "interreflected")
      CHECK((mean > 1e-4) == (visibility == Visibility::screen));
    else
      CHECK(mean > 0.003);
  }
}

TEST_CASE("Parts of the light: of a measured BRDF all is specular, other backgrounds count once", "[gl]") {
  const io::LoadedModel model = test::loadBuilt(everything());
  PictureSettings settings = partSettings();
  settings.quality.samples = 1;
  settings.sources.brdf = "builtin:plastic-0.2";
  Sum sum = sumOfParts(model, settings);
  CHECK(sum.off < 1.0 / 255);
  CHECK(sum.means["lightsDiffuse"] == 0);
  CHECK(sum.means["environmentDiffuse"] == 0);
  CHECK(sum.means["lightsSpecular"] > 0.003);
  settings.sources.brdf.clear();
  settings.frame.background = frame::Background::color;
  settings.frame.backgroundColor = {0.2f, 0.4f, 0.6f};
  sum = sumOfParts(model, settings);
  CHECK(sum.off < 1.0 / 255);
  CHECK(sum.means["background"] > 0.05);
  settings.frame.background = frame::Background::transparent;
  sum = sumOfParts(model, settings);
  CHECK(sum.off < 1.0 / 255);
  CHECK(sum.means["background"] == 0);
}

TEST_CASE("Parts of the light read what lights them, and nothing else", "[gl]") {
  const io::LoadedModel model = test::loadBuilt(everything());
  PictureSettings settings = partSettings();
  const auto tables = [&](const char* part) {
    settings.look.channel = part;
    test::Studio studio;
    const frame::Picture picture = studio.render(model, settings);
    std::string names;
    for (const auto& [name, draws] : picture.statistics.variants) names += name + "; ";
    return std::pair(picture.statistics.tables.size(), names);
  };
  const auto lights = tables("lightsDiffuse"), environment = tables("environmentSpecular"), emitted = tables("emitted");
  CHECK(lights.first < environment.first);
  CHECK(lights.second.find("punctual lights") != std::string::npos);
  CHECK(lights.second.find("environment,") == std::string::npos);
  CHECK(emitted.second.find("punctual lights") == std::string::npos);
}
