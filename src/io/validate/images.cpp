// Images and textures: formats by their first bytes, sizes, and what says of its colours something that glTF does not.

#include <algorithm>
#include <bit>

#include "io/image.hpp"
#include "io/image_formats.hpp"
#include "io/uri.hpp"
#include "io/validate/checks.hpp"
#include "io/validate/image_colour.hpp"
#include "io/validate/material_textures.hpp"
#include "io/validate/resources.hpp"

namespace facet::io::validate {

namespace {

// The extension that a texture names images of that type by; null: none is needed, or there is none.
const char* extensionFor(const std::string& mediaType) {
  if (mediaType == "image/webp") return "EXT_texture_webp";
  if (mediaType == "image/ktx2") return "KHR_texture_basisu";
  if (mediaType == "image/avif") return "EXT_texture_avif";
  return nullptr;
}

bool isCore(const std::string& mediaType) { return mediaType == "image/jpeg" || mediaType == "image/png"; }

struct ImageUse {
  bool colour = false, data = false;
  std::string firstColour, firstData;  // places
};

void checkColours(Asset& asset, std::span<const uint8_t> bytes, const ImageUse& use, const std::string& place) {
  const ImageColour colour = colourOf(bytes);
  if (colour.isUnusual()) asset.add(Code::IMAGE_FEATURES_UNSUPPORTED, place, colour.text() + ", which glTF ignores");
  if (use.data && !use.colour && colour.hasCurve())
    asset.add(Code::FACET_DATA_TEXTURE_WITH_COLOUR_CURVE, place,
              colour.text() + ", but " + use.firstData + " takes its texels as numbers");
}

void checkMediaType(Asset& asset, const Json& image, const std::string& found, const std::string& place) {
  const std::string declared = textAt(image, "mimeType");
  const bool allowed = extensionFor(found) == nullptr || asset.extensionsUsed.contains(extensionFor(found));
  if (!allowed)
    asset.add(Code::IMAGE_NON_ENABLED_MIME_TYPE, place, "is " + found + ", which needs " + extensionFor(found));
  if (!declared.empty() && declared != found)
    asset.add(Code::IMAGE_MIME_TYPE_INVALID, image.contains("bufferView") ? place + "/bufferView" : place + "/uri",
              "is " + found + ", not " + inQuotes(declared) + " as mimeType says");
}

// The media type that its data are; else what mimeType says.
std::string checkImage(Asset& asset, const Json& image, const ImageUse& use, const std::string& place) {
  const Json &uri = member(image, "uri"), &viewMember = member(image, "bufferView");
  const std::string declared = textAt(image, "mimeType");
  if (uri.is_null() == viewMember.is_null())
    asset.add(Code::ONE_OF_MISMATCH, place,
              uri.is_null() ? "has neither uri nor bufferView" : "has both uri and bufferView");
  const bool known = declared.empty() || isCore(declared) ||
                     (extensionFor(declared) != nullptr && asset.extensionsUsed.contains(extensionFor(declared)));
  if (!known)
    asset.add(Code::VALUE_NOT_IN_LIST, place + "/mimeType",
              "is " + inQuotes(declared) + ", neither image/jpeg nor image/png nor of an extension that is used");
  const int view = indexAt(asset, image, "bufferView", "bufferViews");
  useView(asset, view, Use::image, place + "/bufferView");
  if (view >= 0 && asset.views[static_cast<size_t>(view)].stride != 0)
    asset.add(Code::IMAGE_BUFFER_VIEW_WITH_BYTESTRIDE, place + "/bufferView", "the view has a stride");
  std::span<const uint8_t> bytes;
  if (uri.is_string())
    bytes = readUri(asset, uri.get<std::string>(), place + "/uri").value_or(bytes);
  else
    bytes = bytesOf(asset, view);
  if (bytes.empty()) return declared;
  const std::string found = mediaType(bytes);
  if (uri.is_string() && isDataUri(uri.get<std::string>()) && mediaTypeOf(uri.get<std::string>()) != found) {
    asset.add(Code::INVALID_URI, place + "/uri",
              "the data: URI says " + inQuotes(mediaTypeOf(uri.get<std::string>())) + ", but holds " +
                  (found.empty() ? "something else" : found));
    return declared;
  }
  if (found.empty()) {
    asset.add(Code::IMAGE_UNRECOGNIZED_FORMAT, place, "is none of the formats that glTF knows");
    return declared;
  }
  checkMediaType(asset, image, found, place);
  const ImageInfo info = describeImage(bytes, asset.limits);
  if (!info.problem.empty()) {
    asset.add(colourOf(bytes).cutOff ? Code::IMAGE_UNEXPECTED_EOS : Code::IMAGE_DATA_INVALID, place, info.problem);
    return found;
  }
  asset.imageSizes[place] = {info.width, info.height};
  const auto odd = [](int side) { return !std::has_single_bit(static_cast<unsigned>(side)); };
  if (odd(info.width) || odd(info.height))
    asset.add(Code::IMAGE_NPOT_DIMENSIONS, place,
              "is " + std::to_string(info.width) + " x " + std::to_string(info.height) + ", no powers of two");
  checkColours(asset, bytes, use, place);
  return found;
}

// By image: what the materials take of it.
std::vector<ImageUse> usesOf(const Asset& asset) {
  std::vector<ImageUse> uses(collection(asset, "images").size());
  for (size_t m = 0; m < collection(asset, "materials").size(); ++m)
    for (const TextureUse& use : texturesOf(asset, static_cast<int>(m)).uses) {
      const Json& texture = element(asset, "textures", use.texture);
      const auto add = [&](const Json& object) {
        const int image = indexAt(asset, object, "source", "images");
        if (image < 0) return;
        ImageUse& of = uses[static_cast<size_t>(image)];
        bool& kind = use.colour ? of.colour : of.data;
        if (!kind) (use.colour ? of.firstColour : of.firstData) = use.place;
        kind = true;
      };
      add(texture);
      for (const char* name : {"KHR_texture_basisu", "EXT_texture_webp", "EXT_texture_avif"})
        add(extension(texture, name));
    }
  return uses;
}

}  // namespace

void checkImages(Asset& asset) {
  for (const Json& light : collection(asset, "extensions/EXT_lights_image_based/lights"))
    for (const Json& level : member(light, "specularImages"))
      for (const Json& face : level)
        if (const auto image = whole(face); image && *image <= INT32_MAX)
          markUsed(asset, "images", static_cast<int>(*image));
  const Json &images = collection(asset, "images"), &textures = collection(asset, "textures");
  const std::vector<ImageUse> uses = usesOf(asset);
  std::vector<std::string> types;
  for (size_t i = 0; i < images.size(); ++i) {
    const std::string place = at("/images", i);
    types.push_back(checkImage(asset, images[i], uses[i], place));
    if (uses[i].colour && uses[i].data)
      asset.add(Code::FACET_IMAGE_AS_COLOUR_AND_DATA, place,
                uses[i].firstColour + " takes it as colours, " + uses[i].firstData + " as numbers");
  }
  const auto check = [&](const Json& object, const std::string& place, std::string_view wanted) {
    const int image = indexAt(asset, object, "source", "images");
    if (image < 0) return;
    const std::string& type = types[static_cast<size_t>(image)];
    const bool right = wanted.empty() ? isCore(type) : type == wanted;
    if (!right && !type.empty())
      asset.add(Code::TEXTURE_INVALID_IMAGE_MIME_TYPE, place + "/source",
                "image " + std::to_string(image) + " is " + type + ", not " +
                    (wanted.empty() ? "image/jpeg or image/png" : std::string(wanted)));
  };
  for (size_t i = 0; i < textures.size(); ++i) {
    const std::string place = at("/textures", i);
    check(textures[i], place, "");
    for (const char* type : {"image/webp", "image/ktx2", "image/avif"})
      check(extension(textures[i], extensionFor(type)), place + "/extensions/" + extensionFor(type), type);
  }
}

}  // namespace facet::io::validate
