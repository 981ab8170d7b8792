#include <algorithm>
#include <cmath>
#include <map>

#include "base/whole_number.hpp"
#include "io/accessors.hpp"
#include "io/gltf_deformation.hpp"

namespace facet::io {

namespace {

// JOINTS_n and WEIGHTS_n: accessors, -1 where missing.
struct Set {
  int joints = -1, weights = -1;
  bool complete() const { return joints != -1 && weights != -1; }
};

// n of "JOINTS_n"; -1 for other names.
int setNumber(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix)) return -1;
  const std::string_view digits = name.substr(prefix.size());
  const int number = wholeNumber(digits).value_or(-1);
  return number >= 0 && std::to_string(number) == digits ? number : -1;
}

std::map<int, Set> setsOf(const tinygltf::Primitive& primitive) {
  std::map<int, Set> sets;
  for (const auto& [name, accessor] : primitive.attributes) {
    if (const int n = setNumber(name, "JOINTS_"); n >= 0) sets[n].joints = accessor;
    if (const int n = setNumber(name, "WEIGHTS_"); n >= 0) sets[n].weights = accessor;
  }
  return sets;
}

bool isVector4(const tinygltf::Accessor& accessor, bool floats) {
  const int type = accessor.componentType;
  return accessor.type == TINYGLTF_TYPE_VEC4 &&
         (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
          (floats && isFloatingPoint(type)));
}

