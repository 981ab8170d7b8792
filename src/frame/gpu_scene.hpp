#pragma once

// A draw list's data on the GPU: geometry, textures, samplers, materials. Grows on demand: what a draw list does not
// read is neither decoded nor uploaded.

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "frame/draw_list.hpp"
#include "frame/mask_levels.hpp"
#include "frame/mip_level.hpp"
#include "frame/settings_fwd.hpp"
#include "gl/buffer.hpp"
#include "gl/context.hpp"
#include "gl/texture.hpp"
#include "gl/vertex_array.hpp"
#include "io/image.hpp"

namespace facet::frame {

// What is larger goes on the GPU in pieces of so many bytes, between which the caller may do something else.
inline constexpr size_t uploadPiece = size_t{2} << 20;

// One of a primitive's buffers, from an array of the model's.
struct PendingBuffer {
  GLuint location = 0;  // of a vertex attribute
  bool indices = false;
  GLsizei stride = 0;
  const char* label = "";
  std::span<const std::byte> rest = {};  // that is not yet there
  bool begun = false;                    // it is the last one of GpuPrimitive::buffers
};

struct GpuPrimitive {
  gl::VertexArray vertexArray;
  std::vector<gl::Buffer> buffers;
  gl::Buffer influences, morphTargets;  // shaders/deformation.glsl; where a skin or weights deform it
  shading::FeatureBits attributes = 0;  // shading::attributeBits of what is present
  GLenum mode = GL_TRIANGLES;
  GLenum indexType = GL_NONE;  // GL_NONE: not indexed
  GLsizei count = 0;
  std::vector<PendingBuffer> pending;
};

// An image as one use of it needs it: which channels, and through the sRGB curve or not.
struct TextureUse {
  int image = -1;
  bool srgb = false;
  uint8_t channels = 0;  // bit 0 red .. bit 3 alpha
  float mask = 0;        // maskThreshold of the levels' alpha
  auto operator<=>(const TextureUse&) const = default;
};

// A texture that is not yet complete; frame/gpu_texture.hpp fills it.
struct TextureUpload {
  TextureUse use;
  gl::Texture texture;
  std::vector<int> channels;           // of the image, in the order in which they are stored
  bool wide = false;                   // 16 bits a channel
  int level = 0, rows = 0;             // the level that is being filled; its rows that are there
  MaskLevel mask = {};                 // of that level, where the use has one
  LinearLevel before = {}, made = {};  // the last level that was made, and the one that is being made
};

// A primitive that is not yet complete.
struct PrimitiveUpload {
  const scene::Primitive* primitive = nullptr;
  GpuPrimitive gpu;
};

struct GpuScene {
  std::map<const scene::Primitive*, GpuPrimitive> primitives;
  std::map<TextureUse, gl::Texture> textures;
  std::vector<std::pair<scene::Sampler, gl::Sampler>> samplers;
  gl::Texture placeholder;
  gl::Buffer materials, instances, lights, profiles, joints, morphWeights;
  size_t materialStride = 0;
  int imagesDecoded = 0;
  std::optional<PrimitiveUpload> primitiveUpload;  // the next one of primitives
  std::optional<TextureUpload> textureUpload;      // the next one of textures

  size_t textureBytes() const;
  size_t geometryBytes() const;
};

// As the shaders read it.
layout::MaterialUniforms materialUniforms(const scene::Material& material);

// The texture uses of the draw list's variants; where several slots read one image they share one texture. In
// the order of images.
std::vector<TextureUse> textureUses(const scene::Model& model, const DrawList& list);

// Images of the list, or of its texture uses, that the GPU does not hold yet: one entry per image of the model.
std::vector<bool> missingImages(const scene::Model& model, const DrawList& list, const GpuScene& gpu);
std::vector<bool> missingImages(const scene::Model& model, const std::vector<TextureUse>& uses, const GpuScene& gpu);

// Images and vertex attributes of a part (partOf) are there already.
bool isOnGpu(const scene::Model& model, const DrawList& part, const GpuScene& gpu);

// Asked before each object and each piece of a large one: false leaves the rest to the next call. Empty: all at once.
using KeepGoing = std::function<bool()>;

// Geometry that is missing, samplers, and all of the list's materials, instances, joints and lights. True where all of
// it is there.
bool uploadScene(GpuScene& gpu, const scene::Model& model, const DrawList& list, const KeepGoing& keepGoing = {});

// Pixels as io::decodeImages returned them for missingImages, or for some of those (moved from, so that each image's
// memory is freed as soon as it is on the GPU). uses: textureUses of the list. True where all of them are there.
bool uploadImages(GpuScene& gpu, const scene::Model& model, const std::vector<TextureUse>& uses,
                  std::vector<io::Pixels>& pixels, const KeepGoing& keepGoing = {});

// Where a pixel gathers several draws, textures are read at the size of one draw's share of it; the gathering then
// filters along the footprint, so that anisotropic filtering is left out.
void setTextureDetail(const GpuScene& gpu, int draws, TextureFilter filter, const gl::ContextInfo& context);
// Paths read the finest level, which no footprint has to stretch: software OpenGL would take minutes over one.
inline constexpr int tracedDraws = 4096;

// The texture and sampler names of a material's slot. maskThreshold: DrawList's; a texture of other smaller levels is
// given where there is no such.
struct BoundTexture {
  GLuint texture = 0, sampler = 0;
};
BoundTexture boundTexture(const GpuScene& gpu, const scene::Model& model, const scene::Material& material,
                          scene::TextureSlot slot, float maskThreshold = 0);

}  // namespace facet::frame
