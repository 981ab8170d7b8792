// Textures of directions that lie in texture coordinates of their own, and texture coordinates that targets move:
// against models in which the same is baked, in drawn and in traced pictures.

#include <catch2/catch.hpp>
#include <cmath>

#include "frame/path_scenes.hpp"
#include "scene/tangents.hpp"
#include "support/picture.hpp"

namespace facet::test::texture_directions {

namespace {

constexpr int size = 24;  // pixels; the camera sees [-1.5, 1.5]^2
constexpr float right = 1.57079633f;

using Numbers = std::vector<float>;
const Numbers corners = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
const Numbers uv = {0, 1, 1, 1, 1, 0, 0, 0};

// Numbers of 2 or 3 a vertex, turned by a right angle in the plane of the first two.
Numbers turned(const Numbers& values, size_t width) {
  Numbers out = values;
  for (size_t i = 0; i < values.size(); i += width) out[i] = -values[i + 1], out[i + 1] = values[i];
  return out;
}
Numbers transformed(const Numbers& values, float rotation) {
  const glm::dmat3x2 matrix = scene::uvFromTexCoord({.offset = {}, .rotation = rotation, .scale = glm::vec2(1)});
  Numbers out;
  for (size_t i = 0; i < values.size(); i += 2) {
    const glm::dvec2 moved = matrix * glm::dvec3(double{values[i]}, double{values[i + 1]}, 1);
    out.push_back(static_cast<float>(moved.x)), out.push_back(static_cast<float>(moved.y));
  }
  return out;
}
Numbers less(const Numbers& a, const Numbers& b) {
  Numbers out;
  for (size_t i = 0; i < a.size(); ++i) out.push_back(a[i] - b[i]);
  return out;
}

// A texture of one texel, 16 bits a channel.
nlohmann::json texel(GltfBuilder& b, double r, double g, double bl) {
  std::vector<uint8_t> data;
  for (const double value : {r, g, bl}) {
    const auto word = static_cast<uint32_t>(std::lround(value * 65535));
    data.push_back(static_cast<uint8_t>(word >> 8)), data.push_back(static_cast<uint8_t>(word));
  }
  const int image = b.append("images", {{"uri", dataUri(pngBytes(1, 1, 3, 16, data), "image/png")}});
  return {{"index", b.append("textures", {{"source", image}})}};
}

struct Quad {
  Numbers positions = corners, uv0 = uv, uv1 = {};
  Numbers positionsMoved = {}, uv0Moved = {}, uv1Moved = {};  // of the target, whose weight is 1
};

nlohmann::json primitiveOf(GltfBuilder& b, const Quad& q) {
  const auto add = [&](const Numbers& values, const char* type) { return b.add(values, floatType, type); };
  nlohmann::json out = {{"attributes",
                         {{"POSITION", add(q.positions, "VEC3")},
                          {"NORMAL", add({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3")},
                          {"TEXCOORD_0", add(q.uv0, "VEC2")}}},
                        {"indices", b.add(std::vector<uint32_t>{0, 1, 2, 0, 2, 3}, uintType, "SCALAR")}};
  if (!q.uv1.empty()) out["attributes"]["TEXCOORD_1"] = add(q.uv1, "VEC2");
  nlohmann::json target = nlohmann::json::object();
  if (!q.positionsMoved.empty()) target["POSITION"] = add(less(q.positionsMoved, q.positions), "VEC3");
  if (!q.uv0Moved.empty()) target["TEXCOORD_0"] = add(less(q.uv0Moved, q.uv0), "VEC2");
  if (!q.uv1Moved.empty()) target["TEXCOORD_1"] = add(less(q.uv1Moved, q.uv1), "VEC2");
  if (!target.empty()) out["targets"] = {target};
  return out;
}

enum class Kind { coat, grain };

// The normal texture is flat and in set 0, or where the other one is; the coat's normal texture or the anisotropy leans
// along its own u.
io::LoadedModel modelOf(Kind kind, const Quad& q, int set, float rotation, bool normalToo,
                        const nlohmann::json& node = nlohmann::json::object()) {
  GltfBuilder b = emptyScene();
  nlohmann::json m = material({0.6, 0.4, 0.2, 1}, kind == Kind::grain ? 1 : 0, 0.5);
  const auto place = [&](nlohmann::json texture) {
    texture["texCoord"] = set;
    if (rotation != 0) texture["extensions"]["KHR_texture_transform"]["rotation"] = rotation;
    return texture;
  };
  nlohmann::json flat = texel(b, 0.5, 0.5, 1);
  m["normalTexture"] = normalToo ? place(flat) : flat;
  m["doubleSided"] = true;
  if (kind == Kind::coat)
    m["extensions"]["KHR_materials_clearcoat"] = {{"clearcoatFactor", 1},
                                                  {"clearcoatRoughnessFactor", 0.3},
                                                  {"clearcoatNormalTexture", place(texel(b, 0.75, 0.5, 0.95))}};
  else
    m["extensions"]["KHR_materials_anisotropy"] = {{"anisotropyStrength", 0.9},
                                                   {"anisotropyTexture", place(texel(b, 1, 0.5, 1))}};
  b.json["extensionsUsed"].push_back("KHR_texture_transform");
  addMeshNode(b, primitiveOf(b, q), b.append("materials", m), node);
  for (auto& one : b.json["meshes"])
    if (one["primitives"][0].contains("targets")) one["weights"] = {1};
  b.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}, {"intensity", 9}}};
  b.json["scenes"][0]["nodes"].push_back(
      b.append("nodes", {{"translation", {0.9, 0.5, 1.2}}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}}));
  addOrthographicCamera(b, 1.5, 1.5);
  io::LoadedModel model = loadBuilt(b);
  CHECK(model.notes.empty());
  return model;
}

double farthest(Studio& studio, const io::LoadedModel& a, const io::LoadedModel& b, bool traced) {
  frame::PictureSettings s = bareSettings(size, size);
  s.viewpoint.camera = "0";
  if (traced) s.quality.transport = frame::Transport::paths, s.quality.samples = 8;
  if (traced && a.model.lights.empty()) s.sources.environment = "builtin:white";
  const frame::Picture one = studio.render(a, s), other = studio.render(b, s);
  double most = 0;
  for (size_t i = 0; i < one.radiance.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c)
      most = std::max(most, std::abs(double{one.radiance.pixels[i][c]} - double{other.radiance.pixels[i][c]}));
  return most;
}

}  // namespace

