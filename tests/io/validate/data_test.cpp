// Wrong numbers in the buffer.

#include "support/broken_gltf.hpp"

using namespace facet;

namespace {

// The model with one number of an accessor's data (or of a view's) put in.
template <class T>
std::vector<std::string> withNumber(size_t view, size_t index, T value) {
  test::GltfBuilder b = test::everything();
  const auto offset = b.json["bufferViews"][view]["byteOffset"].get<size_t>();
  std::memcpy(&b.bytes[offset + index * sizeof(T)], &value, sizeof value);
  return test::findings(b.text());
}

using Found = std::vector<std::string>;
constexpr float infinite = std::numeric_limits<float>::infinity(), notANumber = std::numeric_limits<float>::quiet_NaN();
const std::string attributes = "/meshes/0/primitives/0/attributes/";

}  // namespace

TEST_CASE("Validation: a model with one of everything and nothing wrong", "[io][validate]") {
  CHECK(test::findings(test::everything().text()) == Found{});
}

TEST_CASE("Validation: positions and what accessors say of them", "[io][validate]") {
  CHECK(withNumber(0, 0, notANumber) == Found{"ACCESSOR_INVALID_FLOAT /accessors/0"});
  CHECK(withNumber(0, 0, infinite) == Found{"ACCESSOR_INVALID_FLOAT /accessors/0"});
  CHECK(withNumber(0, 0, -5.0f) ==
        Found{"ACCESSOR_ELEMENT_OUT_OF_MIN_BOUND /accessors/0/min/0", "ACCESSOR_MIN_MISMATCH /accessors/0/min/0"});
  CHECK(withNumber(0, 3, 5.0f) ==
        Found{"ACCESSOR_ELEMENT_OUT_OF_MAX_BOUND /accessors/0/max/0", "ACCESSOR_MAX_MISMATCH /accessors/0/max/0"});
  CHECK(withNumber(12, 0, notANumber) == Found{"ACCESSOR_INVALID_FLOAT /accessors/12"});
}

TEST_CASE("Validation: normals, tangents and colours", "[io][validate]") {
  CHECK(withNumber(1, 0, 5.0f) == Found{"ACCESSOR_VECTOR3_NON_UNIT " + attributes + "NORMAL"});
  CHECK(withNumber(1, 2, 0.995f) == Found{});  // what 8 bits may be off by
  CHECK(withNumber(1, 2, 0.99f) == Found{"ACCESSOR_VECTOR3_NON_UNIT " + attributes + "NORMAL"});
  CHECK(withNumber(2, 3, 0.5f) == Found{"ACCESSOR_INVALID_SIGN " + attributes + "TANGENT"});
  CHECK(withNumber(2, 0, 0.0f) == Found{"ACCESSOR_VECTOR3_NON_UNIT " + attributes + "TANGENT"});
  CHECK(withNumber(4, 0, 1.5f) == Found{"ACCESSOR_NON_CLAMPED " + attributes + "COLOR_0"});
  CHECK(withNumber(4, 1, -1.0f) == Found{"ACCESSOR_NON_CLAMPED " + attributes + "COLOR_0"});
}

TEST_CASE("Validation: joints and weights", "[io][validate]") {
  CHECK(withNumber<uint8_t>(5, 0, 7) == Found{"ACCESSOR_JOINTS_INDEX_OOB " + attributes + "JOINTS_0",
                                              "ACCESSOR_WEIGHTS_NON_NORMALIZED " + attributes + "WEIGHTS_0"});
  CHECK(withNumber<uint8_t>(5, 1, 0) == Found{"ACCESSOR_JOINTS_INDEX_DUPLICATE " + attributes + "JOINTS_0",
                                              "ACCESSOR_WEIGHTS_NON_NORMALIZED " + attributes + "WEIGHTS_0"});
  CHECK(withNumber<uint8_t>(5, 2, 1) == Found{"ACCESSOR_JOINTS_USED_ZERO_WEIGHT " + attributes + "JOINTS_0"});
  CHECK(withNumber(6, 0, 0.2f) == Found{"ACCESSOR_WEIGHTS_NON_NORMALIZED " + attributes + "WEIGHTS_0"});
  CHECK(withNumber(6, 0, 0.5000001f) == Found{});  // a float's rounding
  CHECK(withNumber(6, 0, -0.5f) == Found{"ACCESSOR_WEIGHTS_NEGATIVE " + attributes + "WEIGHTS_0",
                                         "ACCESSOR_WEIGHTS_NON_NORMALIZED " + attributes + "WEIGHTS_0"});
  CHECK(withNumber(9, 3, 1.0f) == Found{"ACCESSOR_INVALID_IBM /skins/0/inverseBindMatrices"});
  CHECK(withNumber(9, 31, 0.0f) == Found{"ACCESSOR_INVALID_IBM /skins/0/inverseBindMatrices"});
}

TEST_CASE("Validation: indices", "[io][validate]") {
  const std::string place = " /meshes/0/primitives/0/indices";
  CHECK(withNumber<uint16_t>(7, 0, 9) == Found{"ACCESSOR_INDEX_OOB" + place});
  CHECK(withNumber<uint16_t>(7, 0, 3) == Found{"ACCESSOR_INDEX_OOB" + place});
  CHECK(withNumber<uint16_t>(7, 0, 65535) ==
        Found{"ACCESSOR_INDEX_OOB" + place, "ACCESSOR_INDEX_PRIMITIVE_RESTART" + place});
  CHECK(withNumber<uint16_t>(7, 0, 1) == Found{"ACCESSOR_INDEX_TRIANGLE_DEGENERATE" + place});
  CHECK(withNumber<uint16_t>(16, 0, 2) == Found{"ACCESSOR_MAX_MISMATCH /accessors/16/max/1",
                                                "ACCESSOR_SPARSE_INDICES_NON_INCREASING /accessors/16/sparse",
                                                "FACET_TRIANGLES_WITHOUT_AREA /meshes/1/primitives/0"});
  CHECK(withNumber<uint16_t>(16, 1, 7)[1] == "ACCESSOR_SPARSE_INDEX_OOB /accessors/16/sparse");
}

TEST_CASE("Validation: keys of animations", "[io][validate]") {
  const std::string input = " /animations/0/samplers/0/input";
  CHECK(withNumber(10, 0, -1.0f) == Found{"ACCESSOR_ANIMATION_INPUT_NEGATIVE" + input,
                                          "ACCESSOR_ELEMENT_OUT_OF_MIN_BOUND /accessors/10/min/0",
                                          "ACCESSOR_MIN_MISMATCH /accessors/10/min/0"});
  CHECK(withNumber(10, 1, 2.0f) == Found{"ACCESSOR_ANIMATION_INPUT_NON_INCREASING" + input});
  CHECK(withNumber(11, 0, 1.0f) ==
        Found{"ACCESSOR_ANIMATION_SAMPLER_OUTPUT_NON_NORMALIZED_QUATERNION /animations/0/channels/0/sampler"});
}
