// Skins, joints and weights.

#include <catch2/catch.hpp>
#include <cstdio>
#include <limits>

#include "support/gltf_load.hpp"
#include "support/not_a_number.hpp"

using facet::test::notANumber;

namespace {

using namespace facet;
using namespace facet::test;
using Json = nlohmann::json;

// A triangle that node 0 draws with skin 0; its joints are nodes 0 to `joints` - 1.
GltfBuilder skinned(int joints) {
  GltfBuilder b = triangle();
  std::vector<int> list;
  for (int i = 0; i < joints; ++i) {
    if (i > 0) b.append("nodes", Json::object());
    list.push_back(i);
  }
  b.append("skins", {{"joints", list}});
  b.json["nodes"][0]["skin"] = 0;
  return b;
}

const std::vector<uint8_t> noJoints(12, 0);

template <class T, class W>
void addSet(GltfBuilder& b, int set, const std::vector<T>& joints, Component jointType, const std::vector<W>& weights,
            Component weightType) {
  attributes(b)["JOINTS_" + std::to_string(set)] = b.add(joints, jointType, "VEC4");
  attributes(b)["WEIGHTS_" + std::to_string(set)] = b.add(weights, weightType, "VEC4", weightType != floatType);
}

// "0:0.75 2:0.25 | ..." by vertex.
std::string influences(const scene::Primitive& p) {
  std::string text;
  for (size_t i = 0; i < p.influences.size(); ++i) {
    const auto& influence = p.influences[i];
    if (i > 0) text += i % static_cast<size_t>(p.influencesPerVertex) == 0 ? " | " : " ";
    char weight[16];
    std::snprintf(weight, sizeof weight, ":%.3f", static_cast<double>(influence.weight));
    text += std::to_string(influence.joint) + weight;
  }
  return text;
}

std::string skinOutcome(const GltfBuilder& b) { return facet::test::outcome(b.text()); }

}  // namespace

TEST_CASE("Joints and weights of every type", "[io][skins]") {
  const std::string wanted = "2:1.000 0:0.000 | 3:0.750 1:0.250 | 1:1.000 0:0.000";
  GltfBuilder b = skinned(4);
  addSet(b, 0, std::vector<uint8_t>{2, 0, 0, 0, 1, 9, 3, 0, 1, 1, 1, 1}, ubyteType,
         std::vector<float>{1, 0, 0, 0, 0.25f, 0, 0.75f, 0, 0.25f, 0.25f, 0.25f, 0.25f}, floatType);
  auto model = loaded(b);
  CHECK(influences(primitive(model)) == wanted);
  CHECK(primitive(model).influencesPerVertex == 2);
  CHECK(notes(model) == "");
  CHECK(model.model.nodes[0].skin == 0);

  b = skinned(4);
  addSet(b, 0, std::vector<uint16_t>{2, 0, 0, 0, 1, 9, 3, 0, 1, 1, 1, 1}, ushortType,
         std::vector<uint8_t>{255, 0, 0, 0, 64, 0, 191, 0, 64, 64, 64, 63}, ubyteType);
  model = loaded(b);
  CHECK(primitive(model).influences[2].weight == Approx(191 / 255.0).epsilon(1e-6));
  CHECK(primitive(model).influences[3].weight == Approx(64 / 255.0).epsilon(1e-6));
  CHECK(notes(model) == "");

  b = skinned(4);
  addSet(b, 0, std::vector<uint16_t>{2, 0, 0, 0, 1, 9, 3, 0, 1, 1, 1, 1}, ushortType,
         std::vector<uint16_t>{65535, 0, 0, 0, 16384, 0, 49151, 0, 1, 2, 4, 65528}, ushortType);
  model = loaded(b);
  CHECK(influences(primitive(model)) == wanted);
  CHECK(primitive(model).influences[2].weight == Approx(49151 / 65535.0).epsilon(1e-7));
  CHECK(notes(model) == "");
  // Integers that should be "normalized" and are not.
  for (Json& accessor : b.json["accessors"]) accessor.erase("normalized");
  model = loaded(b);
  CHECK(influences(primitive(model)) == wanted);
  CHECK(notes(model) == "");
  // Joints that should not be.
  b.json["accessors"][1]["normalized"] = true;
  CHECK(influences(primitive(loaded(b))) == wanted);
}

