#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>

#include "optics/bsdf.hpp"
#include "optics/mapping.hpp"
#include "optics/presets.hpp"
#include "scene/builtin_environments.hpp"
#include "support/picture.hpp"

using namespace facet;
using frame::PictureSettings;
using nlohmann::json;
using optics::DiffuseModel;
using optics::EnergyModel;
using optics::FresnelModel;
using optics::Masking;
using optics::NormalDistribution;
using test::GltfBuilder;

namespace {

constexpr double roughness = 0.6;

// A plane under one point light, seen from above by an orthographic camera.
GltfBuilder litPlane(const glm::dvec3& light, json extension, const glm::vec3& color, double metallic) {
  GltfBuilder builder = test::emptyScene();
  json plane = test::material(glm::vec4(color, 1), metallic, roughness);
  if (!extension.is_null()) {
    plane["extensions"]["FACET_materials_models"] = std::move(extension);
    builder.json["extensionsUsed"].push_back("FACET_materials_models");
  }
  const int index = builder.append("materials", plane);
  test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {1, 1}), index);
  builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}, {"intensity", 7}}};
  json node = test::at(light.x, light.y, light.z);
  node["extensions"]["KHR_lights_punctual"]["light"] = 0;
  builder.json["scenes"][0]["nodes"].push_back(builder.append("nodes", node));
  test::addOrthographicCamera(builder, 1, 1);
  return builder;
}

// Largest relative error of the picture against the twin.
double worstError(test::Studio& studio, const optics::Models& chosen, const optics::Models& shown, json extension,
                  const optics::Conductor* conductor, double metallic) {
  const glm::dvec3 light(0.7, -0.6, 0.4),
      color = conductor ? optics::findMetal("gold")->f0() : glm::dvec3(0.8, 0.5, 0.1);
  PictureSettings settings = test::bareSettings(16, 16);
  settings.viewpoint.camera = "0";
  settings.look.models.diffuse = chosen.diffuse, settings.look.models.fresnel = chosen.fresnel;
  settings.look.models.distribution = chosen.distribution, settings.look.models.masking = chosen.masking;
  settings.look.models.energy = chosen.energy;
  const GltfBuilder builder = litPlane(light, std::move(extension), glm::vec3(color), metallic);
  const frame::Picture picture = studio.render(test::loadBuilt(builder), settings);
  optics::Surface surface{color, metallic, roughness};
  surface.models = shown;
  surface.conductor = conductor;
  const glm::dvec3 N(0, 0, 1);
  const optics::Dfg dfg = optics::dfgOf(surface, 1);
  double worst = 0;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      const glm::dvec3 towards = light - glm::dvec3((x + 0.5) / 8 - 1, 1 - (y + 0.5) / 8, 0);
      const double distance2 = glm::dot(towards, towards);
      const glm::dvec3 L = towards / std::sqrt(distance2);
      const optics::Dfg dfgL = optics::dfgOf(surface, L.z);
      const optics::Reflected r = optics::reflect(surface, dfg, N, N, L, dfgL.A + dfgL.B);
      const glm::dvec3 expected = (r.specular + r.diffuse) * (7 / distance2);
      const glm::vec4& got = test::pixel(picture.radiance, x, y);
      for (int i = 0; i < 3; ++i)
        worst = std::max(worst, std::abs(double(got[i]) - expected[i]) / std::max(expected[i], 1e-3));
    }
  return worst;
}

}  // namespace

