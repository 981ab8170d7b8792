#include <algorithm>
#include <cmath>

#include "io/validate/checks.hpp"
#include "io/validate/material_textures.hpp"
#include "scene/usage.hpp"

namespace facet::io::validate {

namespace {

const Json& atPath(const Json& object, std::string_view path) {
  const size_t slash = path.find('/');
  const Json& value = member(object, path.substr(0, slash));
  return slash == path.npos ? value : atPath(value, path.substr(slash + 1));
}

void addUse(const Asset& asset, const Json& material, std::string_view path, bool colour, const std::string& place,
            MaterialTextures& out) {
  const Json& info = atPath(material, path);
  if (!info.is_object()) return;
  const auto own = wholeAt(info, "texCoord"), moved = wholeAt(extension(info, "KHR_texture_transform"), "texCoord");
  const int64_t set = moved.value_or(own.value_or(0));
  out.uses.push_back({place + "/" + std::string(path), indexAt(asset, info, "index", "textures"),
                      static_cast<int>(std::clamp<int64_t>(set, -1, 1 << 20)), colour});
  const bool normal = path.ends_with("ormalTexture") || path.ends_with("anisotropyTexture");
  out.hasNormalMap = out.hasNormalMap || normal;
  out.hasBaseNormalMap = out.hasBaseNormalMap || path == "normalTexture";
}

bool isZero(const Json& numbers) {
  return numbers.is_null() ||
         (numbers.is_array() && std::ranges::all_of(numbers, [](const Json& v) { return v == 0; }));
}

// The texCoord of a texture's object; nothing where there is none.
std::optional<int64_t> texCoordOf(const Json& info) {
  return info.is_object() ? std::optional(wholeAt(info, "texCoord").value_or(0)) : std::nullopt;
}

void checkTexCoords(Asset& asset, const Json& material, const Json& other, Code code, const std::string& place) {
  const auto base = texCoordOf(member(material, "normalTexture")), own = texCoordOf(other);
  if (base && own && *base != *own)
    asset.add(code, place,
              "uses TEXCOORD_" + std::to_string(*own) + ", the normal texture TEXCOORD_" + std::to_string(*base));
}

void checkIridescence(Asset& asset, const Json& iridescence, const std::string& place) {
  const bool hasTexture = member(iridescence, "iridescenceThicknessTexture").is_object();
  const double low = numberAt(iridescence, "iridescenceThicknessMinimum").value_or(100),
               high = numberAt(iridescence, "iridescenceThicknessMaximum").value_or(400);
  if (member(iridescence, "iridescenceThicknessMinimum").is_number() && !hasTexture)
    asset.add(Code::KHR_MATERIALS_IRIDESCENCE_THICKNESS_RANGE_WITHOUT_TEXTURE, place + "/iridescenceThicknessMinimum",
              "has no effect without a texture");
  if (hasTexture && low == high)
    asset.add(Code::KHR_MATERIALS_IRIDESCENCE_THICKNESS_TEXTURE_UNUSED, place + "/iridescenceThicknessTexture",
              "minimum and maximum are equal");
}

void checkExtensions(Asset& asset, const Json& material, const std::string& place) {
  const std::string head = place + "/extensions/KHR_materials_";
  const auto has = [&](const char* name) {
    return extension(material, std::string("KHR_materials_") + name).is_object();
  };
  if (has("dispersion") && !has("volume"))
    asset.add(Code::KHR_MATERIALS_DISPERSION_NO_VOLUME, head + "dispersion", "there is no KHR_materials_volume");
  if (has("volume")) {
    if (!has("transmission") && !has("diffuse_transmission"))
      asset.add(Code::KHR_MATERIALS_VOLUME_NO_TRANSMISSION, head + "volume", "nothing lets light into the volume");
    const double thickness = numberAt(extension(material, "KHR_materials_volume"), "thicknessFactor").value_or(0);
    if (thickness > 0 && member(material, "doubleSided") == true)
      asset.add(Code::KHR_MATERIALS_VOLUME_DOUBLE_SIDED, head + "volume", "the material is double-sided");
  }
  if (const Json& strength = member(extension(material, "KHR_materials_emissive_strength"), "emissiveStrength");
      strength.is_number() && isZero(member(material, "emissiveFactor")))
    asset.add(Code::KHR_MATERIALS_EMISSIVE_STRENGTH_ZERO_FACTOR, head + "emissive_strength", "emissiveFactor is zero");
  if (has("iridescence"))
    checkIridescence(asset, extension(material, "KHR_materials_iridescence"), head + "iridescence");
  checkTexCoords(asset, material, member(extension(material, "KHR_materials_anisotropy"), "anisotropyTexture"),
                 Code::KHR_MATERIALS_ANISOTROPY_ANISOTROPY_TEXTURE_TEXCOORD, head + "anisotropy/anisotropyTexture");
  checkTexCoords(asset, material, member(extension(material, "KHR_materials_clearcoat"), "clearcoatNormalTexture"),
                 Code::KHR_MATERIALS_CLEARCOAT_CLEARCOAT_NORMAL_TEXTURE_TEXCOORD,
                 head + "clearcoat/clearcoatNormalTexture");
}

}  // namespace

MaterialTextures texturesOf(const Asset& asset, int material) {
  MaterialTextures out;
  const Json& json = element(asset, "materials", material);
  const std::string place = at("/materials", static_cast<size_t>(material));
  for (const scene::TextureSlot slot : scene::textureSlots)
    addUse(asset, json, scene::path(slot), texelUse({}, slot).srgb, place, out);
  for (const char* path : {"extensions/KHR_materials_pbrSpecularGlossiness/diffuseTexture",
                           "extensions/KHR_materials_pbrSpecularGlossiness/specularGlossinessTexture"})
    addUse(asset, json, path, true, place, out);
  out.needsTangents = numberAt(extension(json, "KHR_materials_anisotropy"), "anisotropyStrength").value_or(0) != 0;
  return out;
}

void checkMaterials(Asset& asset) {
  const Json& list = collection(asset, "materials");
  for (size_t i = 0; i < list.size(); ++i) {
    const std::string place = at("/materials", i);
    const Json& mode = member(list[i], "alphaMode");
    if (list[i].is_object() && list[i].contains("alphaCutoff") && mode != "MASK")
      asset.add(Code::MATERIAL_ALPHA_CUTOFF_INVALID_MODE, place + "/alphaCutoff", "alphaMode is not MASK");
    checkExtensions(asset, list[i], place);
  }
}

}  // namespace facet::io::validate
