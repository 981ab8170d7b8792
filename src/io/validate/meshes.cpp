// Primitives: attributes, indices, morph targets, what their materials ask of them.

#include <algorithm>
#include <charconv>

#include "io/uri.hpp"
#include "io/validate/checks.hpp"
#include "io/validate/elements.hpp"
#include "io/validate/formats.hpp"
#include "io/validate/material_textures.hpp"
#include "io/validate/vertex_data.hpp"

namespace facet::io::validate {

namespace {

// n of "TEXCOORD_n"; -1 where it is written otherwise.
int setOf(std::string_view digits) {
  if (digits.empty() || digits.size() > 4 || (digits.size() > 1 && digits[0] == '0')) return -1;
  int set = 0;
  const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), set);
  return end.ec == std::errc() && end.ptr == digits.data() + digits.size() ? set : -1;
}

struct Sets {
  int count = 0, highest = -1;
};

struct Names {
  std::map<std::string_view, Sets> numbered = {{"COLOR", {}}, {"JOINTS", {}}, {"WEIGHTS", {}}, {"TEXCOORD", {}}};
  bool position = false, normal = false, tangent = false;
};

Names checkNames(Asset& asset, const Json& attributes, const std::string& place) {
  Names names;
  for (const auto& [key, value] : attributes.items()) {
    const std::string_view name = key;
    if (name.starts_with('_')) continue;
    names.position = names.position || name == "POSITION";
    names.normal = names.normal || name == "NORMAL";
    names.tangent = names.tangent || name == "TANGENT";
    if (name == "POSITION" || name == "NORMAL" || name == "TANGENT") continue;
    const size_t line = name.find('_');
    const auto sets = line == name.npos ? names.numbered.end() : names.numbered.find(name.substr(0, line));
    const int set = sets == names.numbered.end() ? -1 : setOf(name.substr(line + 1));
    if (set < 0) {
      asset.add(Code::MESH_PRIMITIVE_INVALID_ATTRIBUTE, at(place, key), inQuotes(name) + " is no attribute of glTF");
      continue;
    }
    ++sets->second.count;
    sets->second.highest = std::max(sets->second.highest, set);
  }
  if (!names.position) asset.add(Code::MESH_PRIMITIVE_NO_POSITION, place, "has no POSITION");
  if (names.tangent && !names.normal)
    asset.add(Code::MESH_PRIMITIVE_TANGENT_WITHOUT_NORMAL, at(place, "TANGENT"), "there is no NORMAL");
  for (auto& [name, sets] : names.numbered) {
    if (sets.highest + 1 == sets.count) continue;
    asset.add(Code::MESH_PRIMITIVE_INDEXED_SEMANTIC_CONTINUITY, place,
              std::string(name) + " goes up to " + std::to_string(sets.highest) + ", but there are " +
                  std::to_string(sets.count));
    sets.count = 0;
  }
  Sets &joints = names.numbered["JOINTS"], &weights = names.numbered["WEIGHTS"];
  if (joints.count != weights.count)
    asset.add(Code::MESH_PRIMITIVE_JOINTS_WEIGHTS_MISMATCH, place,
              std::to_string(joints.count) + " sets of joints, " + std::to_string(weights.count) + " of weights");
  return names;
}

