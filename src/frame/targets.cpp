#include <algorithm>

#include "frame/frame.hpp"
#include "frame/gather.hpp"
#include "frame/settings.hpp"

namespace facet::frame {

namespace {

// Without the display picture.
Targets createDrawTargets(int width, int height, int samples, bool gather, GLenum format = GL_RGBA16F) {
  Targets t;
  t.width = width;
  t.height = height;
  t.samples = std::max(1, samples);
  const GLenum target = t.samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
  const int count = t.samples > 1 ? t.samples : 0;
  t.color = gl::Texture({.format = format, .width = width, .height = height}, "scene-linear");
  t.depth = gl::Texture(
      {.target = target, .format = GL_DEPTH_COMPONENT32F, .width = width, .height = height, .samples = count}, "depth");
  t.resolved = gl::Framebuffer("resolved");
  t.resolved.attach(GL_COLOR_ATTACHMENT0, t.color);
  t.drawn = gl::Framebuffer("drawn");
  if (t.samples > 1) {
    t.multisample = gl::Texture(
        {.target = target, .format = format, .width = width, .height = height, .samples = count}, "multisample");
    t.drawn.attach(GL_COLOR_ATTACHMENT0, t.multisample);
  } else {
    t.drawn.attach(GL_COLOR_ATTACHMENT0, t.color);
  }
  t.drawn.attach(GL_DEPTH_ATTACHMENT, t.depth);
  if (gather) {
    t.sum = gl::Texture({.format = GL_RGBA32F, .width = width, .height = height}, "gathered samples");
    t.gathered = gl::Framebuffer("gathered");
    t.gathered.attach(GL_COLOR_ATTACHMENT0, t.sum);
  }
  return t;
}

}  // namespace

Targets createTargets(int width, int height, int samples, bool gather, bool precise) {
  Targets t = createDrawTargets(width, height, samples, gather, precise ? GL_RGBA32F : GL_RGBA16F);
  t.display = gl::Texture({.format = GL_RGBA8, .width = width, .height = height}, "display");
  t.shown = gl::Framebuffer("shown");
  t.shown.attach(GL_COLOR_ATTACHMENT0, t.display);
  return t;
}

Targets createGatherTargets(int width, int height) {
  Targets t = createDrawTargets(width, height, 1, true);
  t.before = gl::Texture({.format = GL_RGBA32F, .width = width, .height = height}, "first samples");
  return t;
}

Targets createValueTargets(int width, int height, GLenum format) {
  Targets t;
  t.width = width, t.height = height;
  t.color = gl::Texture({.format = format, .width = width, .height = height}, "values");
  t.depth = gl::Texture({.format = GL_DEPTH_COMPONENT32F, .width = width, .height = height}, "depth of values");
  t.drawn = gl::Framebuffer("values");
  t.drawn.attach(GL_COLOR_ATTACHMENT0, t.color);
  t.drawn.attach(GL_DEPTH_ATTACHMENT, t.depth);
  return t;
}

void prepareComparison(Targets& targets, const DrawList& list) {
  if (!list.compared) targets.fitted = {}, targets.fittedGathered = {};
  if (!list.compared || targets.fitted) return;
  const GLenum format = targets.sum ? GL_RGBA32F : targets.color.description().format;
  targets.fitted =
      gl::Texture({.format = format, .width = targets.width, .height = targets.height}, "fitted model's picture");
  targets.fittedGathered = gl::Framebuffer("fitted model's picture");
  targets.fittedGathered.attach(GL_COLOR_ATTACHMENT0, targets.fitted);
}

namespace {

template <class T>
void flipRows(std::vector<T>& data, size_t rowLength) {
  const size_t rows = data.size() / rowLength;
  for (size_t y = 0; y < rows / 2; ++y)
    std::swap_ranges(data.begin() + static_cast<ptrdiff_t>(y * rowLength),
                     data.begin() + static_cast<ptrdiff_t>((y + 1) * rowLength),
                     data.begin() + static_cast<ptrdiff_t>((rows - 1 - y) * rowLength));
}

}  // namespace

size_t targetBytes(const Targets& targets) {
  size_t sum = 0;
  for (const gl::Texture* texture :
       {&targets.multisample, &targets.depth, &targets.color, &targets.sum, &targets.before, &targets.contrasts,
        &targets.fitted, &targets.display, &targets.behind.color, &targets.behind.depth})
    if (*texture) sum += texture->bytes();
  return sum;
}

namespace {

io::RadianceImage readPixels(const Targets& targets, const gl::Texture& source, float unit) {
  io::RadianceImage out;
  out.width = targets.width;
  out.height = targets.height;
  out.pixels.resize(static_cast<size_t>(targets.width) * static_cast<size_t>(targets.height));
  glGetTextureImage(source.id(), 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(out.pixels.size() * sizeof(glm::vec4)),
                    out.pixels.data());
  flipRows(out.pixels, static_cast<size_t>(targets.width));
  if (unit != 1)
    for (glm::vec4& p : out.pixels) p *= glm::vec4(glm::vec3(unit), 1);
  return out;
}

}  // namespace

io::RadianceImage readRadiance(const Targets& targets, float unit) {
  return readPixels(targets, targets.sum ? targets.sum : targets.color, unit);
}

io::RadianceImage readStandardError(const Targets& targets, int draws, float unit) {
  io::RadianceImage out = readPixels(targets, targets.contrasts, 1);
  int contrasts = 0;
  for (int done = 1; done < draws; done = nextEstimate(done, draws))
    contrasts += isContrast(nextEstimate(done, draws), draws) ? 1 : 0;
  const float factor = 1 / (static_cast<float>(std::max(contrasts, 1)) * static_cast<float>(draws));
  for (glm::vec4& p : out.pixels) p = glm::vec4(unit, unit, unit, 1) * glm::sqrt(p * factor);
  return out;
}

io::RadianceImage readFitted(const Targets& targets, float unit) { return readPixels(targets, targets.fitted, unit); }

io::Pixels readDisplay(const Targets& targets, bool withAlpha) {
  io::Pixels out;
  out.width = targets.width;
  out.height = targets.height;
  out.channels = withAlpha ? 4 : 3;
  out.bytesPerSample = targets.display.description().format == GL_RGBA16 ? 2 : 1;
  const size_t rowBytes = static_cast<size_t>(targets.width) * static_cast<size_t>(out.channels * out.bytesPerSample);
  out.data.resize(rowBytes * static_cast<size_t>(targets.height));
  glGetTextureImage(targets.display.id(), 0, withAlpha ? GL_RGBA : GL_RGB,
                    out.bytesPerSample == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_BYTE,
                    static_cast<GLsizei>(out.data.size()), out.data.data());
  flipRows(out.data, rowBytes);
  return out;
}

}  // namespace facet::frame
