#include "support/broken_gltf.hpp"

using namespace facet;

TEST_CASE("Validation: images, broken", "[io][validate]") {
  test::check({
      {R"({"/images/0/mimeType": "image/gif"})",
       {"IMAGE_MIME_TYPE_INVALID /images/0/bufferView", "VALUE_NOT_IN_LIST /images/0/mimeType"}},
      {R"({"/images/0/mimeType": "image/jpeg"})", {"IMAGE_MIME_TYPE_INVALID /images/0/bufferView"}},
      {R"({"/images/0/mimeType": "[removed]"})", {"UNSATISFIED_DEPENDENCY /images/0/bufferView"}},
      {R"({"/images/0/uri": "a.png"})", {"IO_ERROR /images/0/uri", "ONE_OF_MISMATCH /images/0"}},
      {R"({"/images/1/uri": "[removed]"})", {"ONE_OF_MISMATCH /images/1"}},
      {R"({"/images/0/bufferView": 0})",
       {"BUFFER_VIEW_TARGET_OVERRIDE /images/0/bufferView", "IMAGE_UNRECOGNIZED_FORMAT /images/0",
        "UNUSED_OBJECT /bufferViews/18"}},
      {R"({"/images/0/bufferView": 77})",
       {"UNRESOLVED_REFERENCE /images/0/bufferView", "UNUSED_OBJECT /bufferViews/18"}},
  });
}