// What base attributes and displacements have in common.
void checkAttribute(Asset& asset, int index, const std::string& name, bool target, const std::string& place) {
  useAccessor(asset, index, Use::vertices, place);
  const Accessor& a = asset.accessors[static_cast<size_t>(index)];
  useView(asset, a.view, Use::vertices, place);
  if (name == "POSITION" && !a.hasBounds)
    asset.add(Code::MESH_PRIMITIVE_POSITION_ACCESSOR_WITHOUT_BOUNDS, place,
              "accessor " + std::to_string(index) + " has no min and max");
  if (!a.wellFormed) return;
  if (!isAttributeFormat(asset, name, target, a))
    asset.add(Code::MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_INVALID_FORMAT, place,
              "is " + formatText(a) + ", which " + inQuotes(name) + " can't be");
  if (!target && name.starts_with('_') && a.componentType == 5125)
    asset.add(Code::MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_UNSIGNED_INT, place, "is 32-bit integers");
  if (a.view < 0) return;
  View& view = asset.views[static_cast<size_t>(a.view)];
  if (a.offset % 4 != 0 || (a.elementLength % 4 != 0 && view.stride == 0))
    asset.add(Code::MESH_PRIMITIVE_ACCESSOR_UNALIGNED, place, "not all elements begin at multiples of 4 bytes");
  if (view.stride != 0) return;
  if (view.vertexAccessor < 0)
    view.vertexAccessor = index;
  else if (view.vertexAccessor != index)
    asset.add(Code::MESH_PRIMITIVE_ACCESSOR_WITHOUT_BYTESTRIDE, place,
              "buffer view " + std::to_string(a.view) + " holds accessor " + std::to_string(view.vertexAccessor) +
                  ", too, and has no byteStride");
}

constexpr const char* modeNames[] = {"POINTS",    "LINES",          "LINE_LOOP",   "LINE_STRIP",
                                     "TRIANGLES", "TRIANGLE_STRIP", "TRIANGLE_FAN"};

bool isCountOf(int64_t mode, uint64_t count) {
  switch (mode) {
    case 1:
      return count % 2 == 0;
    case 2:
    case 3:
      return count >= 2;
    case 4:
      return count % 3 == 0;
    case 5:
    case 6:
      return count >= 3;
    default:
      return true;
  }
}

// The number of vertices that the primitive draws; 0 where that can't be told.
uint64_t checkIndices(Asset& asset, const Json& primitive, uint64_t vertices, int64_t mode, const std::string& place) {
  const int index = indexAt(asset, primitive, "indices", "accessors");
  if (index < 0) return member(primitive, "indices").is_null() ? vertices : 0;
  const std::string here = place + "/indices";
  useAccessor(asset, index, Use::indices, here);
  const Accessor& a = asset.accessors[static_cast<size_t>(index)];
  useView(asset, a.view, Use::indices, here);
  if (a.view >= 0 && asset.views[static_cast<size_t>(a.view)].stride != 0)
    asset.add(Code::MESH_PRIMITIVE_INDICES_ACCESSOR_WITH_BYTESTRIDE, here, "the buffer view has a stride");
  if (!a.wellFormed) return 0;
  const bool fits = a.type == "SCALAR" && !a.normalized &&
                    (a.componentType == 5121 || a.componentType == 5123 || a.componentType == 5125);
  if (!fits)
    asset.add(Code::MESH_PRIMITIVE_INDICES_ACCESSOR_INVALID_FORMAT, here, "is " + formatText(a));
  else
    checkIndexData(asset, index, vertices, mode == 4, here);
  return a.count;
}

void checkVertexData(Asset& asset, int index, const std::string& name, const std::string& place) {
  const Accessor& a = asset.accessors[static_cast<size_t>(index)];
  if (!a.wellFormed || !isAttributeFormat(asset, name, false, a)) return;
  if (name == "NORMAL" || name == "TANGENT") checkUnitVectors(asset, index, name == "TANGENT", place);
  if (name == "COLOR_0" && isFloat(a.componentType)) checkClamped(asset, index, place);
}

// Returns the number of vertices.
uint64_t checkAttributes(Asset& asset, const Json& attributes, const std::string& place) {
  uint64_t vertices = 0;
  for (const auto& [name, value] : attributes.items()) {
    const int index = indexAt(asset, attributes, name, "accessors");
    if (index < 0) continue;
    const std::string here = at(place, name);
    checkAttribute(asset, index, name, false, here);
    checkVertexData(asset, index, name, here);
    const uint64_t count = asset.accessors[static_cast<size_t>(index)].count;
    if (vertices == 0) vertices = count;
    if (count != 0 && count != vertices)
      asset.add(Code::MESH_PRIMITIVE_UNEQUAL_ACCESSOR_COUNT, here,
                "has " + std::to_string(count) + " elements, another attribute " + std::to_string(vertices));
  }
  return vertices;
}

