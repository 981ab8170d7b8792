#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "support/picture.hpp"

// Masked surfaces cover as much as the test lets pass, however far they are (frame/mask_levels.hpp).

using namespace facet;
using frame::PictureSettings;
using frame::Transport, frame::Visibility;
using nlohmann::json;
using test::at, test::emptyScene;
using test::GltfBuilder;

namespace {

constexpr int side = 64;  // of the textures

using Texels = std::function<int(int x, int y)>;  // -> alpha
// Hairs a texel or two wide that lean.
int hair(int x, int y) { return (3 * x + y) % 19 < 5 ? 255 : 0; }
// Alpha of all kinds: a cutoff of 0.25 leaves more of it than one of 0.75.
int dunes(int x, int y) {
  return static_cast<int>(127.5 + 127.5 * std::sin(0.7 * x) * std::cos(0.45 * y + 0.02 * x * x));
}

// A white texture of that alpha.
int addTexture(GltfBuilder& builder, const Texels& alpha, const json& sampler = json::object()) {
  std::vector<uint8_t> texels;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) texels.insert(texels.end(), {255, 255, 255, static_cast<uint8_t>(alpha(x, y))});
  const int image =
      builder.append("images", {{"uri", test::dataUri(test::pngBytes(side, side, 4, 8, texels), "image/png")}});
  const int index = builder.append("samplers", sampler);
  return builder.append("textures", {{"source", image}, {"sampler", index}});
}

json masked(int texture, double cutoff = 0.5, double factor = 1) {
  json m = test::material({1, 1, 1, factor});
  m["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", texture}};
  m["alphaMode"] = "MASK", m["alphaCutoff"] = cutoff;
  return m;
}

// A square of 4 m that repeats the texture four times along each axis.
json square(GltfBuilder& builder) {
  json quad = test::addQuad(builder, {-2, -2}, {2, 2});
  quad["attributes"]["TEXCOORD_0"] = builder.add(std::vector<float>{0, 0, 4, 0, 4, 4, 0, 4}, test::floatType, "VEC2");
  return quad;
}

struct Way {
  const char* name;
  Transport transport;
  Visibility visibility;
  int samples;
};
constexpr Way drawn{"drawn", Transport::direct, Visibility::none, 4};

// Share of the square that is covered, of as many texels a pixel.
double coveredShare(test::Studio& studio, GltfBuilder builder, double texels, const Way& way = drawn) {
  constexpr int pixels = 64;
  const double extent = texels * pixels / side;
  test::addOrthographicCamera(builder, extent / 2, extent / 2);
  PictureSettings settings = test::bareSettings(pixels, pixels);
  settings.viewpoint.camera = "0";
  settings.sources.environment = "builtin:white";
  settings.quality.transport = way.transport, settings.quality.visibility = way.visibility;
  settings.quality.samples = way.samples;
  const frame::Picture picture = studio.render(test::loadBuilt(builder), settings);
  if (way.transport == Transport::paths) CHECK(picture.statistics.frame.rays > 0);
  double sum = 0;
  for (const glm::vec4& p : picture.radiance.pixels) sum += double(p.w) / (pixels * pixels);
  return sum * std::pow(std::max(extent / 4, 1.0), 2);
}

// Share of the square that passes.
double passingShare(const Texels& alpha, double threshold) {
  constexpr int steps = 8;
  double passing = 0;
  const auto texel = [&](int x, int y) { return alpha((x + side) % side, (y + side) % side) / 255.0; };
  for (int y = 0; y < steps * side; ++y)
    for (int x = 0; x < steps * side; ++x) {
      const double u = (x + 0.5) / steps - 0.5, v = (y + 0.5) / steps - 0.5;
      const int i = static_cast<int>(std::floor(u)), j = static_cast<int>(std::floor(v));
      passing += std::lerp(std::lerp(texel(i, j), texel(i + 1, j), u - i),
                           std::lerp(texel(i, j + 1), texel(i + 1, j + 1), u - i), v - j) >= threshold;
    }
  return passing / (steps * steps * side * side);
}

}  // namespace

TEST_CASE("Masks: hair covers as much at any distance, of few samples and many, drawn and traced", "[gl]") {
  test::Studio studio;
  GltfBuilder builder = emptyScene();
  test::addMeshNode(builder, square(builder), builder.append("materials", masked(addTexture(builder, hair))));
  const double share = passingShare(hair, 0.5);
  CHECK(share == Approx(0.27).margin(0.02));
  struct Row {
    Way way;
    double margin;
  };
  for (const Row& row : {Row{{"one sample", Transport::direct, Visibility::none, 1}, 0.1}, Row{drawn, 0.05},
                         Row{{"gathered", Transport::direct, Visibility::none, 8}, 0.05},
                         Row{{"corrected by rays", Transport::direct, Visibility::rays, 4}, 0.05},
                         Row{{"path traced", Transport::paths, Visibility::automatic, 16}, 0.1}})
    for (const double texels : {1.0, 2.3, 4.4, 9.0, 15.0, 25.0}) {
      const double covered = coveredShare(studio, builder, texels, row.way);
      INFO(row.way.name << ", " << texels << " texels a pixel");
      CHECK(covered == Approx(share).margin(row.margin));
    }
}

