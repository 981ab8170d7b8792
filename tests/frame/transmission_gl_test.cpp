#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <iostream>

#include "optics/bsdf.hpp"
#include "optics/transmission.hpp"
#include "optics/transmitted.hpp"
#include "support/picture.hpp"

using namespace facet;
using frame::PictureSettings;
using nlohmann::json;
using test::at, test::checkPixel, test::emptyScene, test::material, test::unlit;
using test::GltfBuilder;

namespace {

struct Glass {
  GltfBuilder builder = emptyScene();
  int glass = 0;  // index of the material

  Glass() { glass = builder.append("materials", material({1, 1, 1, 1}, 0, 0)); }
  // An unlit quad in front of the camera, z away from the origin.
  void paint(const glm::vec4& color, glm::vec2 low, glm::vec2 high, double z, const json& extra = json::object()) {
    const int painted = builder.append("materials", unlit(color, extra));
    test::addMeshNode(builder, test::addQuad(builder, low, high), painted, at(0, 0, z));
  }
  void pane(glm::vec2 low, glm::vec2 high, const json& where = at(0, 0, 0)) {
    test::addMeshNode(builder, test::addQuad(builder, low, high), glass, where);
  }
  // The pane's material is set where the file's extensions would.
  io::LoadedModel load(const std::function<void(scene::Material&)>& change) {
    io::LoadedModel model = test::loadBuilt(builder);
    scene::Material& m = model.model.materials[static_cast<size_t>(glass)];
    m.transmissionFactor = 1;
    change(m);
    return model;
  }
};

PictureSettings frontSettings(int width, int height) {
  PictureSettings settings = test::bareSettings(width, height);
  settings.viewpoint.camera = "0";
  return settings;
}

bool hasPass(const frame::Picture& picture, const std::string& name) {
  return std::ranges::count(picture.statistics.frame.passes, name) > 0;
}

// What enters a dielectric of f0 0.04 facing the viewer, by the formulas that evaluateBsdf and irradianceAlbedo share.
double entering(double perceptualRoughness, double f0 = 0.04) {
  optics::Surface surface{glm::dvec3(1), 0, perceptualRoughness, glm::dvec3(f0)};
  const optics::SpecularEnergy energy = optics::energyFdezAguera(optics::dfgOf(surface, 1), surface.f0);
  return energy.diffuse.x;
}

}  // namespace

TEST_CASE("A thin sheet of glass shows what is behind times its tint, and nothing is see-through there") {
  Glass scene;
  scene.paint({0.5, 0.25, 1, 1}, {-1, -1}, {0, 1}, -1);
  scene.paint({1, 1, 1, 1}, {0, -1}, {1, 1}, -1);
  scene.pane({-1, -1}, {1, 0});  // the lower half
  test::addOrthographicCamera(scene.builder, 1, 1);
  const io::LoadedModel model = scene.load([](scene::Material& m) { m.baseColorFactor = {0.9f, 0.5f, 0.2f, 1}; });
  test::Studio studio;
  const float T = float(entering(0));
  for (const int samples : {1, 4}) {
    PictureSettings settings = frontSettings(8, 8);
    settings.quality.samples = samples;
    const frame::Picture picture = studio.render(model, settings);
    checkPixel(test::pixel(picture.radiance, 1, 1), {0.5f, 0.25f, 1, 1});
    checkPixel(test::pixel(picture.radiance, 1, 6), {0.9f * 0.5f * T, 0.5f * 0.25f * T, 0.2f * T, 1}, 2e-3f);
    checkPixel(test::pixel(picture.radiance, 6, 6), {0.9f * T, 0.5f * T, 0.2f * T, 1}, 2e-3f);
  }
}

