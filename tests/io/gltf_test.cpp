#include "io/gltf.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "support/gltf_builder.hpp"
#include "support/skip.hpp"

namespace {

using namespace facet;
using Json = nlohmann::json;

}  // namespace

TEST_CASE("Every shared model loads", "[io][gltf][shared]") {
  const std::string manifestPath = test::sharedFile("assets/manifest.json");
  if (manifestPath.empty()) return;
  std::ifstream stream(manifestPath);
  const Json manifest = Json::parse(stream);
  for (const Json& entry : manifest["models"]) {
    const auto path = std::filesystem::path(manifestPath).parent_path() / entry["entry"].get<std::string>();
    INFO(path.string());
    const auto model = io::loadGltf(path);
    CHECK((model ? std::string() : model.error().problem) == "");
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
    for (const Note& note : model->notes) {
      if (note.text.starts_with("\"/materials/5/normalTexture/offset\"")) continue;  // AnimateAllTheThings' own slip
      CHECK(note.severity == Note::Severity::info);
    }
  }
}

TEST_CASE("What moves in the shared models is read whole", "[io][gltf][shared]") {
  struct Row {
    const char* path;
    size_t skins, joints, influences, targets, animations, channels, instances;
  };
  const Row rows[] = {
      {"RiggedFigure/glTF-Binary/RiggedFigure.glb", 1, 19, 370 * 4, 0, 1, 57, 0},
      {"RiggedFigure/glTF-Draco/RiggedFigure.gltf", 1, 19, 367 * 4, 0, 1, 57, 0},
      {"RecursiveSkeletons/glTF-Binary/RecursiveSkeletons.glb", 84, 840, 40, 0, 1, 840, 0},
      {"MorphStressTest/glTF-Binary/MorphStressTest.glb", 0, 0, 0, 16, 3, 3, 0},
      {"SparseMorphCube/glTF-Binary/singleBlendshapeCube_sparse.glb", 0, 0, 0, 1, 1, 1, 0},
      {"InterpolationTest/glTF-Binary/InterpolationTest.glb", 0, 0, 0, 0, 9, 9, 0},
      {"SimpleInstancing/glTF-Binary/SimpleInstancing.glb", 0, 0, 0, 0, 0, 0, 125},
  };
  for (const Row& row : rows) {
    INFO(row.path);
    const std::string path = test::sharedFile(std::string("assets/models/") + row.path);
    if (path.empty()) return;
    const auto loaded = io::loadGltf(path);
    REQUIRE(loaded);
    for (const Note& note : loaded->notes) CHECK(note.text.find("supported") != std::string::npos);
    const scene::Model& model = loaded->model;
    size_t joints = 0, influences = 0, targets = 0, channels = 0, instances = 0;
    for (const auto& skin : model.skins) joints += skin.joints.size();
    for (const auto& mesh : model.meshes) {
      for (const auto& p : mesh.primitives) influences += p.influences.size(), targets += p.targets.size();
    }
    for (const auto& animation : model.animations) channels += animation.channels.size();
    for (const auto& node : model.nodes) instances += node.instances.size();
    CHECK(model.skins.size() == row.skins);
    CHECK(joints == row.joints);
    CHECK(influences == row.influences);
    CHECK(targets == row.targets);
    CHECK(model.animations.size() == row.animations);
    CHECK(channels == row.channels);
    CHECK(instances == row.instances);
  }
}