TEST_CASE("Chosen models under a point light, against the double-precision surface") {
  test::Studio studio;
  const optics::MetalPreset& gold = *optics::findMetal("gold");
  const optics::Conductor conductor{gold.eta, gold.k};
  const auto check = [&](const char* name, const optics::Models& models, const optics::Conductor* metal,
                         double metallic) {
    const json extension = metal ? json{{"conductor", "gold"}} : json();
    const double worst = worstError(studio, models, models, extension, metal, metallic);
    std::cout << "models, " << name << ": largest relative error " << worst << "\n";
    INFO(name);
    CHECK(worst < 3e-3);  // half floats and the DFG table
  };
  check("Burley", {.diffuse = DiffuseModel::burley}, nullptr, 0.3);
  check("Frostbite", {.diffuse = DiffuseModel::frostbite}, nullptr, 0.3);
  check("Oren-Nayar", {.diffuse = DiffuseModel::orenNayar}, nullptr, 0.3);
  check("EON", {.diffuse = DiffuseModel::eon}, nullptr, 0.3);
  check("Call of Duty", {.diffuse = DiffuseModel::callOfDuty}, nullptr, 0.3);
  check("exact Fresnel", {.fresnel = FresnelModel::exact}, nullptr, 0);
  check("exact Fresnel of gold", {.fresnel = FresnelModel::exact}, &conductor, 1);
  check("F82-tint of gold", {.fresnel = FresnelModel::f82Tint}, &conductor, 1);
  check("Beckmann", {.distribution = NormalDistribution::beckmann}, nullptr, 0.5);
  check("Blinn", {.distribution = NormalDistribution::blinn}, nullptr, 0.5);
  check("approximate masking", {.masking = Masking::approximate}, nullptr, 0.5);
  check("V-cavities", {.masking = Masking::cavity}, nullptr, 0.5);
  check("remapped masking", {.masking = Masking::remapped}, nullptr, 0.5);
  check("single scattering", {.energy = EnergyModel::none}, nullptr, 0.5);
  check("Fdez-Aguera", {.energy = EnergyModel::fdezAguera}, nullptr, 0.5);
  check("Kulla and Conty", {.energy = EnergyModel::kullaConty}, nullptr, 0.5);
  check("Turquin", {.energy = EnergyModel::turquin}, nullptr, 0.5);
  // A material that names its distribution keeps it, whatever the picture's.
  const double own =
      worstError(studio, {.distribution = NormalDistribution::blinn}, {.distribution = NormalDistribution::beckmann},
                 {{"microfacets", "beckmann"}}, nullptr, 1);
  CHECK(own < 3e-3);
  CHECK(worstError(studio, {}, {.distribution = NormalDistribution::beckmann}, nullptr, nullptr, 1) > 0.1);
}

TEST_CASE("EON keeps a white furnace white, in default and in sampled pictures, Burley's loses and gains") {
  const io::LoadedModel model = test::loadBuiltin("builtin:furnace");
  test::Studio studio;
  PictureSettings settings = test::bareSettings(220, 44);
  settings.sources.environment = "builtin:white";
  settings.viewpoint.orbit = frame::Orbit{0, 90, 32.2};
  settings.viewpoint.fovYDeg = 4;
  const auto range = [&] {
    glm::vec2 ends(9, 0);
    const frame::Picture picture = studio.render(model, settings);
    for (int y = 22; y < 44; ++y)  // dielectrics
      for (int x = 0; x < 220; ++x) {
        const glm::vec4& p = test::pixel(picture.radiance, x, y);
        if (p.w == 1) ends = {std::min(ends.x, p.x), std::max(ends.y, p.x)};
      }
    return ends;
  };
  settings.look.models.diffuse = DiffuseModel::eon;
  const glm::vec2 eon = range();
  CHECK(eon.x > 0.985f);
  CHECK(eon.y < 1.015f);
  settings.look.models.diffuse = DiffuseModel::burley;
  const glm::vec2 burley = range();
  CHECK(burley.x < 0.93f);
  CHECK(burley.y > 1.02f);
  settings.quality.samples = 64;
  settings.look.models.diffuse = DiffuseModel::eon;
  const glm::vec2 sampled = range();
  std::cout << "white dielectrics: EON " << eon.x << " to " << eon.y << ", sampled " << sampled.x << " to " << sampled.y
            << "; Burley " << burley.x << " to " << burley.y << "\n";
  CHECK(sampled.x > 0.9f);
  CHECK(sampled.y < 1.1f);
}