TEST_CASE("Glass before nothing stays see-through: by its mean transmittance, or by its least before a known colour") {
  Glass scene;
  scene.pane({-1, -1}, {1, 1});
  test::addOrthographicCamera(scene.builder, 1, 1);
  const io::LoadedModel model = scene.load([](scene::Material& m) { m.baseColorFactor = {0.9f, 0.6f, 0.3f, 1}; });
  test::Studio studio;
  PictureSettings settings = frontSettings(4, 4);
  const float T = float(entering(0));
  checkPixel(test::pixel(studio.render(model, settings).radiance, 1, 1), {0, 0, 0, 1 - 0.6f * T}, 2e-3f);

  settings.frame.background = frame::Background::color;
  settings.frame.backgroundColor = glm::vec3(0.5f, 1, 1);
  settings.display.toneMapper = frame::ToneMapper::none;
  settings.display.exposureStops = 1;
  const frame::Picture shown = studio.render(model, settings);
  const auto byte = [&](int channel) { return int(shown.display.data[static_cast<size_t>(3 * 5 + channel)]); };
  const auto encoded = [](float linear) { return 255 * (1.055f * std::pow(linear, 1 / 2.4f) - 0.055f); };
  CHECK(std::abs(float(byte(0)) - encoded(0.5f * 0.9f * T)) <= 1.5f);
  CHECK(std::abs(float(byte(1)) - encoded(0.6f * T)) <= 1.5f);
  CHECK(std::abs(float(byte(2)) - encoded(0.3f * T)) <= 1.5f);
}

TEST_CASE("A volume attenuates by colour^(way / distance), the way scaled with the node") {
  Glass scene;
  scene.paint({1, 1, 1, 1}, {-2, -2}, {2, 2}, -5);
  json where = at(0, 0, 0);
  where["scale"] = {2, 2, 2};
  scene.pane({-1, -1}, {1, 1}, where);
  test::addOrthographicCamera(scene.builder, 1, 1);
  const glm::vec3 color(0.8f, 0.4f, 0.1f);
  const io::LoadedModel model = scene.load([&](scene::Material& m) {
    m.thicknessFactor = 0.75f;
    m.attenuationColor = color;
    m.attenuationDistance = 0.6f;
  });
  const frame::Picture picture = test::Studio().render(model, frontSettings(4, 4));
  const glm::dvec3 expected = optics::volumeTransmittance(color, double(0.6f), 1.5) * entering(0);
  checkPixel(test::pixel(picture.radiance, 1, 1), glm::vec4(glm::vec3(expected), 1), 2e-3f);
}

TEST_CASE("A body of ior 1 only attenuates: neither reflection nor refraction nor blur") {
  Glass scene;
  scene.paint({1, 1, 1, 1}, {-9, -9}, {0, 9}, -5);
  json where = at(0, 0, 0);
  where["rotation"] = {0, std::sin(0.3), 0, std::cos(0.3)};
  scene.pane({-3, -3}, {3, 3}, where);
  test::addOrthographicCamera(scene.builder, 1, 1);
  const glm::vec3 color(0.8f, 0.4f, 0.1f);
  const io::LoadedModel model = scene.load([&](scene::Material& m) {
    m.ior = 1;
    m.specularWeight = 0;  // no reflection at grazing angles either
    m.perceptualRoughnessFactor = 0.7f;
    m.thicknessFactor = 0.75f;
    m.attenuationColor = color;
    m.attenuationDistance = 0.6f;
  });
  const frame::Picture picture = test::Studio().render(model, frontSettings(8, 8));
  const glm::dvec3 expected = optics::volumeTransmittance(color, double(0.6f), 0.75);
  for (int x = 0; x < 4; ++x) checkPixel(test::pixel(picture.radiance, x, 4), glm::vec4(glm::vec3(expected), 1), 1e-3f);
  checkPixel(test::pixel(picture.radiance, 4, 4), {0, 0, 0, 1 - float(expected.x + expected.y + expected.z) / 3});
}

