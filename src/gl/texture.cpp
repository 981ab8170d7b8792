#include "gl/texture.hpp"

#include <algorithm>
#include <bit>
#include <cassert>

namespace facet::gl {

namespace {

GLuint createTexture(GLenum target) {
  GLuint id = 0;
  glCreateTextures(target, 1, &id);
  return id;
}

size_t bytesPerTexel(GLenum format) {
  switch (format) {
    case GL_R8:
      return 1;
    case GL_RG8:
      return 2;
    case GL_RGB8:
    case GL_SRGB8:
    case GL_RGBA8:
    case GL_SRGB8_ALPHA8:
    case GL_RG16F:
    case GL_R32F:
    case GL_DEPTH_COMPONENT32F:
    case GL_R11F_G11F_B10F:
      return 4;
    case GL_R16:
      return 2;
    case GL_RG16:
      return 4;
    case GL_RGB16:
    case GL_RGBA16:
    case GL_RGBA16F:
    case GL_RG32F:
      return 8;
    case GL_RGBA32F:
      return 16;
    default:
      assert(false && "unknown texture format");
      return 4;
  }
}

}  // namespace

int mipLevels(int width, int height) { return std::bit_width(static_cast<unsigned>(std::max(width, height))); }

Texture::Texture(const TextureDescription& d, std::string_view label)
    : Handle(createTexture(d.target)), description_(d) {
  if (d.target == GL_TEXTURE_2D_MULTISAMPLE)
    glTextureStorage2DMultisample(id(), d.samples, d.format, d.width, d.height, GL_TRUE);
  else if (d.target == GL_TEXTURE_CUBE_MAP_ARRAY)
    glTextureStorage3D(id(), d.levels, d.format, d.width, d.height, 6 * d.layers);
  else if (d.target == GL_TEXTURE_2D_ARRAY)
    glTextureStorage3D(id(), d.levels, d.format, d.width, d.height, d.layers);
  else
    glTextureStorage2D(id(), d.levels, d.format, d.width, d.height);
  glObjectLabel(GL_TEXTURE, id(), static_cast<GLsizei>(label.size()), label.data());
}

Texture Texture::ofBuffer(GLuint buffer, GLenum format, std::string_view label) {
  Texture texture;
  static_cast<Handle&>(texture) = Handle(createTexture(GL_TEXTURE_BUFFER));
  glTextureBuffer(texture.id(), format, buffer);
  glObjectLabel(GL_TEXTURE, texture.id(), static_cast<GLsizei>(label.size()), label.data());
  texture.description_ = {.target = GL_TEXTURE_BUFFER, .format = format};
  return texture;
}

void Texture::filterLinear() const {
  parameter(GL_TEXTURE_MIN_FILTER, description_.levels > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
  parameter(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  parameter(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  parameter(GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  parameter(GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
}

size_t Texture::bytes() const {
  size_t texels = 0;
  for (int level = 0; level < description_.levels; ++level)
    texels += static_cast<size_t>(std::max(1, description_.width >> level)) *
              static_cast<size_t>(std::max(1, description_.height >> level));
  const bool cube = description_.target == GL_TEXTURE_CUBE_MAP || description_.target == GL_TEXTURE_CUBE_MAP_ARRAY;
  return texels * bytesPerTexel(description_.format) * static_cast<size_t>(description_.layers) * (cube ? 6 : 1) *
         static_cast<size_t>(std::max(1, description_.samples));
}

Framebuffer::Framebuffer(std::string_view label) {
  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  static_cast<Handle&>(*this) = Handle(id);
  glObjectLabel(GL_FRAMEBUFFER, id, static_cast<GLsizei>(label.size()), label.data());
}

}  // namespace facet::gl
