#include <algorithm>
#include <array>
#include <cmath>

#include "io/validate/checks.hpp"
#include "io/validate/elements.hpp"
#include "io/validate/graph.hpp"
#include "io/validate/vertex_data.hpp"

namespace facet::io::validate {

namespace {

using Matrix = std::array<double, 16>;

template <size_t n>
std::optional<std::array<double, n>> numbersAt(const Json& object, const char* key) {
  const Json& list = member(object, key);
  if (!list.is_array() || list.size() != n) return std::nullopt;
  std::array<double, n> out;
  for (size_t i = 0; i < n; ++i) {
    if (!list[i].is_number()) return std::nullopt;
    out[i] = list[i].get<double>();
  }
  return out;
}

double dot(const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Translation, rotation and scale make it up: a last row of 0 0 0 1, columns at right angles, none of length zero.
bool isDecomposable(const Matrix& m) {
  constexpr double tolerance = 1e-3;
  if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1) return false;
  const double* columns[] = {&m[0], &m[4], &m[8]};
  for (const double* column : columns)
    if (dot(column, column) == 0) return false;
  for (size_t i = 0; i < 3; ++i) {
    const double *a = columns[i], *b = columns[(i + 1) % 3];
    if (std::abs(dot(a, b)) > tolerance * std::sqrt(dot(a, a) * dot(b, b))) return false;
  }
  return true;
}

constexpr Matrix identity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

void checkTransform(Asset& asset, const Json& node, const std::string& place) {
  const auto rotation = numbersAt<4>(node, "rotation");
  if (rotation && std::ranges::all_of(*rotation, [](double v) { return std::abs(v) <= 1; })) {
    double sum = 0;
    for (const double v : *rotation) sum += v * v;
    if (std::abs(std::sqrt(sum) - 1) > quaternionTolerance)
      asset.add(Code::ROTATION_NON_UNIT, place + "/rotation",
                "the quaternion's length is " + numberText(std::sqrt(sum)));
  }
  const auto matrix = numbersAt<16>(node, "matrix");
  if (!matrix) return;
  if (numbersAt<3>(node, "translation") || rotation || numbersAt<3>(node, "scale"))
    asset.add(Code::NODE_MATRIX_TRS, place + "/matrix", "stands beside translation, rotation or scale");
  if (*matrix == identity)
    asset.add(Code::NODE_MATRIX_DEFAULT, place + "/matrix", "is the identity");
  else if (!isDecomposable(*matrix))
    asset.add(Code::NODE_MATRIX_NON_TRS, place + "/matrix", "is not made up of translation, rotation and scale");
}

bool movesLocally(const Json& node) {
  const auto differs = [&](const char* key, auto neutral) {
    const auto value = numbersAt<std::tuple_size_v<decltype(neutral)>>(node, key);
    return value && *value != neutral;
  };
  return differs("matrix", identity) || differs("translation", std::array<double, 3>{}) ||
         differs("rotation", std::array<double, 4>{0, 0, 0, 1}) || differs("scale", std::array<double, 3>{1, 1, 1});
}

bool hasJoints(const Json& primitive) {
  const Json& attributes = member(primitive, "attributes");
  return member(attributes, "JOINTS_0").is_number() && member(attributes, "WEIGHTS_0").is_number();
}

void checkMeshOf(Asset& asset, const Json& node, const std::string& place) {
  const int mesh = indexAt(asset, node, "mesh", "meshes");
  const Json& primitives = member(element(asset, "meshes", mesh), "primitives");
  if (!primitives.is_array() || primitives.empty()) return;
  const Json& weights = member(node, "weights");
  if (weights.is_array() && !weights.empty() && weights.size() != targetCountOf(primitives[0]))
    asset.add(Code::NODE_WEIGHTS_INVALID, place + "/weights",
              std::to_string(weights.size()) + " weights for " + std::to_string(targetCountOf(primitives[0])) +
                  " morph targets");
  if (indexAt(asset, node, "skin", "skins") >= 0) {
    if (!std::ranges::all_of(primitives, hasJoints))
      asset.add(Code::NODE_SKIN_WITH_NON_SKINNED_MESH, place, "its mesh has no joints and weights");
  } else if (member(node, "skin").is_null() && std::ranges::any_of(primitives, hasJoints)) {
    asset.add(Code::NODE_SKINNED_MESH_WITHOUT_SKIN, place, "its mesh has joints and weights");
  }
}

void checkSkinOf(Asset& asset, const Graph& graph, const Json& node, size_t i) {
  const int skin = indexAt(asset, node, "skin", "skins");
  if (skin < 0) return;
  const std::string place = at("/nodes", i);
  if (graph.parents[i] >= 0)
    asset.add(Code::NODE_SKINNED_MESH_NON_ROOT, place, "is not at the root, and moving its parents does not move it");
  if (movesLocally(node))
    asset.add(Code::NODE_SKINNED_MESH_LOCAL_TRANSFORMS, place, "has a transform, which does not move it");
  const std::vector<int> joints = jointsOf(asset, skin);
  const auto root = std::ranges::find_if(
      joints, [&](int joint) { return graph.parents[static_cast<size_t>(rootOf(graph, joint))] < 0; });
  if (root == joints.end() || graph.scenes[i].empty()) return;
  const std::set<int>& ofJoints = graph.scenes[static_cast<size_t>(*root)];
  if (!std::ranges::all_of(graph.scenes[i], [&](int scene) { return ofJoints.contains(scene); }))
    asset.add(Code::NODE_SKIN_NO_SCENE, place, "is in a scene that its joints are not in");
}

// Weights of a mesh that every node overrides.
void checkMeshWeights(Asset& asset) {
  const Json& meshes = collection(asset, "meshes");
  std::vector<size_t> users(meshes.size()), overrides(meshes.size());
  for (const Json& node : collection(asset, "nodes"))
    if (const int mesh = indexAt(asset, node, "mesh", "meshes"); mesh >= 0) {
      ++users[static_cast<size_t>(mesh)];
      if (member(node, "weights").is_array()) ++overrides[static_cast<size_t>(mesh)];
    }
  for (size_t i = 0; i < meshes.size(); ++i)
    if (member(meshes[i], "weights").is_array() && users[i] > 0 && users[i] == overrides[i])
      asset.add(Code::UNUSED_MESH_WEIGHTS, at("/meshes", i) + "/weights",
                "all nodes with the mesh have weights of their own");
}

}  // namespace

void checkNodes(Asset& asset) {
  const Json& nodes = collection(asset, "nodes");
  const Graph graph = graphOf(asset);
  std::vector<bool> joints(nodes.size());
  for (size_t i = 0; i < collection(asset, "skins").size(); ++i)
    for (const int joint : jointsOf(asset, static_cast<int>(i))) joints[static_cast<size_t>(joint)] = true;
  for (size_t i = 0; i < nodes.size(); ++i) {
    const Json& node = nodes[i];
    if (!node.is_object()) continue;
    const std::string place = at("/nodes", i);
    checkTransform(asset, node, place);
    checkMeshOf(asset, node, place);
    checkSkinOf(asset, graph, node, i);
    const bool empty = !joints[i] && !node.contains("children") && !node.contains("mesh") && !node.contains("camera") &&
                       !node.contains("extensions") && !node.contains("extras");
    if (empty) asset.add(Code::NODE_EMPTY, place, "holds nothing");
    if (graph.inLoop[i]) asset.add(Code::NODE_LOOP, place, "is below itself");
  }
  checkMeshWeights(asset);
}

}  // namespace facet::io::validate
