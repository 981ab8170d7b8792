#include "support/gltf_load.hpp"

#include <catch2/catch.hpp>

namespace facet::test {

std::string outcome(const Result<io::LoadedModel>& result) {
  return result ? std::string("loaded") : describe(result.error());
}

std::string outcome(const std::string& gltfText) {
  return outcome(io::loadGltfBytes({reinterpret_cast<const uint8_t*>(gltfText.data()), gltfText.size()}, "m"));
}

io::LoadedModel loaded(const GltfBuilder& builder) {
  const auto glb = builder.glb();
  auto result = io::loadGltfBytes(glb, "m");
  if (!result) FAIL(describe(result.error()));
  return std::move(*result);
}

std::string notes(const io::LoadedModel& model) {
  std::string text;
  for (const Note& note : model.notes) {
    text += (note.severity == Note::Severity::warning ? "! " : "") + note.place + ": " + note.text + "\n";
  }
  return text;
}

const scene::Primitive& primitive(const io::LoadedModel& model) { return model.model.meshes.at(0).primitives.at(0); }

nlohmann::json& attributes(GltfBuilder& builder) { return builder.json["meshes"][0]["primitives"][0]["attributes"]; }

}  // namespace facet::test
