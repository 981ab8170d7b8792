#include <algorithm>
#include <cmath>

#include "io/gltf_deformation.hpp"

namespace facet::io {

namespace {

// What a target can change.
struct TargetRule {
  std::string name;
  const char* what;
  int minComponents, maxComponents;
  size_t bytes;           // of a vertex
  bool alwaysNormalized;  // integers without "normalized" are a writer's slip
};
const TargetRule positionRule = {"POSITION", "positions", 3, 3, 12, false};
const TargetRule normalRule = {"NORMAL", "normals", 3, 3, 12, true};
const TargetRule tangentRule = {"TANGENT", "tangents", 3, 3, 12, true};
const TargetRule colorRule = {"COLOR_0", "colours", 3, 4, 16, true};
constexpr const TargetRule* targetRules[] = {&positionRule, &normalRule, &tangentRule, &colorRule};

TargetRule texCoordRule(size_t set) {
  return {"TEXCOORD_" + std::to_string(set), "texture coordinates", 2, 2, 8, false};
}

using Target = std::map<std::string, int>;

int vectorComponents(const Document& doc, int accessor) {
  const int type = doc.gltf.accessors[static_cast<size_t>(accessor)].type;
  return type >= TINYGLTF_TYPE_VEC2 && type <= TINYGLTF_TYPE_VEC4 ? type : 0;
}

struct MorphReader {
  const Document& doc;
  const tinygltf::Primitive& from;
  const std::string& place;
  Notes& notes;

  void warning(std::string at, std::string text) {
    notes.push_back({Note::Severity::warning, std::move(at), std::move(text)});
  }
};

// Differences of one attribute; empty where the target has none or all are zero.
template <class V>
void readDifferences(MorphReader& reader, size_t target, const TargetRule& rule, std::vector<V>& out) {
  const auto found = reader.from.targets[target].find(rule.name);
  if (found == reader.from.targets[target].end()) return;
  out.assign(reader.doc.gltf.accessors[static_cast<size_t>(found->second)].count, V(0));
  readFloats(reader.doc, found->second, V::length(), &out[0].x, rule.alwaysNormalized);
  size_t bad = 0;
  bool any = false;
  for (V& v : out) {
    for (int c = 0; c < V::length(); ++c) {
      if (std::isfinite(v[c])) continue;
      v = V(0);
      ++bad;
      break;
    }
    any = any || v != V(0);
  }
  if (bad > 0) {
    reader.warning(pointer(reader.place + "/targets", target) + "/" + rule.name,
                   std::to_string(bad) + " are not finite: replaced by zero");
  }
  if (!any) out = {};
}

// Whether what the rule changes is there; says once where it is not.
bool isThere(MorphReader& reader, const TargetRule& rule, bool there) {
  if (there) return true;
  const auto& targets = reader.from.targets;
  const auto n = std::count_if(targets.begin(), targets.end(), [&](const Target& t) { return t.count(rule.name) > 0; });
  if (n > 0) {
    reader.notes.push_back({Note::Severity::info, reader.place + "/targets",
                            std::to_string(n) + " change " + rule.what + ", but there are none: ignored"});
  }
  return false;
}

// Of sets that nothing reads they are not looked at.
void readTexCoordDifferences(MorphReader& reader, scene::Primitive& primitive) {
  for (size_t set = 0; set < primitive.texCoords.size(); ++set) {
    const TargetRule rule = texCoordRule(set);
    if (!isThere(reader, rule, reader.from.attributes.contains(rule.name)) || primitive.texCoords[set].empty())
      continue;
    for (size_t i = 0; i < reader.from.targets.size(); ++i)
      readDifferences(reader, i, rule, primitive.targets[i].texCoords[set]);
  }
}

Result<float> finiteWeight(const Document& doc, double value, const std::string& place) {
  if (std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max())) return static_cast<float>(value);
  return doc.error(place, "holds a number that is not finite in single precision");
}

}  // namespace

size_t targetCount(const tinygltf::Mesh& mesh) {
  size_t largest = 0;
  for (const auto& primitive : mesh.primitives) largest = std::max(largest, primitive.targets.size());
  return largest;
}