TEST_CASE("Directions: a coat's normals and a grain in coordinates of their own are as baked ones", "[gl]") {
  Studio studio;
  studio.display = false;
  Quad q;
  q.uv1 = turned(uv, 2);
  Quad baked = q;
  baked.uv1 = transformed(uv, right);
  const nlohmann::json mirrored = {{"scale", {-1, 1, 1}}}, odd = {{"rotation", {0, 0.6, 0, 0.8}}};
  for (const Kind kind : {Kind::coat, Kind::grain})
    for (const bool traced : {false, true})
      for (const nlohmann::json& node : {nlohmann::json::object(), mirrored, odd}) {
        INFO((kind == Kind::coat ? "coat" : "grain") << (traced ? ", traced " : ", drawn ") << node.dump());
        // In another set.
        CHECK(farthest(studio, modelOf(kind, q, 1, 0, false, node), modelOf(kind, q, 1, 0, true, node), traced) < 5e-4);
        // Turned by its transform.
        CHECK(farthest(studio, modelOf(kind, q, 0, right, false, node), modelOf(kind, baked, 1, 0, true, node),
                       traced) < 5e-4);
        // Which shows.
        CHECK(farthest(studio, modelOf(kind, q, 1, 0, false, node), modelOf(kind, q, 0, 0, false, node), traced) >
              0.02);
      }
}

TEST_CASE("Directions: each basis follows morph targets", "[gl]") {
  Studio studio;
  studio.display = false;
  for (const Kind kind : {Kind::coat, Kind::grain})
    for (const bool traced : {false, true}) {
      INFO((kind == Kind::coat ? "coat" : "grain") << (traced ? ", traced" : ", drawn"));
      Quad q, baked;
      q.uv1 = baked.uv1 = turned(uv, 2);
      q.positionsMoved = baked.positions = turned(corners, 3);
      CHECK(farthest(studio, modelOf(kind, q, 1, 0, false), modelOf(kind, baked, 1, 0, true), traced) < 5e-4);
      // The coordinates move, and the directions with them.
      Quad moved, still;
      moved.uv1 = uv;
      moved.uv1Moved = still.uv1 = turned(uv, 2);
      CHECK(farthest(studio, modelOf(kind, moved, 1, 0, false), modelOf(kind, still, 1, 0, true), traced) < 5e-4);
    }
}

TEST_CASE("Directions: targets move texture coordinates", "[gl]") {
  Studio studio;
  studio.display = false;
  const auto pictured = [&](const Numbers& coordinates, const Numbers& moved, double weight) {
    GltfBuilder b = emptyScene();
    std::vector<uint8_t> texels;
    for (int i = 0; i < 16; ++i)
      for (const int c : {0, 1, 2}) texels.push_back(static_cast<uint8_t>(i * 15 * (c + 1) % 256));
    const int image = b.append("images", {{"uri", dataUri(pngBytes(4, 4, 3, 8, texels), "image/png")}});
    nlohmann::json m = unlit({1, 1, 1, 1});
    m["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", b.append("textures", {{"source", image}})},
                                                     {"texCoord", 1}};
    Quad q;
    q.uv1 = coordinates, q.uv1Moved = moved;
    addMeshNode(b, primitiveOf(b, q), b.append("materials", m));
    if (!moved.empty()) b.json["meshes"][0]["weights"] = {weight};
    // Something lit, without which nothing is traced.
    addMeshNode(b, addQuad(b, {1.2f, 1.2f}, {1.4f, 1.4f}), b.append("materials", material({1, 1, 1, 1})));
    addOrthographicCamera(b, 1.5, 1.5);
    io::LoadedModel model = loadBuilt(b);
    CHECK(model.notes.empty());
    return model;
  };
  Numbers moved;
  for (const float c : uv) moved.push_back(0.3f + 0.6f * c);
  for (const float weight : {1.0f, 0.25f, 0.0f}) {
    Numbers baked;
    for (size_t i = 0; i < uv.size(); ++i) baked.push_back(uv[i] + weight * (moved[i] - uv[i]));
    const io::LoadedModel a = pictured(uv, moved, double{weight}), b = pictured(baked, {}, 0),
                          rest = pictured(uv, {}, 0);
    for (const bool traced : {false, true}) {
      INFO("weight " << weight << (traced ? ", traced" : ", drawn"));
      CHECK(farthest(studio, a, b, traced) < 2e-5);
      CHECK((farthest(studio, a, rest, traced) > 0.05) == (weight > 0));
    }
  }
}

}  // namespace facet::test::texture_directions
