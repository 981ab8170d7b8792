// EXT_mesh_gpu_instancing: one mesh many times. Custom attributes (_NAME) only count the instances.

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "io/accessors.hpp"

namespace facet::io {

namespace {

constexpr const char* instancingExtension = "EXT_mesh_gpu_instancing";

// What one instance takes from the file to the picture, measured: matrices, boxes, uniforms and their copies.
constexpr uint64_t instanceBytes = 800;

// Of instances that the file does not store; a few bytes could ask for any number of them.
constexpr size_t maxInstancesWithoutData = 65536;

struct Attributes {
  int translation = -1, rotation = -1, scale = -1;  // accessors
  size_t count = 0;
};

Result<Attributes> findAttributes(const Document& doc, const tinygltf::Value& from, const std::string& place) {
  Attributes result;
  const struct {
    const char* name;
    int type;
    int* accessor;
  } rules[] = {{"TRANSLATION", TINYGLTF_TYPE_VEC3, &result.translation},
               {"ROTATION", TINYGLTF_TYPE_VEC4, &result.rotation},
               {"SCALE", TINYGLTF_TYPE_VEC3, &result.scale}};
  bool first = true;
  for (const std::string& name : from.Keys()) {
    const std::string at = place + "/" + name;
    const auto& value = from.Get(name);
    if (!value.IsInt()) return doc.error(at, "is not a whole number");
    const int index = value.GetNumberAsInt();
    if (auto ok = checkIndex(doc, index, doc.gltf.accessors.size(), at, "accessor"); !ok)
      return tl::unexpected(ok.error());
    const auto& accessor = doc.gltf.accessors[static_cast<size_t>(index)];
    if (!first && accessor.count != result.count) {
      return doc.error(
          at, "has " + std::to_string(accessor.count) + " elements, but another has " + std::to_string(result.count));
    }
    first = false;
    result.count = accessor.count;
    if (accessor.bufferView == -1 && accessor.count > maxInstancesWithoutData) {
      return doc.error(at, "has no buffer view for " + std::to_string(accessor.count) + " instances; at most " +
                               std::to_string(maxInstancesWithoutData) + " can do without");
    }
    for (const auto& rule : rules) {
      if (name != rule.name) continue;
      *rule.accessor = index;
      if (accessor.type != rule.type) {
        return doc.error(at, "is not a vector of " + std::to_string(rule.type) + " components");
      }
    }
  }
  return result;
}

template <class V>
std::vector<V> readVectors(const Document& doc, int accessor, size_t count, V initial, bool normalized) {
  std::vector<V> values(count, initial);
  if (accessor != -1 && count > 0) readFloats(doc, accessor, V::length(), &values[0].x, normalized);
  return values;
}

bool isFinite(const glm::dmat4& matrix) {
  double sum = 0;  // NaN and Inf survive a product with zero
  for (int i = 0; i < 16; ++i) sum += matrix[i / 4][i % 4] * 0.0;
  return sum == 0;
}

}  // namespace

Result<void> readInstances(Document& doc, const tinygltf::Node& from, const std::string& place, scene::Node& node,
                           uint64_t& bytes) {
  const auto extension = from.extensions.find(instancingExtension);
  if (extension == from.extensions.end() || node.mesh == -1) return {};
  const std::string extensionPlace = place + "/extensions/" + instancingExtension, at = extensionPlace + "/attributes";
  if (!extension->second.Has("attributes") || !extension->second.Get("attributes").IsObject()) {
    doc.warning(extensionPlace, "has no attributes: the mesh is shown once");
    return {};
  }
  const auto attributes = findAttributes(doc, extension->second.Get("attributes"), at);
  if (!attributes) return tl::unexpected(attributes.error());
  const size_t count = attributes->count;
  bytes += count * instanceBytes;
  if (bytes > doc.limits.geometryBytes) {
    return doc.error(at, "the instances take more than " + std::to_string(doc.limits.geometryBytes) + " bytes",
                     "use a smaller model");
  }
  const auto translations = readVectors(doc, attributes->translation, count, glm::vec3(0), false);
  // Integers without "normalized" are a writer's slip.
  const auto rotations = readVectors(doc, attributes->rotation, count, glm::vec4(0, 0, 0, 1), true);
  const auto scales = readVectors(doc, attributes->scale, count, glm::vec3(1), false);
  for (size_t i = 0; i < count; ++i) {
    const glm::dvec4 q(rotations[i]);
    const double length = glm::length(q);
    glm::dmat4 matrix = glm::mat4_cast(glm::dquat(q.w / length, q.x / length, q.y / length, q.z / length));
    const glm::dvec3 scale(scales[i]);
    for (int c = 0; c < 3; ++c) matrix[c] *= scale[c];
    matrix[3] = glm::dvec4(glm::dvec3(translations[i]), 1);
    if (isFinite(matrix)) node.instances.push_back(matrix);
  }
  if (node.instances.size() != count) {
    doc.warning(
        at, std::to_string(count - node.instances.size()) + " instances have no rotation or are not finite: left out");
  }
  if (node.instances.empty()) {
    doc.warning(extensionPlace, "there are no instances: the mesh is not shown");
    node.mesh = -1;
  }
  return {};
}

}  // namespace facet::io
