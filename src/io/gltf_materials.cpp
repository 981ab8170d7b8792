// Textures, samplers and materials; one function per extension.

#include <algorithm>
#include <cmath>

#include "io/gltf_document.hpp"
#include "io/uri.hpp"

namespace facet::io {

namespace {

using Value = tinygltf::Value;
using Extensions = tinygltf::ExtensionMap;

const Value* find(const Extensions& extensions, const char* name) {
  const auto found = extensions.find(name);
  return found == extensions.end() || !found->second.IsObject() ? nullptr : &found->second;
}

// A finite single-precision number; nothing if the key is missing.
Result<std::optional<float>> number(const Document& doc, const Value& object, const char* key,
                                    const std::string& place) {
  const Value& value = object.Get(key);
  if (value.Type() == tinygltf::NULL_TYPE) return std::nullopt;
  if (!value.IsNumber()) return doc.error(place + "/" + key, "is not a number");
  const auto result = static_cast<float>(value.GetNumberAsDouble());
  if (!std::isfinite(result)) return doc.error(place + "/" + key, "is not finite in single precision");
  return result;
}

// A factor of the core material: finite, brought to [low, high] with a warning.
Result<float> factor(Document& doc, double value, float low, float high, const std::string& place) {
  const auto single = static_cast<float>(value);
  if (!std::isfinite(single)) return doc.error(place, "is not finite in single precision");
  if (single < low || single > high) doc.warning(place, "is out of range: clamped");
  return std::clamp(single, low, high);
}

constexpr float unbounded = std::numeric_limits<float>::max();

// ---- Samplers and textures ------------------------------------------------------------------------------------------

scene::Wrap wrap(Document& doc, int value, const std::string& place) {
  switch (value) {
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
      return scene::Wrap::clampToEdge;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
      return scene::Wrap::mirroredRepeat;
    case TINYGLTF_TEXTURE_WRAP_REPEAT:
      return scene::Wrap::repeat;
    default:
      doc.warning(place, std::to_string(value) + " is not a wrapping mode: repeat is used");
      return scene::Wrap::repeat;
  }
}

// -1, not given: the implementation chooses; we choose trilinear.
void setMinFilter(Document& doc, int value, const std::string& place, scene::Sampler& sampler) {
  using scene::Filter, scene::MipFilter;
  const struct {
    int value;
    Filter filter;
    MipFilter mip;
  } table[] = {{-1, Filter::linear, MipFilter::linear},
               {TINYGLTF_TEXTURE_FILTER_NEAREST, Filter::nearest, MipFilter::none},
               {TINYGLTF_TEXTURE_FILTER_LINEAR, Filter::linear, MipFilter::none},
               {TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST, Filter::nearest, MipFilter::nearest},
               {TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST, Filter::linear, MipFilter::nearest},
               {TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR, Filter::nearest, MipFilter::linear},
               {TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR, Filter::linear, MipFilter::linear}};
  for (const auto& row : table) {
    if (row.value != value) continue;
    sampler.minFilter = row.filter;
    sampler.mipFilter = row.mip;
    return;
  }
  doc.warning(place, std::to_string(value) + " is not a filter: linear with mipmaps is used");
}

scene::Sampler readSampler(Document& doc, const tinygltf::Sampler& from, const std::string& place) {
  scene::Sampler sampler;
  sampler.wrapS = wrap(doc, from.wrapS, place + "/wrapS");
  sampler.wrapT = wrap(doc, from.wrapT, place + "/wrapT");
  setMinFilter(doc, from.minFilter, place + "/minFilter", sampler);
  if (from.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST) {
    sampler.magFilter = scene::Filter::nearest;
  } else if (from.magFilter != -1 && from.magFilter != TINYGLTF_TEXTURE_FILTER_LINEAR) {
    doc.warning(place + "/magFilter", std::to_string(from.magFilter) + " is not a filter: linear is used");
  }
  return sampler;
}

// Which image: that of an extension whose format is read, else the core's. KHR_texture_basisu has to fall back.
Result<int> textureImage(Document& doc, const tinygltf::Texture& from, const std::string& place) {
  int source = from.source;
  std::string at = place + "/source";
  if (const Value* webp = find(from.extensions, "EXT_texture_webp")) {
    const Value& image = webp->Get("source");
    if (image.Type() != tinygltf::NULL_TYPE) {
      at = place + "/extensions/EXT_texture_webp/source";
      if (!image.IsInt()) return doc.error(at, "is not a whole number");
      source = image.GetNumberAsInt();
      if (source < 0) source = -2;  // -1 would mean "not given"
    }
  }
  if (source != -1) {
    if (auto ok = checkIndex(doc, source, doc.model.images.size(), at, "image"); !ok) {
      return tl::unexpected(ok.error());
    }
    return source;
  }
  if (find(from.extensions, "KHR_texture_basisu")) {
    doc.warning(place,
                "its image is only given through KHR_texture_basisu, which is not supported yet: a placeholder is "
                "shown");
    return -1;
  }
  doc.warning(place, "has no image: a placeholder is shown");
  return -1;
}

// ---- References to textures -----------------------------------------------------------------------------------------

// KHR_texture_transform
Result<void> readTextureTransform(Document& doc, const Value& extension, const std::string& place,
                                  scene::TextureRef& ref) {
  const auto pair = [&](const char* key, glm::vec2& target) -> Result<void> {
    const Value& value = extension.Get(key);
    if (value.Type() == tinygltf::NULL_TYPE) return {};
    if (value.ArrayLen() != 2) return doc.error(place + "/" + key, "does not have two numbers");
    for (int i = 0; i < 2; ++i) {
      target[i] = static_cast<float>(value.Get(i).GetNumberAsDouble());
      if (!value.Get(i).IsNumber() || !std::isfinite(target[i])) {
        return doc.error(place + "/" + key, "does not have two finite numbers");
      }
    }
    return {};
  };
  if (auto ok = pair("offset", ref.transform.offset); !ok) return ok;
  if (auto ok = pair("scale", ref.transform.scale); !ok) return ok;
  const auto rotation = number(doc, extension, "rotation", place);
  if (!rotation) return tl::unexpected(rotation.error());
  ref.transform.rotation = rotation->value_or(0.0f);
  const Value& texCoord = extension.Get("texCoord");
  if (texCoord.IsInt()) ref.texCoord = texCoord.GetNumberAsInt();
  return {};
}

Result<scene::TextureRef> readRef(Document& doc, int index, int texCoord, const Extensions& extensions,
                                  const std::string& place) {
  scene::TextureRef ref;
  if (index == -1) return ref;
  if (auto ok = checkIndex(doc, index, doc.model.textures.size(), place + "/index", "texture"); !ok) {
    return tl::unexpected(ok.error());
  }
  ref.texture = index;
  ref.texCoord = texCoord;
  if (const Value* extension = find(extensions, "KHR_texture_transform")) {
    if (auto ok = readTextureTransform(doc, *extension, place + "/extensions/KHR_texture_transform", ref); !ok) {
      return tl::unexpected(ok.error());
    }
  }
  if (ref.texCoord < 0 || ref.texCoord >= scene::maxTexCoordSets) {
    doc.warning(place + "/texCoord", "TEXCOORD_" + std::to_string(ref.texCoord) + " is none of the supported 0 to " +
                                         std::to_string(scene::maxTexCoordSets - 1) + ": shown without this texture");
    return scene::TextureRef();
  }
  return ref;
}

template <class Info>
Result<void> readRef(Document& doc, const Info& info, const std::string& place, scene::TextureRef& target) {
  const auto ref = readRef(doc, info.index, info.texCoord, info.extensions, place);
  if (!ref) return tl::unexpected(ref.error());
  target = *ref;
  return {};
}

// ---- Materials ------------------------------------------------------------------------------------------------------

Result<void> readCoreTextures(Document& doc, const tinygltf::Material& from, const std::string& place,
                              scene::Material& material) {
  const auto& pbr = from.pbrMetallicRoughness;
  const std::string pbrPlace = place + "/pbrMetallicRoughness";
  if (auto ok = readRef(doc, pbr.baseColorTexture, pbrPlace + "/baseColorTexture", material.baseColor); !ok) return ok;
  if (auto ok = readRef(doc, pbr.metallicRoughnessTexture, pbrPlace + "/metallicRoughnessTexture",
                        material.metallicRoughness);
      !ok) {
    return ok;
  }
  if (auto ok = readRef(doc, from.normalTexture, place + "/normalTexture", material.normal); !ok) return ok;
  if (auto ok = readRef(doc, from.occlusionTexture, place + "/occlusionTexture", material.occlusion); !ok) return ok;
  return readRef(doc, from.emissiveTexture, place + "/emissiveTexture", material.emissive);
}

Result<void> readCoreFactors(Document& doc, const tinygltf::Material& from, const std::string& place,
                             scene::Material& material) {
  const auto& pbr = from.pbrMetallicRoughness;
  const std::string pbrPlace = place + "/pbrMetallicRoughness";
  const struct {
    double value;
    float low, high;
    std::string place;
    float* target;
  } factors[] = {
      {pbr.baseColorFactor[0], 0, 1, pbrPlace + "/baseColorFactor/0", &material.baseColorFactor.r},
      {pbr.baseColorFactor[1], 0, 1, pbrPlace + "/baseColorFactor/1", &material.baseColorFactor.g},
      {pbr.baseColorFactor[2], 0, 1, pbrPlace + "/baseColorFactor/2", &material.baseColorFactor.b},
      {pbr.baseColorFactor[3], 0, 1, pbrPlace + "/baseColorFactor/3", &material.baseColorFactor.a},
      {pbr.metallicFactor, 0, 1, pbrPlace + "/metallicFactor", &material.metallicFactor},
      {pbr.roughnessFactor, 0, 1, pbrPlace + "/roughnessFactor", &material.perceptualRoughnessFactor},
      {from.emissiveFactor[0], 0, 1, place + "/emissiveFactor/0", &material.emissiveFactor.r},
      {from.emissiveFactor[1], 0, 1, place + "/emissiveFactor/1", &material.emissiveFactor.g},
      {from.emissiveFactor[2], 0, 1, place + "/emissiveFactor/2", &material.emissiveFactor.b},
      {from.normalTexture.scale, -unbounded, unbounded, place + "/normalTexture/scale", &material.normalScale},
      {from.occlusionTexture.strength, 0, 1, place + "/occlusionTexture/strength", &material.occlusionStrength},
      {from.alphaCutoff, 0, unbounded, place + "/alphaCutoff", &material.alphaCutoff},
  };
  for (const auto& f : factors) {
    const auto value = factor(doc, f.value, f.low, f.high, f.place);
    if (!value) return tl::unexpected(value.error());
    *f.target = *value;
  }
  return {};
}

void readAlphaMode(Document& doc, const tinygltf::Material& from, const std::string& place, scene::Material& material) {
  if (from.alphaMode == "MASK") {
    material.alphaMode = scene::AlphaMode::mask;
  } else if (from.alphaMode == "BLEND") {
    material.alphaMode = scene::AlphaMode::blend;
  } else if (from.alphaMode != "OPAQUE") {
    doc.warning(place + "/alphaMode", inQuotes(from.alphaMode) + " is not an alpha mode: shown opaque");
  }
}

// KHR_materials_unlit
Result<void> readUnlit(Document&, const Value&, const std::string&, scene::Material& material) {
  material.unlit = true;
  return {};
}

// KHR_materials_emissive_strength
Result<void> readEmissiveStrength(Document& doc, const Value& extension, const std::string& place,
                                  scene::Material& material) {
  const auto strength = number(doc, extension, "emissiveStrength", place);
  if (!strength) return tl::unexpected(strength.error());
  const auto value = factor(doc, strength->value_or(1.0f), 0, unbounded, place + "/emissiveStrength");
  if (!value) return tl::unexpected(value.error());
  material.emissiveStrength = *value;
  return {};
}

// `count` numbers in [0, 1] at object[key]; what is missing leaves the target as it is.
Result<void> readFactors(Document& doc, const Value& object, const char* key, int count, const std::string& place,
                         float* target) {
  const Value& value = object.Get(key);
  if (value.Type() == tinygltf::NULL_TYPE) return {};
  const std::string at = place + "/" + key;
  if (static_cast<int>(value.ArrayLen()) != count)
    return doc.error(at, "does not have " + std::to_string(count) + " numbers");
  for (int i = 0; i < count; ++i) {
    const std::string element = pointer(at, static_cast<size_t>(i));
    if (!value.Get(i).IsNumber()) return doc.error(element, "is not a number");
    const auto single = factor(doc, value.Get(i).GetNumberAsDouble(), 0, 1, element);
    if (!single) return tl::unexpected(single.error());
    target[i] = *single;
  }
  return {};
}

// A texture of an extension.
Result<void> readRef(Document& doc, const Value& object, const char* key, const std::string& place,
                     scene::TextureRef& target) {
  target = {};
  const Value& info = object.Get(key);
  if (info.Type() == tinygltf::NULL_TYPE) return {};
  const std::string at = place + "/" + key;
  const Value &index = info.Get("index"), &texCoord = info.Get("texCoord"), &inner = info.Get("extensions");
  if (!index.IsInt()) return doc.error(at + "/index", "is not a whole number");
  if (auto ok = checkIndex(doc, index.GetNumberAsInt(), doc.model.textures.size(), at + "/index", "texture"); !ok)
    return ok;
  Extensions extensions;
  for (const std::string& name : inner.IsObject() ? inner.Keys() : std::vector<std::string>())
    extensions.emplace(name, inner.Get(name));
  const auto ref =
      readRef(doc, index.GetNumberAsInt(), texCoord.IsInt() ? texCoord.GetNumberAsInt() : 0, extensions, at);
  if (!ref) return tl::unexpected(ref.error());
  target = *ref;
  return {};
}

// KHR_materials_pbrSpecularGlossiness: takes the place of the core's metallic-roughness where a file has both.
Result<void> readSpecularGlossiness(Document& doc, const Value& extension, const std::string& place,
                                    scene::Material& material) {
  if (material.unlit) return {};  // which says itself what the base colour is
  material.specularGlossiness = true;
  material.baseColorFactor = glm::vec4(1);
  if (auto ok = readFactors(doc, extension, "diffuseFactor", 4, place, &material.baseColorFactor.x); !ok) return ok;
  if (auto ok = readFactors(doc, extension, "specularFactor", 3, place, &material.specularFactor.x); !ok) return ok;
  const auto glossiness = number(doc, extension, "glossinessFactor", place);
  if (!glossiness) return tl::unexpected(glossiness.error());
  const auto inRange = factor(doc, glossiness->value_or(1.0f), 0, 1, place + "/glossinessFactor");
  if (!inRange) return tl::unexpected(inRange.error());
  material.glossinessFactor = *inRange;
  if (auto ok = readRef(doc, extension, "diffuseTexture", place, material.baseColor); !ok) return ok;
  return readRef(doc, extension, "specularGlossinessTexture", place, material.metallicRoughness);
}

// FACET_materials_models: what our built-in scenes say beyond glTF.
Result<void> readModels(Document& doc, const Value& extension, const std::string& place, scene::Material& material) {
  const auto text = [&](const char* key) {
    const Value& value = extension.Get(key);
    return value.IsString() ? value.Get<std::string>() : std::string();
  };
  using scene::Microfacets;
  constexpr std::pair<std::string_view, Microfacets> names[] = {{"", Microfacets::any},
                                                                {"ggx", Microfacets::ggx},
                                                                {"beckmann", Microfacets::beckmann},
                                                                {"blinn", Microfacets::blinn}};
  const std::string wanted = text("microfacets");
  const auto found =
      std::ranges::find(names, std::string_view(wanted), &std::pair<std::string_view, Microfacets>::first);
  if (found == std::end(names)) return doc.error(place + "/microfacets", "is not ggx, beckmann or blinn");
  material.microfacets = found->second;
  material.conductor = text("conductor");
  return {};
}

using ReadExtension = Result<void> (*)(Document&, const Value&, const std::string& place, scene::Material&);
constexpr struct {
  const char* name;
  ReadExtension read;
} materialExtensions[] = {
    {"KHR_materials_unlit", readUnlit},
    {"KHR_materials_pbrSpecularGlossiness", readSpecularGlossiness},
    {"KHR_materials_emissive_strength", readEmissiveStrength},
    {"FACET_materials_models", readModels},
};

Result<void> readMaterial(Document& doc, size_t index) {
  const auto& from = doc.gltf.materials[index];
  const std::string place = pointer("/materials", index);
  scene::Material material;
  material.name = from.name;
  material.doubleSided = from.doubleSided;
  readAlphaMode(doc, from, place, material);
  if (auto ok = readCoreFactors(doc, from, place, material); !ok) return ok;
  if (auto ok = readCoreTextures(doc, from, place, material); !ok) return ok;
  for (const auto& extension : materialExtensions) {
    const Value* value = find(from.extensions, extension.name);
    if (value == nullptr) continue;
    if (auto ok = extension.read(doc, *value, place + "/extensions/" + extension.name, material); !ok) return ok;
  }
  doc.model.materials.push_back(std::move(material));
  return {};
}

}  // namespace

Result<void> readTextures(Document& doc) {
  std::vector<scene::Sampler> samplers;
  for (size_t i = 0; i < doc.gltf.samplers.size(); ++i) {
    samplers.push_back(readSampler(doc, doc.gltf.samplers[i], pointer("/samplers", i)));
  }
  for (size_t i = 0; i < doc.gltf.textures.size(); ++i) {
    const auto& from = doc.gltf.textures[i];
    const std::string place = pointer("/textures", i);
    scene::Texture texture;
    texture.name = from.name;
    const auto image = textureImage(doc, from, place);
    if (!image) return tl::unexpected(image.error());
    texture.image = *image;
    if (from.sampler != -1) {
      if (auto ok = checkIndex(doc, from.sampler, samplers.size(), place + "/sampler", "sampler"); !ok) return ok;
      texture.sampler = samplers[static_cast<size_t>(from.sampler)];
    }
    doc.model.textures.push_back(std::move(texture));
  }
  return {};
}

Result<void> readMaterials(Document& doc) {
  for (size_t i = 0; i < doc.gltf.materials.size(); ++i) {
    if (auto ok = readMaterial(doc, i); !ok) return ok;
  }
  return {};
}

}  // namespace facet::io