TEST_CASE("Masks: one texture with different cutoffs, with alpha of factor and vertices", "[gl]") {
  test::Studio studio;
  struct Row {
    double cutoff, factor, vertex;
  };
  for (const Row& row : {Row{0.25, 1, 1}, Row{0.75, 1, 1}, Row{0.25, 0.5, 1}, Row{0.3, 1, 0.6}, Row{0.05, 1, 1},
                         Row{0.5, 1, 0.4}, Row{0.5, 0.4, 1}}) {
    GltfBuilder builder = emptyScene();
    const int texture = addTexture(builder, dunes);
    json quad = square(builder);
    if (row.vertex < 1) {
      std::vector<float> colors;
      for (int i = 0; i < 4; ++i) colors.insert(colors.end(), {1, 1, 1, float(row.vertex)});
      quad["attributes"]["COLOR_0"] = builder.add(colors, test::floatType, "VEC4");
    }
    test::addMeshNode(builder, quad, builder.append("materials", masked(texture, row.cutoff, row.factor)));
    // The same texture behind the viewer with another cutoff.
    test::addMeshNode(builder, square(builder), builder.append("materials", masked(texture, 0.6)), at(0, 0, 20));
    const double share = passingShare(dunes, row.cutoff / row.factor / row.vertex);
    for (const double texels : {1.0, 4.4, 15.0}) {
      INFO("cutoff " << row.cutoff << ", factor " << row.factor << ", vertices " << row.vertex << ", " << texels
                     << " texels a pixel");
      CHECK(coveredShare(studio, builder, texels) == Approx(share).margin(0.03));
    }
  }
}

TEST_CASE("Masks: layers hide as much of each other as they cover", "[gl]") {
  test::Studio studio;
  GltfBuilder builder = emptyScene();
  const int material = builder.append("materials", masked(addTexture(builder, hair)));
  for (const double z : {0.0, 0.1, 0.2})
    test::addMeshNode(builder, square(builder), material, at(0.003 * z, 0.07 * z, z));
  const double share = passingShare(hair, 0.5);
  CHECK(coveredShare(studio, builder, 12) == Approx(1 - std::pow(1 - share, 3)).margin(0.05));
}

TEST_CASE("Masks: edges of few samples are smooth, and those of a sampler without levels", "[gl]") {
  test::Studio studio;
  for (const json& sampler : {json::object(), json{{"magFilter", 9729}, {"minFilter", 9729}}}) {
    GltfBuilder builder = emptyScene();
    const auto disc = [](int x, int y) { return std::hypot(x - 31.5, y - 31.5) < 20 ? 255 : 0; };
    test::addMeshNode(builder, square(builder),
                      builder.append("materials", masked(addTexture(builder, disc, sampler))));
    test::addOrthographicCamera(builder, 0.5, 0.5);
    PictureSettings settings = test::bareSettings(32, 32);
    settings.viewpoint.camera = "0", settings.quality.samples = 4;
    settings.sources.environment = "builtin:white";
    const frame::Picture picture = studio.render(test::loadBuilt(builder), settings);
    double area = 0;
    int partly = 0;
    for (const glm::vec4& p : picture.radiance.pixels) area += double(p.w), partly += p.w > 0 && p.w < 1;
    CHECK(area == Approx(passingShare(disc, 0.5) * 32 * 32).epsilon(0.01));
    CHECK(partly > 30);
  }
}

TEST_CASE("Masks: textures of materials that mask alike, or read colour alone, are one", "[gl]") {
  GltfBuilder builder = emptyScene();
  const int texture = addTexture(builder, hair);
  json opaque = masked(texture);
  opaque["alphaMode"] = "OPAQUE";
  std::vector<json> materials = {masked(texture), masked(texture, 0.25, 0.5), opaque};
  size_t expected = 1;
  SECTION("one") {}
  SECTION("another cutoff") { materials.push_back(masked(texture, 0.7)), expected = 2; }
  SECTION("a veil") {
    json veil = masked(texture);
    veil["alphaMode"] = "BLEND";
    materials.push_back(veil), expected = 2;
  }
  for (const json& m : materials) test::addMeshNode(builder, square(builder), builder.append("materials", m));
  const io::LoadedModel model = test::loadBuilt(builder);
  frame::LoadedScene scene = test::sceneOf(model);
  PictureSettings settings = test::bareSettings(8, 8);
  test::Studio().render(scene, settings);
  CHECK(scene.gpu.textures.size() == expected);
}