TEST_CASE("A refracting body shifts what is behind by its closed form, each colour by its own index") {
  // The view along -Z meets a pane that is turned by theta about Y: the ray leaves thickness sin(theta - theta') aside.
  const double theta = 0.7, thickness = 0.8, ior = 1.5, dispersion = 8;
  Glass scene;
  scene.paint({1, 1, 1, 1}, {-4, -4}, {0, 4}, -3);  // an edge at x = 0
  scene.paint({0, 0, 0, 1}, {0, -4}, {4, 4}, -3);
  json where = at(0, 0, 0);
  where["rotation"] = {0, std::sin(theta / 2), 0, std::cos(theta / 2)};
  scene.pane({-3, -3}, {3, 3}, where);
  test::addOrthographicCamera(scene.builder, 1, 0.02);
  const io::LoadedModel model = scene.load([&](scene::Material& m) {
    m.thicknessFactor = float(thickness);
    m.dispersion = float(dispersion);
  });
  const int width = 400;
  const frame::Picture picture = test::Studio().render(model, frontSettings(width, 8));
  const glm::dvec3 iors = optics::dispersedIors(ior, dispersion);
  const float full = test::pixel(picture.radiance, 4, 4).x;
  CHECK(full > 0.8f);
  double worst = 0;
  for (int channel = 0; channel < 3; ++channel) {
    double bright = 0;  // pixels left of the edge
    for (int x = 0; x < width; ++x) bright += double(test::pixel(picture.radiance, x, 4)[channel] / full);
    const double edge = 2 * bright / width - 1;
    // N = (sin theta, 0, cos theta); refraction turns the ray towards -N, that is to negative x.
    const double expected = thickness * std::sin(theta - std::asin(std::sin(theta) / iors[channel]));
    worst = std::max(worst, std::abs(edge - expected));
  }
  std::cout << "refraction: an edge's place is off by at most " << worst * width / 2 << " pixels\n";
  CHECK(worst < 1.5 * 2 / width);
}

TEST_CASE("Rough glass blurs an edge behind it as its lobe does, in proportion to the distance behind") {
  test::Studio studio;
  for (const int samples : {1, 64})
    for (const double roughness : {0.25, 0.4, 0.5})
      for (const double distance : {0.25, 0.5}) {
        Glass scene;
        scene.paint({1, 1, 1, 1}, {-9, -9}, {0, 9}, -distance);
        scene.paint({0, 0, 0, 1}, {0, -9}, {9, 9}, -distance);
        scene.pane({-9, -9}, {9, 9});
        test::addOrthographicCamera(scene.builder, 1, 0.5);
        const io::LoadedModel model =
            scene.load([&](scene::Material& m) { m.perceptualRoughnessFactor = float(roughness); });
        PictureSettings settings = frontSettings(256, 128);
        settings.quality.samples = samples;
        if (samples > 1) settings.sources.environment = "builtin:white", settings.frame.environmentStrength = 1e-6f;
        const frame::Picture picture = studio.render(model, settings);
        const double a = 2 * roughness * roughness * distance;
        double worst = 0;
        for (int x = 20; x < 236; ++x) {
          const double p = (x + 0.5) / 128 - 1;
          const double expected = 0.5 * (1 - p / std::hypot(p, a));
          worst = std::max(worst,
                           std::abs(double(test::pixel(picture.radiance, x, 64).x) / entering(roughness) - expected));
        }
        std::cout << "blur, " << samples << " samples, roughness " << roughness << ", " << distance
                  << " m behind: edge off by at most " << worst << "\n";
        CHECK(worst < 0.05);
      }
}

TEST_CASE("White glass in a white furnace: what is reflected and what passes make 1") {
  test::Studio studio;
  for (const int samples : {4, 16})
    for (const float roughness : {0.0f, 0.3f, 0.6f, 1.0f})
      for (const float thickness : {0.0f, 0.5f}) {
        Glass scene;
        test::addMeshNode(scene.builder, test::addSphere(scene.builder, 1), scene.glass);
        const io::LoadedModel model = scene.load([&](scene::Material& m) {
          m.perceptualRoughnessFactor = roughness;
          m.thicknessFactor = thickness;
          m.dispersion = thickness;
          m.diffuseTransmissionFactor = 0.5f;
          m.transmissionFactor = 0.75f;
        });
        PictureSettings settings = test::bareSettings(40, 40);
        settings.sources.environment = "builtin:white";
        settings.frame.background = frame::Background::environment;
        settings.quality.samples = samples;
        const frame::Picture picture = studio.render(model, settings);
        CHECK(hasPass(picture, "transmit"));
        float low = 2, high = 0;
        for (const glm::vec4& p : picture.radiance.pixels)
          for (int i = 0; i < 3; ++i) low = std::min(low, p[i]), high = std::max(high, p[i]);
        std::cout << "glass in a furnace, " << samples << " samples, roughness " << roughness << ", thickness "
                  << thickness << ": " << low << " to " << high << "\n";
        CHECK(low > (samples == 4 ? 0.985f : 0.96f));
        CHECK(high < (samples == 4 ? 1.01f : 1.04f));
        // The same before nothing: what is missing is see-through.
        settings.frame.background = frame::Background::transparent;
        const frame::Picture open = studio.render(model, settings);
        const glm::vec4 center = test::pixel(open.radiance, 20, 20);
        CHECK(std::abs(center.x + 1 - center.w - 1) < 0.02f);
        CHECK(center.w < 0.5f);
      }
}

