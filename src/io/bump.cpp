#include "io/bump.hpp"

#include <cmath>
#include <cstring>

#include "io/safe_files.hpp"

namespace facet::io {

namespace {

// Sample c of a pixel, 0 ... 1.
float sampleAt(const Pixels& pixels, size_t pixel, size_t channel) {
  const size_t index = pixel * static_cast<size_t>(pixels.channels) + channel;
  if (pixels.bytesPerSample == 1) return static_cast<float>(pixels.data[index]) / 255.0f;
  uint16_t value = 0;
  std::memcpy(&value, pixels.data.data() + index * 2, 2);
  return static_cast<float>(value) / 65535.0f;
}

}  // namespace

Result<scene::HeightMap> readHeights(const std::string& file, double scale, const Limits& limits) {
  const auto bytes = readRegularFile(file, limits.fileBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  const Result<Pixels> pixels = decodeImage(bytes->span(), file, limits);
  if (!pixels) return tl::unexpected(pixels.error());
  scene::HeightMap map{pixels->width, pixels->height, {}};
  map.heights.resize(static_cast<size_t>(map.width) * static_cast<size_t>(map.height));
  for (size_t i = 0; i < map.heights.size(); ++i) {
    const float grey = sampleAt(*pixels, i, 0);
    if (pixels->channels >= 3 && (sampleAt(*pixels, i, 1) != grey || sampleAt(*pixels, i, 2) != grey)) {
      const size_t width = static_cast<size_t>(map.width);
      return fail(file, "pixel " + std::to_string(i % width) + "," + std::to_string(i / width),
                  "is not grey: a height map has one value for each pixel", "convert the picture to grey");
    }
    map.heights[i] = static_cast<float>(grey * scale);
  }
  return map;
}

Pixels encodeNormals(const scene::HeightMap& map, bool wrap) {
  Pixels pixels{.width = map.width, .height = map.height, .channels = 3, .bytesPerSample = 1, .data = {}};
  const std::vector<glm::vec3> normals = scene::normalsOf(map, wrap);
  pixels.data.reserve(normals.size() * 3);
  for (const glm::vec3& normal : normals)
    for (int c = 0; c < 3; ++c) pixels.data.push_back(static_cast<uint8_t>(std::lround((normal[c] + 1) * 127.5f)));
  return pixels;
}

Result<void> applyBump(scene::Model& model, const Bump& bump, const Limits& limits) {
  const Result<scene::HeightMap> map = readHeights(bump.file, bump.scale, limits);
  if (!map) return tl::unexpected(map.error());
  Result<std::vector<uint8_t>> png = encodePng(encodeNormals(*map, true), bump.file);
  if (!png) return tl::unexpected(png.error());
  scene::Image image;
  image.name = bump.file;
  image.encoded = std::move(*png);
  model.images.push_back(std::move(image));
  scene::Texture texture;
  texture.name = bump.file;
  texture.image = static_cast<int>(model.images.size()) - 1;
  model.textures.push_back(texture);
  for (scene::Material& material : model.materials)
    if (!material.normal) material.normal.texture = static_cast<int>(model.textures.size()) - 1;
  return {};
}

}  // namespace facet::io