TEST_CASE("Validation: materials, broken", "[io][validate]") {
  test::check({
      {R"({"/materials/0/pbrMetallicRoughness/metallicFactor": 2})",
       {"VALUE_NOT_IN_RANGE /materials/0/pbrMetallicRoughness/metallicFactor"}},
      {R"({"/materials/0/pbrMetallicRoughness/baseColorFactor": [1, 1, 1]})",
       {"ARRAY_LENGTH_NOT_IN_LIST /materials/0/pbrMetallicRoughness/baseColorFactor"}},
      {R"({"/materials/0/pbrMetallicRoughness/baseColorFactor": [1, 1, 1, 2]})",
       {"VALUE_NOT_IN_RANGE /materials/0/pbrMetallicRoughness/baseColorFactor/3"}},
      {R"({"/materials/0/pbrMetallicRoughness/baseColorTexture/index": 9})",
       {"UNRESOLVED_REFERENCE /materials/0/pbrMetallicRoughness/baseColorTexture/index", "UNUSED_OBJECT /textures/0"}},
      {R"({"/materials/0/pbrMetallicRoughness/baseColorTexture/texCoord": 1})",
       {"MESH_PRIMITIVE_TOO_FEW_TEXCOORDS /meshes/0/primitives/0/material"}},
      {R"({"/materials/0/normalTexture/texCoord": -1})", {"VALUE_NOT_IN_RANGE /materials/0/normalTexture/texCoord"}},
      {R"({"/materials/0/normalTexture/scale": "big"})", {"TYPE_MISMATCH /materials/0/normalTexture/scale"}},
      {R"({"/materials/0/occlusionTexture": {"index": 0, "strength": 2}})",
       {"FACET_IMAGE_AS_COLOUR_AND_DATA /images/0", "VALUE_NOT_IN_RANGE /materials/0/occlusionTexture/strength"}},
      {R"({"/materials/0/emissiveFactor": [2, 0, 0]})", {"VALUE_NOT_IN_RANGE /materials/0/emissiveFactor/0"}},
      {R"({"/materials/0/alphaCutoff": 0.5})", {"MATERIAL_ALPHA_CUTOFF_INVALID_MODE /materials/0/alphaCutoff"}},
      {R"({"/materials/0/alphaMode": "mask"})", {"VALUE_NOT_IN_LIST /materials/0/alphaMode"}},
      {R"({"/materials/0/doubleSided": 1})", {"TYPE_MISMATCH /materials/0/doubleSided"}},
      {R"({"/materials/0/normalTexture": "[removed]"})",
       {"UNUSED_MESH_TANGENT /meshes/0/primitives/0/attributes/TANGENT", "UNUSED_OBJECT /textures/1"}},
      {R"({"/materials/0/colour": [1, 1, 1]})", {"UNEXPECTED_PROPERTY /materials/0/colour"}},
      {R"({"/materials/1/emissiveFactor": "[removed]"})",
       {"KHR_MATERIALS_EMISSIVE_STRENGTH_ZERO_FACTOR /materials/1/extensions/KHR_materials_emissive_strength"}},
      {R"({"/materials/1/extensions/KHR_materials_ior/ior": 0.5})",
       {"VALUE_NOT_IN_RANGE /materials/1/extensions/KHR_materials_ior/ior"}},
      {R"({"/materials/1/extensions/KHR_materials_clearcoat/clearcoatFactor": -1})",
       {"VALUE_NOT_IN_RANGE /materials/1/extensions/KHR_materials_clearcoat/clearcoatFactor"}},
      {R"({"/materials/1/extensions/KHR_materials_clearcoat/clearcoatNormalTexture": {"index": 1}})",
       {"MESH_PRIMITIVE_NO_TANGENT_SPACE /meshes/1/primitives/0/material",
        "MESH_PRIMITIVE_NO_TANGENT_SPACE /meshes/2/primitives/0/material",
        "MESH_PRIMITIVE_TOO_FEW_TEXCOORDS /meshes/1/primitives/0/material",
        "MESH_PRIMITIVE_TOO_FEW_TEXCOORDS /meshes/2/primitives/0/material"}},
      {R"({"/materials/1/extensions/KHR_materials_sheen": {}})",
       {"UNDECLARED_EXTENSION /materials/1/extensions/KHR_materials_sheen"}},
      {R"({"/materials/1/extensions/KHR_materials_clearcoat/clearcoat": 1})",
       {"UNEXPECTED_PROPERTY /materials/1/extensions/KHR_materials_clearcoat/clearcoat"}},
      {R"({"/materials/1/extensions": []})",
       {"FACET_EXTENSION_UNUSED /extensionsUsed/1", "FACET_EXTENSION_UNUSED /extensionsUsed/2",
        "FACET_EXTENSION_UNUSED /extensionsUsed/3", "TYPE_MISMATCH /materials/1/extensions"}},
      {R"({"/materials/1/extras": 3})", {"NON_OBJECT_EXTRAS /materials/1/extras"}},
      {R"({"/materials/1/extensions/KHR_lights_punctual": {"light": 0}})",
       {"UNEXPECTED_EXTENSION_OBJECT /materials/1/extensions/KHR_lights_punctual"}},
      {R"({"/materials/0/extensions": {"KHR_texture_transform": {}}})",
       {"UNDECLARED_EXTENSION /materials/0/extensions/KHR_texture_transform",
        "UNEXPECTED_EXTENSION_OBJECT /materials/0/extensions/KHR_texture_transform"}},
      {R"({"/materials/0/normalTexture/extensions": {"KHR_texture_transform": {"scale": [1]}}})",
       {"ARRAY_LENGTH_NOT_IN_LIST /materials/0/normalTexture/extensions/KHR_texture_transform/scale",
        "UNDECLARED_EXTENSION /materials/0/normalTexture/extensions/KHR_texture_transform"}},
      {R"({"/extensionsUsed/-": "KHR_texture_transform", "/materials/0/normalTexture/extensions": {"KHR_texture_transform": {"scale": [1]}}})",
       {"ARRAY_LENGTH_NOT_IN_LIST /materials/0/normalTexture/extensions/KHR_texture_transform/scale"}},
      {R"({"/extensionsUsed/-": "KHR_texture_transform", "/materials/0/normalTexture/extensions": {"KHR_texture_transform": {"texCoord": 1}}})",
       {"MESH_PRIMITIVE_TOO_FEW_TEXCOORDS /meshes/0/primitives/0/material"}},
      {R"({"/extensionsUsed/-": "KHR_materials_volume", "/materials/1/extensions/KHR_materials_volume": {"thicknessFactor": 1}})",
       {"KHR_MATERIALS_VOLUME_NO_TRANSMISSION /materials/1/extensions/KHR_materials_volume"}},
      {R"({"/extensionsUsed/-": "KHR_materials_volume", "/materials/1/extensions/KHR_materials_volume": {"attenuationDistance": 0}})",
       {"KHR_MATERIALS_VOLUME_NO_TRANSMISSION /materials/1/extensions/KHR_materials_volume",
        "VALUE_NOT_IN_RANGE /materials/1/extensions/KHR_materials_volume/attenuationDistance"}},
      {R"({"/extensionsUsed/-": "KHR_materials_dispersion", "/materials/1/extensions/KHR_materials_dispersion": {"dispersion": 1}})",
       {"KHR_MATERIALS_DISPERSION_NO_VOLUME /materials/1/extensions/KHR_materials_dispersion"}},
      {R"({"/extensionsUsed/-": "KHR_materials_iridescence", "/materials/1/extensions/KHR_materials_iridescence": {"iridescenceThicknessMinimum": 100}})",
       {"KHR_MATERIALS_IRIDESCENCE_THICKNESS_RANGE_WITHOUT_TEXTURE "
        "/materials/1/extensions/KHR_materials_iridescence/iridescenceThicknessMinimum"}},
      {R"({"/extensionsUsed/-": "KHR_materials_iridescence", "/materials/0/extensions": {"KHR_materials_iridescence": {"iridescenceThicknessTexture": {"index": 0}, "iridescenceThicknessMinimum": 400}}})",
       {"FACET_IMAGE_AS_COLOUR_AND_DATA /images/0",
        "KHR_MATERIALS_IRIDESCENCE_THICKNESS_TEXTURE_UNUSED "
        "/materials/0/extensions/KHR_materials_iridescence/iridescenceThicknessTexture"}},
      {R"({"/extensionsUsed/-": "KHR_materials_anisotropy", "/materials/0/extensions": {"KHR_materials_anisotropy": {"anisotropyTexture": {"index": 0, "texCoord": 1}}}})",
       {"FACET_IMAGE_AS_COLOUR_AND_DATA /images/0",
        "KHR_MATERIALS_ANISOTROPY_ANISOTROPY_TEXTURE_TEXCOORD "
        "/materials/0/extensions/KHR_materials_anisotropy/anisotropyTexture",
        "MESH_PRIMITIVE_TOO_FEW_TEXCOORDS /meshes/0/primitives/0/material"}},
      {R"({"/extensionsUsed/-": "KHR_materials_clearcoat", "/materials/0/extensions": {"KHR_materials_clearcoat": {"clearcoatNormalTexture": {"index": 0, "texCoord": 1}}}})",
       {"DUPLICATE_ELEMENTS /extensionsUsed/4", "FACET_IMAGE_AS_COLOUR_AND_DATA /images/0",
        "KHR_MATERIALS_CLEARCOAT_CLEARCOAT_NORMAL_TEXTURE_TEXCOORD "
        "/materials/0/extensions/KHR_materials_clearcoat/clearcoatNormalTexture",
        "MESH_PRIMITIVE_TOO_FEW_TEXCOORDS /meshes/0/primitives/0/material"}},
      {R"({"/extensionsUsed/-": "KHR_materials_unlit", "/materials/1/extensions/KHR_materials_unlit": {}})",
       {"MULTIPLE_EXTENSIONS /materials/1/extensions/KHR_materials_unlit"}},
      {R"({"/extensionsUsed/-": "KHR_materials_transmission", "/materials/1/extensions/KHR_materials_transmission": {"transmissionFactor": 1.5}})",
       {"VALUE_NOT_IN_RANGE /materials/1/extensions/KHR_materials_transmission/transmissionFactor"}},
      {R"({"/extensionsUsed/-": "KHR_materials_sheen", "/materials/1/extensions/KHR_materials_sheen": {"sheenColorFactor": [1, 2, 0]}})",
       {"VALUE_NOT_IN_RANGE /materials/1/extensions/KHR_materials_sheen/sheenColorFactor/1"}},
      {R"({"/extensionsUsed/-": "KHR_materials_specular", "/materials/1/extensions/KHR_materials_specular": {"specularColorFactor": [-1, 2, 0]}})",
       {"VALUE_NOT_IN_RANGE /materials/1/extensions/KHR_materials_specular/specularColorFactor/0"}},
  });
}