// How far the four weights of a set may be off the sum of 1 without a word: rounding. Writers in single precision stay
// well below 1e-3; quantised weights are off by half a step each.
double sumTolerance(int componentType) {
  if (componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return 4 * 0.5 / 255 + 1e-6;
  if (componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return 4 * 0.5 / 65535 + 1e-6;
  return 1e-3;
}

// One set's data: integers in single precision are exact up to 2^24, so joints come out right.
struct SetData {
  int number = 0;
  std::vector<glm::vec4> joints, weights;
  float jointScale = 1;  // undoes a normalisation that makes no sense for joints
  size_t badWeights = 0;
};

std::vector<glm::vec4> readSet(const Document& doc, const DracoGeometry& draco, const std::string& name, int accessor,
                               bool normalized) {
  std::vector<glm::vec4> values(accessorAt(doc, accessor).count, glm::vec4(0));
  if (values.empty()) return values;
  const auto decoded = draco.attributes.find(name);
  if (decoded == draco.attributes.end()) {
    readFloats(doc, accessor, 4, &values[0].x, normalized);
  } else {
    const Elements from = decodedElements(doc, accessor, decoded->second);
    convertElements(from, from.normalized || normalized, 4, &values[0].x);
  }
  return values;
}

struct Share {
  uint32_t joint;
  double weight;
};

struct Reading {
  std::vector<SetData> sets;
  double tolerance = 0;
  size_t withoutWeights = 0, normalised = 0;
};

uint32_t jointAt(const SetData& set, size_t vertex, int component) {
  return static_cast<uint32_t>(std::lround(set.joints[vertex][component] * set.jointScale));
}

void addEqualJoints(std::vector<Share>& shares) {
  std::sort(shares.begin(), shares.end(), [](const Share& a, const Share& b) { return a.joint < b.joint; });
  size_t last = 0;
  for (size_t i = 1; i < shares.size(); ++i) {
    if (shares[i].joint == shares[last].joint) {
      shares[last].weight += shares[i].weight;
    } else {
      shares[++last] = shares[i];
    }
  }
  shares.resize(last + 1);
}

// The vertex's shares, none of zero, each joint once, adding up to 1. Without any the vertex follows its first joint,
// which may be a filler that the skin (of so many joints, at least one) does not have: then the skin's first.
void gather(Reading& reading, size_t vertex, size_t joints, std::vector<Share>& shares) {
  shares.clear();
  double sum = 0;
  for (SetData& set : reading.sets) {
    for (int c = 0; c < 4; ++c) {
      const auto weight = static_cast<double>(set.weights[vertex][c]);
      if (!(weight >= 0) || !std::isfinite(weight)) {
        ++set.badWeights;
        continue;
      }
      if (weight == 0) continue;
      sum += weight;
      shares.push_back({jointAt(set, vertex, c), weight});
    }
  }
  if (shares.empty()) {
    ++reading.withoutWeights;
    const uint32_t joint = jointAt(reading.sets[0], vertex, 0);
    shares.push_back({joint < joints ? joint : 0, 1});
    return;
  }
  if (std::abs(sum - 1) > reading.tolerance) ++reading.normalised;
  addEqualJoints(shares);
  for (Share& share : shares) share.weight /= sum;
  std::sort(shares.begin(), shares.end(), [](const Share& a, const Share& b) {
    return a.weight != b.weight ? a.weight > b.weight : a.joint < b.joint;
  });
}

void noteRepairs(const Reading& reading, const std::string& place, Notes& notes) {
  for (const SetData& set : reading.sets) {
    if (set.badWeights == 0) continue;
    notes.push_back({Note::Severity::warning, place + "/WEIGHTS_" + std::to_string(set.number),
                     std::to_string(set.badWeights) + " are negative or not finite: replaced by zero"});
  }
  const std::string at = place + "/WEIGHTS_" + std::to_string(reading.sets[0].number);
  if (reading.withoutWeights > 0) {
    notes.push_back({Note::Severity::warning, at,
                     std::to_string(reading.withoutWeights) + " vertices have none: they follow their first joint"});
  }
  if (reading.normalised > 0) {
    notes.push_back({Note::Severity::info, at,
                     "those of " + std::to_string(reading.normalised) + " vertices do not add up to 1: normalised"});
  }
}

// Rows of `from` entries, of which `to` are used, moved together.
void tighten(std::vector<scene::Influence>& influences, size_t from, size_t to) {
  if (from == to) return;
  const size_t rows = influences.size() / from;
  for (size_t row = 0; row < rows; ++row) {
    std::copy_n(influences.begin() + static_cast<std::ptrdiff_t>(row * from), to,
                influences.begin() + static_cast<std::ptrdiff_t>(row * to));
  }
  influences.resize(rows * to);
  influences.shrink_to_fit();
}

Reading readSets(const Document& doc, const tinygltf::Primitive& from, const DracoGeometry& draco,
                 const std::string& place, Notes& notes) {
  Reading reading;
  for (const auto& [n, set] : setsOf(from)) {
    const std::string joints = "JOINTS_" + std::to_string(n), weights = "WEIGHTS_" + std::to_string(n);
    if (!set.complete()) {
      notes.push_back({Note::Severity::warning, place + "/" + (set.joints != -1 ? joints : weights),
                       "there is no " + (set.joints != -1 ? weights : joints) + ": ignored"});
      continue;
    }
    SetData data;
    data.number = n;
    data.joints = readSet(doc, draco, joints, set.joints, false);
    // Integers without "normalized" are a writer's slip.
    data.weights = readSet(doc, draco, weights, set.weights, true);
    const auto& accessor = accessorAt(doc, set.joints);
    if (accessor.normalized) {
      data.jointScale = accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ? 255.0f : 65535.0f;
    }
    reading.tolerance += sumTolerance(accessorAt(doc, set.weights).componentType);
    reading.sets.push_back(std::move(data));
  }
  return reading;
}

}  // namespace

std::vector<JointLimit> jointLimits(const Document& doc) {
  std::vector<JointLimit> limits(doc.gltf.meshes.size());
  for (const scene::Node& node : doc.model.nodes) {
    if (node.mesh < 0 || node.skin < 0) continue;
    JointLimit& limit = limits[static_cast<size_t>(node.mesh)];
    const size_t joints = doc.model.skins[static_cast<size_t>(node.skin)].joints.size();
    if (limit.skin == -1 || joints < limit.joints) limit = {node.skin, joints};
  }
  return limits;
}

Result<void> checkInfluences(const Document& doc, const tinygltf::Primitive& primitive, const std::string& place) {
  for (const auto& [n, set] : setsOf(primitive)) {
    if (!set.complete()) continue;
    const std::string at = place + "/attributes/";
    if (!isVector4(accessorAt(doc, set.joints), false)) {
      return doc.error(at + "JOINTS_" + std::to_string(n), "is not a vector of 4 unsigned bytes or shorts");
    }
    if (!isVector4(accessorAt(doc, set.weights), true)) {
      return doc.error(at + "WEIGHTS_" + std::to_string(n), "is not a vector of 4 floats, unsigned bytes or shorts");
    }
  }
  return {};
}

uint64_t influenceBytes(const Document& doc, const tinygltf::Primitive& primitive, const JointLimit& limit) {
  if (limit.skin == -1) return 0;
  uint64_t bytes = 0;
  for (const auto& [n, set] : setsOf(primitive)) {
    if (set.complete()) bytes += accessorAt(doc, set.joints).count * uint64_t{4} * sizeof(scene::Influence);
  }
  return bytes == 0 ? 0 : bytes + limit.joints * sizeof(scene::Bounds);
}

void appendInfluenceNames(const tinygltf::Primitive& primitive, std::vector<const char*>& names) {
  for (const auto& [name, accessor] : primitive.attributes) {
    if (setNumber(name, "JOINTS_") >= 0 || setNumber(name, "WEIGHTS_") >= 0) names.push_back(name.c_str());
  }
}

Result<void> readInfluences(const Document& doc, const tinygltf::Primitive& from, const DracoGeometry& draco,
                            const std::string& place, const JointLimit& limit, scene::Primitive& primitive,
                            Notes& notes) {
  if (limit.skin == -1) return {};
  const std::string at = place + "/attributes";
  Reading reading = readSets(doc, from, draco, at, notes);
  if (reading.sets.empty()) return {};
  const size_t vertices = primitive.positions.size(), room = 4 * reading.sets.size();
  auto& influences = primitive.influences;
  influences.resize(vertices * room);
  size_t largest = 1;
  std::vector<Share> shares;
  for (size_t v = 0; v < vertices; ++v) {
    gather(reading, v, limit.joints, shares);
    for (size_t i = 0; i < shares.size(); ++i) {
      const auto weight = static_cast<float>(shares[i].weight);
      if (weight == 0) break;  // too small; so are those that follow
      if (shares[i].joint >= limit.joints) {
        return doc.error(at, "vertex " + std::to_string(v) + " follows joint " + std::to_string(shares[i].joint) +
                                 ", but skin " + std::to_string(limit.skin) + " has " + std::to_string(limit.joints) +
                                 " joints");
      }
      influences[v * room + i] = {shares[i].joint, weight};
      largest = std::max(largest, i + 1);
    }
  }
  tighten(influences, room, largest);
  primitive.influencesPerVertex = static_cast<int>(largest);
  noteRepairs(reading, at, notes);
  return {};
}

}  // namespace facet::io