TEST_CASE("White glass under a coat, sheen and a film keeps the furnace's energy too") {
  Glass scene;
  test::addMeshNode(scene.builder, test::addSphere(scene.builder, 1), scene.glass);
  test::Studio studio;
  for (const float roughness : {0.1f, 0.6f}) {
    const io::LoadedModel model = scene.load([&](scene::Material& m) {
      m.perceptualRoughnessFactor = roughness;
      m.thicknessFactor = 0.3f;
      m.ior = 1.8f;
      m.clearcoatFactor = 1, m.clearcoatRoughnessFactor = 0.2f;
      m.sheenColorFactor = glm::vec3(0.5f), m.sheenRoughnessFactor = 0.5f;
      m.iridescenceFactor = 0.5f;
    });
    PictureSettings settings = test::bareSettings(40, 40);
    settings.sources.environment = "builtin:white";
    settings.frame.background = frame::Background::environment;
    settings.quality.samples = 4;
    const frame::Picture picture = studio.render(model, settings);
    float low = 2, high = 0;
    for (const glm::vec4& p : picture.radiance.pixels)
      for (int i = 0; i < 3; ++i) low = std::min(low, p[i]), high = std::max(high, p[i]);
    std::cout << "glass under layers in a furnace, roughness " << roughness << ": " << low << " to " << high << "\n";
    CHECK(high < 1.01f);
    CHECK(low > 0.8f);  // the layers' own losses
  }
}

TEST_CASE("Blended surfaces behind glass shine through it, those before it are drawn over it") {
  Glass scene;
  const json blend = {{"alphaMode", "BLEND"}};
  scene.paint({1, 1, 1, 1}, {-2, -2}, {2, 2}, -3);
  scene.paint({1, 0, 0, 0.5}, {-1, -1}, {0, 1}, -1, blend);
  scene.paint({0, 0, 1, 0.25}, {0, -1}, {1, 1}, 1, blend);
  scene.pane({-1, -1}, {1, 0});
  test::addOrthographicCamera(scene.builder, 1, 1);
  const io::LoadedModel model = scene.load([](scene::Material& m) { m.baseColorFactor = {0.5f, 0.5f, 0.5f, 1}; });
  const frame::Picture picture = test::Studio().render(model, frontSettings(8, 8));
  const float T = 0.5f * float(entering(0));
  checkPixel(test::pixel(picture.radiance, 1, 1), {1, 0.5f, 0.5f, 1});
  checkPixel(test::pixel(picture.radiance, 1, 6), {T, 0.5f * T, 0.5f * T, 1}, 2e-3f);
  checkPixel(test::pixel(picture.radiance, 6, 1), {0.75f, 0.75f, 1, 1});
  checkPixel(test::pixel(picture.radiance, 6, 6), {0.75f * T, 0.75f * T, 0.75f * T + 0.25f, 1}, 2e-3f);
  CHECK(picture.statistics.frame.passes ==
        std::vector<std::string>{"opaque", "blend behind", "copy behind", "transmit", "blend", "display"});
}

TEST_CASE("Glass that is blended too covers by its alpha, a back face shows only where it is double-sided") {
  Glass scene;
  scene.paint({1, 1, 1, 1}, {-2, -2}, {2, 2}, -3);
  json turned = at(0, 0, 0);
  turned["rotation"] = {0, 1, 0, 0};
  scene.pane({-1, -1}, {1, 0}, turned);
  test::addOrthographicCamera(scene.builder, 1, 1);
  test::Studio studio;
  const float T = float(entering(0));
  for (const bool both : {false, true}) {
    const io::LoadedModel model = scene.load([&](scene::Material& m) {
      m.baseColorFactor = {0.5f, 0.5f, 0.5f, 0.25f};
      m.alphaMode = scene::AlphaMode::blend;
      m.doubleSided = both;
    });
    const float expected = both ? 0.75f + 0.25f * 0.5f * T : 1;
    checkPixel(test::pixel(studio.render(model, frontSettings(8, 8)).radiance, 2, 6), {expected, expected, expected, 1},
               2e-3f);
  }
}

