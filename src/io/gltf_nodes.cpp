#include <cmath>

#include "io/gltf_deformation.hpp"
#include "io/gltf_image_light.hpp"

namespace facet::io {

namespace {

// Beyond single precision's range products overflow on the way to the GPU.
bool finite(double value) { return std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max()); }

Result<void> checkNumbers(const Document& doc, const std::vector<double>& values, size_t count,
                          const std::string& place) {
  if (values.empty()) return {};
  if (values.size() != count) {
    return doc.error(place, "has " + std::to_string(values.size()) + " numbers instead of " + std::to_string(count));
  }
  for (const double value : values) {
    if (!finite(value)) return doc.error(place, "holds a number that is not finite in single precision");
  }
  return {};
}

void readMatrix(Document& doc, const std::vector<double>& values, const std::string& place, scene::Node& node) {
  glm::dmat4 matrix(1);
  for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = values[static_cast<size_t>(i)];
  for (int column = 0; column < 4; ++column) {
    const double expected = column == 3 ? 1 : 0;
    if (std::abs(matrix[column][3] - expected) > 1e-6) {
      doc.warning(place + "/matrix", "the last row is not 0 0 0 1 and is ignored");
      for (int c = 0; c < 4; ++c) matrix[c][3] = c == 3 ? 1 : 0;
      break;
    }
  }
  if (glm::determinant(glm::dmat3(matrix)) == 0)
    doc.info(place + "/matrix", "cannot be inverted: what it moves is flat");
  node.matrix = matrix;
}

void readRotation(Document& doc, const std::vector<double>& v, const std::string& place, scene::Node& node) {
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3]);
  if (!(length > 0)) {
    doc.warning(place + "/rotation", "is zero: replaced by no rotation");
    return;
  }
  // Single-precision writers stay well below 1e-3.
  if (std::abs(length - 1) > 1e-3) doc.info(place + "/rotation", "was not of unit length: normalised");
  node.rotation = glm::dquat(v[3] / length, v[0] / length, v[1] / length, v[2] / length);
}

Result<void> readTransform(Document& doc, const tinygltf::Node& from, const std::string& place, scene::Node& node) {
  if (auto ok = checkNumbers(doc, from.matrix, 16, place + "/matrix"); !ok) return ok;
  if (auto ok = checkNumbers(doc, from.translation, 3, place + "/translation"); !ok) return ok;
  if (auto ok = checkNumbers(doc, from.rotation, 4, place + "/rotation"); !ok) return ok;
  if (auto ok = checkNumbers(doc, from.scale, 3, place + "/scale"); !ok) return ok;
  if (!from.matrix.empty()) readMatrix(doc, from.matrix, place, node);
  if (!from.rotation.empty()) readRotation(doc, from.rotation, place, node);
  if (!from.translation.empty()) node.translation = {from.translation[0], from.translation[1], from.translation[2]};
  if (!from.scale.empty()) {
    node.scale = {from.scale[0], from.scale[1], from.scale[2]};
    if (node.scale.x * node.scale.y * node.scale.z == 0) {
      doc.info(place + "/scale", "cannot be inverted: what it moves is flat");
    }
  }
  return {};
}

// KHR_lights_punctual
Result<void> readNodeLight(const Document& doc, const tinygltf::Node& from, const std::string& place,
                           scene::Node& node) {
  const auto extension = from.extensions.find("KHR_lights_punctual");
  if (extension == from.extensions.end()) return {};
  const std::string lightPlace = place + "/extensions/KHR_lights_punctual/light";
  const auto& value = memberValue(extension->second, "light");
  if (!value.IsInt()) return doc.error(lightPlace, "is not a whole number");
  node.light = value.GetNumberAsInt();
  return checkIndex(doc, node.light, doc.gltf.lights.size(), lightPlace, "light");
}

void readVisibility(Document& doc, const tinygltf::Node& from, const std::string& place, scene::Node& node) {
  const auto extension = from.extensions.find("KHR_node_visibility");
  if (extension == from.extensions.end() || !extension->second.Has("visible")) return;
  const auto& visible = memberValue(extension->second, "visible");
  if (visible.IsBool()) {
    node.visible = visible.Get<bool>();
  } else {
    doc.warning(place + "/extensions/KHR_node_visibility/visible", "is neither true nor false: shown");
  }
}

