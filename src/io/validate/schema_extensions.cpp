// Objects of extensions: those of materials come from the tables that they are read by, the others from their schemas.

#include <algorithm>
#include <map>

#include "io/validate/schema_fields.hpp"
#include "scene/material_properties.hpp"
#include "scene/usage.hpp"

namespace facet::io::validate {

namespace {

using Types = std::map<std::pair<std::string, std::string>, Type>;  // by extension and the type that it extends

constexpr std::string_view head = "extensions/";

const Type& variantType() {
  static const Type type{"KHR_materials_variants.variant", {text("name").required()}};
  return type;
}

const Type& mappingType() {
  static const Type type{"KHR_materials_variants.mapping",
                         {indices("variants", "extensions/KHR_materials_variants/variants").required(),
                          index("material", "materials").required(), text("name")}};
  return type;
}

const Type& spotType() {
  constexpr double halfPi = 1.57079632679489662;
  static const Type type{"KHR_lights_punctual.spot",
                         {number("innerConeAngle").within(0, halfPi), number("outerConeAngle").above(0)}};
  return type;
}

const Type& lightType() {
  static const Type type{
      "KHR_lights_punctual.light",
      {numbers("color", 3).within(0, 1), number("intensity").atLeast(0), number("range").above(0),
       object("spot", spotType),
       text("type").required().oneOf(std::vector<std::string>{"directional", "point", "spot"}), text("name")}};
  return type;
}

Field freely(std::string name) { return field(std::move(name), Kind::anything); }

const Type& imageLightType() {
  static const Type type{"EXT_lights_image_based.light",
                         {numbers("rotation", 4).within(-1, 1), number("intensity").atLeast(0),
                          freely("irradianceCoefficients").required(), freely("specularImages").required(),
                          natural("specularImageSize").required().atLeast(1), text("name")}};
  return type;
}

const Type& lightProfileType() {
  static const Type type{"EXT_lights_ies.light",
                         {text("uri"), text("mimeType"), index("bufferView", "bufferViews"), text("name")}};
  return type;
}

// A row of the material's table, "extensions/KHR_materials_ior/ior".
Field fieldOf(const scene::MaterialProperty& property, std::string name) {
  Field row = componentCount(property) > 1 ? numbers(std::move(name), static_cast<size_t>(componentCount(property)))
                                           : number(std::move(name));
  constexpr double most = 3e38, least = 1e-17;  // what the table has for "no bound" and for "not zero"
  if (property.high < most) row.high = property.high;
  if (property.low > -most) row.low = property.low;
  if (property.low > 0 && property.low < least) row.low = 0, row.lowExcluded = true;
  if (property.property == scene::AnimatedProperty::ior) row.low = 1, row.orElse = 0;
  return row;
}

void addMaterialExtensions(Types& types) {
  const auto add = [&](std::string_view path, const auto& make) {
    if (!path.starts_with(head)) return;
    path.remove_prefix(head.size());
    const size_t slash = path.find('/');
    const std::string extension(path.substr(0, slash)), rest(path.substr(slash + 1));
    Type& type = types[{extension, "material"}];
    type.name = extension;
    if (rest.find('/') == std::string::npos) type.fields.push_back(make(rest));
  };
  for (const scene::MaterialProperty& property : scene::materialProperties())
    add(property.path, [&](const std::string& rest) { return fieldOf(property, rest); });
  for (const scene::TextureSlot slot : scene::textureSlots) {
    const bool normal = slot == scene::TextureSlot::clearcoatNormal;
    add(scene::path(slot),
        [&](const std::string& rest) { return object(rest, normal ? normalTextureInfoType : textureInfoType); });
  }
}

void addMeshopt(Types& types, const std::string& name) {
  types[{name, "buffer"}] = {name, {boolean("fallback")}};
  types[{name, "bufferView"}] = {
      name,
      {index("buffer", "buffers").required(), natural("byteOffset"), natural("byteLength").required().atLeast(1),
       natural("byteStride").required().within(2, 256), natural("count").required().atLeast(1),
       text("mode").required().oneOf(std::vector<std::string>{"ATTRIBUTES", "TRIANGLES", "INDICES"}),
       text("filter").oneOf(std::vector<std::string>{"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "COLOR"})}};
}

Types makeTypes() {
  Types types;
  addMaterialExtensions(types);
  addMeshopt(types, "EXT_meshopt_compression");
  addMeshopt(types, "KHR_meshopt_compression");
  const auto add = [&](const char* name, const char* parent, std::vector<Field> fields) {
    types[{name, parent}] = {name, std::move(fields)};
  };
  add("KHR_lights_punctual", "glTF", {objects("lights", lightType).required()});
  add("KHR_lights_punctual", "node", {index("light", "extensions/KHR_lights_punctual/lights").required()});
  add("KHR_texture_transform", "textureInfo",
      {numbers("offset", 2), number("rotation"), numbers("scale", 2), natural("texCoord")});
  add("KHR_materials_unlit", "material", {});
  add("KHR_materials_pbrSpecularGlossiness", "material",
      {numbers("diffuseFactor", 4).within(0, 1), object("diffuseTexture", textureInfoType),
       numbers("specularFactor", 3).within(0, 1), number("glossinessFactor").within(0, 1),
       object("specularGlossinessTexture", textureInfoType)});
  add("KHR_materials_variants", "glTF", {objects("variants", variantType).required()});
  add("KHR_materials_variants", "mesh.primitive", {objects("mappings", mappingType).required()});
  Field attributes = freely("attributes");  // numbers of Draco's own
  add("KHR_draco_mesh_compression", "mesh.primitive",
      {index("bufferView", "bufferViews").required(), std::move(attributes).required()});
  Field instances = field("attributes", Kind::indexMap);
  instances.into = "accessors";
  add("EXT_mesh_gpu_instancing", "node", {std::move(instances).required()});
  add("KHR_node_visibility", "node", {boolean("visible")});
  add("KHR_animation_pointer", "animation.channel.target", {text("pointer").required()});
  add("KHR_xmp_json_ld", "glTF", {freely("packets").required()});
  for (const char* parent : {"asset", "scene", "node", "mesh", "material", "image", "animation"})
    add("KHR_xmp_json_ld", parent, {natural("packet").required()});
  for (const char* name : {"KHR_texture_basisu", "EXT_texture_webp", "EXT_texture_avif"})
    add(name, "texture", {index("source", "images").required()});
  add("EXT_lights_image_based", "glTF", {objects("lights", imageLightType).required()});
  add("EXT_lights_image_based", "scene", {index("light", "extensions/EXT_lights_image_based/lights").required()});
  add("EXT_lights_ies", "glTF", {objects("lights", lightProfileType).required()});
  add("EXT_lights_ies", "node",
      {index("light", "extensions/EXT_lights_ies/lights").required(), number("multiplier").atLeast(0),
       numbers("color", 3).within(0, 1)});
  add("MSFT_lod", "node", {indices("ids", "nodes").required()});
  add("MSFT_lod", "material", {indices("ids", "materials").required()});
  add("KHR_gaussian_splatting", "mesh.primitive",
      {text("kernel").required(), text("colorSpace").required(), text("projection"), text("sortingMethod")});
  add("FACET_materials_models", "material", {text("microfacets"), text("masking"), text("conductor")});
  return types;
}

const Types& extensionTypes() {
  static const Types types = makeTypes();
  return types;
}

}  // namespace

const Type* extensionType(std::string_view name, std::string_view parent) {
  const auto found = extensionTypes().find({std::string(name), std::string(parent)});
  return found == extensionTypes().end() ? nullptr : &found->second;
}

bool isKnownExtension(std::string_view name) {
  constexpr std::string_view withoutObjects[] = {"KHR_mesh_quantization", "KHR_accessor_float64"};
  return std::ranges::find(withoutObjects, name) != std::end(withoutObjects) ||
         std::ranges::any_of(extensionTypes(), [&](const auto& entry) { return entry.first.first == name; });
}

}  // namespace facet::io::validate
