#include "frame/gpu_texture.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <utility>

#include "optics/alpha_mask.hpp"

namespace facet::frame {

namespace {

// Where the shader's red, green, blue, alpha come from in the decoded image: grey images repeat themselves.
std::array<int, 4> sourceChannels(int channels) {
  switch (channels) {
    case 1:
      return {0, 0, 0, -1};
    case 2:
      return {0, 0, 0, 1};
    case 3:
      return {0, 1, 2, -1};
    default:
      return {0, 1, 2, 3};
  }
}

struct Storage {
  std::vector<int> channels;  // of the image, in the order in which they are stored
  std::array<GLint, 4> swizzle = {GL_ZERO, GL_ZERO, GL_ZERO, GL_ONE};
};

Storage planStorage(const io::Pixels& pixels, const TextureUse& use) {
  constexpr GLint sources[] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA};
  Storage plan;
  const std::array<int, 4> from = sourceChannels(pixels.channels);
  for (int c = 0; c < 4; ++c) {
    const int source = from[static_cast<size_t>(c)];
    if (!(use.channels & (1 << c)) || source < 0) continue;
    size_t slot = 0;
    while (slot < plan.channels.size() && plan.channels[slot] != source) ++slot;
    if (slot == plan.channels.size()) plan.channels.push_back(source);
    plan.swizzle[static_cast<size_t>(c)] = sources[slot];
  }
  if (plan.channels.empty()) plan.channels = {from[0]};  // alpha of an image that has none: 1
  // sRGB exists for three and four channels only, and alpha stays outside the curve.
  if (use.srgb && plan.channels.size() < 3) {
    const bool alpha = (use.channels & 8) != 0 && from[3] >= 0;
    plan.channels = {from[0], from[1], from[2]};
    if (alpha) plan.channels.push_back(from[3]);
    plan.swizzle = {GL_RED, GL_GREEN, GL_BLUE, alpha ? GL_ALPHA : GL_ONE};
  }
  return plan;
}

GLenum internalFormat(size_t channels, bool srgb, bool wide) {
  if (srgb) return channels == 3 ? GL_SRGB8 : GL_SRGB8_ALPHA8;
  constexpr GLenum narrowFormats[] = {GL_R8, GL_RG8, GL_RGB8, GL_RGBA8};
  constexpr GLenum wideFormats[] = {GL_R16, GL_RG16, GL_RGB16, GL_RGBA16};
  return wide ? wideFormats[channels - 1] : narrowFormats[channels - 1];
}

// A mip level of the image as its file has it.
struct Level {
  int width = 0, height = 0;
  const uint8_t* data = nullptr;  // none: it is made from the level before
};

Level levelOf(const io::Pixels& pixels, int level) {
  const auto index = static_cast<size_t>(level);
  const uint8_t* data = level == 0                      ? pixels.data.data()
                        : index <= pixels.levels.size() ? pixels.levels[index - 1].data()
                                                        : nullptr;
  return {std::max(1, pixels.width >> level), std::max(1, pixels.height >> level), data};
}

// Those channels of so many texels, one after another; `stride` samples make a texel.
template <class Sample>
std::vector<uint8_t> repack(const uint8_t* data, size_t count, size_t stride, const std::vector<int>& channels,
                            bool narrow) {
  const auto* source = reinterpret_cast<const Sample*>(data);
  std::vector<uint8_t> out(count * channels.size() * (narrow ? 1 : sizeof(Sample)));
  for (size_t k = 0; k < channels.size(); ++k) {
    const auto channel = static_cast<size_t>(channels[k]);
    if (narrow) {
      for (size_t i = 0; i < count; ++i) {
        const Sample value = source[i * stride + channel];
        out[i * channels.size() + k] =
            static_cast<uint8_t>(sizeof(Sample) == 2 ? (value * 255u + 32767u) / 65535u : value);
      }
    } else {
      auto* target = reinterpret_cast<Sample*>(out.data());
      for (size_t i = 0; i < count; ++i) target[i * channels.size() + k] = source[i * stride + channel];
    }
  }
  return out;
}

bool isIdentity(const std::vector<int>& channels, int stored) {
  if (static_cast<int>(channels.size()) != stored) return false;
  for (size_t i = 0; i < channels.size(); ++i)
    if (channels[i] != static_cast<int>(i)) return false;
  return true;
}

GLenum formatOf(const TextureUpload& upload) {
  constexpr GLenum formats[] = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
  return formats[upload.channels.size() - 1];
}
GLenum typeOf(const TextureUpload& upload) { return upload.wide ? GL_UNSIGNED_SHORT : GL_UNSIGNED_BYTE; }

// The next rows of a level that the file has.
void uploadRows(TextureUpload& upload, const io::Pixels& pixels) {
  const Level level = levelOf(pixels, upload.level);
  const auto stride = static_cast<size_t>(pixels.channels);
  const size_t rowBytes = static_cast<size_t>(level.width) * stride * static_cast<size_t>(pixels.bytesPerSample);
  const int most = static_cast<int>(std::max<size_t>(1, uploadPiece / rowBytes));
  const int first = upload.rows, rows = std::min(most, level.height - first);
  const uint8_t* data = level.data + rowBytes * static_cast<size_t>(first);
  const size_t count = static_cast<size_t>(level.width) * static_cast<size_t>(rows);
  std::vector<uint8_t> packed;
  if (pixels.bytesPerSample == 2 && !upload.wide)
    packed = repack<uint16_t>(data, count, stride, upload.channels, true), data = packed.data();
  else if (!isIdentity(upload.channels, pixels.channels))
    packed = upload.wide ? repack<uint16_t>(data, count, stride, upload.channels, false)
                         : repack<uint8_t>(data, count, stride, upload.channels, false),
    data = packed.data();
  glTextureSubImage2D(upload.texture.id(), upload.level, 0, first, level.width, rows, formatOf(upload), typeOf(upload),
                      data);
  upload.rows += rows;
}

bool masks(const TextureUpload& upload) { return upload.use.mask > 0 && upload.channels.size() == 4 && !upload.wide; }

// The shares of the level's texels from `first` on into the alpha of as many.
void putMask(const TextureUpload& upload, size_t first, std::vector<uint8_t>& texels) {
  const double pivot = optics::maskPivot(static_cast<double>(upload.use.mask));
  for (size_t i = 0; i < texels.size() / 4; ++i) {
    const auto share = static_cast<double>(upload.mask.shares[first + i]);
    texels[4 * i + 3] = static_cast<uint8_t>(std::lround(255 * optics::maskAlpha(share, pivot)));
  }
}

// Those of a level of the file's.
void writeMask(const TextureUpload& upload) {
  std::vector<uint8_t> texels(4 * upload.mask.shares.size());
  const GLuint id = upload.texture.id();
  glGetTextureImage(id, upload.level, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(texels.size()), texels.data());
  putMask(upload, 0, texels);
  glTextureSubImage2D(id, upload.level, 0, 0, upload.mask.width, upload.mask.height, GL_RGBA, GL_UNSIGNED_BYTE,
                      texels.data());
}

MipSource sourceOf(const TextureUpload& upload, const io::Pixels& pixels) {
  const Level before = levelOf(pixels, upload.level - 1);
  MipSource source{.width = before.width, .height = before.height, .channels = upload.channels};
  source.srgb = upload.use.srgb;
  source.data = before.data, source.stride = pixels.channels, source.bytesPerSample = pixels.bytesPerSample;
  source.linear = &upload.before;
  return source;
}

// The next rows of a level that the file has not, from the level before.
void makeRows(TextureUpload& upload, const io::Pixels& pixels) {
  const Level level = levelOf(pixels, upload.level);
  const size_t channels = upload.channels.size(), rowTexels = static_cast<size_t>(level.width);
  if (upload.rows == 0)
    upload.made = {level.width, level.height,
                   std::vector<uint16_t>(rowTexels * static_cast<size_t>(level.height) * channels)};
  const int most = static_cast<int>(std::max<size_t>(1, uploadPiece / (rowTexels * channels)));
  const int first = upload.rows, rows = std::min(most, level.height - first);
  averageRows(sourceOf(upload, pixels), upload.made, first, rows);
  const TexelCode code = upload.use.srgb ? TexelCode::srgb8 : upload.wide ? TexelCode::unorm16 : TexelCode::unorm8;
  std::vector<uint8_t> stored = storedRows(upload.made, static_cast<int>(channels), code, first, rows);
  if (masks(upload)) putMask(upload, static_cast<size_t>(first) * rowTexels, stored);
  glTextureSubImage2D(upload.texture.id(), upload.level, 0, first, level.width, rows, formatOf(upload), typeOf(upload),
                      stored.data());
  upload.rows += rows;
  if (upload.rows == level.height) upload.before = std::move(upload.made);
}

}  // namespace

