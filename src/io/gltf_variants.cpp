// KHR_materials_variants.

#include "io/gltf_document.hpp"
#include "io/uri.hpp"

namespace facet::io {

namespace {

using Value = tinygltf::Value;

constexpr const char* variantsExtension = "KHR_materials_variants";

// The whole number at value[key], which has to be an index below count.
Result<int> indexAt(const Document& doc, const Value& value, size_t count, const std::string& place, const char* what) {
  if (!value.IsInt()) return doc.error(place, "is not a whole number");
  const int index = value.GetNumberAsInt();
  if (auto ok = checkIndex(doc, index, count, place, what); !ok) return tl::unexpected(ok.error());
  return index;
}

Result<void> readMapping(Document& doc, const Value& mapping, const std::string& place, std::vector<int>& materials) {
  const auto material =
      indexAt(doc, memberValue(mapping, "material"), doc.gltf.materials.size(), place + "/material", "material");
  if (!material) return tl::unexpected(material.error());
  const Value& variants = memberValue(mapping, "variants");
  if (!variants.IsArray()) return doc.error(place + "/variants", "is not a list of variants");
  for (size_t i = 0; i < variants.ArrayLen(); ++i) {
    const std::string at = pointer(place + "/variants", i);
    const auto variant =
        indexAt(doc, variants.Get(static_cast<int>(i)), doc.model.variants.size(), at, "material variant");
    if (!variant) return tl::unexpected(variant.error());
    const auto index = static_cast<size_t>(*variant);
    if (materials.size() <= index) materials.resize(index + 1, -1);
    if (materials[index] != -1)
      doc.warning(at, "variant " + std::to_string(index) + " has a material already: this one is ignored");
    else
      materials[index] = *material;
  }
  return {};
}

}  // namespace

Result<void> readVariants(Document& doc) {
  const auto extension = doc.gltf.extensions.find(variantsExtension);
  if (extension == doc.gltf.extensions.end()) return {};
  const std::string place = std::string("/extensions/") + variantsExtension + "/variants";
  const Value& variants = memberValue(extension->second, "variants");
  if (!variants.IsArray()) {
    doc.warning(place, "is not a list of variants: there are none");
    return {};
  }
  for (size_t i = 0; i < variants.ArrayLen(); ++i) {
    const Value& name = memberValue(variants.Get(static_cast<int>(i)), "name");
    if (!name.IsString()) doc.warning(pointer(place, i), "has no name: choose it by its index");
    doc.model.variants.push_back(name.IsString() ? name.Get<std::string>() : std::string());
  }
  return {};
}

Result<std::vector<int>> variantMaterials(Document& doc, const tinygltf::Primitive& primitive,
                                          const std::string& place) {
  std::vector<int> materials;
  const auto extension = primitive.extensions.find(variantsExtension);
  if (extension == primitive.extensions.end()) return materials;
  const std::string at = place + "/extensions/" + variantsExtension + "/mappings";
  const Value& mappings = memberValue(extension->second, "mappings");
  if (!mappings.IsArray()) return doc.error(at, "is not a list of mappings");
  for (size_t i = 0; i < mappings.ArrayLen(); ++i) {
    if (auto ok = readMapping(doc, mappings.Get(static_cast<int>(i)), pointer(at, i), materials); !ok)
      return tl::unexpected(ok.error());
  }
  return materials;
}

}  // namespace facet::io
