#include "io/referenced_files.hpp"

#include <nlohmann/json.hpp>

#include "io/glb.hpp"
#include "io/gltf.hpp"
#include "io/json_scan.hpp"
#include "io/safe_files.hpp"
#include "io/uri.hpp"

namespace facet::io {

namespace fs = std::filesystem;

std::vector<fs::path> referencedFiles(const fs::path& gltf, const std::string& allowOutside) {
  std::vector<fs::path> files;
  std::error_code problem;
  const fs::path folder = fs::canonical(gltf.has_parent_path() ? gltf.parent_path() : fs::path("."), problem);
  const auto bytes = readRegularFile(gltf, Limits{}.fileBytes);
  if (problem || !bytes) return files;
  std::string_view text(reinterpret_cast<const char*>(bytes->data.get()), bytes->size);
  if (isGlb(bytes->span())) {
    const auto parts = splitGlb(bytes->span());
    if (!parts) return files;
    text = parts->json;
  }
  const auto outline = scanJson(text, Limits{}.jsonDepth);
  if (!outline) return files;
  for (const char* section : {"buffers", "images", "extensions"}) {
    const JsonMember* member = outline->find(section);
    if (!member) continue;
    auto list = nlohmann::json::parse(text.begin() + static_cast<ptrdiff_t>(member->begin),
                                      text.begin() + static_cast<ptrdiff_t>(member->end), nullptr, false);
    if (section == std::string_view("extensions")) {
      const nlohmann::json::json_pointer profiles("/EXT_lights_ies/lights");
      list = list.contains(profiles) ? nlohmann::json(list[profiles]) : nlohmann::json();
    }
    for (const auto& entry : list) {
      const auto uri = entry.is_object() ? entry.find("uri") : entry.end();
      if (!entry.is_object() || uri == entry.end() || !uri->is_string()) continue;
      const auto& name = uri->get_ref<const std::string&>();
      if (isDataUri(name)) continue;
      if (auto path = resolveBelow(folder, name, allowOutside)) files.push_back(std::move(*path));
    }
  }
  return files;
}

}  // namespace facet::io
