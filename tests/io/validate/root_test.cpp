#include "support/broken_gltf.hpp"

using namespace facet;

TEST_CASE("Validation: the asset, broken", "[io][validate]") {
  test::check({
      {R"({"/asset": "[removed]"})", {"UNDEFINED_PROPERTY"}},
      {R"({"/asset/version": "[removed]"})", {"UNDEFINED_PROPERTY /asset"}},
      {R"({"/asset/version": "2"})", {"PATTERN_MISMATCH /asset/version"}},
      {R"({"/asset/version": "1.0"})", {"UNKNOWN_ASSET_MAJOR_VERSION /asset/version"}},
      {R"({"/asset/version": "2.1"})", {"UNKNOWN_ASSET_MINOR_VERSION /asset/version"}},
      {R"({"/asset/version": 2.0})", {"TYPE_MISMATCH /asset/version"}},
      {R"({"/asset/minVersion": "2.1"})", {"ASSET_MIN_VERSION_GREATER_THAN_VERSION /asset/minVersion"}},
      {R"({"/asset/generator": 5})", {"TYPE_MISMATCH /asset/generator"}},
  });
}

TEST_CASE("Validation: cameras, broken", "[io][validate]") {
  test::check({
      {R"({"/cameras/0/perspective/yfov": 0})", {"VALUE_NOT_IN_RANGE /cameras/0/perspective/yfov"}},
      {R"({"/cameras/0/perspective/yfov": 3.2})", {"CAMERA_YFOV_GEQUAL_PI /cameras/0/perspective"}},
      {R"({"/cameras/0/perspective/zfar": 0.01})", {"CAMERA_ZFAR_LEQUAL_ZNEAR /cameras/0/perspective"}},
      {R"({"/cameras/0/perspective/znear": "[removed]"})", {"UNDEFINED_PROPERTY /cameras/0/perspective"}},
      {R"({"/cameras/0/type": "fisheye"})", {"VALUE_NOT_IN_LIST /cameras/0/type"}},
      {R"({"/cameras/0/perspective": "[removed]"})", {"UNDEFINED_PROPERTY /cameras/0"}},
      {R"({"/cameras/0/orthographic": {"xmag": 1, "ymag": 1, "znear": 0, "zfar": 1}})", {"ONE_OF_MISMATCH /cameras/0"}},
      {R"({"/cameras/1/orthographic/xmag": 0})", {"CAMERA_XMAG_YMAG_ZERO /cameras/1/orthographic/xmag"}},
      {R"({"/cameras/1/orthographic/ymag": -1})", {"CAMERA_XMAG_YMAG_NEGATIVE /cameras/1/orthographic/ymag"}},
      {R"({"/cameras/1/orthographic/zfar": 0})", {"VALUE_NOT_IN_RANGE /cameras/1/orthographic/zfar"}},
      {R"({"/cameras/0/perspective/aspectRatio": 0})", {"VALUE_NOT_IN_RANGE /cameras/0/perspective/aspectRatio"}},
  });
}

