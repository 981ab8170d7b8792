#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>

#include "base/srgb.hpp"
#include "optics/bsdf.hpp"
#include "support/picture.hpp"

using namespace facet;
using frame::PictureSettings;
using nlohmann::json;
using test::at, test::checkPixel, test::emptyScene, test::material;
using test::GltfBuilder;

TEST_CASE("Specular-glossiness: a white furnace shows what the surface in double precision reflects, at most all") {
  GltfBuilder builder = emptyScene();
  const glm::dvec3 f0s[] = {{0, 0, 0}, {0.04, 0.04, 0.04}, {0.5, 0.2, 0.9}, {1, 1, 1}};
  const double glosses[] = {0, 0.3, 0.7, 1};
  const bool curved = GENERATE(false, true);
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) {
      const glm::dvec3& f0 = f0s[row];
      json m = material({0, 0, 0, 1});
      m["extensions"]["KHR_materials_pbrSpecularGlossiness"] = {{"specularFactor", {f0.x, f0.y, f0.z}},
                                                                {"glossinessFactor", glosses[column]}};
      json node = at(column - 1.5, 1.5 - row, 0);
      test::addMeshNode(builder,
                        curved ? test::addSphere(builder, 0.5) : test::addQuad(builder, {-0.5, -0.5}, {0.5, 0.5}),
                        builder.append("materials", m), node);
    }
  test::addOrthographicCamera(builder, 2, 2);
  PictureSettings settings = test::bareSettings(96, 96);
  settings.viewpoint.camera = "0";
  settings.sources.environment = "builtin:white";
  const frame::Picture picture = test::Studio().render(test::loadBuilt(builder), settings);
  float largest = 0, off = 0;
  for (const glm::vec4& p : picture.radiance.pixels)
    if (p.w == 1) largest = std::max({largest, p.x, p.y, p.z});
  CHECK(largest <= 1.015f);
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) {
      const optics::Surface surface = optics::specularGlossinessSurface(glm::dvec3(1), f0s[row], glosses[column]);
      const optics::DistantWeights weights = optics::distantWeights(surface, optics::dfgOf(surface, 1));
      const glm::vec4& got = test::pixel(picture.radiance, 24 * column + 12, 24 * row + 12);
      for (int i = 0; i < 3; ++i)
        off = std::max(off, std::abs(got[i] - float(weights.prefiltered[i] + weights.irradiance[i])));
    }
  std::cout << "specular-glossiness furnace: at most " << largest << ", at normal incidence off by " << off << "\n";
  CHECK(off <= 0.006f);
}

TEST_CASE("Specular-glossiness: the texture's alpha is linear, its colour is not, the debug views show them") {
  GltfBuilder builder = emptyScene();
  const std::vector<uint8_t> texel = {188, 188, 188, 64};
  builder.append("images", {{"uri", test::dataUri(test::pngBytes(1, 1, 4, 8, texel), "image/png")}});
  builder.append("textures", {{"source", 0}});
  json m = material({1, 1, 1, 1}, 1, 0.25);
  m["extensions"]["KHR_materials_pbrSpecularGlossiness"] = {{"diffuseFactor", {0.25, 0.5, 0.75, 1}},
                                                            {"glossinessFactor", 0.5},
                                                            {"specularGlossinessTexture", {{"index", 0}}}};
  json quad = test::addQuad(builder, {-1, -1}, {1, 1});
  quad["attributes"]["TEXCOORD_0"] = builder.add(std::vector<float>(8, 0.5f), test::floatType, "VEC2");
  test::addMeshNode(builder, quad, builder.append("materials", m));
  test::addOrthographicCamera(builder, 1, 1);
  const io::LoadedModel model = test::loadBuilt(builder);
  PictureSettings settings = test::bareSettings(2, 2);
  settings.viewpoint.camera = "0";
  test::Studio studio;
  const auto shown = [&](const char* channel) {
    settings.look.channel = channel;
    return test::pixel(studio.render(model, settings).radiance, 1, 1);
  };
  const float rough = 1 - 0.5f * 64 / 255;
  checkPixel(shown("roughness"), {rough, rough, rough, 1});
  checkPixel(shown("metallic"), {0, 0, 0, 1});
  checkPixel(shown("baseColor"), {0.25, 0.5, 0.75, 1});
  settings.sources.environment = "builtin:white";
  const double f0 = linearFromSrgb(188 / 255.0);
  const optics::Surface surface = optics::specularGlossinessSurface({0.25, 0.5, 0.75}, glm::dvec3(f0), 0.5 * 64 / 255);
  const optics::DistantWeights weights = optics::distantWeights(surface, optics::dfgOf(surface, 1));
  checkPixel(shown(""), glm::vec4(glm::vec3(weights.prefiltered + weights.irradiance), 1), 6e-3f);
}
