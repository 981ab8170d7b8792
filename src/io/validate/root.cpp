// Versions, extensions, and at the end what nothing uses.

#include <algorithm>
#include <charconv>

#include "io/uri.hpp"
#include "io/validate/checks.hpp"
#include "io/validate/schema.hpp"

namespace facet::io::validate {

namespace {

struct Version {
  uint32_t major = 0, minor = 0;
  auto operator<=>(const Version&) const = default;
};

// "2.0"; nothing where it is written otherwise.
std::optional<Version> versionOf(const std::string& text) {
  Version version;
  const char* const end = text.data() + text.size();
  const auto major = std::from_chars(text.data(), end, version.major);
  if (major.ec != std::errc() || major.ptr == end || *major.ptr != '.') return std::nullopt;
  const auto minor = std::from_chars(major.ptr + 1, end, version.minor);
  if (minor.ec != std::errc() || minor.ptr != end) return std::nullopt;
  return version;
}

std::optional<Version> checkVersion(Asset& asset, const char* key) {
  const Json& value = member(member(asset.json, "asset"), key);
  if (!value.is_string()) return std::nullopt;
  const auto version = versionOf(value.get<std::string>());
  if (!version)
    asset.add(Code::PATTERN_MISMATCH, at("/asset", key),
              "is " + inQuotes(value.get<std::string>()) + ", not two whole numbers with a full stop between them");
  return version;
}

void checkVersions(Asset& asset) {
  const auto version = checkVersion(asset, "version"), least = checkVersion(asset, "minVersion");
  if (version && version->major != 2)
    asset.add(Code::UNKNOWN_ASSET_MAJOR_VERSION, "/asset/version",
              "is glTF " + std::to_string(version->major) + ", not 2");
  else if (version && version->minor > 0)
    asset.add(Code::UNKNOWN_ASSET_MINOR_VERSION, "/asset/version",
              "is glTF 2." + std::to_string(version->minor) + "; 2.0 is the latest");
  if (version && least && *least > *version)
    asset.add(Code::ASSET_MIN_VERSION_GREATER_THAN_VERSION, "/asset/minVersion", "is later than the version");
}

// PREFIX_name
bool isExtensionName(std::string_view name) {
  const auto isUpper = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); };
  const auto isWord = [&](char c) { return isUpper(c) || (c >= 'a' && c <= 'z') || c == '_'; };
  const size_t line = name.find('_');
  return line != name.npos && line > 0 && line + 1 < name.size() &&
         std::ranges::all_of(name.substr(0, line), isUpper) && std::ranges::all_of(name, isWord);
}

// Whether an accessor's type needs KHR_mesh_quantization is asked where attributes are.
bool mayStandAlone(const std::string& name) {
  return name == "KHR_mesh_quantization" || name == "KHR_accessor_float64";
}

void checkExtensionLists(Asset& asset) {
  const Json &used = collection(asset, "extensionsUsed"), &required = collection(asset, "extensionsRequired");
  for (size_t i = 0; i < used.size(); ++i) {
    if (!used[i].is_string()) continue;
    const auto& name = used[i].get_ref<const std::string&>();
    const std::string place = at("/extensionsUsed", i);
    if (!isExtensionName(name))
      asset.add(Code::INVALID_EXTENSION_NAME_FORMAT, place, inQuotes(name) + " is not PREFIX_name");
    if (!isKnownExtension(name))
      asset.add(Code::UNSUPPORTED_EXTENSION, place, inQuotes(name) + " is not known here");
    else if (!asset.extensionsSeen.contains(name) && !mayStandAlone(name))
      asset.add(Code::FACET_EXTENSION_UNUSED, place, "nothing in the file uses " + inQuotes(name));
    if (mayStandAlone(name) && std::ranges::find(required, used[i]) == required.end())
      asset.add(Code::NON_REQUIRED_EXTENSION, place,
                inQuotes(name) + " changes how data are read, but is not required");
  }
  for (size_t i = 0; i < required.size(); ++i)
    if (required[i].is_string() && !asset.extensionsUsed.contains(required[i].get<std::string>()))
      asset.add(Code::UNUSED_EXTENSION_REQUIRED, at("/extensionsRequired", i),
                inQuotes(required[i].get<std::string>()) + " is required, but extensionsUsed does not list it");
}

}  // namespace

void checkRoot(Asset& asset) {
  checkVersions(asset);
  checkExtensionLists(asset);
}

void checkUnusedParts(Asset& asset) {
  for (const char* path :
       {"accessors", "buffers", "bufferViews", "cameras", "images", "materials", "meshes", "nodes", "samplers", "skins",
        "textures", "extensions/KHR_lights_punctual/lights", "extensions/KHR_materials_variants/variants"}) {
    const size_t count = collection(asset, path).size();
    std::vector<bool>& used = asset.used[path];
    used.resize(count);
    for (size_t i = 0; i < count; ++i)
      if (!used[i] && collection(asset, path)[i].is_object())
        asset.add(Code::UNUSED_OBJECT, at(std::string("/") + path, i), "nothing uses it");
  }
}

}  // namespace facet::io::validate
