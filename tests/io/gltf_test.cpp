#include "io/gltf.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>

#include "support/gltf_builder.hpp"
#include "support/skip.hpp"

namespace {

using namespace facet;
using Json = nlohmann::json;

}  // namespace

TEST_CASE("Every shared model loads, or is refused for an extension it requires", "[io][gltf][shared]") {
  const std::string manifestPath = test::sharedFile("assets/manifest.json");
  if (manifestPath.empty()) return;
  std::ifstream stream(manifestPath);
  const Json manifest = Json::parse(stream);
  const std::vector<std::string> unsupported = {"KHR_texture_basisu"};
  for (const Json& entry : manifest["models"]) {
    const auto path = std::filesystem::path(manifestPath).parent_path() / entry["entry"].get<std::string>();
    INFO(path.string());
    std::string expected;  // the first of them that the file requires
    for (const Json& name : entry["extensions_required"]) {
      const auto& text = name.get_ref<const std::string&>();
      if (expected.empty() && std::find(unsupported.begin(), unsupported.end(), text) != unsupported.end()) {
        expected = "the model requires the extension \"" + text + "\", which is not supported";
      }
    }
    const auto model = io::loadGltf(path);
    CHECK((model ? std::string() : model.error().problem) == expected);
    if (!model) continue;
    size_t triangles = 0, primitives = 0;
    for (const auto& mesh : model->model.meshes) {
      for (const auto& p : mesh.primitives) {
        const size_t count = p.indices.empty() ? p.positions.size() : p.indices.size();
        if (p.topology == scene::Topology::triangles) triangles += count / 3;
        if (p.topology > scene::Topology::triangles) triangles += count - 2;
        ++primitives;
      }
    }
    CHECK(triangles == entry["triangles_unique"].get<size_t>());
    CHECK(model->model.meshes.size() == entry["meshes"].get<size_t>());
    CHECK(model->model.nodes.size() == entry["nodes"].get<size_t>());
    CHECK(model->model.materials.size() == entry["materials"].get<size_t>());
    CHECK(model->model.images.size() == entry["images"].get<size_t>());
    for (const Note& note : model->notes) CHECK(note.severity == Note::Severity::info);
  }
}
