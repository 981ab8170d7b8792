// glTF 2.0, section 5: properties of its objects.

#include "io/validate/schema_fields.hpp"

namespace facet::io::validate {

namespace {

const std::vector<double> componentTypes = {5120, 5121, 5122, 5123, 5125, 5126, 5130};  // 5130: KHR_accessor_float64
const std::vector<double> wraps = {10497, 33071, 33648};

Field notMarked(Field row) {
  row.marks = false;
  return row;
}

const Type& assetType() {
  static const Type type{"asset",
                         {text("copyright"), text("generator"), text("version").required(), text("minVersion")}};
  return type;
}

const Type& sparseIndicesType() {
  static const Type type{"accessor.sparse.indices",
                         {index("bufferView", "bufferViews").required(), natural("byteOffset"),
                          natural("componentType").required().oneOf(std::vector<double>{5121, 5123, 5125})}};
  return type;
}

const Type& sparseValuesType() {
  static const Type type{"accessor.sparse.values",
                         {index("bufferView", "bufferViews").required(), natural("byteOffset")}};
  return type;
}

const Type& sparseType() {
  static const Type type{"accessor.sparse",
                         {natural("count").required().atLeast(1), object("indices", sparseIndicesType).required(),
                          object("values", sparseValuesType).required()}};
  return type;
}

const Type& accessorType() {
  static const Type type{
      "accessor",
      {index("bufferView", "bufferViews"), natural("byteOffset").with("bufferView"),
       natural("componentType").required().oneOf(componentTypes), boolean("normalized"),
       natural("count").required().atLeast(1),
       text("type").required().oneOf(
           std::vector<std::string>{"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"}),
       field("max", Kind::wholes), field("min", Kind::wholes), object("sparse", sparseType), text("name")}};
  return type;
}

const Type& channelTargetType() {
  static const Type type{"animation.channel.target", {index("node", "nodes"), text("path").required()}};
  return type;
}

const Type& channelType() {
  static const Type type{"animation.channel",
                         {index("sampler", "").required(), object("target", channelTargetType).required()}};
  return type;
}

const Type& animationSamplerType() {
  static const Type type{"animation.sampler",
                         {index("input", "accessors").required(), index("output", "accessors").required(),
                          text("interpolation").oneOf(std::vector<std::string>{"LINEAR", "STEP", "CUBICSPLINE"})}};
  return type;
}

const Type& animationType() {
  static const Type type{"animation",
                         {objects("channels", channelType).required(),
                          objects("samplers", animationSamplerType).required(), text("name")}};
  return type;
}

const Type& bufferType() {
  static const Type type{"buffer", {text("uri"), natural("byteLength").required().atLeast(1), text("name")}};
  return type;
}

const Type& bufferViewType() {
  static const Type type{
      "bufferView",
      {index("buffer", "buffers").required(), natural("byteOffset"), natural("byteLength").required().atLeast(1),
       natural("byteStride").within(4, 252), natural("target").oneOf(std::vector<double>{34962, 34963}), text("name")}};
  return type;
}

const Type& orthographicType() {
  static const Type type{"camera.orthographic",
                         {number("xmag").required(), number("ymag").required(), number("zfar").required().above(0),
                          number("znear").required().atLeast(0)}};
  return type;
}

const Type& perspectiveType() {
  static const Type type{"camera.perspective",
                         {number("aspectRatio").above(0), number("yfov").required().above(0), number("zfar").above(0),
                          number("znear").required().above(0)}};
  return type;
}

const Type& cameraType() {
  static const Type type{
      "camera",
      {object("orthographic", orthographicType), object("perspective", perspectiveType),
       text("type").required().oneOf(std::vector<std::string>{"orthographic", "perspective"}), text("name")}};
  return type;
}

const Type& imageType() {
  static const Type type{
      "image", {text("uri"), text("mimeType"), index("bufferView", "bufferViews").with("mimeType"), text("name")}};
  return type;
}

const Type& pbrType() {
  static const Type type{"pbrMetallicRoughness",
                         {numbers("baseColorFactor", 4).within(0, 1), object("baseColorTexture", textureInfoType),
                          number("metallicFactor").within(0, 1), number("roughnessFactor").within(0, 1),
                          object("metallicRoughnessTexture", textureInfoType)}};
  return type;
}

const Type& materialType() {
  static const Type type{"material",
                         {object("pbrMetallicRoughness", pbrType), object("normalTexture", normalTextureInfoType),
                          object("occlusionTexture", occlusionTextureInfoType),
                          object("emissiveTexture", textureInfoType), numbers("emissiveFactor", 3).within(0, 1),
                          text("alphaMode").oneOf(std::vector<std::string>{"OPAQUE", "MASK", "BLEND"}),
                          number("alphaCutoff").atLeast(0), boolean("doubleSided"), text("name")}};
  return type;
}

const Type& primitiveType() {
  static const Type type{"mesh.primitive",
                         {[] {
                            Field row = field("attributes", Kind::indexMap).required();
                            row.into = "accessors";
                            return row;
                          }(),
                          index("indices", "accessors"), index("material", "materials"), natural("mode").within(0, 6),
                          [] {
                            Field row = field("targets", Kind::indexMaps);
                            row.into = "accessors";
                            return row;
                          }()}};
  return type;
}

const Type& meshType() {
  static const Type type{
      "mesh", {objects("primitives", primitiveType).required(), field("weights", Kind::numbers), text("name")}};
  return type;
}

const Type& nodeType() {
  static const Type type{
      "node",
      {index("camera", "cameras"), indices("children", "nodes"), index("skin", "skins").with("mesh"),
       numbers("matrix", 16), index("mesh", "meshes"), numbers("rotation", 4).within(-1, 1), numbers("scale", 3),
       numbers("translation", 3), field("weights", Kind::numbers).with("mesh"), text("name")}};
  return type;
}

const Type& samplerType() {
  static const Type type{"sampler",
                         {natural("magFilter").oneOf(std::vector<double>{9728, 9729}),
                          natural("minFilter").oneOf(std::vector<double>{9728, 9729, 9984, 9985, 9986, 9987}),
                          natural("wrapS").oneOf(wraps), natural("wrapT").oneOf(wraps), text("name")}};
  return type;
}

const Type& sceneType() {
  static const Type type{"scene", {indices("nodes", "nodes"), text("name")}};
  return type;
}

const Type& skinType() {
  static const Type type{"skin",
                         {index("inverseBindMatrices", "accessors"), notMarked(index("skeleton", "nodes")),
                          indices("joints", "nodes").required(), text("name")}};
  return type;
}

const Type& textureType() {
  static const Type type{"texture", {index("sampler", "samplers"), index("source", "images"), text("name")}};
  return type;
}

}  // namespace

const Type& textureInfoType() {
  static const Type type{"textureInfo", {index("index", "textures").required(), natural("texCoord")}};
  return type;
}

const Type& normalTextureInfoType() {
  static const Type type{"textureInfo", {index("index", "textures").required(), natural("texCoord"), number("scale")}};
  return type;
}

const Type& occlusionTextureInfoType() {
  static const Type type{"textureInfo",
                         {index("index", "textures").required(), natural("texCoord"), number("strength").within(0, 1)}};
  return type;
}

const Type& rootType() {
  static const Type type{
      "glTF",
      {field("extensionsUsed", Kind::texts), field("extensionsRequired", Kind::texts).with("extensionsUsed"),
       objects("accessors", accessorType), objects("animations", animationType), object("asset", assetType).required(),
       objects("buffers", bufferType), objects("bufferViews", bufferViewType), objects("cameras", cameraType),
       objects("images", imageType), objects("materials", materialType), objects("meshes", meshType),
       objects("nodes", nodeType), objects("samplers", samplerType), index("scene", "scenes"),
       objects("scenes", sceneType), objects("skins", skinType), objects("textures", textureType)}};
  return type;
}

}  // namespace facet::io::validate
