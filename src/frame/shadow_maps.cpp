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

constexpr int fineSize = 1024;                  // texels along an edge
constexpr int fineMaps = 6;                     // up to so many are fine
constexpr double widestSpot = 60.0 * pi / 180;  // [rad] half its cone; wider ones have six maps

enum class Kind { directional = 0, point = 1, spot = 2, sun = 3 };
Kind kindOf(const layout::LightUniforms& light) { return static_cast<Kind>(static_cast<int>(light.position.w)); }

// Angle of the cone from its axis.
double outerCone(const layout::LightUniforms& light) {
  return std::acos(std::clamp(-static_cast<double>(light.cone.y) / static_cast<double>(light.cone.x), -1.0, 1.0));
}

int mapsOf(const layout::LightUniforms& light) {
  const Kind kind = kindOf(light);
  return kind == Kind::point || (kind == Kind::spot && outerCone(light) > widestSpot) ? 6 : 1;
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

// halfAngle [rad] of the map's edges; a texel more, which filtering reads.
scene::View pointView(const DrawList& list, const glm::dvec3& eye, const glm::dvec3& direction, double halfAngle) {
  scene::View view = lookAlong(eye, direction);
  const double wider = std::atan(std::tan(halfAngle) * (1 + 4.0 / shadowMapSize(list)));
  view.zNear = 1e-5 * std::max(list.bounds.radius(), 1e-30);
  view.clipFromView = scene::perspective(2 * wider, 1, view.zNear, view.zFar);
  view.clipFromWorld = view.clipFromView * view.viewFromWorld;
  return view;
}

double spotEdge(const layout::LightUniforms& light) { return outerCone(light) + 0.01; }

// Width of a texel [m], but of what spreads 1 m away.
double texelWidth(const DrawList& list, const layout::LightUniforms& light, int size) {
  const Kind kind = kindOf(light);
  if (kind == Kind::directional || kind == Kind::sun) return 2.02 * list.bounds.radius() / size;
  return 2 * (mapsOf(light) == 6 ? 1 : std::tan(spotEdge(light))) / size;
}

}  // namespace

int shadowMapSize(const DrawList& list) {
  int maps = 0;
  for (const layout::LightUniforms& light : list.lights) maps += shines(light) ? mapsOf(light) : 0;
  return maps <= fineMaps ? fineSize : fineSize / 2;
}

void assignShadowMaps(DrawList& list) {
  const int size = shadowMapSize(list);
  int next = 0;
  for (layout::LightUniforms& light : list.lights) {
    light.cone.z = light.cone.w = 0;
    const int maps = mapsOf(light);
    if (!shines(light) || next + maps > layout::mostShadowMaps) continue;
    light.cone.z = static_cast<float>(maps == 6 ? -(next + 1) : next + 1);
    light.cone.w = static_cast<float>(texelWidth(list, light, size));
    next += maps;
  }
}

int lightsWithoutMap(const DrawList& list) {
  return static_cast<int>(std::ranges::count_if(
      list.lights, [](const layout::LightUniforms& light) { return shines(light) && light.cone.z == 0; }));
}

std::vector<scene::View> shadowViews(const DrawList& list, double environmentRotationDeg) {
  std::vector<scene::View> views;
  const glm::dmat4 turn = glm::rotate(glm::dmat4(1), glm::radians(environmentRotationDeg), glm::dvec3(0, 1, 0));
  for (const layout::LightUniforms& light : list.lights) {
    if (light.cone.z == 0) continue;
    const Kind kind = kindOf(light);
    const glm::dvec3 direction(light.direction), eye = list.origin + glm::dvec3(light.position);
    if (kind == Kind::directional || kind == Kind::sun) {
      views.push_back(parallelView(list, kind == Kind::sun ? glm::dvec3(turn * glm::dvec4(direction, 0)) : direction));
    } else if (mapsOf(light) == 1) {
      views.push_back(pointView(list, eye, direction, spotEdge(light)));
    } else {
      for (int axis = 0; axis < 3; ++axis)
        for (const double side : {1.0, -1.0}) {
          glm::dvec3 face(0);
          face[axis] = side;
          views.push_back(pointView(list, eye, face, pi / 4));
        }
    }
  }
  return views;
}

Result<void> drawShadowMaps(const FrameInput& in, ShadowMaps& maps, shading::ProgramStore& programs,
                            FrameStatistics& statistics) {
  const float rotation = in.settings.frame.environmentRotationDeg;
  if (maps.depths && maps.environmentRotationDeg == rotation) return {};
  const std::vector<scene::View> views = shadowViews(in.list, static_cast<double>(rotation));
  const int size = shadowMapSize(in.list), count = std::max(1, static_cast<int>(views.size()));
  if (!maps.depths || maps.depths.description().layers != count) {
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
  for (size_t i = 0; i < views.size(); ++i) {
    uniforms[0].clipFromWorld[i] = glm::mat4(views[i].clipFromWorld * fromOrigin);
    gl::Framebuffer framebuffer("shadow map");
    glNamedFramebufferTextureLayer(framebuffer.id(), GL_DEPTH_ATTACHMENT, maps.depths.id(), 0, static_cast<GLint>(i));
    if (Result<void> r = drawDepth(in, views[i], framebuffer, {size, size}, DepthOf::bothSides, programs, statistics);
        !r)
      return r;
  }
  maps.uniforms = gl::Buffer::of(uniforms, "shadow maps");
  maps.environmentRotationDeg = rotation;
  statistics.passes.emplace_back(std::to_string(views.size()) + (views.size() == 1 ? " shadow map" : " shadow maps"));
  return {};
}

}  // namespace facet::frame