TEST_CASE("Further sets of joints", "[io][skins]") {
  GltfBuilder b = skinned(12);
  addSet(b, 0, std::vector<uint8_t>{0, 1, 2, 3, 0, 0, 0, 0, 0, 0, 0, 0}, ubyteType,
         std::vector<float>{0.1f, 0.1f, 0.1f, 0.1f, 1, 0, 0, 0, 0, 0, 0, 0}, floatType);
  addSet(b, 1, std::vector<uint16_t>{4, 5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, ushortType,
         std::vector<float>{0.3f, 0.2f, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, floatType);
  addSet(b, 2, std::vector<uint16_t>{11, 0, 0, 0, 0, 0, 0, 0, 7, 0, 0, 0}, ushortType,
         std::vector<uint16_t>{6554, 0, 0, 0, 0, 0, 0, 0, 65535, 0, 0, 0}, ushortType);
  const auto model = loaded(b);
  const auto& p = primitive(model);
  CHECK(p.influencesPerVertex == 7);
  CHECK(p.influences.size() == 21);
  CHECK(influences(p).substr(0, 56) == "4:0.300 5:0.200 11:0.100 0:0.100 1:0.100 2:0.100 3:0.100");
  CHECK(p.influences[7].weight == 1);
  CHECK(p.influences[14].joint == 7);
  CHECK(notes(model) == "");
}

TEST_CASE("Weights are repaired and reported", "[io][skins]") {
  GltfBuilder b = skinned(3);
  const float infinity = std::numeric_limits<float>::infinity();
  addSet(b, 0, std::vector<uint8_t>{0, 1, 2, 0, 2, 1, 0, 0, 1, 1, 2, 0}, ubyteType,
         std::vector<float>{0.5f, notANumber, -1, 0, 0, 0, infinity, 0, 3, 1, 4, 0}, floatType);
  const auto model = loaded(b);
  CHECK(influences(primitive(model)) == "0:1.000 0:0.000 | 2:1.000 0:0.000 | 1:0.500 2:0.500");
  CHECK(notes(model) ==
        "! /meshes/0/primitives/0/attributes/WEIGHTS_0: 3 are negative or not finite: replaced by zero\n"
        "! /meshes/0/primitives/0/attributes/WEIGHTS_0: 1 vertices have none: they follow their first joint\n"
        "/meshes/0/primitives/0/attributes/WEIGHTS_0: those of 2 vertices do not add up to 1: normalised\n");
  // Rounding to bytes is no fault, more is.
  const auto summed = [](uint8_t weight) {
    GltfBuilder bytes = skinned(4);
    addSet(bytes, 0, std::vector<uint8_t>{0, 1, 2, 3, 0, 0, 0, 0, 0, 0, 0, 0}, ubyteType,
           std::vector<uint8_t>{weight, 63, 63, 64, 255, 0, 0, 0, 255, 0, 0, 0}, ubyteType);
    return notes(loaded(bytes));
  };
  CHECK(summed(63) == "");
  CHECK(summed(62) ==
        "/meshes/0/primitives/0/attributes/WEIGHTS_0: those of 1 vertices do not add up to 1: normalised\n");
}

TEST_CASE("Half a set of joints is ignored", "[io][skins]") {
  GltfBuilder b = skinned(1);
  attributes(b)["JOINTS_0"] = b.add(noJoints, ubyteType, "VEC4");
  attributes(b)["WEIGHTS_1"] = b.add(std::vector<float>(12, 0.25f), floatType, "VEC4");
  auto model = loaded(b);
  CHECK(primitive(model).influences.empty());
  CHECK(primitive(model).influencesPerVertex == 0);
  CHECK(notes(model) ==
        "! /meshes/0/primitives/0/attributes/JOINTS_0: there is no WEIGHTS_0: ignored\n"
        "! /meshes/0/primitives/0/attributes/WEIGHTS_1: there is no JOINTS_1: ignored\n");
  attributes(b)["JOINTS_1"] = attributes(b)["JOINTS_0"];
  model = loaded(b);
  CHECK(influences(primitive(model)) == "0:1.000 | 0:1.000 | 0:1.000");
}

TEST_CASE("Joints and weights that no skin reads are not kept", "[io][skins]") {
  GltfBuilder b = skinned(3);
  addSet(b, 0, std::vector<uint16_t>{0, 1, 0, 0, 1, 0, 0, 0, 65535, 2, 0, 0}, ushortType,
         std::vector<float>{0.5f, 0.5f, 0, 0, 1, 0, 0, 0, 0, 2, 0, 0}, floatType);
  auto model = loaded(b);
  CHECK(primitive(model).influencesPerVertex == 2);
  CHECK(influences(primitive(model)) == "0:0.500 1:0.500 | 1:1.000 0:0.000 | 2:1.000 0:0.000");
  // A node that draws the mesh as it is changes nothing as long as another has the skin.
  b.append("nodes", {{"mesh", 0}});
  CHECK(primitive(loaded(b)).influences.size() == 6);
  b.json["nodes"][0].erase("skin");
  const auto glb = b.glb();
  io::Limits limits;
  limits.geometryBytes = 36;  // positions alone
  const auto plain = io::loadGltfBytes(glb, "m", {}, limits);
  REQUIRE(plain);
  CHECK(primitive(*plain).influences.empty());
  CHECK(primitive(*plain).influencesPerVertex == 0);
  CHECK(notes(*plain) == "");
}

TEST_CASE("Joints are checked against the smallest skin", "[io][skins]") {
  GltfBuilder b = skinned(3);
  addSet(b, 0, std::vector<uint8_t>{0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0}, ubyteType,
         std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, floatType);
  CHECK(skinOutcome(b) == "loaded");
  b.append("skins", {{"joints", {1, 2}}});
  CHECK(skinOutcome(b) == "loaded");
  b.append("nodes", {{"mesh", 0}, {"skin", 1}});
  CHECK(skinOutcome(b) ==
        "m: /meshes/0/primitives/0/attributes: vertex 1 follows joint 2, but skin 1 has 2 joints; export the model "
        "again.");
}

TEST_CASE("A vertex without weights does not need the joint that it names", "[io][skins]") {
  GltfBuilder b = skinned(2);
  const std::vector<uint16_t> joints = {1, 9, 9, 9, 65535, 0, 0, 0, 2, 1, 1, 1};
  addSet(b, 0, joints, ushortType, std::vector<float>(12, 0.0f), floatType);
  const auto model = loaded(b);
  CHECK(influences(primitive(model)) == "1:1.000 | 0:1.000 | 0:1.000");
  CHECK(notes(model) ==
        "! /meshes/0/primitives/0/attributes/WEIGHTS_0: 3 vertices have none: they follow their first joint\n");
}

TEST_CASE("Skins: joints and inverse bind matrices", "[io][skins]") {
  GltfBuilder b = skinned(2);
  auto model = loaded(b);
  REQUIRE(model.model.skins.size() == 1);
  CHECK(model.model.skins[0].joints == std::vector<int>{0, 1});
  CHECK(model.model.skins[0].inverseBindMatrices.empty());
  CHECK(notes(model) == "");

  std::vector<float> matrices(48, 0.0f);  // one more than there are joints
  for (const size_t i : {0, 5, 10, 15, 16, 21, 26, 31}) matrices[i] = 1;
  matrices[28] = 7;           // x of the second translation
  matrices[32] = notANumber;  // of the third
  matrices[19] = 0.5f;        // last row of the second
  b.json["skins"][0] = {{"name", "arm"}, {"joints", {1, 0, 1}}, {"skeleton", 0}};
  const int accessor =
      b.addAccessor({{"bufferView", b.addView(matrices)}, {"componentType", 5126}, {"type", "MAT4"}, {"count", 3}});
  b.json["skins"][0]["inverseBindMatrices"] = accessor;
  CHECK(notes(loaded(b)) ==
        "/skins/0/joints: node 1 is listed twice\n"
        "! /skins/0/inverseBindMatrices: matrix 2 is not finite: what it moves is shown at rest\n");
  b.json["skins"][0]["joints"] = {1, 1};
  model = loaded(b);
  const scene::Skin& skin = model.model.skins[0];
  CHECK(skin.name == "arm");
  REQUIRE(skin.inverseBindMatrices.size() == 2);
  CHECK(skin.inverseBindMatrices[0] == glm::dmat4(1));
  CHECK(skin.inverseBindMatrices[1][3] == glm::dvec4(7, 0, 0, 1));
  CHECK(skin.inverseBindMatrices[1][0] == glm::dvec4(1, 0, 0, 0));
  CHECK(notes(model) ==
        "/skins/0/joints: node 1 is listed twice\n"
        "! /skins/0/inverseBindMatrices: the last row of 1 is not 0 0 0 1 and is ignored\n");
}

TEST_CASE("Sparse inverse bind matrices, more than there are joints", "[io][skins]") {
  GltfBuilder b = skinned(2);
  std::vector<float> values(32, 0.0f);
  for (const size_t i : {0, 5, 10, 15, 16, 21, 26, 31}) values[i] = 1;
  values[13] = 4;  // y of the first translation
  const int places = b.addView(std::vector<uint8_t>{1, 5}), view = b.addView(values);
  b.json["skins"][0]["inverseBindMatrices"] =
      b.addAccessor({{"componentType", 5126},
                     {"type", "MAT4"},
                     {"count", 6},
                     {"sparse",
                      {{"count", 2},
                       {"indices", {{"bufferView", places}, {"componentType", 5121}}},
                       {"values", {{"bufferView", view}}}}}});
  const auto model = loaded(b);
  REQUIRE(model.model.skins[0].inverseBindMatrices.size() == 2);
  CHECK(model.model.skins[0].inverseBindMatrices[1][3] == glm::dvec4(0, 4, 0, 1));
  CHECK(notes(model) == "! /skins/0/inverseBindMatrices: the last row of 1 is not 0 0 0 1 and is ignored\n");
}

TEST_CASE("Broken skins cost what they move its motion, broken influences the model", "[io][skins]") {
  const struct {
    void (*breakIt)(GltfBuilder&);
    const char* message;
  } rows[] = {
      {[](GltfBuilder& b) { b.json["skins"] = 3; }, "m: /skins: is not an array; export the model again."},
      {[](GltfBuilder& b) { b.json["skins"][0].erase("joints"); },
       "! /skins/0/joints: is missing or empty: a skin has at least one joint: what it moves is shown at rest\n"},
      {[](GltfBuilder& b) {
         b.json["skins"][0]["joints"] = {0, 2};
       },
       "! /skins/0/joints/1: node 2 does not exist; there are 2: what it moves is shown at rest\n"},
      {[](GltfBuilder& b) { b.json["skins"][0]["joints"] = {-1}; },
       "! /skins/0/joints/0: node -1 does not exist; there are 2: what it moves is shown at rest\n"},
      {[](GltfBuilder& b) { b.json["skins"][0]["joints"] = {4294967296}; },
       "! /skins/0/joints/0: node 4294967296 does not exist; there are 2: what it moves is shown at rest\n"},
      {[](GltfBuilder& b) { b.json["skins"][0]["joints"] = {0.5}; },
       "! /skins/0/joints/0: is not a whole number: what it moves is shown at rest\n"},
      {[](GltfBuilder& b) { b.json["skins"][0]["inverseBindMatrices"] = 9; },
       "! /skins/0/inverseBindMatrices: accessor 9 does not exist; there are 3: what it moves is shown at rest\n"},
      {[](GltfBuilder& b) { b.json["skins"][0]["inverseBindMatrices"] = 0; },
       "! /skins/0/inverseBindMatrices: is not an accessor of 4 x 4 matrices of floats: what it moves is shown at "
       "rest\n"},
      {[](GltfBuilder& b) {
         b.json["skins"][0]["inverseBindMatrices"] =
             b.addAccessor({{"componentType", 5126}, {"type", "MAT4"}, {"count", 1}});
       },
       "! /skins/0/inverseBindMatrices: has 1 matrices for 2 joints: what it moves is shown at rest\n"},
      {[](GltfBuilder& b) { b.json["nodes"][0]["skin"] = 1; },
       "! /nodes/0/skin: skin 1 does not exist; there are 1: the node is shown without it\n"},
      {[](GltfBuilder& b) { attributes(b)["JOINTS_0"] = b.add(std::vector<float>(12, 0), floatType, "VEC4"); },
       "m: /meshes/0/primitives/0/attributes/JOINTS_0: is not a vector of 4 unsigned bytes or shorts; export the model "
       "again."},
      {[](GltfBuilder& b) { attributes(b)["WEIGHTS_0"] = b.add(std::vector<float>(9, 0), floatType, "VEC3"); },
       "m: /meshes/0/primitives/0/attributes/WEIGHTS_0: is not a vector of 4 floats, unsigned bytes or shorts; export "
       "the model again."},
  };
  for (const auto& row : rows) {
    GltfBuilder b = skinned(2);
    addSet(b, 0, noJoints, ubyteType, std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, floatType);
    row.breakIt(b);
    const std::string said = skinOutcome(b);
    CHECK((said == "loaded" ? notes(loaded(b)) : said) == row.message);
  }
}

TEST_CASE("Influences and targets count towards the limit", "[io][skins]") {
  GltfBuilder b = skinned(2);
  addSet(b, 0, noJoints, ubyteType, std::vector<float>(12, 0.25f), floatType);
  const auto glb = b.glb();
  io::Limits limits;
  limits.geometryBytes = 36 + 96 + 2 * 48 - 1;  // positions, four shares each vertex, two boxes
  CHECK(facet::test::outcome(io::loadGltfBytes(glb, "m", {}, limits)) ==
        "m: /meshes: the geometry takes 228 bytes, more than the limit of 227; use a smaller model.");
}
