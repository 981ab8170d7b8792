// Animations: samplers and channels.

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "support/gltf_load.hpp"
#include "support/not_a_number.hpp"

using facet::test::notANumber;

namespace {

using namespace facet;
using namespace facet::test;
using scene::AnimatedProperty;
using scene::Interpolation;
using Json = nlohmann::json;

Json& animation(GltfBuilder& b) { return b.json["animations"][0]; }
Json& sampler(GltfBuilder& b) { return animation(b)["samplers"][0]; }

// Node 0's `path` with keys at these times and these values.
template <class T>
GltfBuilder animated(const char* path, const std::vector<float>& times, const std::vector<T>& values, Component type,
                     const char* shape, bool normalized = false) {
  GltfBuilder b = triangle();
  const int input = b.add(times, floatType, "SCALAR"), output = b.add(values, type, shape, normalized);
  b.append("animations", {{"name", "wave"},
                          {"samplers", {{{"input", input}, {"output", output}}}},
                          {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}}});
  return b;
}

// Node 0 goes from (0, 0, 0) at 1 s to (1, 2, 3) at 2.5 s.
GltfBuilder moved() {
  return animated("translation", {1, 2.5f}, std::vector<float>{0, 0, 0, 1, 2, 3}, floatType, "VEC3");
}

// Gives mesh 0 that many targets.
void addTargets(GltfBuilder& b, int count) {
  for (int i = 0; i < count; ++i) b.json["meshes"][0]["primitives"][0]["targets"].push_back({{"POSITION", 0}});
}

const scene::AnimationSampler& first(const io::LoadedModel& model) {
  return model.model.animations.at(0).samplers.at(0);
}

std::string outcome(const GltfBuilder& b) { return facet::test::outcome(b.text()); }

}  // namespace

TEST_CASE("A channel of translations", "[io][animations]") {
  GltfBuilder b = moved();
  auto model = loaded(b);
  CHECK(notes(model) == "");
  REQUIRE(model.model.animations.size() == 1);
  const scene::Animation& wave = model.model.animations[0];
  CHECK(wave.name == "wave");
  REQUIRE(wave.channels.size() == 1);
  CHECK(wave.channels[0].property == AnimatedProperty::translation);
  CHECK(wave.channels[0].object == 0);
  CHECK(wave.channels[0].sampler == 0);
  CHECK(wave.channels[0].element == -1);
  CHECK(first(model).times == std::vector<float>{1, 2.5f});
  CHECK(first(model).values == std::vector<float>{0, 0, 0, 1, 2, 3});
  CHECK(first(model).width == 3);
  CHECK(first(model).interpolation == Interpolation::linear);
  sampler(b)["interpolation"] = "STEP";
  CHECK(first(loaded(b)).interpolation == Interpolation::step);
}

TEST_CASE("Several channels share a sampler, what none uses is not read", "[io][animations]") {
  GltfBuilder b = moved();
  b.append("nodes", Json::object());
  animation(b)["samplers"] = {Json{{"input", 77}, {"output", 99}}, sampler(b)};
  animation(b)["channels"] = {{{"sampler", 1}, {"target", {{"node", 1}, {"path", "scale"}}}},
                              {{"sampler", 1}, {"target", {{"node", 0}, {"path", "translation"}}}},
                              {{"sampler", 0}, {"target", {{"path", "translation"}}}}};
  const auto model = loaded(b);
  CHECK(notes(model) == "");
  const scene::Animation& wave = model.model.animations[0];
  CHECK(wave.samplers.size() == 1);
  REQUIRE(wave.channels.size() == 2);
  CHECK(wave.channels[0].property == AnimatedProperty::scale);
  CHECK(wave.channels[0].object == 1);
  CHECK(wave.channels[1].sampler == 0);
}

