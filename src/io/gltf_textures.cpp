// Samplers, textures and the references to them.

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/gltf_document.hpp"
#include "io/gltf_materials.hpp"
#include "io/json_section.hpp"

namespace facet::io {

namespace {

using Json = nlohmann::json;

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

// Of an object with a `source`: the image's index, or -1 where it names none.
Result<int> sourceOf(Document& doc, const Json& from, const std::string& place) {
  std::string at = place;
  const auto source = valueAt(doc, from, "source", at);
  if (!source) return tl::unexpected(source.error());
  if (*source == nullptr) return -1;
  return readIndex(doc, **source, doc.model.images.size(), at, "image");
}

// Which image: that of an extension, else the core's; what comes after it is shown where it can't be.
int textureImage(Document& doc, const Json& from, const std::string& place) {
  std::vector<int> images;
  std::vector<Error> problems;
  const auto add = [&](const Json& object, const std::string& at) {
    const auto image = sourceOf(doc, object, at);
    if (!image)
      problems.push_back(image.error());
    else if (*image >= 0)
      images.push_back(*image);
  };
  for (const char* name : {"KHR_texture_basisu", "EXT_texture_avif", "EXT_texture_webp"})
    if (const Json* extension = extensionOf(from, name)) add(*extension, place + "/extensions/" + name);
  add(from, place);
  for (const Error& problem : problems)
    doc.lost(problem, images.empty() ? "a placeholder is shown" : "the texture's other image is shown");
  if (images.empty() && problems.empty()) doc.warning(place, "has no image: a placeholder is shown");
  if (images.empty()) return -1;
  scene::Image& shown = doc.model.images[static_cast<size_t>(images[0])];
  if (images.size() > 1 && images[1] != images[0] && shown.fallback < 0) shown.fallback = images[1];
  return images[0];
}

// ---- References to textures -----------------------------------------------------------------------------------------

// -1 and beyond the largest: as they are, for the message.
Result<void> readTexCoord(Document& doc, const Json& object, std::string place, scene::TextureRef& ref) {
  const auto value = valueAt(doc, object, "texCoord", place);
  if (!value) return tl::unexpected(value.error());
  if (*value == nullptr) return {};
  const double set = (*value)->is_number() ? (*value)->get<double>() : 0.5;
  if (set != std::floor(set)) return doc.error(place, "is not a whole number");
  ref.texCoord = static_cast<int>(std::clamp(set, -1e9, 1e9));
  return {};
}

// KHR_texture_transform
Result<void> readTransform(Document& doc, const Json& extension, const std::string& place, scene::TextureRef& ref) {
  const auto asItIs = [](double value) { return static_cast<float>(value); };
  scene::TextureTransform& to = ref.transform;
  if (auto ok = readNumbers(doc, extension, "offset", place, {&to.offset.x, 2}, asItIs); !ok) return ok;
  if (auto ok = readNumbers(doc, extension, "scale", place, {&to.scale.x, 2}, asItIs); !ok) return ok;
  if (auto ok = readNumbers(doc, extension, "rotation", place, {&to.rotation, 1}, asItIs); !ok) return ok;
  return readTexCoord(doc, extension, place, ref);
}

}  // namespace

Result<void> readTextures(Document& doc) {
  std::vector<scene::Sampler> samplers;
  for (size_t i = 0; i < doc.gltf.samplers.size(); ++i) {
    samplers.push_back(readSampler(doc, doc.gltf.samplers[i], pointer("/samplers", i)));
  }
  const auto list = section(doc, "textures");
  if (!list) return tl::unexpected(list.error());
  for (size_t i = 0; i < doc.gltf.textures.size(); ++i) {
    const auto& from = doc.gltf.textures[i];
    const std::string place = pointer("/textures", i);
    scene::Texture texture;
    texture.name = from.name;
    texture.image = textureImage(doc, (*list)[i], place);
    if (from.sampler != -1) {
      const auto ok = checkIndex(doc, from.sampler, samplers.size(), place + "/sampler", "sampler");
      ok ? void(texture.sampler = samplers[static_cast<size_t>(from.sampler)])
         : doc.lost(ok.error(), "repeat and linear are used");
    }
    doc.model.textures.push_back(std::move(texture));
  }
  return {};
}

Result<const Json*> valueAt(const Document& doc, const Json& object, std::string_view path, std::string& place) {
  const Json* value = &object;
  while (true) {
    if (value->is_null()) return nullptr;
    if (!value->is_object()) return doc.error(place, "is not an object");
    const size_t end = std::min(path.find('/'), path.size());
    const auto found = value->find(std::string(path.substr(0, end)));
    if (found == value->end()) return nullptr;
    value = &*found;
    place += "/" + std::string(path.substr(0, end));
    if (end == path.size()) return value->is_null() ? nullptr : value;
    path.remove_prefix(end + 1);
  }
}

Result<void> readNumbers(Document& doc, const Json& object, std::string_view path, std::string place,
                         std::span<float> to, const std::function<float(double)>& inRange) {
  const auto value = valueAt(doc, object, path, place);
  if (!value) return tl::unexpected(value.error());
  if (*value == nullptr) return {};
  const Json& from = **value;
  if (to.size() > 1 && (!from.is_array() || from.size() != to.size()))
    return doc.error(place, "does not have " + std::to_string(to.size()) + " numbers");
  for (size_t i = 0; i < to.size(); ++i) {
    const Json& number = to.size() > 1 ? from[i] : from;
    const std::string at = to.size() > 1 ? pointer(place, i) : place;
    if (!number.is_number()) return doc.error(at, "is not a number");
    const auto given = number.get<double>();
    if (!std::isfinite(static_cast<float>(given))) return doc.error(at, "is not finite in single precision");
    to[i] = inRange(given);
    if (to[i] != static_cast<float>(given)) doc.warning(at, "is out of range: clamped");
  }
  return {};
}

Result<void> readTextureRef(Document& doc, const Json& object, std::string_view path, std::string place,
                            scene::TextureRef& to) {
  to = {};
  const auto info = valueAt(doc, object, path, place);
  if (!info) return tl::unexpected(info.error());
  if (*info == nullptr) return {};
  std::string at = place;
  const auto index = valueAt(doc, **info, "index", at);
  if (!index) return tl::unexpected(index.error());
  const auto texture =
      readIndex(doc, *index ? **index : Json(), doc.model.textures.size(), place + "/index", "texture");
  if (!texture) {
    doc.lost(texture.error(), "shown without this texture");
    return {};
  }
  scene::TextureRef ref;
  ref.texture = *texture;
  if (auto ok = readTexCoord(doc, **info, place, ref); !ok) return ok;
  if (const Json* transform = extensionOf(**info, "KHR_texture_transform")) {
    const std::string inner = place + "/extensions/KHR_texture_transform";
    if (auto ok = readTransform(doc, *transform, inner, ref); !ok) return ok;
  }
  if (ref.texCoord < 0 || ref.texCoord >= scene::maxTexCoordSets) {
    doc.warning(place + "/texCoord", "TEXCOORD_" + std::to_string(ref.texCoord) + " is none of the supported 0 to " +
                                         std::to_string(scene::maxTexCoordSets - 1) + ": shown without this texture");
    return {};
  }
  to = ref;
  return {};
}

}  // namespace facet::io
