#include "report/table_images.hpp"

#include <algorithm>
#include <cstdio>

#include "ibl/layers.hpp"
#include "ibl/tables.hpp"

namespace facet::report {

namespace {

// firstFace, faces: of cubes; one layer else.
io::RadianceImage readBack(const gl::Texture& texture, int level, int firstFace, int faces, float scale) {
  const int width = std::max(texture.description().width >> level, 1);
  const int height = std::max(texture.description().height >> level, 1);
  io::RadianceImage image{.width = width, .height = height * faces, .pixels = {}};
  image.pixels.resize(static_cast<size_t>(width) * static_cast<size_t>(image.height));
  glGetTextureSubImage(texture.id(), level, 0, 0, firstFace, width, height, faces, GL_RGBA, GL_FLOAT,
                       static_cast<GLsizei>(image.pixels.size() * sizeof(glm::vec4)), image.pixels.data());
  for (glm::vec4& pixel : image.pixels) pixel = glm::vec4(glm::vec3(pixel) * scale, 1);
  return image;
}

std::string layerName(double perceptualRoughness) {
  char text[16];
  std::snprintf(text, sizeof text, "ld-%.2f", perceptualRoughness);
  return text;
}

}  // namespace

Result<std::vector<TableImage>> tableImages(const scene::Environment& environment, shading::ProgramStore& programs) {
  ibl::Tables tables;
  const ibl::Needs all{.dfg = true, .irradiance = true, .layers = true, .cube = true, .sheen = true};
  if (Result<void> r = ibl::computeTables(tables, &environment, all, programs); !r) return tl::unexpected(r.error());
  const float scale = tables.radianceScale;
  const std::string half = "halves, a power of two of the map's as unit", single = "32-bit floats";
  std::vector<TableImage> images;
  images.push_back({"dfg",
                    "red A, green B of F0 A + F90 B, blue the sine of the lobe's mean direction over the mirror's; "
                    "columns (NoV)^(1/2), rows perceptual roughness, both from 0 to 1 at texel centres",
                    half, readBack(tables.dfg, 0, 0, 1, 1)});
  images.push_back(
      {"sheen",
       "red the sheen's directional albedo; columns (NoV)^(1/2), rows sheen roughness, both from 0 to 1 at "
       "texel centres",
       single, readBack(tables.sheen, 0, 0, 1, 1)});
  images.push_back(
      {"irradiance", "irradiance / pi, by normal; six faces", single, readBack(tables.irradiance, 0, 0, 6, scale)});
  for (const ibl::Layer& layer : ibl::layers)
    images.push_back(
        {layerName(layer.perceptualRoughness),
         "prefiltered radiance of that perceptual roughness, by mirror direction; six faces", half,
         readBack(layer.mirror ? tables.mirrorLayers : tables.roughLayers, layer.level, 6 * layer.cube, 6, scale)});
  images.push_back({"environment", "radiance, by direction; six faces", single, readBack(tables.cube, 0, 0, 6, scale)});
  return images;
}

Table tableImagesTable(const std::vector<TableImage>& images) {
  Table table{
      .name = "tables",
      .title = "Tables of the environment",
      .note =
          "As the shaders read them, linear Rec. 709; how wrong each is by which method: facet report light. Halves "
          "have "
          "11 bits, which drivers round towards zero. Six faces: +X, -X, +Y, -Y, +Z, -Z below each other, each as "
          "OpenGL has it.",
      .columns = {"file", "width", "height", "holds", "stored as"},
      .rows = {}};
  for (const TableImage& image : images)
    table.rows.push_back({image.name + ".exr", static_cast<double>(image.image.width),
                          static_cast<double>(image.image.height), image.holds, image.storedAs});
  return table;
}

}  // namespace facet::report
