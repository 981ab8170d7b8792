// Animations: read from the JSON itself (see gltf.cpp). A file whose keys are broken still shows: what cannot be used
// is left out and named. Only data that a channel uses is read.

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "io/accessors.hpp"
#include "io/gltf_animation_targets.hpp"
#include "io/uri.hpp"

namespace facet::io {

namespace {

using Json = nlohmann::json;
using scene::AnimatedProperty;
using scene::Interpolation;

// How a channel wants to have its sampler's values.
struct Wanted {
  int components = 1, width = 1;
  bool rotation = false;    // unit quaternions
  bool normalized = false;  // integers without "normalized" are a writer's slip
  bool flag = false;        // true or false: steps only

  explicit Wanted(const AnimationTarget& target)
      : components(target.components),
        width(target.width),
        rotation(target.channel.property == AnimatedProperty::rotation),
        normalized(rotation || target.channel.property == AnimatedProperty::weights),
        flag(target.channel.property == AnimatedProperty::visible) {}
  auto operator<=>(const Wanted&) const = default;
};

struct AnimationReader {
  Document& doc;
  const MeshUsers& users;
  uint64_t& bytes;  // of all animations so far
  const Json* samplers = nullptr;
  std::string place = {};
  scene::Animation animation = {};
  // By sampler of the file and what is wanted of it: index in animation.samplers; -1: cannot be used, said already.
  std::map<std::pair<int, Wanted>, int> known = {};
};

// Notes what is wrong and gives up the sampler.
std::nullopt_t refuse(Document& doc, const std::string& place, std::string problem) {
  doc.warning(place, std::move(problem) + ": its channels are left out");
  return std::nullopt;
}

Result<int> accessorOf(const Document& doc, const Json& sampler, const char* key, const std::string& place) {
  const auto found = sampler.find(key);
  return readIndex(doc, found == sampler.end() ? Json() : *found, doc.gltf.accessors.size(), place + "/" + key,
                   "accessor");
}

std::optional<Interpolation> interpolationOf(Document& doc, const Json& sampler, const Wanted& wanted,
                                             const std::string& place) {
  const auto found = sampler.find("interpolation");
  const std::string name = found == sampler.end() ? "LINEAR" : stringAt(sampler, "interpolation");
  if (name == "STEP") return Interpolation::step;
  if (name == "LINEAR") return wanted.flag ? Interpolation::step : Interpolation::linear;
  if (name == "CUBICSPLINE" && !wanted.flag) return Interpolation::cubicSpline;
  return refuse(doc, place + "/interpolation",
                name == "CUBICSPLINE" ? "true and false have no spline" : inQuotes(name) + " is no interpolation");
}

// Numbers of one key in values.
size_t strideOf(const scene::AnimationSampler& sampler) {
  return static_cast<size_t>(sampler.width) * (sampler.interpolation == Interpolation::cubicSpline ? 3 : 1);
}

bool isFinite(std::span<const float> values) {
  float sum = 0;  // NaN and Inf survive a product with zero
  for (const float value : values) sum += value * 0.0f;
  return sum == 0.0f;
}

double lengthOf(std::span<const float> values) {
  double sum = 0;
  for (const float value : values) sum += static_cast<double>(value) * static_cast<double>(value);
  return std::sqrt(sum);
}

// Two keys at one time are a jump there: the later one comes at the next number that there is. Of more, those between
// are left to dropBadKeys.
void spreadJumps(Document& doc, scene::AnimationSampler& sampler, const std::string& place) {
  size_t jumps = 0;
  auto& times = sampler.times;
  for (size_t i = 1; i < times.size(); ++i) {
    if (times[i] != times[i - 1] || (i + 1 < times.size() && times[i + 1] == times[i])) continue;
    times[i] = std::nextafter(times[i], std::numeric_limits<float>::infinity());
    ++jumps;
  }
  if (jumps > 0) doc.info(place, std::to_string(jumps) + " times two keys lie at one time: a jump");
}

// Leaves only the keys that can be used: finite, later than the one before.
void dropBadKeys(Document& doc, scene::AnimationSampler& sampler, bool unitLength, const std::string& place) {
  const size_t stride = strideOf(sampler), count = sampler.times.size();
  size_t kept = 0, first = count;
  for (size_t i = 0; i < count; ++i) {
    const std::span<float> key = std::span(sampler.values).subspan(i * stride, stride);
    const bool rises = kept == 0 || sampler.times[i] > sampler.times[kept - 1];
    if (!std::isfinite(sampler.times[i]) || !rises || !isFinite(key) || (unitLength && !(lengthOf(key) > 0))) {
      first = std::min(first, i);
      continue;
    }
    if (kept != i) {
      sampler.times[kept] = sampler.times[i];
      std::copy(key.begin(), key.end(), sampler.values.begin() + static_cast<std::ptrdiff_t>(kept * stride));
    }
    ++kept;
  }
  if (kept == count) return;
  sampler.times.resize(kept);
  sampler.values.resize(kept * stride);
  sampler.times.shrink_to_fit();
  sampler.values.shrink_to_fit();
  doc.warning(place, std::to_string(count - kept) + " of " + std::to_string(count) +
                         " keys are not finite or do not follow the one before: left out; the first is key " +
                         std::to_string(first));
}

// Rotations between which is interpolated on the sphere. A spline's are made unit after they have been interpolated.
void makeUnit(Document& doc, scene::AnimationSampler& sampler, bool quantised, const std::string& place) {
  // Single-precision writers stay well below 1e-3; 8-bit ones are off by 0.8 % at most.
  const double tolerance = quantised ? 1e-2 : 1e-3;
  size_t off = 0;
  for (size_t i = 0; i < sampler.values.size(); i += 4) {
    const std::span<float> q = std::span(sampler.values).subspan(i, 4);
    const double length = lengthOf(q);
    if (std::abs(length - 1) > tolerance) ++off;
    for (float& value : q) value = static_cast<float>(static_cast<double>(value) / length);
  }
  if (off > 0) doc.info(place, std::to_string(off) + " rotations were not of unit length: normalised");
}

using MaybeSampler = std::optional<scene::AnimationSampler>;

// Whether keys and values fit each other and the property; notes where they do not.
bool fits(Document& doc, const scene::AnimationSampler& sampler, const Wanted& wanted, int input, int output,
          const std::string& place) {
  const auto &times = accessorAt(doc, input), &values = accessorAt(doc, output);
  if (times.type != TINYGLTF_TYPE_SCALAR || times.count == 0) {
    refuse(doc, place + "/input", "holds no times");
    return false;
  }
  if (values.type != (wanted.components == 1 ? TINYGLTF_TYPE_SCALAR : wanted.components)) {
    refuse(doc, place + "/output", "its elements do not have " + std::to_string(wanted.components) + " components");
    return false;
  }
  const uint64_t needed = times.count * uint64_t{strideOf(sampler)} / static_cast<uint64_t>(wanted.components);
  if (values.count == needed) return true;
  refuse(doc, place + "/output",
         "has " + std::to_string(values.count) + " elements instead of " + std::to_string(needed) + " for " +
             std::to_string(times.count) + " keys");
  return false;
}

Result<MaybeSampler> readSampler(AnimationReader& reader, int index, const Wanted& wanted) {
  Document& doc = reader.doc;
  const Json& from = (*reader.samplers)[static_cast<size_t>(index)];
  const std::string place = pointer(reader.place + "/samplers", static_cast<size_t>(index));
  if (!from.is_object()) return doc.error(place, "is not an object");
  const auto input = accessorOf(doc, from, "input", place), output = accessorOf(doc, from, "output", place);
  if (!input) return tl::unexpected(input.error());
  if (!output) return tl::unexpected(output.error());
  const auto interpolation = interpolationOf(doc, from, wanted, place);
  if (!interpolation) return MaybeSampler();
  scene::AnimationSampler sampler;
  sampler.interpolation = *interpolation;
  sampler.width = wanted.width;
  if (!fits(doc, sampler, wanted, *input, *output, place)) return MaybeSampler();
  const uint64_t keys = accessorAt(doc, *input).count;
  reader.bytes += keys * sizeof(float) * (1 + uint64_t{strideOf(sampler)});
  if (reader.bytes > doc.limits.geometryBytes) return MaybeSampler();  // the caller says so
  sampler.times.resize(keys);
  sampler.values.resize(keys * strideOf(sampler));
  readFloats(doc, *input, 1, sampler.times.data());
  readFloats(doc, *output, wanted.components, sampler.values.data(), wanted.normalized);
  const bool unitLength = wanted.rotation && sampler.interpolation != Interpolation::cubicSpline;
  spreadJumps(doc, sampler, place);
  dropBadKeys(doc, sampler, unitLength, place);
  if (sampler.times.empty()) {
    refuse(doc, place, "has no keys");
    return MaybeSampler();
  }
  const bool quantised = !isFloatingPoint(accessorAt(doc, *output).componentType);
  if (unitLength) makeUnit(doc, sampler, quantised, place + "/output");
  return MaybeSampler(std::move(sampler));
}

// Index in animation.samplers; -1 where it cannot be used.
Result<int> samplerFor(AnimationReader& reader, int index, const Wanted& wanted) {
  const auto [known, isNew] = reader.known.try_emplace({index, wanted}, -1);
  if (!isNew) return known->second;
  auto sampler = readSampler(reader, index, wanted);
  if (!sampler) return tl::unexpected(sampler.error());
  if (*sampler) {
    known->second = static_cast<int>(reader.animation.samplers.size());
    reader.animation.samplers.push_back(std::move(**sampler));
  }
  return known->second;
}

Result<void> checkBytes(const AnimationReader& reader) {
  if (reader.bytes <= reader.doc.limits.geometryBytes) return {};
  return reader.doc.error(reader.place,
                          "the animations take more than " + std::to_string(reader.doc.limits.geometryBytes) + " bytes",
                          "use a smaller model");
}

Result<void> readChannel(AnimationReader& reader, const Json& from, const std::string& place) {
  Document& doc = reader.doc;
  if (!from.is_object()) return doc.error(place, "is not an object");
  const auto found = from.find("sampler");
  const auto sampler =
      readIndex(doc, found == from.end() ? Json() : *found, reader.samplers->size(), place + "/sampler", "sampler");
  if (!sampler) return tl::unexpected(sampler.error());
  const auto targets = animationTargets(doc, from, reader.users, place);
  if (!targets) return tl::unexpected(targets.error());
  for (const AnimationTarget& target : *targets) {
    const auto index = samplerFor(reader, *sampler, Wanted(target));
    if (!index) return tl::unexpected(index.error());
    reader.bytes += sizeof(scene::AnimationChannel);
    if (auto ok = checkBytes(reader); !ok) return ok;
    if (*index == -1) continue;
    reader.animation.channels.push_back(target.channel);
    reader.animation.channels.back().sampler = *index;
  }
  return {};
}

// glTF forbids two channels that set the same; the later one counts.
void noteDuplicates(Document& doc, const scene::Animation& animation, const std::string& place) {
  std::set<std::tuple<AnimatedProperty, int, scene::TextureSlot, int>> seen;
  size_t twice = 0;
  for (const auto& c : animation.channels)
    twice += seen.insert({c.property, c.object, c.slot, c.element}).second ? 0 : 1;
  if (twice > 0) {
    doc.info(place + "/channels",
             std::to_string(twice) + " set what another one before them sets, too: the last one counts");
  }
}

const Json& arrayAt(const Json& object, const char* key) {
  static const Json empty = Json::array();
  const auto found = object.find(key);
  return found != object.end() && found->is_array() ? *found : empty;
}

}  // namespace

Result<void> readAnimations(Document& doc) {
  const auto animations = section(doc, "animations");
  if (!animations) return tl::unexpected(animations.error());
  if (animations->empty()) return {};
  const MeshUsers users = meshUsers(doc.model);
  uint64_t bytes = 0;
  for (size_t i = 0; i < animations->size(); ++i) {
    const Json& from = (*animations)[i];
    AnimationReader reader{doc, users, bytes};
    reader.place = pointer("/animations", i);
    reader.samplers = &arrayAt(from, "samplers");
    reader.animation.name = stringAt(from, "name");
    const Json& channels = arrayAt(from, "channels");
    for (size_t c = 0; c < channels.size(); ++c) {
      const auto ok = readChannel(reader, channels[c], pointer(reader.place + "/channels", c));
      if (auto fits = checkBytes(reader); !fits) return fits;
      if (!ok) doc.lost(ok.error(), "the channel is left out");
    }
    noteDuplicates(doc, reader.animation, reader.place);
    doc.model.animations.push_back(std::move(reader.animation));
  }
  return {};
}

}  // namespace facet::io
