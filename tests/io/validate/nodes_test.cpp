#include "support/broken_gltf.hpp"

using namespace facet;

TEST_CASE("Validation: nodes, broken", "[io][validate]") {
  test::check({
      {R"({"/nodes/1/children": [2, 2]})",
       {"DUPLICATE_ELEMENTS /nodes/1/children/1", "NODE_PARENT_OVERRIDE /nodes/1/children/1"}},
      {R"({"/nodes/1/children": [99]})",
       {"SKIN_NO_COMMON_ROOT /skins/0/joints", "SKIN_SKELETON_INVALID /skins/0/skeleton",
        "UNRESOLVED_REFERENCE /nodes/1/children/0"}},
      {R"({"/nodes/1/children": []})",
       {"EMPTY_ENTITY /nodes/1/children", "SKIN_NO_COMMON_ROOT /skins/0/joints",
        "SKIN_SKELETON_INVALID /skins/0/skeleton"}},
      {R"({"/nodes/1/children": [2, 3]})", {"SCENE_NON_ROOT_NODE /scenes/0/nodes/2"}},
      {R"({"/nodes/2/children": [1]})",
       {"NODE_LOOP /nodes/1", "NODE_LOOP /nodes/2", "SCENE_NON_ROOT_NODE /scenes/0/nodes/1"}},
      {R"({"/nodes/0/rotation": [1, 1, 0, 0]})",
       {"NODE_SKINNED_MESH_LOCAL_TRANSFORMS /nodes/0", "ROTATION_NON_UNIT /nodes/0/rotation"}},
      {R"({"/nodes/0/rotation": [0, 0, 0, 2]})",
       {"NODE_SKINNED_MESH_LOCAL_TRANSFORMS /nodes/0", "VALUE_NOT_IN_RANGE /nodes/0/rotation/3"}},
      {R"({"/nodes/0/scale": [2, 2, 2]})", {"NODE_SKINNED_MESH_LOCAL_TRANSFORMS /nodes/0"}},
      {R"({"/nodes/7/translation": [0, 0, 1]})", {"NODE_MATRIX_TRS /nodes/7/matrix"}},
      {R"({"/nodes/7/matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]})",
       {"NODE_MATRIX_DEFAULT /nodes/7/matrix"}},
      {R"({"/nodes/7/matrix": [1, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]})",
       {"NODE_MATRIX_NON_TRS /nodes/7/matrix"}},
      {R"({"/nodes/7/matrix": [1, 0, 0, 0]})", {"ARRAY_LENGTH_NOT_IN_LIST /nodes/7/matrix"}},
      {R"({"/nodes/7/matrix": [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1]})",
       {"NODE_MATRIX_NON_TRS /nodes/7/matrix"}},
      {R"({"/nodes/0/skin": "[removed]"})", {"NODE_SKINNED_MESH_WITHOUT_SKIN /nodes/0", "UNUSED_OBJECT /skins/0"}},
      {R"({"/nodes/0/mesh": "[removed]"})",
       {"NODE_EMPTY /nodes/0", "UNSATISFIED_DEPENDENCY /nodes/0/skin", "UNUSED_OBJECT /meshes/0"}},
      {R"({"/nodes/5/skin": 0})", {"NODE_SKIN_WITH_NON_SKINNED_MESH /nodes/5"}},
      {R"({"/nodes/6/weights": [1, 1]})", {"NODE_WEIGHTS_INVALID /nodes/6/weights"}},
      {R"({"/nodes/-": {}})", {"NODE_EMPTY /nodes/8", "UNUSED_OBJECT /nodes/8"}},
      {R"({"/nodes/4/camera": 7})", {"UNRESOLVED_REFERENCE /nodes/4/camera", "UNUSED_OBJECT /cameras/1"}},
      {R"({"/nodes/7/extensions/KHR_lights_punctual/light": 4})",
       {"UNRESOLVED_REFERENCE /nodes/7/extensions/KHR_lights_punctual/light",
        "UNUSED_OBJECT /extensions/KHR_lights_punctual/lights/0"}},
      {R"({"/nodes/3/name": 4})", {"TYPE_MISMATCH /nodes/3/name"}},
      {R"({"/nodes": {}})",
       {"TYPE_MISMATCH /nodes",
        "UNRESOLVED_REFERENCE /animations/0/channels/0/target/node",
        "UNRESOLVED_REFERENCE /animations/0/channels/1/target/node",
        "UNRESOLVED_REFERENCE /animations/0/channels/2/target/node",
        "UNRESOLVED_REFERENCE /animations/0/channels/3/target/node",
        "UNRESOLVED_REFERENCE /scenes/0/nodes/0",
        "UNRESOLVED_REFERENCE /scenes/0/nodes/1",
        "UNRESOLVED_REFERENCE /scenes/0/nodes/2",
        "UNRESOLVED_REFERENCE /scenes/0/nodes/3",
        "UNRESOLVED_REFERENCE /scenes/0/nodes/4",
        "UNRESOLVED_REFERENCE /scenes/0/nodes/5",
        "UNRESOLVED_REFERENCE /scenes/0/nodes/6",
        "UNRESOLVED_REFERENCE /skins/0/joints/0",
        "UNRESOLVED_REFERENCE /skins/0/joints/1",
        "UNRESOLVED_REFERENCE /skins/0/skeleton",
        "UNUSED_OBJECT /cameras/0",
        "UNUSED_OBJECT /cameras/1",
        "UNUSED_OBJECT /extensions/KHR_lights_punctual/lights/0",
        "UNUSED_OBJECT /meshes/0",
        "UNUSED_OBJECT /meshes/1",
        "UNUSED_OBJECT /meshes/2",
        "UNUSED_OBJECT /skins/0"}},
      {R"({"/nodes/3": null})", {"TYPE_MISMATCH /nodes/3", "UNUSED_OBJECT /cameras/0"}},
  });
}