TEST_CASE("Validation: samplers, broken", "[io][validate]") {
  test::check({
      {R"({"/samplers/0/magFilter": 1})", {"VALUE_NOT_IN_LIST /samplers/0/magFilter"}},
      {R"({"/samplers/0/wrapS": 5})", {"VALUE_NOT_IN_LIST /samplers/0/wrapS"}},
      {R"({"/samplers/-": {}})", {"UNUSED_OBJECT /samplers/1"}},
  });
}

TEST_CASE("Validation: textures, broken", "[io][validate]") {
  test::check({
      {R"({"/textures/0/source": 5})", {"UNRESOLVED_REFERENCE /textures/0/source", "UNUSED_OBJECT /images/0"}},
      {R"({"/textures/0/sampler": 5})", {"UNRESOLVED_REFERENCE /textures/0/sampler", "UNUSED_OBJECT /samplers/0"}},
      {R"({"/textures/0": 7})", {"TYPE_MISMATCH /textures/0", "UNUSED_OBJECT /images/0", "UNUSED_OBJECT /samplers/0"}},
      {R"({"/textures/-": {"source": 0}})", {"UNUSED_OBJECT /textures/2"}},
      {R"({"/extensionsUsed/-": "EXT_texture_webp", "/textures/0/extensions": {"EXT_texture_webp": {"source": 0}}})",
       {"TEXTURE_INVALID_IMAGE_MIME_TYPE /textures/0/extensions/EXT_texture_webp/source"}},
  });
}
