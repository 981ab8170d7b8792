// Cameras and punctual lights.

#include "io/validate/checks.hpp"

namespace facet::io::validate {

namespace {

void checkRange(Asset& asset, const Json& camera, const std::string& place) {
  const auto near = numberAt(camera, "znear"), far = numberAt(camera, "zfar");
  if (near && far && *far > 0 && *far <= *near)
    asset.add(Code::CAMERA_ZFAR_LEQUAL_ZNEAR, place,
              "zfar " + numberText(*far) + " is not beyond znear " + numberText(*near));
}

void checkMagnification(Asset& asset, const Json& camera, const char* key, const std::string& place) {
  const auto value = numberAt(camera, key);
  if (value == 0.0) asset.add(Code::CAMERA_XMAG_YMAG_ZERO, at(place, key), "is zero");
  if (value && *value < 0) asset.add(Code::CAMERA_XMAG_YMAG_NEGATIVE, at(place, key), "is negative");
}

}  // namespace

void checkCameras(Asset& asset) {
  constexpr double pi = 3.14159265358979324;
  const Json& cameras = collection(asset, "cameras");
  for (size_t i = 0; i < cameras.size(); ++i) {
    const std::string place = at("/cameras", i);
    const Json &perspective = member(cameras[i], "perspective"), &orthographic = member(cameras[i], "orthographic");
    if (perspective.is_object() && orthographic.is_object())
      asset.add(Code::ONE_OF_MISMATCH, place, "is both perspective and orthographic");
    const std::string type = textAt(cameras[i], "type");
    if ((type == "perspective" && perspective.is_null()) || (type == "orthographic" && orthographic.is_null()))
      asset.add(Code::UNDEFINED_PROPERTY, place, "\"" + type + "\" is missing");
    if (perspective.is_object()) {
      checkRange(asset, perspective, place + "/perspective");
      const auto angle = numberAt(perspective, "yfov");
      if (angle && *angle >= pi)
        asset.add(Code::CAMERA_YFOV_GEQUAL_PI, place + "/perspective", "yfov is " + numberText(*angle) + " radians");
    }
    if (orthographic.is_object()) {
      checkRange(asset, orthographic, place + "/orthographic");
      checkMagnification(asset, orthographic, "xmag", place + "/orthographic");
      checkMagnification(asset, orthographic, "ymag", place + "/orthographic");
    }
  }
  const Json& lights = collection(asset, "extensions/KHR_lights_punctual/lights");
  for (size_t i = 0; i < lights.size(); ++i) {
    const std::string place = at("/extensions/KHR_lights_punctual/lights", i);
    const Json& spot = member(lights[i], "spot");
    if (textAt(lights[i], "type") == "spot" && spot.is_null())
      asset.add(Code::UNDEFINED_PROPERTY, place, "\"spot\" is missing");
    if (textAt(lights[i], "type") != "spot" && !spot.is_null())
      asset.add(Code::EXTRA_PROPERTY, place + "/spot", "the light is no spot");
    const double inner = numberAt(spot, "innerConeAngle").value_or(0),
                 outer = numberAt(spot, "outerConeAngle").value_or(pi / 4);
    if (spot.is_object() && outer <= inner)
      asset.add(Code::KHR_LIGHTS_PUNCTUAL_LIGHT_SPOT_ANGLES, place + "/spot/outerConeAngle",
                "outerConeAngle " + numberText(outer) + " is not greater than innerConeAngle " + numberText(inner));
  }
}

}  // namespace facet::io::validate