TEST_CASE("Validation: lists of extensions, broken", "[io][validate]") {
  test::check({
      {R"({"/extensionsUsed": "[removed]"})",
       {"UNDECLARED_EXTENSION /extensions/KHR_lights_punctual",
        "UNDECLARED_EXTENSION /materials/1/extensions/KHR_materials_clearcoat",
        "UNDECLARED_EXTENSION /materials/1/extensions/KHR_materials_emissive_strength",
        "UNDECLARED_EXTENSION /materials/1/extensions/KHR_materials_ior",
        "UNDECLARED_EXTENSION /nodes/7/extensions/KHR_lights_punctual"}},
      {R"({"/extensionsUsed": ["KHR_lights_punctual"]})",
       {"UNDECLARED_EXTENSION /materials/1/extensions/KHR_materials_clearcoat",
        "UNDECLARED_EXTENSION /materials/1/extensions/KHR_materials_emissive_strength",
        "UNDECLARED_EXTENSION /materials/1/extensions/KHR_materials_ior"}},
      {R"({"/extensionsUsed/-": "KHR_lights_punctual"})", {"DUPLICATE_ELEMENTS /extensionsUsed/4"}},
      {R"({"/extensionsUsed/-": "foo"})",
       {"INVALID_EXTENSION_NAME_FORMAT /extensionsUsed/4", "UNSUPPORTED_EXTENSION /extensionsUsed/4"}},
      {R"({"/extensionsUsed/-": "VENDOR_thing"})", {"UNSUPPORTED_EXTENSION /extensionsUsed/4"}},
      {R"({"/extensionsUsed/-": "KHR_mesh_quantization"})", {"NON_REQUIRED_EXTENSION /extensionsUsed/4"}},
      {R"({"/extensionsUsed": {}})",
       {"TYPE_MISMATCH /extensionsUsed", "UNDECLARED_EXTENSION /extensions/KHR_lights_punctual",
        "UNDECLARED_EXTENSION /materials/1/extensions/KHR_materials_clearcoat",
        "UNDECLARED_EXTENSION /materials/1/extensions/KHR_materials_emissive_strength",
        "UNDECLARED_EXTENSION /materials/1/extensions/KHR_materials_ior",
        "UNDECLARED_EXTENSION /nodes/7/extensions/KHR_lights_punctual"}},
  });
}

TEST_CASE("Validation: required extensions, broken", "[io][validate]") {
  test::check({
      {R"({"/extensionsRequired": ["KHR_mesh_quantization"]})", {"UNUSED_EXTENSION_REQUIRED /extensionsRequired/0"}},
  });
}

TEST_CASE("Validation: lights and other extensions of the root, broken", "[io][validate]") {
  test::check({
      {R"({"/extensions/KHR_lights_punctual/lights/0/type": "area"})",
       {"EXTRA_PROPERTY /extensions/KHR_lights_punctual/lights/0/spot",
        "VALUE_NOT_IN_LIST /extensions/KHR_lights_punctual/lights/0/type"}},
      {R"({"/extensions/KHR_lights_punctual/lights/0/spot/outerConeAngle": 0.05})",
       {"KHR_LIGHTS_PUNCTUAL_LIGHT_SPOT_ANGLES /extensions/KHR_lights_punctual/lights/0/spot/outerConeAngle"}},
      {R"({"/extensions/KHR_lights_punctual/lights/0/color": [1, 1]})",
       {"ARRAY_LENGTH_NOT_IN_LIST /extensions/KHR_lights_punctual/lights/0/color"}},
      {R"({"/extensions/KHR_lights_punctual/lights/0/intensity": -1})",
       {"VALUE_NOT_IN_RANGE /extensions/KHR_lights_punctual/lights/0/intensity"}},
      {R"({"/extensions/KHR_lights_punctual/lights/0/spot": "[removed]"})",
       {"UNDEFINED_PROPERTY /extensions/KHR_lights_punctual/lights/0"}},
      {R"({"/extensions/KHR_lights_punctual/lights": []})",
       {"EMPTY_ENTITY /extensions/KHR_lights_punctual/lights",
        "UNRESOLVED_REFERENCE /nodes/7/extensions/KHR_lights_punctual/light"}},
      {R"({"/extensions/KHR_lights_punctual": "[removed]"})",
       {"UNSATISFIED_DEPENDENCY /nodes/7/extensions/KHR_lights_punctual"}},
      {R"({"/extensions/KHR_lights_punctual/lights/-": {"type": "point"}})",
       {"UNUSED_OBJECT /extensions/KHR_lights_punctual/lights/1"}},
      {R"({"/extensionsUsed/-": "KHR_materials_variants", "/extensions/KHR_materials_variants": {"variants": [{}]}})",
       {"UNDEFINED_PROPERTY /extensions/KHR_materials_variants/variants/0",
        "UNUSED_OBJECT /extensions/KHR_materials_variants/variants/0"}},
  });
}

TEST_CASE("Validation: members that nobody knows, broken", "[io][validate]") {
  test::check({
      {R"({"/stuff": 1})", {"UNEXPECTED_PROPERTY /stuff"}},
  });
}