Result<void> readNodeWeights(Document& doc, const tinygltf::Node& from, const std::string& place, scene::Node& node) {
  if (from.weights.empty()) return {};
  const size_t targets = node.mesh == -1 ? 0 : targetCount(doc.gltf.meshes[static_cast<size_t>(node.mesh)]);
  auto weights = readWeights(doc, from.weights, targets, place + "/weights");
  if (!weights) return tl::unexpected(weights.error());
  node.weights = std::move(*weights);
  return {};
}

Result<void> readNode(Document& doc, size_t index, uint64_t& instanceBytes) {
  const auto& from = doc.gltf.nodes[index];
  const std::string place = pointer("/nodes", index);
  scene::Node& node = doc.model.nodes[index];
  node.name = from.name;
  const struct {
    int value;
    int& to;
    size_t count;
    const char *key, *what;
  } references[] = {{from.mesh, node.mesh, doc.gltf.meshes.size(), "/mesh", "mesh"},
                    {from.camera, node.camera, doc.gltf.cameras.size(), "/camera", "camera"},
                    {from.skin, node.skin, doc.model.skins.size(), "/skin", "skin"}};
  for (const auto& r : references) {
    if (r.value == -1) continue;
    const auto ok = checkIndex(doc, r.value, r.count, place + r.key, r.what);
    ok ? void(r.to = r.value) : doc.lost(ok.error(), "the node is shown without it");
  }
  // A skin that could not be read has no joints; its loss has been told.
  if (node.skin != -1 && doc.model.skins[static_cast<size_t>(node.skin)].joints.empty()) node.skin = -1;
  if (auto ok = readNodeLight(doc, from, place, node); !ok) {
    node.light = -1;
    doc.lost(ok.error(), "the node is shown without it");
  }
  if (auto ok = readNodeWeights(doc, from, place, node); !ok) return ok;
  if (auto ok = readInstances(doc, from, place, node, instanceBytes); !ok) return ok;
  readVisibility(doc, from, place, node);
  return readTransform(doc, from, place, node);
}

Result<void> linkChildren(Document& doc, size_t index) {
  const auto& children = doc.gltf.nodes[index].children;
  auto& nodes = doc.model.nodes;
  for (size_t i = 0; i < children.size(); ++i) {
    const auto place = [&] { return pointer(pointer("/nodes", index) + "/children", i); };
    if (children[i] < 0 || static_cast<size_t>(children[i]) >= nodes.size()) {
      return checkIndex(doc, children[i], nodes.size(), place(), "node");
    }
    int& parent = nodes[static_cast<size_t>(children[i])].parent;
    if (static_cast<size_t>(children[i]) == index) return doc.error(place(), "names the node itself as its child");
    if (parent != -1) {
      return doc.error(place(), "node " + std::to_string(children[i]) + " is already a child of node " +
                                    std::to_string(parent) + "; a node has one parent");
    }
    parent = static_cast<int>(index);
  }
  nodes[index].children = children;
  return {};
}

// Every node has one parent at most, so what no root reaches lies on or below a cycle.
Result<void> checkCycles(const Document& doc) {
  const auto& nodes = doc.model.nodes;
  std::vector<char> reached(nodes.size(), 0);
  std::vector<int> open;
  for (size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].parent == -1) open.push_back(static_cast<int>(i));
  }
  while (!open.empty()) {
    const auto node = static_cast<size_t>(open.back());
    open.pop_back();
    reached[node] = 1;
    open.insert(open.end(), nodes[node].children.begin(), nodes[node].children.end());
  }
  for (size_t i = 0; i < nodes.size(); ++i) {
    if (reached[i]) continue;
    size_t node = i;  // upwards until the cycle is surely entered
    for (size_t step = 0; step < nodes.size(); ++step) node = static_cast<size_t>(nodes[node].parent);
    return doc.error(pointer("/nodes", node), "is its own ancestor");
  }
  return {};
}

// EXT_lights_image_based; what it names is read with the environment (gltf_environment.cpp).
void readSceneImageLight(Document& doc, const tinygltf::Scene& from, const std::string& place, scene::Scene& scene) {
  const auto extension = from.extensions.find("EXT_lights_image_based");
  if (extension == from.extensions.end()) return;
  const auto& light = memberValue(extension->second, "light");
  const int index = light.IsInt() ? light.GetNumberAsInt() : -1;
  const auto ok =
      checkIndex(doc, index, imageLightCount(doc), place + "/extensions/EXT_lights_image_based/light", "environment");
  ok ? void(scene.imageLight = index) : doc.lost(ok.error(), "another one is shown");
}

