#include "view/file_kind.hpp"

#include <filesystem>

#include "base/file_ending.hpp"

namespace facet::view {

Result<FileKind> fileKind(std::string_view path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return FileKind::folder;
  const std::string extension = fileEnding(path);
  if (extension == ".gltf" || extension == ".glb") return FileKind::model;
  if (extension == ".hdr" || extension == ".exr") return FileKind::environment;
  if (extension == ".binary" || extension == ".bin") return FileKind::brdf;
  if (extension == ".facet")
    return fail(std::string(path), "", "is a session, with which a window starts", "give it to facet at its start");
  return fail(std::string(path), "", "neither a model, an environment nor a measured BRDF",
              "drop a .gltf or .glb, a .hdr or .exr, a .binary or .bin, or a folder");
}

}  // namespace facet::view
