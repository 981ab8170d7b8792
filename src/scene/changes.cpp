#include "scene/changes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "base/text.hpp"
#include "scene/animation.hpp"
#include "scene/material_properties.hpp"
#include "scene/nodes.hpp"
#include "scene/pick.hpp"
#include "scene/properties.hpp"
#include "scene/usage.hpp"

namespace facet::scene {

namespace {

using Lines = std::vector<std::string>;

std::string shortNumber(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

void told(Lines& lines, const std::string& what, const std::string& from, const std::string& to) {
  if (from != to) lines.push_back(what + " " + from + " -> " + to);
}

// Index by name; what has none, or shares its own, cannot be told apart and is left to the counts.
template <class T>
std::map<std::string, size_t> uniqueNames(const std::vector<T>& things) {
  std::map<std::string, size_t> found;
  std::map<std::string, int> times;
  for (size_t i = 0; i < things.size(); ++i) found[things[i].name] = i, ++times[things[i].name];
  for (const auto& [name, count] : times)
    if (count > 1 || name.empty()) found.erase(name);
  return found;
}

// compare(prefix, before, after) of those that both have.
template <class T, class Compare>
void compareNamed(Lines& lines, const char* kind, const std::vector<T>& before, const std::vector<T>& after,
                  const Compare& compare) {
  const std::string kinds = std::string(kind) + (kind == std::string_view("mesh") ? "es:" : "s:");
  told(lines, kinds, std::to_string(before.size()), std::to_string(after.size()));
  const auto has = [](const std::vector<T>& things, const std::string& name) {
    return std::ranges::any_of(things, [&](const T& thing) { return thing.name == name; });
  };
  const std::map<std::string, size_t> was = uniqueNames(before), is = uniqueNames(after);
  for (const auto& [name, index] : was) {
    const std::string prefix = std::string(kind) + " " + inQuotes(name) + ":";
    if (!has(after, name))
      lines.push_back(prefix + " is gone");
    else if (const auto same = is.find(name); same != is.end())
      compare(prefix, before[index], after[same->second]);
  }
  for (const auto& [name, index] : is)
    if (!has(before, name)) lines.push_back(std::string(kind) + " " + inQuotes(name) + ": is new");
}

struct Geometry {
  size_t vertices = 0, triangles = 0;
};
Geometry geometryOf(const Mesh& mesh) {
  Geometry sum;
  for (const Primitive& p : mesh.primitives) sum.vertices += p.positions.size(), sum.triangles += triangleCount(p);
  return sum;
}
Geometry geometryOf(const Model& model) {
  Geometry sum;
  for (const Mesh& mesh : model.meshes) {
    const Geometry one = geometryOf(mesh);
    sum.vertices += one.vertices, sum.triangles += one.triangles;
  }
  return sum;
}

// prefix: of a mesh; the whole model has none.
void compareGeometry(Lines& lines, const std::string& prefix, const Geometry& was, const Geometry& is) {
  const auto name = [&](const char* what) { return prefix.empty() ? what + std::string(":") : prefix + " " + what; };
  told(lines, name("vertices"), std::to_string(was.vertices), std::to_string(is.vertices));
  told(lines, name("triangles"), std::to_string(was.triangles), std::to_string(is.triangles));
}

std::string numbers(std::span<const float> values) {
  std::string text;
  for (const float value : values) text += (text.empty() ? "" : ", ") + shortNumber(static_cast<double>(value));
  return text;
}

std::string imageOf(const Model& model, const TextureRef& ref) {
  if (!ref) return "none";
  const int image = model.textures[static_cast<size_t>(ref.texture)].image;
  if (image < 0) return "no image";
  const std::string& name = model.images[static_cast<size_t>(image)].name;
  return name.empty() ? "an image" : inQuotes(name);
}

void compareMaterials(Lines& lines, const Model& before, const Model& after) {
  compareNamed(lines, "material", before.materials, after.materials,
               [&](const std::string& prefix, Material was, Material is) {
                 for (const MaterialProperty& property : materialProperties())
                   told(lines, prefix + " " + std::string(lastToken(property.path)), numbers(components(was, property)),
                        numbers(components(is, property)));
                 for (const TextureSlot slot : textureSlots)
                   told(lines, prefix + " " + name(slot), imageOf(before, textureRef(was, slot)),
                        imageOf(after, textureRef(is, slot)));
                 constexpr const char* modes[] = {"OPAQUE", "MASK", "BLEND"};
                 told(lines, prefix + " alphaMode", modes[static_cast<int>(was.alphaMode)],
                      modes[static_cast<int>(is.alphaMode)]);
                 const auto flag = [](bool on) { return on ? "yes" : "no"; };
                 told(lines, prefix + " doubleSided", flag(was.doubleSided), flag(is.doubleSided));
                 told(lines, prefix + " unlit", flag(was.unlit), flag(is.unlit));
               });
}

// To what a float holds: the same placement may be written as a matrix.
bool samePlace(const Node& a, const Node& b) {
  const glm::dmat4 was = localTransform(a), is = localTransform(b);
  double largest = 0, difference = 0;
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      largest = std::max(largest, std::abs(was[c][r])),
      difference = std::max(difference, std::abs(was[c][r] - is[c][r]));
  return difference <= 1e-5 * largest;
}

std::string sizeText(const Bounds& bounds) {
  if (bounds.empty()) return "nothing";
  const glm::dvec3 size = bounds.max - bounds.min;
  return shortNumber(size.x) + " x " + shortNumber(size.y) + " x " + shortNumber(size.z) + " m";
}

void compareExtensions(Lines& lines, const std::vector<std::string>& before, const std::vector<std::string>& after) {
  for (const std::string& name : before)
    if (std::ranges::find(after, name) == after.end()) lines.push_back("extension " + name + ": is gone");
  for (const std::string& name : after)
    if (std::ranges::find(before, name) == before.end()) lines.push_back("extension " + name + ": is new");
}

struct Named {
  std::string name;
};
std::vector<Named> namesOf(const std::vector<std::string>& names) {
  std::vector<Named> named;
  for (const std::string& name : names) named.push_back({name});
  return named;
}

}  // namespace

std::vector<std::string> changesBetween(const Model& before, const Model& after) {
  Lines lines;
  told(lines, "size:", sizeText(sceneBounds(before, before.defaultScene)),
       sizeText(sceneBounds(after, after.defaultScene)));
  compareGeometry(lines, "", geometryOf(before), geometryOf(after));
  const auto nothing = [](const std::string&, const auto&, const auto&) {};
  compareNamed(lines, "scene", before.scenes, after.scenes, nothing);
  compareNamed(lines, "node", before.nodes, after.nodes,
               [&](const std::string& prefix, const Node& was, const Node& is) {
                 if (!samePlace(was, is)) lines.push_back(prefix + " is placed otherwise");
                 told(lines, prefix + " visible", was.visible ? "yes" : "no", is.visible ? "yes" : "no");
               });
  compareNamed(lines, "mesh", before.meshes, after.meshes,
               [&](const std::string& prefix, const Mesh& was, const Mesh& is) {
                 compareGeometry(lines, prefix, geometryOf(was), geometryOf(is));
               });
  compareMaterials(lines, before, after);
  compareNamed(lines, "image", before.images, after.images, nothing);
  compareNamed(lines, "light", before.lights, after.lights,
               [&](const std::string& prefix, const Light& was, const Light& is) {
                 told(lines, prefix + " intensity", numbers({&was.intensity, 1}), numbers({&is.intensity, 1}));
                 told(lines, prefix + " colour", numbers({&was.color.x, 3}), numbers({&is.color.x, 3}));
                 told(lines, prefix + " range", numbers({&was.range, 1}), numbers({&is.range, 1}));
               });
  compareNamed(lines, "camera", before.cameras, after.cameras,
               [&](const std::string& prefix, const Camera& was, const Camera& is) {
                 const auto kind = [](const Camera& c) { return c.perspective ? "perspective" : "orthographic"; };
                 told(lines, prefix + " projection", kind(was), kind(is));
                 if (was.perspective && is.perspective)
                   told(lines, prefix + " yfov", shortNumber(was.fovY), shortNumber(is.fovY));
                 if (!was.perspective && !is.perspective)
                   told(lines, prefix + " ymag", shortNumber(was.yMag), shortNumber(is.yMag));
               });
  compareNamed(lines, "skin", before.skins, after.skins,
               [&](const std::string& prefix, const Skin& was, const Skin& is) {
                 told(lines, prefix + " joints", std::to_string(was.joints.size()), std::to_string(is.joints.size()));
               });
  compareNamed(lines, "animation", before.animations, after.animations,
               [&](const std::string& prefix, const Animation& was, const Animation& is) {
                 told(lines, prefix + " seconds", shortNumber(duration(was)), shortNumber(duration(is)));
                 told(lines, prefix + " channels", std::to_string(was.channels.size()),
                      std::to_string(is.channels.size()));
               });
  compareNamed(lines, "variant", namesOf(before.variants), namesOf(after.variants), nothing);
  compareExtensions(lines, before.extensionsUsed, after.extensionsUsed);
  return lines;
}

}  // namespace facet::scene