Result<void> readScene(Document& doc, size_t index) {
  const auto& from = doc.gltf.scenes[index];
  scene::Scene scene;
  scene.name = from.name;
  std::vector<char> listed(doc.model.nodes.size(), 0);
  for (size_t i = 0; i < from.nodes.size(); ++i) {
    const std::string place = pointer(pointer("/scenes", index) + "/nodes", i);
    if (auto ok = checkIndex(doc, from.nodes[i], doc.model.nodes.size(), place, "node"); !ok) return ok;
    const auto node = static_cast<size_t>(from.nodes[i]);
    if (doc.model.nodes[node].parent != -1) {
      return doc.error(place, "node " + std::to_string(node) + " is not a root: it is a child of node " +
                                  std::to_string(doc.model.nodes[node].parent));
    }
    if (listed[node]) {
      doc.info(place, "node " + std::to_string(node) + " is listed twice: shown once");
      continue;
    }
    listed[node] = 1;
    scene.nodes.push_back(from.nodes[i]);
  }
  readSceneImageLight(doc, from, pointer("/scenes", index), scene);
  doc.model.scenes.push_back(std::move(scene));
  return {};
}

// MSFT_lod: the object that has it is the finest level. Coarser nodes are left out wherever a scene has them, too.
template <class Objects>
void readLevels(Document& doc, const Objects& objects, const char* list, const char* what, size_t& count) {
  for (size_t i = 0; i < objects.size(); ++i) {
    const auto extension = objects[i].extensions.find("MSFT_lod");
    if (extension == objects[i].extensions.end()) continue;
    ++count;
    const std::string place = pointer(list, i) + "/extensions/MSFT_lod/ids";
    const auto& ids = memberValue(extension->second, "ids");
    if (!ids.IsArray()) doc.warning(place, "is no list of the coarser levels");
    for (size_t k = 0; ids.IsArray() && k < ids.ArrayLen(); ++k) {
      const auto& id = ids.Get(static_cast<int>(k));
      const auto ok = checkIndex(doc, id.IsInt() ? id.GetNumberAsInt() : -1, objects.size(), pointer(place, k), what);
      if (!ok) doc.lost(ok.error(), "the finest level is shown");
      if (!ok || what != std::string_view("node") || static_cast<size_t>(id.GetNumberAsInt()) == i) continue;
      doc.model.nodes[static_cast<size_t>(id.GetNumberAsInt())].visible = false;
    }
  }
}

void readAllLevels(Document& doc) {
  size_t nodes = 0, materials = 0;
  readLevels(doc, doc.gltf.nodes, "/nodes", "node", nodes);
  readLevels(doc, doc.gltf.materials, "/materials", "material", materials);
  if (nodes + materials > 0)
    doc.info("", std::to_string(nodes) + " nodes and " + std::to_string(materials) +
                     " materials have coarser levels of detail (MSFT_lod): the finest is shown at any distance");
}

}  // namespace

Result<void> readNodes(Document& doc) {
  doc.model.nodes.resize(doc.gltf.nodes.size());
  uint64_t instanceBytes = 0;
  for (size_t i = 0; i < doc.gltf.nodes.size(); ++i) {
    if (auto ok = readNode(doc, i, instanceBytes); !ok) return ok;
  }
  for (size_t i = 0; i < doc.gltf.nodes.size(); ++i) {
    if (auto ok = linkChildren(doc, i); !ok) return ok;
  }
  if (auto ok = checkCycles(doc); !ok) return ok;
  readAllLevels(doc);
  for (size_t i = 0; i < doc.gltf.scenes.size(); ++i) {
    if (auto ok = readScene(doc, i); !ok) return ok;
  }
  if (doc.gltf.defaultScene != -1) {
    const auto ok = checkIndex(doc, doc.gltf.defaultScene, doc.gltf.scenes.size(), "/scene", "scene");
    ok ? void(doc.model.defaultScene = doc.gltf.defaultScene) : doc.lost(ok.error(), "the first one is shown");
  }
  if (!doc.model.scenes.empty()) return {};
  scene::Scene all;  // a library of meshes: show it whole
  for (size_t i = 0; i < doc.model.nodes.size(); ++i) {
    if (doc.model.nodes[i].parent == -1) all.nodes.push_back(static_cast<int>(i));
  }
  doc.model.scenes.push_back(std::move(all));
  return {};
}

}  // namespace facet::io
