#pragma once

// Path tracing: what a picture shows where light is blocked, reflected and let through by everything that the scene
// draws. A sample of a pixel is one path. The paths of some rows go on together, a surface at a time: rays of all of
// them, then the surfaces that they have met, class by class, each by a program of its own with the material's chunks
// and textures.
//
// Unidirectional, with next-event estimation of the environment's texels or of one punctual light, joined with
// directions drawn from the lobes by multiple importance sampling (Veach 1997), and Russian roulette.

#include <functional>
#include <optional>

#include "frame/frame.hpp"
#include "frame/scene_buffers.hpp"
#include "frame/traced.hpp"

namespace facet::frame {

// A buffer that shaders read as a texture, which software OpenGL reads several times faster than a storage buffer.
struct BufferTexture {
  gl::Buffer buffer;
  gl::Texture texture;
};

// A draw list for paths, on the GPU. Nothing makes it but who traces.
struct PathScene {
  std::optional<DrawList> drawn;  // the list as paths shade it, where it is drawn as well
  TracedList list;                // without what is on the GPU
  BufferTexture nodes, triangles, placements, glowing;
  gl::Buffer holes;     // layout::RayHoles by material, where there are any
  BufferTexture alpha;  // of their textures
  SceneBuffers buffers;
  gl::Buffer instances;
  int triangleCount = 0;
  double buildMs = 0;  // of the trees

  size_t bytes() const;
};

// What of it needs no OpenGL, and most of the time.
struct PathTrees {
  std::optional<DrawList> drawn;  // PathScene's
  TracedList list;
  double buildMs = 0;
};
// On any thread; the model that the list is of must outlive it.
PathTrees pathTrees(const DrawList& list);

// trees: of the list. Textures of the list's materials are on the GPU.
Result<PathScene> pathScene(PathTrees trees, const DrawList& list, const scene::Model& model, const GpuScene& gpu,
                            shading::ProgramStore& programs);

// Paths under way.
struct PathWork {
  size_t paths = 0;
  gl::Buffer states, work, groups;
};

// What paths are traced for.
enum class PathUse {
  picture,     // its radiance
  difference,  // the correction of a drawn picture (difference.hpp)
  ground       // light on the floor (ground.hpp)
};

// Rows of the targets from the bottom, and what becomes of them: times `share` onto the texture.
struct PathRows {
  int first = 0, count = 0;
  PathUse use = PathUse::picture;
  const gl::Texture* sum = nullptr;  // RGBA32F, of the picture; for other uses their images are bound
  float share = 1;
  glm::dvec2 offset = glm::dvec2(0);  // from the pixel's middle, without sum
  int firstColumn = 0, columns = 0;   // of the picture; 0: all
};
// Sample `number` of each pixel of the rows. `work` is kept by the caller for the next rows.
Result<void> tracePaths(const FrameInput& in, const PathRows& rows, PathWork& work, int number,
                        shading::ProgramStore& programs);

// The same with the list as paths shade it.
FrameInput tracedInput(const FrameInput& in);

// Where rays begin and go (layout::PathUniforms), for other passes over the same pixels.
gl::Buffer pathUniformBuffer(const FrameInput& in, int firstColumn, int columns);

// Rays that have been traced with it so far; waits for the GPU.
uint64_t tracedRays(const PathWork& work);

// All that tracePaths uses.
std::vector<ProgramGetter> neededPathPrograms(const FrameInput& in, PathUse use, shading::ProgramStore& programs);

}  // namespace facet::frame
