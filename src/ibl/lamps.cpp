#include "ibl/lamps.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "ibl/layers.hpp"
#include "ibl/tables.hpp"
#include "optics/mapping.hpp"

namespace facet::ibl {

namespace {

constexpr double brightness = 2;     // of a lamp's texel, to the mean
constexpr double leastShare = 0.02;  // of the light
constexpr size_t pointCount = static_cast<size_t>(lampPointsWidth) * lampPointsHeight;

double brightest(const glm::vec4& texel) { return static_cast<double>(std::max({texel.x, texel.y, texel.z})); }

// A cube's texels by face, column and row; across an edge those of the face beyond.
struct CubeGrid {
  int size;
  size_t index(int face, int column, int row) const {
    return (static_cast<size_t>(face) * static_cast<size_t>(size) + static_cast<size_t>(row)) *
               static_cast<size_t>(size) +
           static_cast<size_t>(column);
  }
  size_t around(int face, int column, int row) const {
    if (column >= 0 && column < size && row >= 0 && row < size) return index(face, column, row);
    const optics::CubePoint beyond =
        optics::cubeFromDirection(optics::directionFromCube({face, {(column + 0.5) / size, (row + 0.5) / size}}));
    const auto texel = [&](double x) { return std::clamp(static_cast<int>(x * size), 0, size - 1); };
    return index(beyond.face, texel(beyond.uv.x), texel(beyond.uv.y));
  }
};

// Column and row of place `along` on Hilbert's curve (1891) through size^2 places, a power of two.
glm::ivec2 onCurve(int along, int size) {
  glm::ivec2 at(0);
  for (int s = 1; s < size; s *= 2, along /= 4) {
    const int right = along / 2 & 1, up = (along ^ right) & 1;
    if (!up) {
      if (right) at = glm::ivec2(s - 1) - at;
      std::swap(at.x, at.y);
    }
    at += s * glm::ivec2(right, up);
  }
  return at;
}

// Of radiance above which a texel's excess is a lamp's.
double threshold(const std::vector<glm::vec4>& texels, double mean) {
  std::vector<double> values;
  for (const glm::vec4& texel : texels)
    if (brightest(texel) > brightness * mean) values.push_back(brightest(texel));
  constexpr size_t most = pointCount / 4;
  if (values.size() <= most) return brightness * mean;
  std::ranges::nth_element(values, values.begin() + most, std::greater<>());
  return values[most];
}

// How much of the light each texel's samples are for: of its own and of its neighbours', where it is interpolated.
std::vector<double> interpolatedFlux(const std::vector<glm::vec4>& lamps, const CubeGrid& grid) {
  constexpr double tent[] = {1.0 / 8, 6.0 / 8, 1.0 / 8};  // a texel's share of the tent about its middle
  std::vector<double> flux(lamps.size());
  for (int face = 0; face < 6; ++face)
    for (int row = 0; row < grid.size; ++row)
      for (int column = 0; column < grid.size; ++column) {
        const double light = brightest(lamps[grid.index(face, column, row)]);
        if (light <= 0) continue;
        for (int j = -1; j <= 1; ++j)
          for (int i = -1; i <= 1; ++i)
            flux[grid.around(face, column + i, row + j)] +=
                tent[i + 1] * tent[j + 1] * light * optics::cubeTexelSolidAngle(column, row, grid.size);
      }
  return flux;
}

// Shares out the points along a curve through each face; one at least to every texel that has any flux.
void placePoints(Lamps& out, const std::vector<double>& flux, const CubeGrid& grid) {
  std::vector<size_t> order;
  double total = 0, before = 0;
  for (int face = 0; face < 6; ++face)
    for (int along = 0; along < grid.size * grid.size; ++along) {
      const glm::ivec2 at = onCurve(along, grid.size);
      const size_t texel = grid.index(face, at.x, at.y);
      if (flux[texel] > 0) order.push_back(texel), total += flux[texel];
    }
  const size_t shared = pointCount - order.size();
  size_t given = 0;
  for (const size_t texel : order) {
    before += flux[texel];
    const size_t until =
        texel == order.back() ? shared : static_cast<size_t>(before / total * static_cast<double>(shared));
    const size_t count = 1 + until - given;
    given = until;
    const auto size = static_cast<size_t>(grid.size);
    const double chance = static_cast<double>(count) / static_cast<double>(pointCount);
    const double solidAngle =
        optics::cubeTexelSolidAngle(static_cast<int>(texel % size), static_cast<int>(texel / size % size), grid.size);
    out.points.insert(out.points.end(), count,
                      {static_cast<float>(texel), static_cast<float>(chance * grid.size * grid.size / 4)});
    out.lamps[texel].w = static_cast<float>(chance / solidAngle);
  }
}

gl::Texture nearestTexture(GLenum format, int width, int height, std::string_view label) {
  gl::Texture texture({.format = format, .width = width, .height = height}, label);
  texture.parameter(GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  texture.parameter(GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return texture;
}

void uploadFaces(const gl::Texture& cube, const std::vector<glm::vec4>& texels) {
  const int size = cube.description().width;
  glTextureSubImage3D(cube.id(), 0, 0, 0, 0, size, size, 6, GL_RGBA, GL_FLOAT, texels.data());
}

void split(Tables& made, const gl::Texture& cube) {
  const int size = cube.description().width;
  std::vector<glm::vec4> texels(size_t{6} * static_cast<size_t>(size) * static_cast<size_t>(size));
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  glGetTextureImage(cube.id(), 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(texels.size() * sizeof(glm::vec4)),
                    texels.data());
  const Lamps found = findLamps(texels, size);
  made.rest = cubeTexture(GL_RGBA32F, size, gl::mipLevels(size, size), "environment without lamps");
  uploadFaces(made.rest, found.rest);
  const bool any = !found.points.empty();
  made.lamps = cubeTexture(GL_RGBA32F, any ? size : 1, 1, "lamps");
  uploadFaces(made.lamps, any ? found.lamps : std::vector<glm::vec4>(6, glm::vec4(0)));
  made.lampPoints = nearestTexture(GL_RG32F, any ? lampPointsWidth : 1, any ? lampPointsHeight : 1, "lamp points");
  if (any)
    glTextureSubImage2D(made.lampPoints.id(), 0, 0, 0, lampPointsWidth, lampPointsHeight, GL_RG, GL_FLOAT,
                        found.points.data());
}

Result<void> drawRestLevels(const gl::Texture& rest, shading::ProgramStore& programs) {
  const auto program = programs.compute("passes/cube_tent.comp.glsl");
  if (!program) return tl::unexpected(program.error());
  glUseProgram((*program)->id());
  rest.bind(layout::sourceUnit);
  for (int level = 1; level < rest.description().levels; ++level) {
    (*program)->set(layout::tentFineLevelLocation, level - 1);
    glBindImageTexture(0, rest.id(), level, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    dispatchFaces(rest.description().width >> level);
  }
  return {};
}

}  // namespace

Lamps findLamps(const std::vector<glm::vec4>& texels, int size) {
  const CubeGrid grid{size};
  Lamps out{texels, std::vector<glm::vec4>(texels.size(), glm::vec4(0)), {}};
  double flux = 0, solidAngle = 0, lampFlux = 0;
  std::vector<double> solidAngles(static_cast<size_t>(size) * static_cast<size_t>(size));  // of each face
  for (size_t i = 0; i < solidAngles.size(); ++i)
    solidAngles[i] = optics::cubeTexelSolidAngle(static_cast<int>(i) % size, static_cast<int>(i) / size, size);
  for (size_t i = 0; i < texels.size(); ++i) {
    flux += brightest(texels[i]) * solidAngles[i % solidAngles.size()];
    solidAngle += solidAngles[i % solidAngles.size()];
  }
  const double least = threshold(texels, flux / solidAngle);
  for (size_t i = 0; i < texels.size(); ++i) {
    if (brightest(texels[i]) <= least) continue;
    const auto kept = static_cast<float>(least / brightest(texels[i]));
    out.rest[i] = texels[i] * kept;
    out.lamps[i] = glm::vec4(glm::vec3(texels[i]) - glm::vec3(out.rest[i]), 0);
    lampFlux += brightest(out.lamps[i]) * solidAngles[i % solidAngles.size()];
  }
  if (lampFlux < leastShare * flux || lampFlux <= 0) return {texels, {}, {}};
  placePoints(out, interpolatedFlux(out.lamps, grid), grid);
  return out;
}

void addLampSteps(std::vector<Step>& steps, Tables& made, const std::shared_ptr<Scratch>& scratch,
                  shading::ProgramStore& programs) {
  const uint64_t texels = uint64_t{6} * mirrorSize * mirrorSize;
  steps.push_back({"lamps", texels, [&made, scratch]() -> Result<void> {
                     split(made, scratch->environmentCube());
                     return {};
                   }});
  steps.push_back({"lamps", texels / 3 * 16, [&made, &programs] { return drawRestLevels(made.rest, programs); }});
}

}  // namespace facet::ibl