TEST_CASE("Sampled pictures shade with the diffuse model itself: against the sum over the environment's texels") {
  // Tilted away from the viewer; the dielectric's base alone differs from model to model.
  GltfBuilder builder = test::emptyScene();
  const int rough = builder.append("materials", test::material({0.8, 0.5, 0.1, 1}, 0, 1));
  const double tilt = glm::radians(-65.0);
  test::addMeshNode(builder, test::addQuad(builder, {-4, -4}, {4, 4}), rough,
                    {{"rotation", {std::sin(tilt / 2), 0, 0, std::cos(tilt / 2)}}});
  test::addOrthographicCamera(builder, 0.1, 0.1);
  const io::LoadedModel model = test::loadBuilt(builder);
  PictureSettings settings = test::bareSettings(4, 4);
  settings.viewpoint.camera = "0";
  settings.sources.environment = "builtin:studio";
  settings.quality.samples = 256;
  test::Studio studio;
  const glm::dvec3 lambert(test::pixel(studio.render(model, settings).radiance, 2, 2));

  const scene::Environment studioMap = *scene::builtinEnvironment("studio");
  const glm::dvec3 N(0, -std::sin(tilt), std::cos(tilt)), V(0, 0, 1), color(0.8, 0.5, 0.1);
  optics::Surface surface{color, 0, 1};
  const glm::dvec3 left = optics::energyFdezAguera(optics::dfgOf(surface, N.z), surface.f0).diffuse;
  for (const DiffuseModel model_ : {DiffuseModel::eon, DiffuseModel::burley, DiffuseModel::callOfDuty}) {
    glm::dvec3 expected(0);
    for (int row = 0; row < studioMap.height; ++row)
      for (int column = 0; column < studioMap.width; ++column) {
        const glm::dvec3 L =
            optics::directionFromEquirect(optics::equirectTexelCentre(column, row, studioMap.width, studioMap.height));
        const double NoL = glm::dot(N, L);
        if (NoL <= 0) continue;
        const glm::dvec3 f =
            optics::diffuseTerm(model_, {N.z, NoL, glm::dot(V, L)}, 1, color) - color * optics::Fd_Lambert();
        expected += f * glm::dvec3(studioMap.radiance[size_t(row * studioMap.width + column)]) *
                    (NoL * optics::equirectTexelSolidAngle(row, studioMap.width, studioMap.height));
      }
    expected *= left;
    settings.look.models.diffuse = model_;
    const glm::dvec3 got = glm::dvec3(test::pixel(studio.render(model, settings).radiance, 2, 2)) - lambert;
    std::cout << "sampled diffuse model " << int(model_) << ": difference to Lambert " << got.x << ", expected "
              << expected.x << " of " << lambert.x << "\n";
    for (int i = 0; i < 3; ++i) CHECK(std::abs(got[i] - expected[i]) < 0.005 * lambert[i]);
  }
}

TEST_CASE("Energy models in a white furnace, in default and in sampled pictures") {
  const io::LoadedModel model = test::loadBuiltin("builtin:furnace");
  test::Studio studio;
  PictureSettings settings = test::bareSettings(220, 44);
  settings.sources.environment = "builtin:white";
  settings.viewpoint.orbit = frame::Orbit{0, 90, 32.2};
  settings.viewpoint.fovYDeg = 4;
  const auto check = [&](const char* name, EnergyModel energy, int samples, float within) {
    settings.look.models.energy = energy;
    settings.quality.samples = samples;
    const frame::Picture picture = studio.render(model, settings);
    glm::vec2 ends[2] = {{9, 0}, {9, 0}};  // metal above, dielectric below
    for (int y = 0; y < 44; ++y)
      for (int x = 0; x < 220; ++x) {
        const glm::vec4& p = test::pixel(picture.radiance, x, y);
        glm::vec2& range = ends[y < 22 ? 0 : 1];
        if (p.w == 1) range = {std::min(range.x, p.x), std::max(range.y, p.x)};
      }
    std::cout << "white furnace, " << name << ", " << samples << " samples: metal " << ends[0].x << " to " << ends[0].y
              << ", dielectric " << ends[1].x << " to " << ends[1].y << "\n";
    INFO(name << ", " << samples << " samples");
    if (energy == EnergyModel::none)
      CHECK(ends[0].x == Approx(1 - std::log(2.0)).margin(within + 0.01));
    else
      CHECK(ends[0].x > 1 - within);
    CHECK(ends[0].y < 1 + within);
    CHECK(ends[1].x > 1 - within);
    CHECK(ends[1].y < 1 + within);
  };
  // In sampled pictures 64 samples of the lobe, the same ones in every pixel.
  check("none", EnergyModel::none, 4, 0.01f);
  check("Turquin", EnergyModel::turquin, 4, 0.01f);
  check("Kulla and Conty", EnergyModel::kullaConty, 4, 0.01f);
  check("none", EnergyModel::none, 16, 0.06f);
  check("Turquin", EnergyModel::turquin, 16, 0.08f);
  check("Kulla and Conty", EnergyModel::kullaConty, 16, 0.06f);
}

