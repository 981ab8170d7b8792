#include "frame/gpu_scene.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>
#include <functional>
#include <numeric>

#include "frame/choose.hpp"
#include "frame/gpu_texture.hpp"
#include "frame/settings.hpp"
#include "optics/alpha_mask.hpp"
#include "scene/tangents.hpp"

namespace facet::frame {

namespace {

using scene::Primitive;
using scene::TextureSlot;
using scene::Topology;

GLenum drawMode(Topology topology) {
  switch (topology) {
    case Topology::points:
      return GL_POINTS;
    case Topology::lines:
      return GL_LINES;
    case Topology::lineLoop:
      return GL_LINE_LOOP;
    case Topology::lineStrip:
      return GL_LINE_STRIP;
    case Topology::triangles:
      return GL_TRIANGLES;
    case Topology::triangleStrip:
      return GL_TRIANGLE_STRIP;
    case Topology::triangleFan:
      return GL_TRIANGLE_FAN;
  }
  return GL_TRIANGLES;
}

void attach(GpuPrimitive& gpu, const PendingBuffer& wanted, gl::Buffer buffer) {
  const GLuint id = gpu.buffers.emplace_back(std::move(buffer)).id();
  if (wanted.indices)
    glVertexArrayElementBuffer(gpu.vertexArray.id(), id);
  else
    glVertexArrayVertexBuffer(gpu.vertexArray.id(), wanted.location, id, 0, wanted.stride);
}

// What is large waits for uploadPieces.
void addBuffer(GpuPrimitive& gpu, const PendingBuffer& wanted) {
  if (wanted.rest.size() > uploadPiece)
    gpu.pending.push_back(wanted);
  else
    attach(gpu, wanted, gl::Buffer(wanted.rest, wanted.label));
}

template <class T>
void addAttribute(GpuPrimitive& gpu, GLuint location, GLint components, const std::vector<T>& data, const char* label) {
  addBuffer(gpu, {.location = location, .stride = sizeof(T), .label = label, .rest = std::as_bytes(std::span(data))});
  const GLuint vao = gpu.vertexArray.id();
  glVertexArrayAttribFormat(vao, location, components, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayAttribBinding(vao, location, location);
  glEnableVertexArrayAttrib(vao, location);
}

// 16-bit indices where they suffice.
void addIndices(GpuPrimitive& gpu, const Primitive& primitive) {
  if (primitive.indices.empty()) {
    gpu.count = static_cast<GLsizei>(primitive.positions.size());
    return;
  }
  gpu.count = static_cast<GLsizei>(primitive.indices.size());
  PendingBuffer buffer = {.indices = true, .label = "indices"};
  if (primitive.positions.size() <= 65535) {
    const std::vector<uint16_t> narrow(primitive.indices.begin(), primitive.indices.end());
    gpu.indexType = GL_UNSIGNED_SHORT;
    attach(gpu, buffer, gl::Buffer::of(narrow, buffer.label));
  } else {
    gpu.indexType = GL_UNSIGNED_INT;
    buffer.rest = std::as_bytes(std::span(primitive.indices));
    addBuffer(gpu, buffer);
  }
}

// Influences per vertex, then joint and bits of the weight.
gl::Buffer uploadInfluences(const Primitive& primitive) {
  std::vector<uint32_t> words = {static_cast<uint32_t>(primitive.influencesPerVertex)};
  words.reserve(1 + 2 * primitive.influences.size());
  for (const scene::Influence& influence : primitive.influences) {
    words.push_back(influence.joint);
    words.push_back(std::bit_cast<uint32_t>(influence.weight));
  }
  return gl::Buffer::of(words, "influences");
}

// As shaders/deformation.glsl reads it; what a target leaves out is zero.
gl::Buffer uploadMorphTargets(const Primitive& primitive, const shading::VariantKey& key) {
  using shading::Feature;
  const auto has = [&](Feature feature) { return shading::usesFeature(key, feature); };
  const bool normals = has(Feature::morphedNormals), anyTangents = has(Feature::morphedTangents);
  const bool tangents = anyTangents && has(Feature::tangents), coat = anyTangents && has(Feature::coatTangents),
             grain = anyTangents && has(Feature::grainTangents), colors = has(Feature::morphedColors);
  uint32_t stride = 3;
  const auto placeOf = [&](bool there, uint32_t numbers) {
    const uint32_t at = stride;
    stride += there ? numbers : 0;
    return at;
  };
  std::vector<uint32_t> head = {static_cast<uint32_t>(primitive.positions.size()), 0};
  for (const bool there : {normals, tangents, coat, grain}) head.push_back(placeOf(there, 3));
  head.push_back(placeOf(colors, 4));
  std::vector<size_t> sets;
  for (size_t set = 0; set < primitive.texCoords.size(); ++set) {
    const auto changes = [&](const scene::MorphTarget& target) { return !target.texCoords[set].empty(); };
    const bool there = has(Feature::morphedTexCoords) && has(shading::texCoordFeature(static_cast<int>(set))) &&
                       std::ranges::any_of(primitive.targets, changes);
    if (there) sets.push_back(set);
    head.push_back(there ? placeOf(true, 2) : 0);
  }
  head[1] = stride;
  std::vector<float> numbers;
  numbers.reserve(head.size() + primitive.targets.size() * primitive.positions.size() * stride);
  for (const uint32_t word : head) numbers.push_back(std::bit_cast<float>(word));
  const auto add = [&](const auto& values, size_t vertex, int components) {
    for (int c = 0; c < components; ++c) numbers.push_back(values.empty() ? 0.0f : values[vertex][c]);
  };
  for (const scene::MorphTarget& target : primitive.targets)
    for (size_t vertex = 0; vertex < primitive.positions.size(); ++vertex) {
      add(target.positions, vertex, 3);
      if (normals) add(target.normals, vertex, 3);
      if (tangents) add(target.tangents, vertex, 3);
      if (coat) add(target.coatTangents, vertex, 3);
      if (grain) add(target.grainTangents, vertex, 3);
      if (colors) add(target.colors, vertex, 4);
      for (const size_t set : sets) add(target.texCoords[set], vertex, 2);
    }
  return gl::Buffer::of(numbers, "morph targets");
}

// The model's arrays must stay until nothing is pending.
GpuPrimitive beginPrimitive(const Primitive& primitive, const shading::VariantKey& key) {
  GpuPrimitive gpu;
  gpu.attributes = shading::attributeBits(key);
  gpu.mode = drawMode(primitive.topology);
  addAttribute(gpu, layout::positionLocation, 3, primitive.positions, "positions");
  if (shading::usesFeature(key, shading::Feature::normals))
    addAttribute(gpu, layout::normalLocation, 3, primitive.normals, "normals");
  if (shading::usesFeature(key, shading::Feature::tangents))
    addAttribute(gpu, layout::tangentLocation, 4, primitive.tangents, "tangents");
  if (shading::usesFeature(key, shading::Feature::coatTangents))
    addAttribute(gpu, layout::coatTangentLocation, 4, primitive.coatTangents, "tangents of the coat");
  if (shading::usesFeature(key, shading::Feature::grainTangents))
    addAttribute(gpu, layout::grainTangentLocation, 4, primitive.grainTangents, "tangents of the grain");
  for (int set = 0; set < scene::maxTexCoordSets; ++set)
    if (shading::usesFeature(key, shading::texCoordFeature(set)))
      addAttribute(gpu, static_cast<GLuint>(layout::texCoordLocation + set), 2,
                   primitive.texCoords[static_cast<size_t>(set)], "texture coordinates");
  if (shading::usesFeature(key, shading::Feature::vertexColors))
    addAttribute(gpu, layout::colorLocation, 4, primitive.colors, "vertex colours");
  if (shading::usesFeature(key, shading::Feature::skin)) gpu.influences = uploadInfluences(primitive);
  if (shading::usesFeature(key, shading::Feature::morphTargets)) gpu.morphTargets = uploadMorphTargets(primitive, key);
  addIndices(gpu, primitive);
  return gpu;
}

// True where all of it is there.
bool uploadPieces(GpuPrimitive& gpu, const KeepGoing& keepGoing) {
  while (!gpu.pending.empty()) {
    if (keepGoing && !keepGoing()) return false;
    PendingBuffer& next = gpu.pending.back();
    if (!next.begun) {  // by itself: software has to clear its memory
      attach(gpu, next, gl::Buffer(next.rest.size(), next.label, true));
      next.begun = true;
      continue;
    }
    const gl::Buffer& buffer = gpu.buffers.back();
    const std::span<const std::byte> piece = next.rest.first(std::min(uploadPiece, next.rest.size()));
    buffer.update(piece, buffer.bytes() - next.rest.size());
    next.rest = next.rest.subspan(piece.size());
    if (next.rest.empty()) gpu.pending.pop_back();
  }
  return true;
}

// Its geometry, where attributes of it are missing. True where all of it is there.
bool uploadPrimitive(GpuScene& gpu, const Draw& draw, const KeepGoing& keepGoing) {
  const auto found = gpu.primitives.find(draw.primitive);
  const shading::FeatureBits held = found == gpu.primitives.end() ? 0 : found->second.attributes;
  const shading::FeatureBits wanted = shading::attributeBits(draw.key);
  if (found != gpu.primitives.end() && (wanted & ~held) == 0) return true;
  std::optional<PrimitiveUpload>& upload = gpu.primitiveUpload;
  if (upload && (upload->primitive != draw.primitive || (wanted & ~upload->gpu.attributes) != 0)) upload.reset();
  if (!upload) {
    if (keepGoing && !keepGoing()) return false;
    upload = {draw.primitive, beginPrimitive(*draw.primitive, {held | draw.key.features, 0, 0})};
  }
  if (!uploadPieces(upload->gpu, keepGoing)) return false;
  gpu.primitives.insert_or_assign(draw.primitive, std::move(upload->gpu));
  upload.reset();
  return true;
}

void forEachDraw(const DrawList& list, const std::function<void(const Draw&)>& visit) {
  for (const std::vector<Draw>* draws : list.classes())
    for (const Draw& draw : *draws) visit(draw);
}

constexpr uint8_t alphaChannel = 8;

TextureUse useOf(const scene::Model& model, const scene::Material& material, TextureSlot slot, float maskThreshold) {
  const scene::TexelUse texels = scene::texelUse(material, slot);
  const scene::Texture& texture = model.textures[static_cast<size_t>(textureRef(material, slot).texture)];
  return {texture.image, texels.srgb, texels.channels, slot == TextureSlot::baseColor ? maskThreshold : 0};
}

// What is stored for one use serves the other.
bool serves(const TextureUse& stored, const TextureUse& use) {
  return stored.image == use.image && stored.srgb == use.srgb && (stored.channels & use.channels) == use.channels &&
         (stored.mask == use.mask || (use.channels & alphaChannel) == 0);
}

const gl::Texture* findTexture(const GpuScene& gpu, const TextureUse& use) {
  for (auto it = gpu.textures.lower_bound({use.image, use.srgb, 0}); it != gpu.textures.end(); ++it) {
    if (it->first.image != use.image || it->first.srgb != use.srgb) break;
    if (serves(it->first, use)) return &it->second;
  }
  return nullptr;
}

GLuint samplerFor(const GpuScene& gpu, const scene::Sampler& sampler) {
  for (const auto& [key, object] : gpu.samplers)
    if (key == sampler) return object.id();
  return 0;
}

GLint wrapMode(scene::Wrap wrap) {
  switch (wrap) {
    case scene::Wrap::repeat:
      return GL_REPEAT;
    case scene::Wrap::mirroredRepeat:
      return GL_MIRRORED_REPEAT;
    case scene::Wrap::clampToEdge:
      return GL_CLAMP_TO_EDGE;
  }
  return GL_REPEAT;
}

gl::Sampler createSampler(const scene::Sampler& sampler) {
  using scene::Filter;
  using scene::MipFilter;
  gl::Sampler object = gl::Sampler::create();
  const GLuint id = object.id();
  const bool linear = sampler.minFilter == Filter::linear;
  GLint minFilter = linear ? GL_LINEAR : GL_NEAREST;
  if (sampler.mipFilter == MipFilter::nearest)
    minFilter = linear ? GL_LINEAR_MIPMAP_NEAREST : GL_NEAREST_MIPMAP_NEAREST;
  if (sampler.mipFilter == MipFilter::linear) minFilter = linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_LINEAR;
  glSamplerParameteri(id, GL_TEXTURE_MIN_FILTER, minFilter);
  glSamplerParameteri(id, GL_TEXTURE_MAG_FILTER, sampler.magFilter == Filter::linear ? GL_LINEAR : GL_NEAREST);
  glSamplerParameteri(id, GL_TEXTURE_WRAP_S, wrapMode(sampler.wrapS));
  glSamplerParameteri(id, GL_TEXTURE_WRAP_T, wrapMode(sampler.wrapT));
  return object;
}

bool needsMips(const scene::Model& model, int image) {
  return std::ranges::any_of(model.textures, [&](const scene::Texture& texture) {
    return texture.image == image && texture.sampler.mipFilter != scene::MipFilter::none;
  });
}

// Of a footprint, longer over shorter axis, that slanted textures are read for.
constexpr float mostStretch = 8;
// Any other filter is a wish for exactly that filter.
bool isTrilinear(const scene::Sampler& sampler) {
  return sampler.magFilter == scene::Filter::linear && sampler.minFilter == scene::Filter::linear &&
         sampler.mipFilter == scene::MipFilter::linear;
}

layout::SlotUniforms slotUniforms(const scene::TextureRef& ref) {
  const glm::dmat2x3 rows = glm::transpose(scene::uvFromTexCoord(ref.transform));
  return {glm::vec3(rows[0]), static_cast<float>(ref.texCoord), glm::vec3(rows[1]), 1};
}

}  // namespace

layout::MaterialUniforms materialUniforms(const scene::Material& m) {
  layout::MaterialUniforms out{};
#define COPIED(type, name) out.name = m.name;
#define MADE(type, name)
#define UNUSED(name)
#include "material_members.inc"
#undef COPIED
#undef MADE
#undef UNUSED
  out.emission = m.emissiveFactor * m.emissiveStrength;
  out.inverseAttenuationDistance = std::isfinite(m.attenuationDistance) ? 1 / m.attenuationDistance : 0.0f;
  out.anisotropyDirection = {std::cos(m.anisotropyRotation), std::sin(m.anisotropyRotation)};
#define TEXTURE_SLOT(name, ...) out.name##Slot = slotUniforms(m.name);
#include "texture_slots.inc"
#undef TEXTURE_SLOT
  return out;
}

namespace {

void setStretch(layout::MaterialUniforms& uniforms, const scene::Material& m, const scene::Model& model) {
  const auto stretchOf = [&](const scene::TextureRef& ref) {
    return ref && isTrilinear(model.textures[static_cast<size_t>(ref.texture)].sampler) ? mostStretch : 1.0f;
  };
#define TEXTURE_SLOT(name, ...) uniforms.name##Slot.mostStretch = stretchOf(m.name);
#include "texture_slots.inc"
#undef TEXTURE_SLOT
}

void uploadMaterials(GpuScene& gpu, const scene::Model& model, const DrawList& list) {
  GLint alignment = 256;
  glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
  const size_t step = static_cast<size_t>(alignment);
  gpu.materialStride = (sizeof(layout::MaterialUniforms) + step - 1) / step * step;
  std::vector<std::byte> bytes(gpu.materialStride * list.materials.size());
  for (size_t i = 0; i < list.materials.size(); ++i) {
    layout::MaterialUniforms uniforms = materialUniforms(list.materials[i]);
    setStretch(uniforms, list.materials[i], model);
    uniforms.index = static_cast<float>(i);
    if (const float threshold = list.maskThresholds[i]; threshold > 0)
      uniforms.maskPivot = static_cast<float>(optics::maskPivot(static_cast<double>(threshold)));
    std::memcpy(bytes.data() + i * gpu.materialStride, &uniforms, sizeof uniforms);
  }
  gpu.materials = gl::Buffer(bytes, "materials");
}

}  // namespace

size_t GpuScene::textureBytes() const {
  return std::accumulate(textures.begin(), textures.end(), size_t{0},
                         [](size_t sum, const auto& entry) { return sum + entry.second.bytes(); });
}

size_t GpuScene::geometryBytes() const {
  size_t sum = instances.bytes() + joints.bytes();
  for (const auto& entry : primitives) {
    for (const gl::Buffer& buffer : entry.second.buffers) sum += buffer.bytes();
    sum += entry.second.influences.bytes() + entry.second.morphTargets.bytes();
  }
  return sum;
}

std::vector<TextureUse> textureUses(const scene::Model& model, const DrawList& list) {
  std::map<std::tuple<int, bool, float>, uint8_t> channels;  // by image, curve and mask
  forEachDraw(list, [&](const Draw& draw) {
    const scene::Material& material = list.materials[static_cast<size_t>(draw.material)];
    for (const TextureSlot slot : scene::textureSlots) {
      if (!shading::samplesSlot({material, *draw.primitive, list.features}, slot)) continue;
      const TextureUse use = useOf(model, material, slot, list.maskThresholds[static_cast<size_t>(draw.material)]);
      if (use.image < 0) continue;
      uint8_t& all = channels[{use.image, use.srgb, use.mask}];
      all = static_cast<uint8_t>(all | use.channels);
    }
  });
  std::vector<TextureUse> uses;
  for (const auto& [key, all] : channels) uses.push_back({std::get<0>(key), std::get<1>(key), all, std::get<2>(key)});
  // Colour alone is read from what a mask stores.
  std::erase_if(uses, [uses](const TextureUse& use) {
    return std::ranges::any_of(uses, [&](const TextureUse& other) { return other != use && serves(other, use); });
  });
  return uses;
}

std::vector<bool> missingImages(const scene::Model& model, const DrawList& list, const GpuScene& gpu) {
  return missingImages(model, textureUses(model, list), gpu);
}

std::vector<bool> missingImages(const scene::Model& model, const std::vector<TextureUse>& uses, const GpuScene& gpu) {
  std::vector<bool> missing(model.images.size(), false);
  for (const TextureUse& use : uses)
    if (!findTexture(gpu, use)) missing[static_cast<size_t>(use.image)] = true;
  return missing;
}

bool isOnGpu(const scene::Model& model, const DrawList& part, const GpuScene& gpu) {
  if (std::ranges::any_of(missingImages(model, part, gpu), std::identity())) return false;
  return std::ranges::all_of(part.opaque, [&](const Draw& draw) {
    const auto found = gpu.primitives.find(draw.primitive);
    return found != gpu.primitives.end() && (shading::attributeBits(draw.key) & ~found->second.attributes) == 0;
  });
}

bool uploadScene(GpuScene& gpu, const scene::Model& model, const DrawList& list, const KeepGoing& keepGoing) {
  bool whole = true;
  if (!list.features.paths)  // rays meet triangles of their own
    forEachDraw(list, [&](const Draw& draw) { whole = whole && uploadPrimitive(gpu, draw, keepGoing); });
  if (!whole) return false;
  if (!gpu.placeholder)
    gpu.placeholder = uploadTexture(io::placeholderImage(), {.image = -1, .srgb = true, .channels = 0b0111}, true);
  for (const scene::Texture& texture : model.textures)
    if (samplerFor(gpu, texture.sampler) == 0)
      gpu.samplers.emplace_back(texture.sampler, createSampler(texture.sampler));
  uploadMaterials(gpu, model, list);
  gpu.instances = gl::Buffer::of(list.instances, "instances");
  if (!list.joints.empty()) gpu.joints = gl::Buffer::of(list.joints, "joints");
  if (!list.morphWeights.empty()) gpu.morphWeights = gl::Buffer::of(list.morphWeights, "morph weights");
  gpu.lights = gl::Buffer::of(list.lights, "lights");
  gpu.profiles = list.profileNumbers.empty() ? gl::Buffer() : gl::Buffer::of(list.profileNumbers, "light profiles");
  return true;
}

bool uploadImages(GpuScene& gpu, const scene::Model& model, const std::vector<TextureUse>& uses,
                  std::vector<io::Pixels>& pixels, const KeepGoing& keepGoing) {
  const auto byImage = [](const TextureUse& use) { return use.image; };
  for (size_t image = 0; image < pixels.size(); ++image) {
    if (pixels[image].width == 0) continue;
    const int number = static_cast<int>(image);
    for (auto at = std::ranges::lower_bound(uses, number, {}, byImage); at != uses.end() && at->image == number; ++at) {
      const TextureUse& use = *at;
      if (findTexture(gpu, use)) continue;
      std::optional<TextureUpload>& upload = gpu.textureUpload;
      if (!upload || upload->use != use) {
        if (keepGoing && !keepGoing()) return false;
        upload = beginTexture(pixels[image], use, needsMips(model, use.image));
      }
      do {
        if (keepGoing && !keepGoing()) return false;
      } while (!continueTexture(*upload, pixels[image]));
      gpu.textures.emplace(use, std::move(upload->texture));
      upload.reset();
    }
    ++gpu.imagesDecoded;
    pixels[image] = {};
  }
  return true;
}

void setTextureDetail(const GpuScene& gpu, int draws, TextureFilter filter, const gl::ContextInfo& context) {
  const bool hardware = draws == 1 && chooseTextureFilter(filter, gl::drawsBySoftware()) == TextureFilter::hardware;
  // Of several draws each sees a share of the pixel, and averages none of it: two levels finer than its share, because
  // a level is chosen by the longer axis of what it sees, and blur is an error that all draws have in common (two of 48
  // x 48 pixels, 64 samples: 0.32 % for 0.84 % of white, 1.79 % for 1.96 %; three levels gain nothing more).
  const float bias = draws > 1 ? -0.5f * std::log2(static_cast<float>(draws)) - 2 : 0;
  for (const auto& [sampler, object] : gpu.samplers) {
    glSamplerParameterf(object.id(), GL_TEXTURE_LOD_BIAS, bias);
    if (isTrilinear(sampler))
      glSamplerParameterf(object.id(), GL_TEXTURE_MAX_ANISOTROPY_EXT,
                          hardware ? std::min(mostStretch, context.maxAnisotropy) : 1);
  }
}

BoundTexture boundTexture(const GpuScene& gpu, const scene::Model& model, const scene::Material& material,
                          TextureSlot slot, float maskThreshold) {
  const TextureUse use = useOf(model, material, slot, maskThreshold);
  const gl::Texture* texture = use.image >= 0 ? findTexture(gpu, use) : nullptr;
  for (auto it = gpu.textures.begin(); !texture && it != gpu.textures.end(); ++it)
    if (TextureUse other = use; other.mask = it->first.mask, serves(it->first, other)) texture = &it->second;
  const scene::Texture& source = model.textures[static_cast<size_t>(textureRef(material, slot).texture)];
  return {texture ? texture->id() : gpu.placeholder.id(), samplerFor(gpu, source.sampler)};
}

}  // namespace facet::frame