TEST_CASE("Frugality: nothing is copied, mipped or defined where nothing transmits or where that is out of sight") {
  test::Studio studio;
  Glass scene;
  scene.paint({1, 1, 1, 1}, {-1, -1}, {1, 1}, -3);
  scene.pane({-1, -1}, {1, 1}, at(50, 0, 0));
  test::addOrthographicCamera(scene.builder, 1, 1);
  const frame::Picture away = studio.render(scene.load([](scene::Material&) {}), frontSettings(4, 4));
  CHECK(away.statistics.frame.passes == std::vector<std::string>{"opaque", "display"});
  const io::LoadedModel plain = scene.load([](scene::Material& m) { m.transmissionFactor = 0; });
  const frame::DrawList list = frame::buildDrawList(plain.model, 0, {});
  CHECK(list.transmitting.empty());
  for (const frame::Draw& draw : list.opaque)
    for (const shading::Define& define : shading::variantDefines(draw.key))
      CHECK(define.name.find("TRANSMISSION") == std::string::npos);
  frame::Targets targets = frame::createTargets(8, 8, 1, false);
  frame::prepareBehind(targets, list);
  CHECK_FALSE(targets.behind.color);
  frame::prepareBehind(targets, frame::buildDrawList(scene.load([](scene::Material&) {}).model, 0, {}));
  CHECK(targets.behind.color);
  CHECK(targets.behind.color.description().levels == 4);
  frame::prepareBehind(targets, list);
  CHECK_FALSE(targets.behind.color);
}

TEST_CASE("A light behind glass shines through as the mirrored lobe does, one behind paper as its cosine") {
  const double intensity = 5;
  for (const bool paper : {false, true}) {
    Glass scene;
    scene.pane({-1, -1}, {1, 1});
    scene.builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}, {"intensity", intensity}}};
    const glm::dvec3 light(0.3, -0.2, -0.9);
    json node = at(light.x, light.y, light.z);
    node["extensions"]["KHR_lights_punctual"]["light"] = 0;
    scene.builder.json["scenes"][0]["nodes"].push_back(scene.builder.append("nodes", node));
    test::addOrthographicCamera(scene.builder, 1, 1);
    const double roughness = 0.5;
    const glm::dvec3 color(0.9, 0.6, 0.3);
    const io::LoadedModel model = scene.load([&](scene::Material& m) {
      m.perceptualRoughnessFactor = float(roughness);
      m.transmissionFactor = paper ? 0.0f : 1.0f;
      m.diffuseTransmissionFactor = paper ? 0.75f : 0.0f;
      if (paper)
        m.diffuseTransmissionColorFactor = glm::vec3(color);
      else
        m.baseColorFactor = glm::vec4(glm::vec3(color), 1);
    });
    const frame::Picture picture = test::Studio().render(model, frontSettings(16, 16));
    const glm::dvec3 N(0, 0, 1);
    const optics::Dfg dfg = optics::dfgOf({glm::dvec3(1), 0, roughness}, 1);
    double worst = 0;
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        const glm::dvec3 towards = light - glm::dvec3((x + 0.5) / 8 - 1, 1 - (y + 0.5) / 8, 0);
        const double distance2 = glm::dot(towards, towards);
        const glm::dvec3 L = towards / std::sqrt(distance2);
        const double f =
            paper ? 0.75 * -L.z / optics::pi : optics::transmittedLobe(N, L, roughness * roughness) / (dfg.A + dfg.B);
        const glm::dvec3 expected = color * (f * entering(roughness) * intensity / distance2);
        const glm::vec4& got = test::pixel(picture.radiance, x, y);
        for (int i = 0; i < 3; ++i) worst = std::max(worst, std::abs(double(got[i]) - expected[i]) / expected[i]);
      }
    std::cout << "light behind " << (paper ? "paper" : "glass") << ": largest relative error " << worst << "\n";
    CHECK(worst < 4e-3);
  }
}