TEST_CASE("Sampled pictures: Kulla and Conty's further bounces against the sum over the environment's texels") {
  GltfBuilder builder = test::emptyScene();
  const int rough = builder.append("materials", test::material({0.9, 0.6, 0.3, 1}, 1, 1));
  const double tilt = glm::radians(-65.0);
  test::addMeshNode(builder, test::addQuad(builder, {-4, -4}, {4, 4}), rough,
                    {{"rotation", {std::sin(tilt / 2), 0, 0, std::cos(tilt / 2)}}});
  test::addOrthographicCamera(builder, 0.1, 0.1);
  const io::LoadedModel model = test::loadBuilt(builder);
  PictureSettings settings = test::bareSettings(4, 4);
  settings.viewpoint.camera = "0";
  settings.sources.environment = "builtin:studio";
  settings.quality.samples = 256;
  test::Studio studio;
  settings.look.models.energy = EnergyModel::none;
  const glm::dvec3 single(test::pixel(studio.render(model, settings).radiance, 2, 2));
  settings.look.models.energy = EnergyModel::kullaConty;
  const glm::dvec3 got = glm::dvec3(test::pixel(studio.render(model, settings).radiance, 2, 2)) - single;

  const scene::Environment studioMap = *scene::builtinEnvironment("studio");
  const glm::dvec3 N(0, -std::sin(tilt), std::cos(tilt)), color(0.9, 0.6, 0.3);
  const glm::dvec3 multiple =
      optics::compensationOf(EnergyModel::kullaConty, optics::integrateDfg(N.z, 1), 1, color).multiple;
  glm::dvec3 expected(0), flat(0);
  for (int row = 0; row < studioMap.height; ++row)
    for (int column = 0; column < studioMap.width; ++column) {
      const glm::dvec3 L =
          optics::directionFromEquirect(optics::equirectTexelCentre(column, row, studioMap.width, studioMap.height));
      const double NoL = glm::dot(N, L);
      if (NoL <= 0) continue;
      const double E = 1 - NoL * std::log1p(1 / NoL);  // roughness 1
      const glm::dvec3 arriving =
          multiple * glm::dvec3(studioMap.radiance[size_t(row * studioMap.width + column)]) *
          (NoL / optics::pi * optics::equirectTexelSolidAngle(row, studioMap.width, studioMap.height));
      expected += arriving * optics::multipleShape(EnergyModel::kullaConty, E, 1);
      flat += arriving;
    }
  std::cout << "sampled, Kulla and Conty: " << got.x << ", expected " << expected.x << ", flat " << flat.x << "\n";
  for (int i = 0; i < 3; ++i) CHECK(got[i] == Approx(expected[i]).epsilon(0.02));
}

TEST_CASE("Models that a picture cannot show are told") {
  test::Studio studio;
  const auto notesOf = [&](const std::string& source, const std::string& environment, const auto& choose) {
    PictureSettings settings = test::bareSettings(8, 8);
    settings.sources.environment = environment;
    choose(settings);
    studio.render(test::loadBuiltin(source), settings);
    std::string all;
    for (const Note& note : studio.notes) all += note.text + "\n";
    return all;
  };
  const auto beckmann = [](PictureSettings& s) { s.look.models.distribution = NormalDistribution::beckmann; };
  const auto exact = [](PictureSettings& s) { s.look.models.fresnel = FresnelModel::exact; };
  CHECK(notesOf("builtin:furnace", "builtin:white", beckmann)
            .find("the distribution of normals and the masking term change nothing") == 0);
  CHECK(notesOf("builtin:spheres", "builtin:white", beckmann).find("GGX reflects the environment") !=
        std::string::npos);
  CHECK(notesOf("builtin:spheres", "none", beckmann).empty());
  CHECK(notesOf("builtin:furnace", "builtin:white", exact).find("the Fresnel term changes nothing") == 0);
  CHECK(notesOf("builtin:spheres", "none", exact).empty());
  CHECK(notesOf("builtin:ndf", "builtin:white", [](PictureSettings&) {}).empty());
}