void checkTargets(Asset& asset, const Json& primitive, const std::string& place) {
  const Json &targets = member(primitive, "targets"), &attributes = member(primitive, "attributes");
  if (!targets.is_array()) return;
  for (size_t i = 0; i < targets.size(); ++i) {
    if (!targets[i].is_object()) continue;
    const std::string here = at(place + "/targets", i);
    for (const auto& [name, value] : targets[i].items()) {
      const std::string_view stem = std::string_view(name).substr(0, name.find('_'));
      const bool known = name == "POSITION" || name == "NORMAL" || name == "TANGENT" || name.starts_with("_") ||
                         ((stem == "TEXCOORD" || stem == "COLOR") && name.size() > stem.size() &&
                          setOf(name.substr(stem.size() + 1)) >= 0);
      if (!known)
        asset.add(Code::MESH_PRIMITIVE_INVALID_ATTRIBUTE, at(here, name),
                  inQuotes(name) + " is no attribute that morphs");
      const int index = indexAt(asset, targets[i], name, "accessors");
      if (index < 0) continue;
      checkAttribute(asset, index, name, true, at(here, name));
      const int base = indexAt(asset, attributes, name, "accessors");
      if (!attributes.is_object() || !attributes.contains(name))
        asset.add(Code::MESH_PRIMITIVE_MORPH_TARGET_NO_BASE_ACCESSOR, at(here, name),
                  "the primitive has no " + inQuotes(name));
      else if (base >= 0 &&
               asset.accessors[static_cast<size_t>(base)].count != asset.accessors[static_cast<size_t>(index)].count)
        asset.add(Code::MESH_PRIMITIVE_MORPH_TARGET_INVALID_ATTRIBUTE_COUNT, at(here, name),
                  "has another number of elements than the primitive's");
    }
  }
}

void checkMaterialOf(Asset& asset, const Json& primitive, const Names& names, const std::string& place) {
  const int material = indexAt(asset, primitive, "material", "materials");
  const std::string here = place + "/material";
  const MaterialTextures textures = material < 0 ? MaterialTextures() : texturesOf(asset, material);
  if (textures.hasNormalMap && !(names.normal && names.tangent)) {
    if (textures.hasBaseNormalMap)
      asset.add(Code::MESH_PRIMITIVE_GENERATED_TANGENT_SPACE, here,
                "the material has a normal texture, and the primitive no tangents");
    else
      asset.add(Code::MESH_PRIMITIVE_NO_TANGENT_SPACE, here,
                "the material needs tangents that neither the primitive has nor a normalTexture says how to make");
  }
  if (names.tangent && !textures.hasNormalMap && !textures.needsTangents)
    asset.add(Code::UNUSED_MESH_TANGENT, place + "/attributes/TANGENT", "the material has no normal texture");
  const int sets = names.numbered.at("TEXCOORD").count;
  std::vector<bool> used(static_cast<size_t>(std::max(sets, 0)));
  const auto use = [&](const MaterialTextures& from) {
    for (const TextureUse& texture : from.uses)
      if (texture.texCoord >= 0 && texture.texCoord < sets) used[static_cast<size_t>(texture.texCoord)] = true;
  };
  const auto wants = [&](const MaterialTextures& of, const std::string& who) {
    for (const TextureUse& texture : of.uses)
      if (texture.texCoord >= sets)
        asset.add(
            Code::MESH_PRIMITIVE_TOO_FEW_TEXCOORDS, who,
            texture.place + " wants TEXCOORD_" + std::to_string(texture.texCoord) + ", which the primitive lacks");
    use(of);
  };
  wants(textures, here);
  const Json& mappings = member(extension(primitive, "KHR_materials_variants"), "mappings");
  for (size_t i = 0; mappings.is_array() && i < mappings.size(); ++i)
    if (const int other = indexAt(asset, mappings[i], "material", "materials"); other >= 0)
      wants(texturesOf(asset, other), at(place + "/extensions/KHR_materials_variants/mappings", i) + "/material");
  for (size_t i = 0; i < used.size(); ++i)
    if (!used[i])
      asset.add(Code::UNUSED_OBJECT, place + "/attributes/TEXCOORD_" + std::to_string(i),
                "no texture of the material uses it");
}

