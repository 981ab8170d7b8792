#include <algorithm>
#include <cmath>

#include "io/uri.hpp"
#include "io/validate/checks.hpp"
#include "io/validate/elements.hpp"
#include "io/validate/formats.hpp"
#include "io/validate/vertex_data.hpp"

namespace facet::io::validate {

namespace {

void noStride(Asset& asset, int view, const std::string& place) {
  if (view >= 0 && asset.views[static_cast<size_t>(view)].stride != 0)
    asset.add(Code::ANIMATION_SAMPLER_ACCESSOR_WITH_BYTESTRIDE, place, "the buffer view has a stride");
}

void checkTimes(Asset& asset, int index, const std::string& place) {
  if (!asset.checked.insert(std::to_string(index) + " times").second) return;
  Tally negative, falling;
  double last = 0;
  forEachElement(asset, asset.accessors[static_cast<size_t>(index)], false,
                 [&](uint64_t element, std::span<const double> v) {
                   if (v[0] < 0) negative.add(element, v[0]);
                   if (v[0] >= 0 && element > 0 && v[0] <= last) falling.add(element, v[0]);
                   last = v[0];
                 });
  if (negative.count > 0) asset.add(Code::ACCESSOR_ANIMATION_INPUT_NEGATIVE, place, tallyText(negative, "negative"));
  if (falling.count > 0)
    asset.add(Code::ACCESSOR_ANIMATION_INPUT_NON_INCREASING, place,
              tallyText(falling, "not later than the one before"));
}

void checkSampler(Asset& asset, const Json& sampler, const std::string& place) {
  const bool spline = textAt(sampler, "interpolation") == "CUBICSPLINE";
  if (const int input = indexAt(asset, sampler, "input", "accessors"); input >= 0) {
    const std::string here = place + "/input";
    useAccessor(asset, input, Use::times, here);
    const Accessor& a = asset.accessors[static_cast<size_t>(input)];
    useView(asset, a.view, Use::other, here);
    noStride(asset, a.view, here);
    if (a.wellFormed && (a.type != "SCALAR" || !isFloat(a.componentType)))
      asset.add(Code::ANIMATION_SAMPLER_INPUT_ACCESSOR_INVALID_FORMAT, here, "is " + formatText(a));
    else
      checkTimes(asset, input, here);
    if (!a.hasBounds)
      asset.add(Code::ANIMATION_SAMPLER_INPUT_ACCESSOR_WITHOUT_BOUNDS, here,
                "accessor " + std::to_string(input) + " has no min and max");
    if (spline && a.wellFormed && a.count < 2)
      asset.add(Code::ANIMATION_SAMPLER_INPUT_ACCESSOR_TOO_FEW_ELEMENTS, here, "a cubic spline of one key");
  }
  if (const int output = indexAt(asset, sampler, "output", "accessors"); output >= 0) {
    const std::string here = place + "/output";
    useAccessor(asset, output, Use::values, here);
    const Accessor& a = asset.accessors[static_cast<size_t>(output)];
    useView(asset, a.view, Use::other, here);
    noStride(asset, a.view, here);
  }
}

void checkQuaternions(Asset& asset, int index, bool spline, const std::string& place) {
  const Accessor& a = asset.accessors[static_cast<size_t>(index)];
  if (a.components != 4 || !asset.checked.insert(std::to_string(index) + (spline ? " splines" : " quaternions")).second)
    return;
  Tally wrong;
  forEachElement(asset, a, true, [&](uint64_t element, std::span<const double> q) {
    if (spline && element % 3 != 1) return;  // tangents
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (std::abs(length - 1) > quaternionTolerance) wrong.add(element, length);
  });
  if (wrong.count > 0)
    asset.add(Code::ACCESSOR_ANIMATION_SAMPLER_OUTPUT_NON_NORMALIZED_QUATERNION, place,
              tallyText(wrong, "not of unit length"));
}

size_t targetsOf(const Asset& asset, int node) {
  const Json& primitives =
      member(element(asset, "meshes", indexAt(asset, element(asset, "nodes", node), "mesh", "meshes")), "primitives");
  return primitives.is_array() && !primitives.empty() ? targetCountOf(primitives[0]) : 0;
}

void checkTarget(Asset& asset, const Json& target, const std::string& place) {
  const Json& pointer = extension(target, "KHR_animation_pointer");
  const std::string path = textAt(target, "path");
  if (pointer.is_object()) {
    const std::string here = place + "/extensions/KHR_animation_pointer";
    if (target.contains("node"))
      asset.add(Code::KHR_ANIMATION_POINTER_ANIMATION_CHANNEL_TARGET_NODE, here, "the target names a node, too");
    if (path != "pointer")
      asset.add(Code::KHR_ANIMATION_POINTER_ANIMATION_CHANNEL_TARGET_PATH, here, "path is " + inQuotes(path));
    return;
  }
  if (!path.empty() && path != "translation" && path != "rotation" && path != "scale" && path != "weights")
    asset.add(Code::VALUE_NOT_IN_LIST, place + "/path",
              "is " + inQuotes(path) + ", none of translation, rotation, scale and weights");
  const int node = indexAt(asset, target, "node", "nodes");
  if (node < 0) return;
  const Json& json = element(asset, "nodes", node);
  if (path == "weights" && targetsOf(asset, node) == 0)
    asset.add(Code::ANIMATION_CHANNEL_TARGET_NODE_WEIGHTS_NO_MORPHS, place,
              "node " + std::to_string(node) + " has no morph targets");
  if (path != "translation" && path != "rotation" && path != "scale") return;
  if (json.contains("matrix"))
    asset.add(Code::ANIMATION_CHANNEL_TARGET_NODE_MATRIX, place, "node " + std::to_string(node) + " has a matrix");
  if (indexAt(asset, json, "skin", "skins") >= 0)
    asset.add(Code::ANIMATION_CHANNEL_TARGET_NODE_SKIN, place + "/path",
              "node " + std::to_string(node) + " is skinned: only its joints move it");
}

void checkValues(Asset& asset, const Json& animation, const Json& channel, const std::string& place) {
  const Json& samplers = member(animation, "samplers");
  const auto number = wholeAt(channel, "sampler");
  if (!samplers.is_array() || !number || *number < 0) return;
  const std::string here = place + "/sampler";
  if (static_cast<uint64_t>(*number) >= samplers.size()) {
    asset.add(Code::UNRESOLVED_REFERENCE, here,
              "names " + std::to_string(*number) + ", but there are " + std::to_string(samplers.size()) + " samplers");
    return;
  }
  const Json &sampler = samplers[static_cast<size_t>(*number)], &target = member(channel, "target");
  const int input = indexAt(asset, sampler, "input", "accessors"),
            output = indexAt(asset, sampler, "output", "accessors");
  if (output < 0 || !target.is_object()) return;
  const Accessor& values = asset.accessors[static_cast<size_t>(output)];
  const std::string path = textAt(target, "path");
  const bool spline = textAt(sampler, "interpolation") == "CUBICSPLINE";
  if (!values.wellFormed) return;
  if (path == "rotation") checkQuaternions(asset, output, spline, here);
  if (!isAnimationFormat(path, values))
    asset.add(Code::ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_FORMAT, here,
              "the values are " + formatText(values) + ", which " + inQuotes(path) + " can't be");
  if (input < 0 || !asset.accessors[static_cast<size_t>(input)].wellFormed) return;
  uint64_t wanted = asset.accessors[static_cast<size_t>(input)].count * (spline ? 3 : 1);
  if (path == "weights")
    wanted *= targetsOf(asset, indexAt(asset, target, "node", "nodes"));
  else if (path != "translation" && path != "rotation" && path != "scale")
    return;
  if (wanted > 0 && wanted != values.count)
    asset.add(Code::ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_COUNT, here,
              "there are " + std::to_string(values.count) + " values, not " + std::to_string(wanted));
}

void checkAnimation(Asset& asset, const Json& animation, const std::string& place) {
  const Json &samplers = member(animation, "samplers"), &channels = member(animation, "channels");
  if (samplers.is_array())
    for (size_t i = 0; i < samplers.size(); ++i) checkSampler(asset, samplers[i], at(place + "/samplers", i));
  if (!channels.is_array()) return;
  std::map<std::string, size_t> seen;
  std::set<int64_t> used;
  for (size_t i = 0; i < channels.size(); ++i) {
    const std::string here = at(place + "/channels", i);
    const Json& target = member(channels[i], "target");
    if (target.is_object()) checkTarget(asset, target, here + "/target");
    checkValues(asset, animation, channels[i], here);
    if (const auto sampler = wholeAt(channels[i], "sampler")) used.insert(*sampler);
    const auto node = wholeAt(target, "node");
    if (!node) continue;
    const auto [first, isNew] = seen.emplace(std::to_string(*node) + textAt(target, "path"), i);
    if (!isNew)
      asset.add(Code::ANIMATION_DUPLICATE_TARGETS, at(place + "/channels", first->second) + "/target",
                "channel " + std::to_string(i) + " has the same target");
  }
  for (size_t i = 0; samplers.is_array() && i < samplers.size(); ++i)
    if (!used.contains(static_cast<int64_t>(i)))
      asset.add(Code::UNUSED_OBJECT, at(place + "/samplers", i), "no channel uses it");
}

}  // namespace

void checkAnimations(Asset& asset) {
  const Json& list = collection(asset, "animations");
  for (size_t i = 0; i < list.size(); ++i) checkAnimation(asset, list[i], at("/animations", i));
}

}  // namespace facet::io::validate
