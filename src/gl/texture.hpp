#pragma once

#include <string_view>

#include "gl/handle.hpp"

namespace facet::gl {

inline void destroyTexture(GLuint id) { glDeleteTextures(1, &id); }

struct TextureDescription {
  GLenum target = GL_TEXTURE_2D;  // 2D, 2D_ARRAY, 2D_MULTISAMPLE, CUBE_MAP, CUBE_MAP_ARRAY
  GLenum format = GL_RGBA8;       // sized internal format
  int width = 1, height = 1;
  int layers = 1;  // of arrays; cube map arrays: cubes
  int levels = 1;
  int samples = 0;  // multisample targets
};

// Immutable storage; filtering and wrapping are set through parameter() right after creation.
class Texture : public Handle<destroyTexture> {
 public:
  Texture() = default;
  Texture(const TextureDescription& description, std::string_view label);
  // A buffer as a texture of such texels; the buffer must outlive it.
  static Texture ofBuffer(GLuint buffer, GLenum format, std::string_view label);
  const TextureDescription& description() const { return description_; }
  void parameter(GLenum name, GLint value) const { glTextureParameteri(id(), name, value); }
  // Linear filtering (between levels too, where there are several), clamped to the edge.
  void filterLinear() const;
  void bind(GLuint unit) const { glBindTextureUnit(unit, id()); }
  size_t bytes() const;  // of the storage, by format

 private:
  TextureDescription description_;
};

int mipLevels(int width, int height);  // full chain

inline void destroyFramebuffer(GLuint id) { glDeleteFramebuffers(1, &id); }

class Framebuffer : public Handle<destroyFramebuffer> {
 public:
  Framebuffer() = default;
  explicit Framebuffer(std::string_view label);
  void attach(GLenum attachment, const Texture& texture) const {
    glNamedFramebufferTexture(id(), attachment, texture.id(), 0);
  }
};

}  // namespace facet::gl
