#pragma once

// Scene -> what is drawn: pure, no OpenGL. World coordinates are relative to the scene's origin (the centre of its
// bounds), so that single precision suffices on the GPU however far away a scene lies.

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "frame/material_choice.hpp"
#include "ibl/needs.hpp"
#include "layout.h"
#include "scene/model.hpp"
#include "scene/nodes.hpp"
#include "scene/sun.hpp"
#include "shading/features.hpp"

namespace facet::frame {

// What is done about what stands in the light's way: shadow maps and horizons, or rays for either use.
enum class Tracing { none, screen, difference, paths };

struct DrawOptions {
  shading::FrameFeatures features = {};  // punctualLights and lightProfiles are set by buildDrawList
  bool sceneLights = true;               // the file's lights
  bool demoLights = false;               // four point lights around the scene
  std::optional<scene::Sun> sun = {};    // the environment's, where its tables do without it
  uint32_t without = 0;                  // layers that are left out of all materials (scene::Effect, a bit each)
  MaterialChoice material = {};          // in place of the file's, where it is on
  int variant = -1;                      // index in Model::variants; -1: the primitives' own materials
  Tracing tracing = Tracing::none;       // where anything is lit
  bool tracesAnyway = false;             // also where nothing can be in the light's way
  bool ground = false;                   // a floor stands below it
  bool compared = false;                 // drawn a second time, of the model fitted to its measured BRDF
  bool moving = false;  // other poses will follow: morph targets keep their program while all weights are 0

  bool operator==(const DrawOptions&) const = default;
};

// One instanced draw call.
struct Draw {
  const scene::Primitive* primitive = nullptr;
  int material = 0;  // index in DrawList::materials
  shading::VariantKey key;
  uint32_t firstInstance = 0, instanceCount = 1;
  uint32_t firstBounds = 0;  // in DrawList::instanceBounds: one for each instance
  bool mirrored = false;
  bool doubleSided = false;
};

// A camera of the file where the pose puts it.
struct FileCamera {
  scene::PlacedCamera placed;
  scene::Camera lens;
};

// The environment's sun as a light.
layout::LightUniforms sunUniforms(const scene::Sun& sun);

struct DrawList {
  glm::dvec3 origin = glm::dvec3(0);       // world position of the draw list's zero
  scene::Bounds bounds;                    // world
  std::vector<scene::Material> materials;  // the model's, then the default material
  std::vector<float> maskThresholds;       // of each, for its base colour's smaller levels (frame/mask_levels.hpp)
  std::vector<layout::Instance> instances;
  std::vector<int> instanceNodes;             // of each instance
  std::vector<scene::Bounds> instanceBounds;  // world; of one primitive in one instance
  std::vector<layout::Joint> joints;
  std::vector<layout::MorphWeight> morphWeights;  // those that are not 0
  std::vector<layout::LightUniforms> lights;
  std::vector<float> profileNumbers;                  // of lights with profiles (frame/light_profiles.hpp)
  std::vector<const optics::LightProfile*> profiles;  // of each of the first lights; null: it has none
  std::vector<Draw> opaque;                           // opaque and mask, sorted by program and material
  std::vector<Draw> transmitting;                     // show what is behind them, of any alpha mode; sorted likewise
  std::vector<Draw> blended;                          // one instance each; sorted by distance when drawn
  shading::FrameFeatures features;
  bool compared = false, ground = false;  // DrawOptions'
  std::vector<FileCamera> cameras;
  std::string untraced;  // why light that was to be traced is not; else empty
  int overflowed = 0;    // nodes left out because their transform is not finite

  // All classes of draws, in the order in which they are drawn.
  std::array<const std::vector<Draw>*, 3> classes() const { return {&opaque, &transmitting, &blended}; }

  // What the draws read from src/ibl/, and what is seen behind them.
  ibl::Needs needs(bool environmentVisible, float backgroundBlur = 0) const;
};

DrawList buildDrawList(const scene::Model& model, int scene, const DrawOptions& options, const scene::Pose& pose = {});

// The draws of a node's primitives, each instance a draw of its own, as a debug channel (1 and up) shows them: what is
// on the GPU of the list serves the part too, where `isOnGpu` says so. instances, joints, lights and cameras stay with
// the list.
DrawList partOf(const DrawList& list, const std::function<bool(int node, const scene::Primitive&)>& wanted,
                int channel);

// The box around the draws of the nodes for which `wanted` holds, world; empty where they draw nothing.
scene::Bounds boundsOf(const DrawList& list, const std::function<bool(int node)>& wanted);

// Other features for the same draws, as buildDrawList would have made them: programs, and the order by program. What
// the list has on the GPU serves both. The channel must stay, and whether there are punctual lights does.
void setFeatures(DrawList& list, shading::FrameFeatures features);

// Radius of a scene [m] within which 32-bit floats hold what rays compute of it, and what drawing does.
struct SizeRange {
  double least, most;
  bool holds(const scene::Bounds& bounds) const;
};
inline constexpr SizeRange tracedSizes{1e-12, 1e11}, drawnSizes{1e-18, 1e18};

// The features that tracing asks for, where there is light and something that could be in its way; else list.untraced
// says why not. Where nobody has asked for paths by name, they leave a list alone that holds what they do not meet.
void setTracing(DrawList& list, const DrawOptions& options);

}  // namespace facet::frame