TEST_CASE("Rotations of every type", "[io][animations]") {
  const auto values = [](const auto& numbers, Component type, bool normalized) {
    const auto model = loaded(animated("rotation", {0, 1}, numbers, type, "VEC4", normalized));
    CHECK(notes(model) == "");
    CHECK(first(model).width == 4);
    return first(model).values;
  };
  const std::vector<float> wanted = {0, 0, 0, 1, 0.6f, 0, 0, 0.8f};
  const auto close = [&](const std::vector<float>& got, float tolerance) {
    REQUIRE(got.size() == wanted.size());
    for (size_t i = 0; i < got.size(); ++i) CHECK(std::abs(got[i] - wanted[i]) < tolerance);
    CHECK(got[4] * got[4] + got[7] * got[7] == Approx(1).epsilon(1e-6));
  };
  close(values(wanted, floatType, false), 1e-7f);
  close(values(std::vector<uint8_t>{0, 0, 0, 255, 153, 0, 0, 204}, ubyteType, true), 1e-6f);
  close(values(std::vector<int8_t>{0, 0, 0, 127, 76, 0, 0, 102}, byteType, true), 0.005f);
  close(values(std::vector<uint16_t>{0, 0, 0, 65535, 39321, 0, 0, 52428}, ushortType, true), 1e-6f);
  close(values(std::vector<int16_t>{0, 0, 0, 32767, 19660, 0, 0, 26214}, shortType, true), 1e-4f);
  close(values(std::vector<int16_t>{0, 0, 0, 32767, 19660, 0, 0, 26214}, shortType, false), 1e-4f);
}

TEST_CASE("Rotations are made unit, those of a spline are not", "[io][animations]") {
  GltfBuilder b =
      animated("rotation", {0, 1, 2}, std::vector<float>{0, 0, 0, 2, 0, 0, 0, 0, 0, 3, 0, 4}, floatType, "VEC4");
  auto model = loaded(b);
  CHECK(first(model).times == std::vector<float>{0, 2});
  CHECK(first(model).values == std::vector<float>{0, 0, 0, 1, 0, 0.6f, 0, 0.8f});
  CHECK(notes(model) ==
        "! /animations/0/samplers/0: 1 of 3 keys are not finite or do not follow the one before: left out; the first "
        "is key 1\n"
        "/animations/0/samplers/0/output: 2 rotations were not of unit length: normalised\n");
  const std::vector<float> spline = {0, 0, 0, 0, 0, 0, 0, 2, 1, 0, 0, 0};
  b = animated("rotation", {0}, spline, floatType, "VEC4");
  sampler(b)["interpolation"] = "CUBICSPLINE";
  model = loaded(b);
  CHECK(first(model).values == spline);
  CHECK(notes(model) == "");
}

TEST_CASE("Weights: as many as the mesh has targets, as a cubic spline", "[io][animations]") {
  const std::vector<float> values = {0, 0, 0.25f, 0.5f, 1, -1, 2, 3, 1, 1, 0, 0};
  GltfBuilder b = animated("weights", {0, 1}, values, floatType, "SCALAR");
  addTargets(b, 2);
  sampler(b)["interpolation"] = "CUBICSPLINE";
  auto model = loaded(b);
  CHECK(notes(model) == "");
  CHECK(first(model).interpolation == Interpolation::cubicSpline);
  CHECK(first(model).width == 2);
  CHECK(first(model).times.size() == 2);
  CHECK(first(model).values == values);
  CHECK(model.model.animations[0].channels[0].property == AnimatedProperty::weights);
  // Bytes
  b = animated("weights", {0, 1}, std::vector<uint8_t>{0, 51, 255, 102}, ubyteType, "SCALAR", true);
  addTargets(b, 2);
  CHECK(first(loaded(b)).values == std::vector<float>{0, 0.2f, 1, 0.4f});
  // Another number of targets
  addTargets(b, 1);
  model = loaded(b);
  CHECK(model.model.animations[0].channels.empty());
  CHECK(notes(model) ==
        "! /animations/0/samplers/0/output: has 4 elements instead of 6 for 2 keys: its channels are left out\n");
  b.json["meshes"][0]["primitives"][0].erase("targets");
  CHECK(notes(loaded(b)) == "! /animations/0/channels/0/target: node 0 has no morph targets: the channel is ignored\n");
}

