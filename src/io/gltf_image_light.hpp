#pragma once

// Cube maps of EXT_lights_image_based. Internal to io/.

#include <array>
#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "io/gltf_document.hpp"
#include "scene/environment.hpp"

namespace facet::io {

struct CubeMap {
  int size = 0;
  // +X -X +Y -Y +Z -Z, row 0 at the top, as the extension has them: OpenGL's faces with each row turned round.
  std::array<std::vector<glm::vec3>, 6> faces;
};

// Bilinear within the face that the direction meets. mirrored: of a world whose x axis points the other way, and faces
// that are OpenGL's as they are.
glm::dvec3 cubeRadiance(const CubeMap& cube, const glm::dvec3& direction, bool mirrored);

// int L Y over the sphere, real spherical harmonics up to l = 2 (Ramamoorthi and Hanrahan 2001: 00; 1-1 10 11; ...).
std::array<glm::dvec3, 9> harmonicsOf(const CubeMap& cube, bool mirrored);

// gltf_environment.cpp: how many the file has.
size_t imageLightCount(const Document& doc);

// gltf.cpp: reads the file's text, buffers and images, nothing else, and calls `use`; what the libraries throw becomes
// an error.
Result<scene::Environment> withImages(const std::filesystem::path& path, const Limits& limits,
                                      const std::function<Result<scene::Environment>(Document&)>& use);

}  // namespace facet::io