TEST_CASE("Validation: the scene, broken", "[io][validate]") {
  test::check({
      {R"({"/scene": 4})", {"UNRESOLVED_REFERENCE /scene"}},
  });
}

TEST_CASE("Validation: scenes, broken", "[io][validate]") {
  test::check({
      {R"({"/scenes/0/nodes": []})",
       {"EMPTY_ENTITY /scenes/0/nodes", "UNUSED_OBJECT /nodes/0", "UNUSED_OBJECT /nodes/3", "UNUSED_OBJECT /nodes/4",
        "UNUSED_OBJECT /nodes/5", "UNUSED_OBJECT /nodes/7"}},
      {R"({"/scenes/0/nodes": [0, 0]})",
       {"DUPLICATE_ELEMENTS /scenes/0/nodes/1", "NODE_SKIN_NO_SCENE /nodes/0", "UNUSED_OBJECT /nodes/3",
        "UNUSED_OBJECT /nodes/4", "UNUSED_OBJECT /nodes/5", "UNUSED_OBJECT /nodes/7"}},
      {R"({"/scenes/0/nodes/-": 2})", {"SCENE_NON_ROOT_NODE /scenes/0/nodes/7"}},
      {R"({"/scenes": "[removed]"})",
       {"UNRESOLVED_REFERENCE /scene", "UNUSED_OBJECT /nodes/0", "UNUSED_OBJECT /nodes/3", "UNUSED_OBJECT /nodes/4",
        "UNUSED_OBJECT /nodes/5", "UNUSED_OBJECT /nodes/7"}},
  });
}

TEST_CASE("Validation: skins, broken", "[io][validate]") {
  test::check({
      {R"({"/skins/0/joints": []})", {"EMPTY_ENTITY /skins/0/joints", "NODE_EMPTY /nodes/2"}},
      {R"({"/skins/0/joints": [1, 1]})", {"DUPLICATE_ELEMENTS /skins/0/joints/1", "NODE_EMPTY /nodes/2"}},
      {R"({"/skins/0/joints": [1, 3]})",
       {"NODE_EMPTY /nodes/2", "SKIN_NO_COMMON_ROOT /skins/0/joints", "SKIN_SKELETON_INVALID /skins/0/skeleton"}},
      {R"({"/skins/0/skeleton": 2})", {"SKIN_SKELETON_INVALID /skins/0/skeleton"}},
      {R"({"/skins/0/skeleton": 88})", {"UNRESOLVED_REFERENCE /skins/0/skeleton"}},
      {R"({"/skins/0/inverseBindMatrices": 0})",
       {"ACCESSOR_USAGE_OVERRIDE /skins/0/inverseBindMatrices",
        "BUFFER_VIEW_TARGET_OVERRIDE /skins/0/inverseBindMatrices",
        "SKIN_IBM_INVALID_FORMAT /skins/0/inverseBindMatrices", "UNUSED_OBJECT /accessors/9"}},
      {R"({"/skins/0/joints": "[removed]"})", {"NODE_EMPTY /nodes/2", "UNDEFINED_PROPERTY /skins/0"}},
  });
}
