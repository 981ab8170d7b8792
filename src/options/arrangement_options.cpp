#include "options/arrangement_options.hpp"

#include "base/text.hpp"
#include "frame/settings.hpp"

namespace facet::options {

using frame::PictureSettings;

namespace {

std::string vectorOr(const glm::dvec3& vector, const glm::dvec3& usual) {
  return vector == usual ? std::string() : writeVector(vector);
}

}  // namespace

Result<glm::dvec3> parseVector(std::string_view text, double most, std::string_view what, std::string_view example) {
  const std::vector<std::string_view> parts = split(text, ',');
  if (parts.size() != 3)
    return fail({}, {}, inQuotes(text) + " is not " + std::string(what), "give X,Y,Z " + std::string(example));
  glm::dvec3 vector;
  for (int i = 0; i < 3; ++i) {
    const Result<double> value = parseNumber(parts[static_cast<size_t>(i)], -most, most);
    if (!value) return tl::unexpected(value.error());
    vector[i] = *value;
  }
  return vector;
}

std::string writeVector(const glm::dvec3& vector) {
  return number(vector.x) + "," + number(vector.y) + "," + number(vector.z);
}

Result<void> parseSet(std::string_view text, PictureSettings& settings) {
  return scene::parseEdits(text).map(
      [&](scene::Edits edits) { settings.placement.arrangement.edits = std::move(edits); });
}
std::string writeSet(const PictureSettings& settings) {
  return scene::writeEdits(settings.placement.arrangement.edits);
}

Result<void> parseMaterialSet(std::string_view text, PictureSettings& settings) {
  Result<scene::Edits> edits = scene::parseEdits(text);
  if (!edits) return tl::unexpected(edits.error());
  return frame::chooseLayers(settings.look.material, std::move(*edits));
}
std::string writeMaterialSet(const PictureSettings& settings) {
  return settings.look.material.on ? scene::writeEdits(settings.look.material.edits) : std::string();
}

Result<void> parseOnly(std::string_view text, PictureSettings& settings) {
  std::vector<std::string> nodes;
  for (const std::string_view name : split(text, ','))
    if (!name.empty()) nodes.emplace_back(name);
  if (nodes.empty()) return fail({}, {}, "no node is named", "give names or indices of nodes");
  settings.placement.arrangement.only = std::move(nodes);
  return {};
}
std::string writeOnly(const PictureSettings& settings) {
  std::string text;
  for (const std::string& name : settings.placement.arrangement.only) text += (text.empty() ? "" : ",") + name;
  return text;
}

Result<void> parseRotation(std::string_view text, PictureSettings& settings) {
  return parseVector(text, 36000, "a rotation", "in degrees such as 0,90,0").map([&](const glm::dvec3& degrees) {
    settings.placement.arrangement.rotationDeg = degrees;
  });
}
std::string writeRotation(const PictureSettings& settings) {
  return vectorOr(settings.placement.arrangement.rotationDeg, glm::dvec3(0));
}

Result<void> parsePosition(std::string_view text, PictureSettings& settings) {
  return parseVector(text, 1e9, "a position", "in metres such as 0,1.5,0").map([&](const glm::dvec3& metres) {
    settings.placement.arrangement.position = metres;
  });
}
std::string writePosition(const PictureSettings& settings) {
  return vectorOr(settings.placement.arrangement.position, glm::dvec3(0));
}

Result<void> parseScale(std::string_view text, PictureSettings& settings) {
  return parseNumber(text, 1e-9, 1e9).map([&](double scale) { settings.placement.arrangement.scale = scale; });
}
std::string writeScale(const PictureSettings& settings) {
  return settings.placement.arrangement.scale == 1 ? std::string() : number(settings.placement.arrangement.scale);
}

}  // namespace facet::options