TEST_CASE("Keys that cannot be used are left out", "[io][animations]") {
  const float infinity = std::numeric_limits<float>::infinity();
  const GltfBuilder b =
      animated("scale", {0, notANumber, 1, 1, 0.5f, 2, infinity, 3},
               std::vector<float>{1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4, 5, 5, 5, 6, 6, 6, 7, 7, 7, notANumber, 8, 8},
               floatType, "VEC3");
  const auto model = loaded(b);
  CHECK(first(model).times == std::vector<float>{0, 1, std::nextafter(1.0f, 2.0f), 2});  // a jump at 1
  CHECK(first(model).values == std::vector<float>{1, 1, 1, 3, 3, 3, 4, 4, 4, 6, 6, 6});
  CHECK(notes(model) ==
        "/animations/0/samplers/0: 1 times two keys lie at one time: a jump\n"
        "! /animations/0/samplers/0: 4 of 8 keys are not finite or do not follow the one before: left out; the first "
        "is key 1\n");
}

TEST_CASE("Keys that are left out take no memory", "[io][animations]") {
  GltfBuilder b = moved();
  const auto zeros = [&](const char* type) {
    return b.addAccessor({{"componentType", 5126}, {"type", type}, {"count", 10000}});
  };
  sampler(b)["input"] = zeros("SCALAR");
  sampler(b)["output"] = zeros("VEC3");
  const auto model = loaded(b);
  CHECK(first(model).times == std::vector<float>{0, std::numeric_limits<float>::denorm_min()});
  CHECK(first(model).times.capacity() < 10);
  CHECK(first(model).values.capacity() < 10);
}

TEST_CASE("What cannot be played is left out with a warning", "[io][animations]") {
  const struct {
    void (*breakIt)(GltfBuilder&);
    const char* note;
  } rows[] = {
      {[](GltfBuilder& b) { sampler(b)["interpolation"] = "BEZIER"; },
       "! /animations/0/samplers/0/interpolation: \"BEZIER\" is no interpolation: its channels are left out\n"},
      {[](GltfBuilder& b) { sampler(b)["interpolation"] = "CUBICSPLINE"; },
       "! /animations/0/samplers/0/output: has 2 elements instead of 6 for 2 keys: its channels are left out\n"},
      {[](GltfBuilder& b) { sampler(b)["input"] = sampler(b)["output"]; },
       "! /animations/0/samplers/0/input: holds no times: its channels are left out\n"},
      {[](GltfBuilder& b) { sampler(b)["output"] = sampler(b)["input"]; },
       "! /animations/0/samplers/0/output: its elements do not have 3 components: its channels are left out\n"},
      {[](GltfBuilder& b) { sampler(b)["input"] = b.add(std::vector<float>(2, notANumber), floatType, "SCALAR"); },
       "! /animations/0/samplers/0: 2 of 2 keys are not finite or do not follow the one before: left out; the first "
       "is key 0\n"
       "! /animations/0/samplers/0: has no keys: its channels are left out\n"},
      {[](GltfBuilder& b) { animation(b)["channels"][0]["target"]["path"] = "colour"; },
       "! /animations/0/channels/0/target/path: \"colour\" is no path of an animation: the channel is ignored\n"},
      {[](GltfBuilder& b) { animation(b)["channels"][0]["target"].erase("node"); }, ""},
  };
  for (const auto& row : rows) {
    GltfBuilder b = moved();
    row.breakIt(b);
    const auto model = loaded(b);
    CHECK(notes(model) == row.note);
    REQUIRE(model.model.animations.size() == 1);
    CHECK(model.model.animations[0].channels.empty());
    CHECK(model.model.animations[0].samplers.empty());
    CHECK(model.model.meshes.size() == 1);
  }
}

TEST_CASE("A matrix is no rotation", "[io][animations]") {
  GltfBuilder b = animated("rotation", {0}, std::vector<float>{0, 0, 0, 1}, floatType, "VEC4");
  b.json["accessors"].back()["type"] = "MAT2";
  CHECK(notes(loaded(b)) ==
        "! /animations/0/samplers/0/output: its elements do not have 4 components: its channels are left out\n");
}