void checkVariantMappings(Asset& asset, const Json& primitive, const std::string& place) {
  std::set<int64_t> seen;
  const Json& mappings = member(extension(primitive, "KHR_materials_variants"), "mappings");
  if (!mappings.is_array()) return;
  for (size_t i = 0; i < mappings.size(); ++i) {
    const Json& variants = member(mappings[i], "variants");
    for (size_t k = 0; variants.is_array() && k < variants.size(); ++k)
      if (const auto variant = whole(variants[k]); variant && !seen.insert(*variant).second)
        asset.add(Code::KHR_MATERIALS_VARIANTS_NON_UNIQUE_VARIANT,
                  at(at(place + "/extensions/KHR_materials_variants/mappings", i) + "/variants", k),
                  "variant " + std::to_string(*variant) + " is mapped twice");
  }
}

void checkPrimitive(Asset& asset, const Json& primitive, const std::string& place) {
  const Json& attributes = member(primitive, "attributes");
  Names names;
  uint64_t vertices = 0;
  if (attributes.is_object() && !attributes.empty()) {
    names = checkNames(asset, attributes, place + "/attributes");
    vertices = checkAttributes(asset, attributes, place + "/attributes");
  }
  const int64_t mode = wholeAt(primitive, "mode").value_or(4);
  const uint64_t drawn = checkIndices(asset, primitive, vertices, mode, place);
  if (drawn > 0 && mode >= 0 && mode <= 6 && !isCountOf(mode, drawn))
    asset.add(Code::MESH_PRIMITIVE_INCOMPATIBLE_MODE, place,
              std::to_string(drawn) + " vertices or indices don't make up whole " + modeNames[mode]);
  checkMaterialOf(asset, primitive, names, place);
  checkVariantMappings(asset, primitive, place);
  checkTargets(asset, primitive, place);
}

}  // namespace

size_t targetCountOf(const Json& primitive) {
  const Json& targets = member(primitive, "targets");
  return targets.is_array() ? targets.size() : 0;
}

void checkMeshes(Asset& asset) {
  const Json& meshes = collection(asset, "meshes");
  for (size_t m = 0; m < meshes.size(); ++m) {
    const Json &primitives = member(meshes[m], "primitives"), &weights = member(meshes[m], "weights");
    if (!primitives.is_array()) continue;
    const std::string place = at("/meshes", m);
    for (size_t p = 0; p < primitives.size(); ++p) {
      const std::string here = at(place + "/primitives", p);
      if (!primitives[p].is_object()) continue;
      checkPrimitive(asset, primitives[p], here);
      if (targetCountOf(primitives[p]) != targetCountOf(primitives[0]))
        asset.add(Code::MESH_PRIMITIVES_UNEQUAL_TARGETS_COUNT,
                  targetCountOf(primitives[p]) > 0 ? here + "/targets" : here,
                  "has " + std::to_string(targetCountOf(primitives[p])) + " morph targets, the first primitive " +
                      std::to_string(targetCountOf(primitives[0])));
    }
    if (weights.is_array() && !weights.empty() && !primitives.empty() && weights.size() != targetCountOf(primitives[0]))
      asset.add(Code::MESH_INVALID_WEIGHTS_COUNT, place + "/weights",
                std::to_string(weights.size()) + " weights for " + std::to_string(targetCountOf(primitives[0])) +
                    " morph targets");
  }
}

}  // namespace facet::io::validate
