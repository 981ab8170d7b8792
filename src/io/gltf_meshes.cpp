#include <algorithm>
#include <atomic>
#include <bitset>
#include <cmath>

#include "base/parallel.hpp"
#include "io/accessors.hpp"
#include "io/gltf_deformation.hpp"
#include "io/gltf_document.hpp"
#include "io/gltf_draco.hpp"
#include "io/uri.hpp"
#include "io/vertex_repair.hpp"
#include "scene/usage.hpp"

namespace facet::io {

namespace {

using TexCoordSets = std::bitset<scene::maxTexCoordSets>;

struct Job {
  const tinygltf::Primitive* from = nullptr;
  std::string place;
  TexCoordSets sets = {};  // to read
  scene::Primitive primitive = {};
  DracoGeometry draco = {};
  Notes notes = {};
  std::optional<Error> error = {};
  JointLimit joints = {};
  size_t targets = 0;  // of the mesh

  void note(Note::Severity severity, std::string key, std::string text) {
    notes.push_back({severity, place + key, std::move(text)});
  }
};

// What each attribute that is read may look like.
struct AttributeRule {
  const char* name;
  int minComponents, maxComponents;
  int texCoordSet = -1;
};
constexpr AttributeRule attributeRules[] = {{"POSITION", 3, 3},      {"NORMAL", 3, 3},        {"TANGENT", 4, 4},
                                            {"COLOR_0", 3, 4},       {"TEXCOORD_0", 2, 2, 0}, {"TEXCOORD_1", 2, 2, 1},
                                            {"TEXCOORD_2", 2, 2, 2}, {"TEXCOORD_3", 2, 2, 3}, {"TEXCOORD_4", 2, 2, 4},
                                            {"TEXCOORD_5", 2, 2, 5}, {"TEXCOORD_6", 2, 2, 6}, {"TEXCOORD_7", 2, 2, 7}};

bool isRead(const AttributeRule& rule, const TexCoordSets& sets) {
  return rule.texCoordSet < 0 || sets[static_cast<size_t>(rule.texCoordSet)];
}

// Set 0, which the debug view of texture coordinates shows, and what the textures of the primitive's materials name.
// What is animated or edited may start at a factor of 0 and still be seen later.
TexCoordSets wantedSets(const Document& doc, const scene::Primitive& primitive) {
  const auto& used = doc.model.extensionsUsed;
  const bool changes =
      doc.limits.editable || std::find(used.begin(), used.end(), "KHR_animation_pointer") != used.end();
  TexCoordSets sets = 1;
  const auto addMaterial = [&](int index) {
    if (index < 0) return;
    const scene::Material& material = doc.model.materials[static_cast<size_t>(index)];
    for (const scene::TextureSlot slot : scene::textureSlots) {
      const scene::TextureRef& ref = textureRef(material, slot);
      if (ref && (changes || usesTexture(material, slot))) sets.set(static_cast<size_t>(ref.texCoord));
    }
  };
  addMaterial(primitive.material);
  for (const int material : primitive.variantMaterials) addMaterial(material);
  return sets;
}

int scalarOrVectorComponents(const Document& doc, int accessor) {
  const int type = doc.gltf.accessors[static_cast<size_t>(accessor)].type;
  return type <= TINYGLTF_TYPE_VEC4 || type == TINYGLTF_TYPE_SCALAR
             ? tinygltf::GetNumComponentsInType(static_cast<uint32_t>(type))
             : 0;  // matrices
}

size_t count(const Document& doc, int accessor) { return doc.gltf.accessors[static_cast<size_t>(accessor)].count; }

// Attributes of a primitive or of one of its morph targets: all exist and have as many elements as the positions.
Result<void> checkAttributes(const Document& doc, const std::map<std::string, int>& attributes, size_t vertexCount,
                             const std::string& place) {
  for (const auto& [name, accessor] : attributes) {
    const std::string at = place + "/" + name;
    if (auto ok = checkIndex(doc, accessor, doc.gltf.accessors.size(), at, "accessor"); !ok) return ok;
    if (count(doc, accessor) != vertexCount) {
      return doc.error(at, "has " + std::to_string(count(doc, accessor)) + " elements, but there are " +
                               std::to_string(vertexCount) + " positions");
    }
  }
  return {};
}

Result<void> checkTypes(const Document& doc, const tinygltf::Primitive& primitive, const std::string& place) {
  for (const auto& rule : attributeRules) {
    const auto found = primitive.attributes.find(rule.name);
    if (found == primitive.attributes.end()) continue;
    const int n = scalarOrVectorComponents(doc, found->second);
    if (n < rule.minComponents || n > rule.maxComponents) {
      return doc.error(place + "/attributes/" + rule.name,
                       "is not a vector of " + std::to_string(rule.minComponents) + " components");
    }
  }
  return {};
}

Result<void> checkIndices(const Document& doc, const tinygltf::Primitive& primitive, const std::string& place) {
  if (primitive.indices == -1) return {};
  const std::string at = place + "/indices";
  if (auto ok = checkIndex(doc, primitive.indices, doc.gltf.accessors.size(), at, "accessor"); !ok) return ok;
  const auto& accessor = doc.gltf.accessors[static_cast<size_t>(primitive.indices)];
  const int type = accessor.componentType;
  if (accessor.type != TINYGLTF_TYPE_SCALAR ||
      (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE && type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
       type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)) {
    return doc.error(at, "indices are not unsigned integers");
  }
  return {};
}

// Everything that can be said without reading vertices. Sets `use` to whether there is something to read.
Result<void> checkPrimitive(Document& doc, const tinygltf::Primitive& primitive, const std::string& place, bool& use) {
  use = false;
  if (primitive.mode < TINYGLTF_MODE_POINTS || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN) {
    return doc.error(place + "/mode", std::to_string(primitive.mode) + " is not a primitive mode");
  }
  const auto position = primitive.attributes.find("POSITION");
  if (position == primitive.attributes.end()) {
    doc.warning(place, "has no positions: not shown");
    return {};
  }
  const std::string at = place + "/attributes";
  if (auto ok = checkIndex(doc, position->second, doc.gltf.accessors.size(), at + "/POSITION", "accessor"); !ok)
    return ok;
  const size_t vertexCount = count(doc, position->second);
  if (auto ok = checkAttributes(doc, primitive.attributes, vertexCount, at); !ok) return ok;
  for (size_t i = 0; i < primitive.targets.size(); ++i) {
    if (auto ok = checkAttributes(doc, primitive.targets[i], vertexCount, pointer(place + "/targets", i)); !ok)
      return ok;
  }
  if (auto ok = checkTypes(doc, primitive, place); !ok) return ok;
  if (auto ok = checkInfluences(doc, primitive, place); !ok) return ok;
  if (auto ok = checkTargets(doc, primitive, place); !ok) return ok;
  if (auto ok = checkIndices(doc, primitive, place); !ok) return ok;
  if (isDraco(primitive)) {
    if (auto ok = checkDraco(doc, primitive, place); !ok) return ok;
  }
  use = vertexCount > 0 && (primitive.indices == -1 || count(doc, primitive.indices) > 0);
  if (!use) doc.info(place, "has no vertices: not shown");
  return {};
}

// -1, the default one, where it does not exist.
int materialOf(Document& doc, const tinygltf::Primitive& primitive, const std::string& place) {
  if (primitive.material == -1) return -1;
  const auto ok = checkIndex(doc, primitive.material, doc.gltf.materials.size(), place + "/material", "material");
  if (ok) return primitive.material;
  doc.lost(ok.error(), "the default one is used");
  return -1;
}

uint64_t decodedBytes(const Document& doc, const tinygltf::Primitive& primitive, const TexCoordSets& sets) {
  uint64_t bytes = primitive.indices == -1 ? 0 : count(doc, primitive.indices) * sizeof(uint32_t);
  for (const auto& rule : attributeRules) {
    const auto found = primitive.attributes.find(rule.name);
    if (found != primitive.attributes.end() && isRead(rule, sets)) {
      bytes += count(doc, found->second) * sizeof(float) * static_cast<uint64_t>(rule.maxComponents);
    }
  }
  return bytes;
}

// ---- Reading one primitive; runs on several threads, so it only writes to its job. ----

int attribute(const Job& job, const char* name) {
  const auto found = job.from->attributes.find(name);
  return found == job.from->attributes.end() ? -1 : found->second;
}

template <class V>
void readVectors(const Document& doc, const Job& job, const std::string& name, std::vector<V>& out, V initial,
                 bool alwaysNormalized = false) {
  const int accessor = attribute(job, name.c_str());
  if (accessor == -1) return;
  out.assign(count(doc, accessor), initial);
  const auto decoded = job.draco.attributes.find(name);
  if (decoded == job.draco.attributes.end()) {
    readFloats(doc, accessor, V::length(), &out.data()->x, alwaysNormalized);
  } else {
    const Elements from = decodedElements(doc, accessor, decoded->second);
    convertElements(from, from.normalized || alwaysNormalized, V::length(), &out.data()->x);
  }
}

template <class V>
bool isFinite(const V& v) {
  float sum = 0;  // NaN and Inf survive a product with zero
  for (int i = 0; i < V::length(); ++i) sum += v[i] * 0.0f;
  return sum == 0.0f;
}

// Replaces vectors that are not finite; returns how many.
template <class V>
size_t replaceNonFinite(std::vector<V>& vectors, V by) {
  size_t replaced = 0;
  for (V& v : vectors) {
    if (!isFinite(v)) v = by, ++replaced;
  }
  return replaced;
}

bool readPositions(const Document& doc, Job& job) {
  const int accessor = attribute(job, "POSITION");
  auto& primitive = job.primitive;
  readVectors(doc, job, "POSITION", primitive.positions, glm::vec3(0));
  glm::vec3 low(std::numeric_limits<float>::max()), high(-std::numeric_limits<float>::max());
  for (size_t i = 0; i < primitive.positions.size(); ++i) {
    const glm::vec3& p = primitive.positions[i];
    if (!isFinite(p)) {
      job.error = Error{doc.name, pointer("/accessors", static_cast<size_t>(accessor)),
                        "the position of vertex " + std::to_string(i) + " is not finite", "export the model again"};
      return false;
    }
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  primitive.bounds.add(low);
  primitive.bounds.add(high);
  return true;
}

bool readPrimitiveIndices(const Document& doc, Job& job) {
  if (job.from->indices == -1) return true;
  auto& indices = job.primitive.indices;
  indices = isDraco(*job.from) ? std::move(job.draco.indices) : readIndices(doc, job.from->indices);
  const size_t vertexCount = job.primitive.positions.size();
  uint32_t largest = 0;
  for (const uint32_t index : indices) largest = std::max(largest, index);
  if (largest < vertexCount) return true;
  size_t i = 0;
  while (indices[i] < vertexCount) ++i;
  job.error = Error{doc.name, job.place + "/indices",
                    "index " + std::to_string(i) + " is " + std::to_string(indices[i]) + ", but there are " +
                        std::to_string(vertexCount) + " vertices",
                    "export the model again"};
  return false;
}

void noteRepairs(Job& job, const char* key, const Repairs& repairs, const char* replacement) {
  if (repairs.replaced > 0) {
    job.note(Note::Severity::warning, key,
             std::to_string(repairs.replaced) + " are zero or not finite: replaced by " + replacement);
  }
  if (repairs.normalised > 0) {
    job.note(Note::Severity::info, key, std::to_string(repairs.normalised) + " were not of unit length: normalised");
  }
}

void readFrames(const Document& doc, Job& job) {
  auto& primitive = job.primitive;
  readVectors(doc, job, "NORMAL", primitive.normals, glm::vec3(0));
  noteRepairs(job, "/attributes/NORMAL", repairNormals(primitive), "those of the triangles");
  if (attribute(job, "TANGENT") == -1) return;
  if (primitive.normals.empty()) {
    job.note(Note::Severity::info, "/attributes/TANGENT", "there are no normals: ignored");
    return;
  }
  readVectors(doc, job, "TANGENT", primitive.tangents, glm::vec4(0));
  noteRepairs(job, "/attributes/TANGENT", repairTangents(primitive), "a perpendicular of the normal");
}

void readSurfaceData(const Document& doc, Job& job) {
  auto& primitive = job.primitive;
  for (size_t set = 0; set < job.sets.size(); ++set) {
    if (!job.sets[set]) continue;
    const std::string name = "TEXCOORD_" + std::to_string(set);
    auto& texCoords = primitive.texCoords[set];
    readVectors(doc, job, name, texCoords, glm::vec2(0));
    if (const size_t n = replaceNonFinite(texCoords, glm::vec2(0)); n > 0) {
      job.note(Note::Severity::warning, "/attributes/" + name, std::to_string(n) + " are not finite: replaced by zero");
    }
  }
  readVectors(doc, job, "COLOR_0", primitive.colors, glm::vec4(1), true);
  if (const size_t n = replaceNonFinite(primitive.colors, glm::vec4(1)); n > 0) {
    job.note(Note::Severity::warning, "/attributes/COLOR_0", std::to_string(n) + " are not finite: replaced by white");
  }
  // Where targets change them, the sum is (glTF 2.0, 3.7.2.2); the vertex stage does that.
  const auto changes = [](const auto& target) { return target.count("COLOR_0") > 0; };
  if (std::ranges::any_of(job.from->targets, changes)) return;
  size_t clamped = 0;
  for (glm::vec4& color : primitive.colors) {
    const glm::vec4 inRange = glm::clamp(color, 0.0f, 1.0f);
    clamped += inRange != color ? 1 : 0;
    color = inRange;
  }
  if (clamped > 0)
    job.note(Note::Severity::info, "/attributes/COLOR_0", std::to_string(clamped) + " are not within 0 to 1: clamped");
}

// False after an error.
bool decodeCompressed(const Document& doc, Job& job) {
  if (!isDraco(*job.from)) return true;
  std::vector<const char*> wanted;
  for (const auto& rule : attributeRules)
    if (isRead(rule, job.sets)) wanted.push_back(rule.name);
  if (job.joints.skin != -1) appendInfluenceNames(*job.from, wanted);
  auto geometry = decodeDraco(doc, *job.from, job.place, wanted);
  if (geometry) {
    job.draco = std::move(*geometry);
    // A strip's triangles come out one by one.
    job.primitive.topology = scene::Topology::triangles;
  } else {
    job.error = std::move(geometry.error());
  }
  return geometry.has_value();
}

void readPrimitive(const Document& doc, Job& job) {
  job.primitive.topology = static_cast<scene::Topology>(job.from->mode);
  if (!decodeCompressed(doc, job) || !readPositions(doc, job) || !readPrimitiveIndices(doc, job)) return;
  readFrames(doc, job);
  readSurfaceData(doc, job);
  readTargets(doc, *job.from, job.targets, job.place, job.primitive, job.notes);
  const auto ok = readInfluences(doc, *job.from, job.draco, job.place, job.joints, job.primitive, job.notes);
  if (!ok) job.error = ok.error();
  job.draco = {};
}

// Exceptions must not leave a thread.
void readPrimitiveSafely(const Document& doc, Job& job) {
  try {
    readPrimitive(doc, job);
  } catch (const std::exception&) {
    job.error = Error{doc.name, job.place, "there is not enough memory to read it", "use a smaller model"};
  }
}

static_assert(static_cast<int>(scene::Topology::triangleFan) == TINYGLTF_MODE_TRIANGLE_FAN);

// KHR_gaussian_splatting
void noteSplats(Document& doc) {
  size_t count = 0;
  std::string first;
  for (size_t m = 0; m < doc.gltf.meshes.size(); ++m)
    for (size_t p = 0; p < doc.gltf.meshes[m].primitives.size(); ++p) {
      if (!doc.gltf.meshes[m].primitives[p].extensions.contains("KHR_gaussian_splatting")) continue;
      if (count++ == 0) first = pointer(pointer("/meshes", m) + "/primitives", p);
    }
  if (count > 0)
    doc.warning(first, "its points, and those of " + std::to_string(count - 1) +
                           " more primitives, are Gaussian splats: they are shown as plain points, without size, turn, "
                           "opacity and the colours that depend on the view");
}

}  // namespace

Result<void> readMeshes(Document& doc) {
  noteSplats(doc);
  std::vector<Job> jobs;
  std::vector<size_t> meshOf;
  const std::vector<JointLimit> joints = jointLimits(doc);
  uint64_t bytes = 0;
  for (size_t m = 0; m < doc.gltf.meshes.size(); ++m) {
    const auto& mesh = doc.gltf.meshes[m];
    doc.model.meshes.emplace_back().name = mesh.name;
    if (auto ok = readMeshWeights(doc, m); !ok) return ok;
    const size_t targets = targetCount(mesh);
    for (size_t p = 0; p < mesh.primitives.size(); ++p) {
      std::string place = pointer(pointer("/meshes", m) + "/primitives", p);
      bool use = false;
      if (auto ok = checkPrimitive(doc, mesh.primitives[p], place, use); !ok) return ok;
      auto variants = variantMaterials(doc, mesh.primitives[p], place);
      if (!variants) {
        doc.lost(variants.error(), "shown without its variants");
        variants = std::vector<int>();
      }
      if (!use) continue;
      Job& job = jobs.emplace_back(Job{.from = &mesh.primitives[p], .place = std::move(place)});
      job.primitive.material = materialOf(doc, *job.from, job.place);
      job.primitive.variantMaterials = std::move(*variants);
      job.sets = wantedSets(doc, job.primitive);
      job.joints = joints[m];
      job.targets = targets;
      bytes += decodedBytes(doc, *job.from, job.sets) + influenceBytes(doc, *job.from, joints[m]) +
               targetBytes(doc, *job.from, job.targets);
      meshOf.push_back(m);
    }
  }
  if (bytes > doc.limits.geometryBytes) {
    return doc.error("/meshes",
                     "the geometry takes " + std::to_string(bytes) + " bytes, more than the limit of " +
                         std::to_string(doc.limits.geometryBytes),
                     "use a smaller model");
  }
  parallelFor(jobs.size(), [&](size_t i) { readPrimitiveSafely(doc, jobs[i]); });
  for (size_t i = 0; i < jobs.size(); ++i) {
    if (jobs[i].error) return tl::unexpected(*jobs[i].error);
    doc.notes.insert(doc.notes.end(), jobs[i].notes.begin(), jobs[i].notes.end());
    doc.model.meshes[meshOf[i]].primitives.push_back(std::move(jobs[i].primitive));
  }
  return {};
}

}  // namespace facet::io
