// Lights (KHR_lights_punctual) and cameras. A senseless number costs the light or camera its value, not the user the
// model.

#include <algorithm>
#include <cmath>

#include "io/gltf_document.hpp"

namespace facet::io {

namespace {

constexpr float halfPi = 1.57079633f;

// Keeps the default and warns unless value fits; the bounds belong to the range.
void take(Document& doc, double value, double low, double high, const std::string& place, auto& target) {
  if (value >= low && value <= high) {
    target = static_cast<std::remove_reference_t<decltype(target)>>(value);
  } else {
    doc.warning(place, "is out of range: the default is used");
  }
}

void readCone(Document& doc, const tinygltf::SpotLight& spot, const std::string& place, scene::Light& light) {
  light.outerConeAngle = std::clamp(static_cast<float>(spot.outerConeAngle), 1e-4f, halfPi);
  light.innerConeAngle = std::clamp(static_cast<float>(spot.innerConeAngle), 0.0f, light.outerConeAngle);
  // The falloff divides by the difference of the cosines: a hard edge is a very narrow soft one.
  if (light.innerConeAngle > light.outerConeAngle - 1e-4f) {
    light.innerConeAngle = std::max(0.0f, light.outerConeAngle - 1e-4f);
  }
  const auto differs = [](double a, float b) { return std::abs(a - static_cast<double>(b)) > 2e-4; };
  if (differs(spot.outerConeAngle, light.outerConeAngle) || differs(spot.innerConeAngle, light.innerConeAngle)) {
    doc.warning(place + "/spot", "the cone angles are out of range: brought to 0 <= inner < outer <= pi/2");
  }
}

void readLight(Document& doc, size_t index) {
  const auto& from = doc.gltf.lights[index];
  const std::string place = pointer("/extensions/KHR_lights_punctual/lights", index);
  constexpr double largest = std::numeric_limits<float>::max();
  scene::Light light;
  light.name = from.name;
  if (from.type == "directional") {
    light.type = scene::LightType::directional;
  } else if (from.type == "point") {
    light.type = scene::LightType::point;
  } else if (from.type == "spot") {
    light.type = scene::LightType::spot;
    readCone(doc, from.spot, place, light);
  } else {
    doc.warning(place + "/type", "is none of directional, point and spot: gives no light");
    light.intensity = 0;
    doc.model.lights.push_back(std::move(light));
    return;
  }
  if (from.color.size() == 3) {
    for (int c = 0; c < 3; ++c) {
      take(doc, from.color[static_cast<size_t>(c)], 0, largest, pointer(place + "/color", static_cast<size_t>(c)),
           light.color[c]);
    }
  } else if (!from.color.empty()) {
    doc.warning(place + "/color", "does not have three numbers: white is used");
  }
  take(doc, from.intensity, 0, largest, place + "/intensity", light.intensity);
  // tinygltf says 0 where the file says nothing; the smallest normal float keeps 1 / range finite.
  if (from.range != 0) take(doc, from.range, std::numeric_limits<float>::min(), largest, place + "/range", light.range);
  doc.model.lights.push_back(std::move(light));
}

void readPerspective(Document& doc, const tinygltf::PerspectiveCamera& from, const std::string& place,
                     scene::Camera& camera) {
  constexpr double smallest = std::numeric_limits<float>::min(), largest = std::numeric_limits<float>::max();
  take(doc, from.yfov, 1e-4, 3.1415, place + "/yfov", camera.fovY);
  take(doc, from.znear, smallest, largest, place + "/znear", camera.zNear);
  if (from.aspectRatio != 0) take(doc, from.aspectRatio, 1e-4, 1e4, place + "/aspectRatio", camera.aspectRatio);
  if (from.zfar != 0)
    take(doc, from.zfar, std::nextafter(camera.zNear, largest), largest, place + "/zfar", camera.zFar);
}

void readOrthographic(Document& doc, const tinygltf::OrthographicCamera& from, const std::string& place,
                      scene::Camera& camera) {
  constexpr double smallest = std::numeric_limits<float>::min(), largest = std::numeric_limits<float>::max();
  camera.perspective = false;
  camera.zFar = 100;  // an orthographic far plane cannot be infinite
  take(doc, std::abs(from.xmag), smallest, largest, place + "/xmag", camera.xMag);
  take(doc, std::abs(from.ymag), smallest, largest, place + "/ymag", camera.yMag);
  take(doc, from.znear, 0, largest, place + "/znear", camera.zNear);
  take(doc, from.zfar, std::nextafter(camera.zNear, largest), largest, place + "/zfar", camera.zFar);
  if (!(camera.zFar > camera.zNear)) camera.zFar = camera.zNear * 2;
}

}  // namespace

Result<void> readLights(Document& doc) {
  for (size_t i = 0; i < doc.gltf.lights.size(); ++i) readLight(doc, i);
  return {};
}

Result<void> readCameras(Document& doc) {
  for (size_t i = 0; i < doc.gltf.cameras.size(); ++i) {
    const auto& from = doc.gltf.cameras[i];
    const std::string place = pointer("/cameras", i) + "/" + from.type;
    scene::Camera camera;
    camera.name = from.name;
    if (from.type == "perspective") {
      readPerspective(doc, from.perspective, place, camera);
    } else {
      readOrthographic(doc, from.orthographic, place, camera);
    }
    doc.model.cameras.push_back(std::move(camera));
  }
  return {};
}

}  // namespace facet::io