TEST_CASE("Two channels that set the same", "[io][animations]") {
  GltfBuilder b = moved();
  animation(b)["channels"].push_back(animation(b)["channels"][0]);
  const auto model = loaded(b);
  CHECK(model.model.animations[0].channels.size() == 2);
  CHECK(notes(model) == "/animations/0/channels: 1 set what another one before them sets, too: the last one counts\n");
}

TEST_CASE("Broken animations cost their channels, those that are none are refused", "[io][animations]") {
  const struct {
    void (*breakIt)(GltfBuilder&);
    const char* message;
  } rows[] = {
      {[](GltfBuilder& b) { b.json["animations"] = "x"; }, "m: /animations: is not an array; export the model again."},
      {[](GltfBuilder& b) { b.json["animations"] = {3}; },
       "m: /animations/0: is not an object; export the model again."},
      {[](GltfBuilder& b) { animation(b)["channels"] = {1}; },
       "! /animations/0/channels/0: is not an object: the channel is left out\n"},
      {[](GltfBuilder& b) { animation(b)["channels"][0].erase("sampler"); },
       "! /animations/0/channels/0/sampler: is not a whole number: the channel is left out\n"},
      {[](GltfBuilder& b) { animation(b)["channels"][0]["sampler"] = 1; },
       "! /animations/0/channels/0/sampler: sampler 1 does not exist; there are 1: the channel is left out\n"},
      {[](GltfBuilder& b) { animation(b).erase("samplers"); },
       "! /animations/0/channels/0/sampler: sampler 0 does not exist; there are 0: the channel is left out\n"},
      {[](GltfBuilder& b) { animation(b)["samplers"] = {1}; },
       "! /animations/0/samplers/0: is not an object: the channel is left out\n"},
      {[](GltfBuilder& b) { animation(b)["channels"][0].erase("target"); },
       "! /animations/0/channels/0/target: is missing or not an object: the channel is left out\n"},
      {[](GltfBuilder& b) { animation(b)["channels"][0]["target"]["node"] = 1; },
       "! /animations/0/channels/0/target/node: node 1 does not exist; there are 1: the channel is left out\n"},
      {[](GltfBuilder& b) { animation(b)["channels"][0]["target"]["node"] = -1; },
       "! /animations/0/channels/0/target/node: node -1 does not exist; there are 1: the channel is left out\n"},
      {[](GltfBuilder& b) { sampler(b).erase("input"); },
       "! /animations/0/samplers/0/input: is not a whole number: the channel is left out\n"},
      {[](GltfBuilder& b) { sampler(b)["output"] = 3; },
       "! /animations/0/samplers/0/output: accessor 3 does not exist; there are 3: the channel is left out\n"},
      {[](GltfBuilder& b) { b.json["accessors"][1]["count"] = 2147483648u; },
       "m: /accessors/1: needs 8589934592 bytes of buffer view 1, which has 8; export the model again."},
  };
  for (const auto& row : rows) {
    GltfBuilder b = moved();
    row.breakIt(b);
    const std::string said = outcome(b);
    CHECK((said == "loaded" ? notes(loaded(b)) : said) == row.message);
  }
}

TEST_CASE("Animations do not fill the memory", "[io][animations]") {
  // Zeros that cost the file nothing, by a thousand samplers.
  GltfBuilder b = moved();
  const int times = b.addAccessor({{"componentType", 5126}, {"type", "SCALAR"}, {"count", 1000}});
  const int values = b.addAccessor({{"componentType", 5126}, {"type", "VEC3"}, {"count", 1000}});
  animation(b) = {{"samplers", Json::array()}, {"channels", Json::array()}};
  for (int i = 0; i < 1000; ++i) {
    animation(b)["samplers"].push_back({{"input", times}, {"output", values}});
    animation(b)["channels"].push_back({{"sampler", i}, {"target", {{"node", 0}, {"path", "translation"}}}});
  }
  const auto glb = b.glb();
  io::Limits limits;
  limits.geometryBytes = 1000000;
  CHECK(facet::test::outcome(io::loadGltfBytes(glb, "m", {}, limits)) ==
        "m: /animations/0: the animations take more than 1000000 bytes; use a smaller model.");
}