TextureUpload beginTexture(const io::Pixels& pixels, const TextureUse& use, bool mips) {
  assert(pixels.width > 0 && pixels.height > 0);
  const Storage plan = planStorage(pixels, use);
  TextureUpload upload;
  upload.use = use;
  upload.channels = plan.channels;
  upload.wide = pixels.bytesPerSample == 2 && !use.srgb;
  upload.texture = gl::Texture({.format = internalFormat(plan.channels.size(), use.srgb, upload.wide),
                                .width = pixels.width,
                                .height = pixels.height,
                                .levels = mips ? gl::mipLevels(pixels.width, pixels.height) : 1},
                               "image " + std::to_string(use.image));
  glTextureParameteriv(upload.texture.id(), GL_TEXTURE_SWIZZLE_RGBA, plan.swizzle.data());
  return upload;
}

bool continueTexture(TextureUpload& upload, const io::Pixels& pixels) {
  if (upload.rows == levelOf(pixels, upload.level).height) ++upload.level, upload.rows = 0;
  const Level level = levelOf(pixels, upload.level);
  if (upload.rows == 0 && upload.level > 0 && masks(upload))
    upload.mask =
        upload.level == 1 ? firstMaskLevel(pixels, upload.channels[3], upload.use.mask) : nextMaskLevel(upload.mask);
  level.data ? uploadRows(upload, pixels) : makeRows(upload, pixels);
  if (upload.rows < level.height) return false;
  if (upload.level > 0 && level.data && masks(upload)) writeMask(upload);
  return upload.level + 1 == upload.texture.description().levels;
}

gl::Texture uploadTexture(const io::Pixels& pixels, const TextureUse& use, bool mips) {
  TextureUpload upload = beginTexture(pixels, use, mips);
  while (!continueTexture(upload, pixels)) {
  }
  return std::move(upload.texture);
}

}  // namespace facet::frame
