#include "frame/shadow_maps.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "base/angle.hpp"
#include "frame/depth_pass.hpp"
#include "frame/frame.hpp"
#include "frame/settings.hpp"

namespace facet::frame {

namespace {

constexpr int fineSize = 1024;                 // texels along an edge
constexpr int fineMaps = 6;                    // up to so many are fine
constexpr double widestMap = 60.0 * pi / 180;  // [rad] to either side; what would be wider has six

enum class Kind { directional = 0, point = 1, spot = 2, sun = 3 };
Kind kindOf(const layout::LightUniforms& light) { return static_cast<Kind>(static_cast<int>(light.position.w)); }

// Angle of the cone from its axis.
double outerCone(const layout::LightUniforms& light) {
  return std::acos(std::clamp(-static_cast<double>(light.cone.y) / static_cast<double>(light.cone.x), -1.0, 1.0));
}

// How a light's maps see the scene: one of them that far to either side of an axis, or six.
struct Cover {
  int maps = 1;
  glm::dvec3 axis = glm::dvec3(0, 0, -1);
  double halfAngle = 0;  // [rad]; 0: light is parallel
  double zNear = 0;
};
Cover coverOf(const DrawList& list, const layout::LightUniforms& light) {
  const Kind kind = kindOf(light);
  if (kind == Kind::directional || kind == Kind::sun) return {.axis = light.direction};
  const double radius = std::max(list.bounds.radius(), 1e-30), near = 1e-5 * radius;
  const glm::dvec3 position(light.position);  // the scene's middle is its origin
  const double distance = glm::length(position);
  if (distance * std::sin(widestMap) > radius) {
    const double all = std::asin(radius / distance);
    return {1, -position / distance, all, std::max(0.99 * (distance - radius), near)};
  }
  if (kind == Kind::spot && outerCone(light) <= widestMap) return {1, light.direction, outerCone(light) + 0.01, near};
  return {.maps = 6, .halfAngle = pi / 4, .zNear = near};
}

bool shines(const layout::LightUniforms& light) { return glm::vec3(light.color) != glm::vec3(0); }

scene::View lookAlong(const glm::dvec3& eye, const glm::dvec3& forward) {
  scene::View view;
  const glm::dvec3 side = std::abs(forward.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
  view.eye = eye;
  view.forward = glm::normalize(forward);
  view.right = glm::normalize(glm::cross(view.forward, side));
  view.up = glm::cross(view.right, view.forward);
  view.viewFromWorld = glm::lookAt(eye, eye + view.forward, view.up);
  return view;
}

// All of the scene by parallel light.
scene::View parallelView(const DrawList& list, const glm::dvec3& direction) {
  const double radius = 1.01 * std::max(list.bounds.radius(), 1e-30);
  scene::View view = lookAlong(list.origin - 2 * radius * direction, direction);
  view.orthographic = true;
  view.zNear = radius, view.zFar = 3 * radius;
  view.clipFromView = scene::orthographic(radius, radius, view.zNear, view.zFar);
  view.clipFromWorld = view.clipFromView * view.viewFromWorld;
  return view;
}

// A texel wider, which filtering reads.
scene::View pointView(const DrawList& list, const glm::dvec3& eye, const glm::dvec3& axis, const Cover& cover) {
  scene::View view = lookAlong(eye, axis);
  const double wider = std::atan(std::tan(cover.halfAngle) * (1 + 4.0 / shadowMapSize(list)));
  view.zNear = cover.zNear;
  view.clipFromView = scene::perspective(2 * wider, 1, view.zNear, view.zFar);
  view.clipFromWorld = view.clipFromView * view.viewFromWorld;
  return view;
}

}  // namespace

int shadowMapSize(const DrawList& list) {
  int maps = 0;
  for (const layout::LightUniforms& light : list.lights) maps += shines(light) ? coverOf(list, light).maps : 0;
  return maps <= fineMaps ? fineSize : fineSize / 2;
}

void assignShadowMaps(DrawList& list) {
  const int size = shadowMapSize(list);
  int next = 0;
  for (layout::LightUniforms& light : list.lights) light.cone.z = light.cone.w = 0;
  for (const int maps : {1, 6})
    for (layout::LightUniforms& light : list.lights) {
      const Cover cover = coverOf(list, light);
      if (cover.maps != maps || !shines(light) || next + maps > layout::mostShadowMaps) continue;
      const double halfWidth = cover.halfAngle > 0 ? std::tan(cover.halfAngle) : 1.01 * list.bounds.radius();
      light.cone.z = static_cast<float>(maps == 6 ? -(next + 1) : next + 1);
      light.cone.w = static_cast<float>(2 * halfWidth / size);
      next += maps;
    }
}

int lightsWithoutMap(const DrawList& list) {
  return static_cast<int>(std::ranges::count_if(
      list.lights, [](const layout::LightUniforms& light) { return shines(light) && light.cone.z == 0; }));
}

std::vector<scene::View> shadowViews(const DrawList& list, double environmentRotationDeg) {
  std::vector<scene::View> views;
  const auto place = [&](size_t index, scene::View view) {
    views.resize(std::max(views.size(), index + 1));
    views[index] = std::move(view);
  };
  const glm::dmat4 turn = glm::rotate(glm::dmat4(1), glm::radians(environmentRotationDeg), glm::dvec3(0, 1, 0));
  for (const layout::LightUniforms& light : list.lights) {
    if (light.cone.z == 0) continue;
    const auto first = static_cast<size_t>(std::abs(light.cone.z) - 1);
    const Cover cover = coverOf(list, light);
    const glm::dvec3 eye = list.origin + glm::dvec3(light.position);
    if (cover.halfAngle == 0) {
      const bool sun = kindOf(light) == Kind::sun;
      place(first, parallelView(list, sun ? glm::dvec3(turn * glm::dvec4(cover.axis, 0)) : cover.axis));
    } else if (cover.maps == 1) {
      place(first, pointView(list, eye, cover.axis, cover));
    } else {
      for (size_t face = 0; face < 6; ++face) {
        glm::dvec3 axis(0);
        axis[static_cast<int>(face / 2)] = face % 2 == 0 ? 1 : -1;
        place(first + face, pointView(list, eye, axis, cover));
      }
    }
  }
  return views;
}

Result<void> drawShadowMaps(const FrameInput& in, ShadowMaps& maps, shading::ProgramStore& programs,
                            FrameStatistics& statistics) {
  const float rotation = in.settings.frame.environmentRotationDeg;
  const bool turns = std::ranges::any_of(in.list.lights,
                                         [](const layout::LightUniforms& light) { return kindOf(light) == Kind::sun; });
  if (maps.drawn && (!turns || maps.environmentRotationDeg == rotation)) return {};
  const std::vector<scene::View> views = shadowViews(in.list, static_cast<double>(rotation));
  const int size = shadowMapSize(in.list), count = std::max(1, static_cast<int>(views.size()));
  if (!maps.depths || maps.depths.description().layers != count || maps.depths.description().width != size) {
    maps.depths = gl::Texture({.target = GL_TEXTURE_2D_ARRAY,
                               .format = GL_DEPTH_COMPONENT32F,
                               .width = size,
                               .height = size,
                               .layers = count},
                              "shadow maps");
    maps.depths.filterLinear();
    maps.depths.parameter(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    maps.depths.parameter(GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
  }
  std::vector<layout::ShadowUniforms> uniforms(1);
  const glm::dmat4 fromOrigin = glm::translate(glm::dmat4(1), in.list.origin);
  beginPass(in, statistics, std::to_string(views.size()) + (views.size() == 1 ? " shadow map" : " shadow maps"));
  for (size_t i = 0; i < views.size(); ++i) {
    uniforms[0].clipFromWorld[i] = glm::mat4(views[i].clipFromWorld * fromOrigin);
    gl::Framebuffer framebuffer("shadow map");
    glNamedFramebufferTextureLayer(framebuffer.id(), GL_DEPTH_ATTACHMENT, maps.depths.id(), 0, static_cast<GLint>(i));
    if (Result<void> r = drawDepth(in, views[i], framebuffer, {size, size}, DepthOf::bothSides, programs, statistics);
        !r)
      return r;
  }
  maps.uniforms = gl::Buffer::of(uniforms, "shadow maps");
  maps.environmentRotationDeg = rotation, maps.drawn = true;
  endPass(in);
  return {};
}

}  // namespace facet::frame
