#include "io/validate/validate.hpp"

#include <algorithm>

#include "io/glb.hpp"
#include "io/sources.hpp"
#include "io/validate/checks.hpp"
#include "io/validate/schema.hpp"

namespace facet::io {

namespace {

using namespace validate;

// Compares pointers part by part, numbers as such: /nodes/9 before /nodes/10.
bool comesBefore(std::string_view a, std::string_view b) {
  while (!a.empty() && !b.empty()) {
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    if (isDigit(a[0]) && isDigit(b[0])) {
      const auto digits = [&](std::string_view text) {
        return static_cast<size_t>(std::ranges::find_if_not(text, isDigit) - text.begin());
      };
      const size_t na = digits(a), nb = digits(b);
      if (na != nb) return na < nb;
      if (const int order = a.substr(0, na).compare(b.substr(0, nb)); order != 0) return order < 0;
      a.remove_prefix(na);
      b.remove_prefix(nb);
    } else {
      if (a[0] != b[0]) return a[0] < b[0];
      a.remove_prefix(1);
      b.remove_prefix(1);
    }
  }
  return a.size() < b.size();
}

bool isWorse(const Finding& a, const Finding& b) {
  if (severity(a.code) != severity(b.code)) return severity(a.code) < severity(b.code);
  if (a.place != b.place) return comesBefore(a.place, b.place);
  return std::string_view(validate::name(a.code)) < validate::name(b.code);
}

void run(Asset& asset, std::span<const uint8_t> bytes) {
  asset.bytes = bytes;
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (isGlb(bytes)) text = checkContainer(asset, bytes);
  if (asset.isGlb && text.empty()) return;
  while (asset.isGlb && text.ends_with('\0')) text.remove_suffix(1);
  if (!readJson(asset, text)) return;
  for (const Json& used : collection(asset, "extensionsUsed"))
    if (used.is_string()) asset.extensionsUsed.insert(used.get<std::string>());
  checkSchema(asset);
  for (const auto check : {checkRoot, readBuffers, readViews, decodeCompressed, readAccessors, checkImages,
                           checkMaterials, checkCameras, checkMeshes, checkNodes, checkSkins, checkAnimations,
                           checkAccessorData, checkInfluences, checkSurfaces, checkUnusedParts, findShown})
    check(asset);
}

}  // namespace

Report validateBytes(std::span<const uint8_t> bytes, const std::string& name, const std::filesystem::path& baseFolder,
                     const Limits& limits) {
  Asset asset;
  asset.name = name;
  asset.limits = limits;
  std::error_code code;
  if (!baseFolder.empty()) asset.folder = std::filesystem::canonical(baseFolder, code);
  try {
    run(asset, bytes);
  } catch (const std::bad_alloc&) {
    asset.add(Code::FACET_NOT_CHECKED, "", "there is not enough memory to check all of it");
  }
  std::ranges::stable_sort(asset.report.findings, isWorse);
  return std::move(asset.report);
}

Result<Report> validateModel(const std::string& source, const Limits& limits) {
  return readModelBytes(source, limits).map([&](const ModelBytes& read) {
    return validateBytes(read.bytes(), read.name, read.folder, limits);
  });
}

}  // namespace facet::io
