#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/accessors.hpp"
#include "io/json_section.hpp"

namespace facet::io {

namespace {

using Json = nlohmann::json;

Result<void> readJoints(Document& doc, const Json& from, const std::string& place, scene::Skin& skin) {
  const auto joints = from.find("joints");
  if (joints == from.end() || !joints->is_array() || joints->empty()) {
    return doc.error(place + "/joints", "is missing or empty: a skin has at least one joint");
  }
  for (size_t i = 0; i < joints->size(); ++i) {
    const auto joint = readIndex(doc, (*joints)[i], doc.gltf.nodes.size(), pointer(place + "/joints", i), "node");
    if (!joint) return tl::unexpected(joint.error());
    skin.joints.push_back(*joint);
  }
  std::vector<int> sorted = skin.joints;
  std::sort(sorted.begin(), sorted.end());
  if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end()) {
    doc.info(place + "/joints", "node " + std::to_string(*twice) + " is listed twice");
  }
  return {};
}

Result<void> readMatrices(Document& doc, const Json& from, const std::string& place, scene::Skin& skin) {
  const auto index = readIndex(doc, from, doc.gltf.accessors.size(), place, "accessor");
  if (!index) return tl::unexpected(index.error());
  const auto& accessor = doc.gltf.accessors[static_cast<size_t>(*index)];
  if (accessor.type != TINYGLTF_TYPE_MAT4 || !isFloatingPoint(accessor.componentType)) {
    return doc.error(place, "is not an accessor of 4 x 4 matrices of floats");
  }
  const size_t count = skin.joints.size();
  if (accessor.count < count) {
    return doc.error(place,
                     "has " + std::to_string(accessor.count) + " matrices for " + std::to_string(count) + " joints");
  }
  std::vector<float> values(count * 16);
  readFloats(doc, *index, 16, values.data(), false, count);
  size_t repaired = 0;
  skin.inverseBindMatrices.resize(count);
  for (size_t i = 0; i < count; ++i) {
    glm::dmat4& matrix = skin.inverseBindMatrices[i];
    double off = 0;
    for (int k = 0; k < 16; ++k) {
      const float value = values[i * 16 + static_cast<size_t>(k)];
      if (!std::isfinite(value)) return doc.error(place, "matrix " + std::to_string(i) + " is not finite");
      matrix[k / 4][k % 4] = static_cast<double>(value);
      if (k % 4 != 3) continue;
      const double expected = k == 15 ? 1 : 0;
      off = std::max(off, std::abs(matrix[k / 4][3] - expected));
      matrix[k / 4][3] = expected;
    }
    // Inverting in single precision leaves less.
    if (off > 1e-5) ++repaired;
  }
  if (repaired > 0) {
    doc.warning(place, "the last row of " + std::to_string(repaired) + " is not 0 0 0 1 and is ignored");
  }
  return {};
}

}  // namespace

Result<void> readSkins(Document& doc) {
  const auto skins = section(doc, "skins");
  if (!skins) return tl::unexpected(skins.error());
  for (size_t i = 0; i < skins->size(); ++i) {
    const Json& from = (*skins)[i];
    const std::string place = pointer("/skins", i);
    scene::Skin skin;
    skin.name = stringAt(from, "name");
    auto ok = readJoints(doc, from, place, skin);
    const auto matrices = from.find("inverseBindMatrices");
    if (ok && matrices != from.end()) ok = readMatrices(doc, *matrices, place + "/inverseBindMatrices", skin);
    if (!ok) {
      doc.lost(ok.error(), "what it moves is shown at rest");
      skin = {skin.name, {}, {}};
    }
    doc.model.skins.push_back(std::move(skin));
  }
  return {};
}

}  // namespace facet::io