Result<void> checkTargets(const Document& doc, const tinygltf::Primitive& primitive, const std::string& place) {
  const auto check = [&](size_t i, const TargetRule& rule) -> Result<void> {
    const auto found = primitive.targets[i].find(rule.name);
    if (found == primitive.targets[i].end()) return {};
    const int n = vectorComponents(doc, found->second);
    if (n >= rule.minComponents && n <= rule.maxComponents) return {};
    return doc.error(pointer(place + "/targets", i) + "/" + rule.name,
                     "is not a vector of " + std::to_string(rule.minComponents) + " components");
  };
  for (size_t i = 0; i < primitive.targets.size(); ++i) {
    for (const TargetRule* rule : targetRules)
      if (auto ok = check(i, *rule); !ok) return ok;
    for (size_t set = 0; set < scene::maxTexCoordSets; ++set)
      if (auto ok = check(i, texCoordRule(set)); !ok) return ok;
  }
  return {};
}

uint64_t targetBytes(const Document& doc, const tinygltf::Primitive& primitive, size_t count) {
  if (primitive.targets.empty()) return 0;
  uint64_t perVertex = 0;
  for (const TargetRule* rule : targetRules) {
    const auto names = [&](const Target& target) { return target.count(rule->name) > 0; };
    if (rule == &positionRule || std::ranges::any_of(primitive.targets, names)) perVertex += rule->bytes;
  }
  for (size_t set = 0; set < scene::maxTexCoordSets; ++set) {
    const TargetRule rule = texCoordRule(set);
    const auto names = [&](const Target& target) { return target.count(rule.name) > 0; };
    if (std::ranges::any_of(primitive.targets, names)) perVertex += rule.bytes;
  }
  const uint64_t vertices = doc.gltf.accessors[static_cast<size_t>(primitive.attributes.at("POSITION"))].count;
  return count * (sizeof(scene::MorphTarget) + vertices * perVertex);
}

void readTargets(const Document& doc, const tinygltf::Primitive& from, size_t count, const std::string& place,
                 scene::Primitive& primitive, Notes& notes) {
  if (from.targets.empty()) return;
  MorphReader reader{doc, from, place, notes};
  const bool normals = isThere(reader, normalRule, !primitive.normals.empty());
  const bool tangents = isThere(reader, tangentRule, !primitive.tangents.empty());
  const bool colors = isThere(reader, colorRule, !primitive.colors.empty());
  primitive.targets.resize(count);
  for (size_t i = 0; i < from.targets.size(); ++i) {
    scene::MorphTarget& target = primitive.targets[i];
    readDifferences(reader, i, positionRule, target.positions);
    if (normals) readDifferences(reader, i, normalRule, target.normals);
    if (tangents) readDifferences(reader, i, tangentRule, target.tangents);
    if (colors) readDifferences(reader, i, colorRule, target.colors);
    for (const glm::vec3& p : target.positions) target.bounds.add(glm::dvec3(p));
  }
  readTexCoordDifferences(reader, primitive);
}

Result<std::vector<float>> readWeights(Document& doc, const std::vector<double>& values, size_t targets,
                                       const std::string& place) {
  std::vector<float> weights;
  for (const double value : values) {
    const auto weight = finiteWeight(doc, value, place);
    if (!weight) return tl::unexpected(weight.error());
    weights.push_back(*weight);
  }
  if (!values.empty() && values.size() != targets) {
    doc.warning(place, "has " + std::to_string(values.size()) + " numbers, but there are " + std::to_string(targets) +
                           " morph targets: " +
                           (values.size() > targets ? "the rest is ignored" : "the rest is taken as zero"));
    weights.resize(std::min(weights.size(), targets));
  }
  return weights;
}

Result<void> readMeshWeights(Document& doc, size_t index) {
  const auto& from = doc.gltf.meshes[index];
  const std::string place = pointer("/meshes", index);
  const size_t targets = targetCount(from);
  for (size_t p = 0; p < from.primitives.size(); ++p) {
    const size_t n = from.primitives[p].targets.size();
    if (n == targets) continue;
    doc.warning(pointer(place + "/primitives", p), "has " + std::to_string(n) + " morph targets, but another has " +
                                                       std::to_string(targets) + ": those that are missing do nothing");
  }
  auto weights = readWeights(doc, from.weights, targets, place + "/weights");
  if (!weights) return tl::unexpected(weights.error());
  scene::Mesh& mesh = doc.model.meshes[index];
  mesh.weights = std::move(*weights);
  if (!from.extras.IsObject() || !from.extras.Has("targetNames")) return {};
  const auto& names = memberValue(from.extras, "targetNames");
  if (!names.IsArray()) return {};
  for (size_t i = 0; i < std::min(names.ArrayLen(), targets); ++i) {
    const auto& name = names.Get(static_cast<int>(i));
    mesh.targetNames.push_back(name.IsString() ? name.Get<std::string>() : std::string());
  }
  return {};
}

}  // namespace facet::io
