#include "view/edit_panel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/text.hpp"
#include "scene/edited.hpp"
#include "scene/material_properties.hpp"
#include "scene/nodes.hpp"
#include "scene/properties.hpp"
#include "scene/usage.hpp"
#include "view/beside_panel.hpp"
#include "view/scene_tree.hpp"
#include "view/style.hpp"
#include "view/widgets.hpp"

namespace facet::view {

namespace {

using scene::Owner;
using Values = std::vector<double>;

std::string pointerTo(Owner owner, int object, std::string_view path) {
  return std::string(scene::listPath(owner)) + std::to_string(object) + "/" + std::string(path);
}

// A float's value as one would write it: 0.2, not 0.200000003.
double brief(float value) { return *parseNumber(number(value), -1e38, 1e38); }

enum class Shape { number, color, vector };

// One control.
struct Control {
  std::string pointer, label;
  Values usual;  // the file's
  Shape shape = Shape::number;
  double low = 0, high = 1;  // of a number; without an end: it is dragged
  double factor = 1;         // from its value to what is shown
};

bool same(const Values& a, const Values& b) {
  return std::ranges::equal(
      a, b, {}, [](double x) { return static_cast<float>(x); }, [](double x) { return static_cast<float>(x); });
}

bool numberControl(const char* label, const Control& control, float& value) {
  const auto low = static_cast<float>(control.low * control.factor),
             high = static_cast<float>(control.high * control.factor);
  if (std::isfinite(high) && high < 1e6f) return numberedSlider(label, value, low, high, "%.3g");
  return ImGui::DragFloat(label, &value, std::max(0.01f * std::abs(value), 0.001f), low, 1e18f, "%.4g",
                          ImGuiSliderFlags_AlwaysClamp);
}

bool colorControl(const char* label, Values& values) {
  glm::vec3 linear(values[0], values[1], values[2]);
  const glm::vec3 before = linear;
  editColor(label, linear, linear, "");
  if (linear == before) return false;
  for (int c = 0; c < 3; ++c) values[static_cast<size_t>(c)] = brief(linear[c]);
  return true;
}

bool vectorControl(const char* label, Values& values) {
  std::array<float, 4> shown{};
  for (size_t i = 0; i < values.size(); ++i) shown[i] = static_cast<float>(values[i]);
  const double length = std::abs(*std::ranges::max_element(values, {}, [](double v) { return std::abs(v); }));
  const auto speed = static_cast<float>(std::max(0.005 * length, 0.002));
  if (!ImGui::DragScalarN(label, ImGuiDataType_Float, shown.data(), static_cast<int>(values.size()), speed, nullptr,
                          nullptr, "%.4g"))
    return false;
  for (size_t i = 0; i < values.size(); ++i) values[i] = brief(shown[i]);
  return true;
}

// With a mark where it is not the file's; a right click gives it back.
void edit(scene::Edits& edits, const Control& control) {
  const scene::Edit* found = scene::findEdit(edits, control.pointer);
  Values values = found && found->values.size() == control.usual.size() ? found->values : control.usual;
  const bool changed = !same(values, control.usual);
  const std::string label = control.label + (changed ? " *" : "") + "###" + control.pointer;
  bool moved = false;
  ImGui::BeginGroup();
  if (control.shape == Shape::number) {
    auto value = static_cast<float>(values[0] * control.factor);
    moved = numberControl(label.c_str(), control, value);
    if (moved) values[0] = control.factor == 1 ? brief(value) : static_cast<double>(value) / control.factor;
  } else {
    moved = control.shape == Shape::color ? colorControl(label.c_str(), values) : vectorControl(label.c_str(), values);
  }
  ImGui::EndGroup();
  if (changed && resetAsked()) return scene::removeEdit(edits, control.pointer);
  if (changed && ImGui::IsItemHovered() && ImGui::GetIO().KeyShift) hint(control.pointer);
  if (!moved) return;
  if (same(values, control.usual))
    scene::removeEdit(edits, control.pointer);
  else
    scene::setEdit(edits, control.pointer, values);
}

// On or off, as one number.
void editFlag(scene::Edits& edits, const std::string& pointer, const char* label, bool usual) {
  const scene::Edit* found = scene::findEdit(edits, pointer);
  bool on = found && !found->values.empty() ? found->values[0] != 0 : usual;
  const std::string text = label + std::string(on != usual ? " *" : "") + "###" + pointer;
  if (!ImGui::Checkbox(text.c_str(), &on)) return;
  if (on == usual)
    scene::removeEdit(edits, pointer);
  else
    scene::setEdit(edits, pointer, {on ? 1.0 : 0.0});
}

// "extensions/KHR_materials_clearcoat/clearcoatRoughnessFactor": "clearcoat roughness".
std::string labelOf(std::string_view path) {
  std::string_view last = path.substr(path.rfind('/') + 1);
  std::string head;
  if (last == "scale" || last == "strength") {  // of a texture, whose name says of what
    std::string_view texture = path.substr(0, path.rfind('/'));
    head = texture.substr(texture.rfind('/') + 1);
    if (head.ends_with("Texture")) head.resize(head.size() - 7);
    head += ' ';
  }
  if (last.ends_with("Factor")) last.remove_suffix(6);
  for (const char c : std::string(last)) {
    const bool capital = c >= 'A' && c <= 'Z';
    if (capital) head += ' ';
    head += capital ? static_cast<char>(c + 32) : c;
  }
  return head;
}

Values valuesOf(const scene::Material& material, const scene::MaterialProperty& property) {
  scene::Material copy = material;
  Values values;
  for (const float v : scene::components(copy, property)) values.push_back(brief(v));
  return values;
}

Control controlOf(const scene::Material& material, const scene::MaterialProperty& property, std::string pointer) {
  Control control{std::move(pointer), labelOf(property.path), valuesOf(material, property)};
  control.low = property.low, control.high = property.high;
  if (control.usual.size() >= 3 && property.high <= 1) control.shape = Shape::color;
  if (control.usual.size() >= 3 && control.shape != Shape::color) control.shape = Shape::vector;
  const bool angle = property.property == scene::AnimatedProperty::anisotropyRotation;
  if (angle) control.low = 0, control.high = 2 * glm::pi<double>(), control.factor = 180 / glm::pi<double>();
  return control;
}

// A colour's fourth component by itself.
void editCoverage(scene::Edits& edits, const Control& color) {
  const scene::Edit* found = scene::findEdit(edits, color.pointer);
  Values values = found && found->values.size() == 4 ? found->values : color.usual;
  auto alpha = static_cast<float>(values[3]);
  const std::string label = "alpha###" + color.pointer + "/3";
  bool moved = numberedSlider(label.c_str(), alpha, 0, 1, "%.3g");
  if (resetAsked()) alpha = static_cast<float>(color.usual[3]), moved = true;
  if (!moved) return;
  values[3] = brief(alpha);
  if (same(values, color.usual))
    scene::removeEdit(edits, color.pointer);
  else
    scene::setEdit(edits, color.pointer, values);
}

bool isCore(scene::AnimatedProperty property) {
  using enum scene::AnimatedProperty;
  constexpr scene::AnimatedProperty core[] = {baseColorFactor, metallicFactor, perceptualRoughnessFactor,
                                              emissiveFactor};
  return std::ranges::find(core, property) != std::end(core);
}

// What a material has of itself, or has been given; the rest is in a list to be added from.
void editProperties(scene::Edits& edits, const scene::Material& material, const std::string& head) {
  std::vector<Control> further;
  for (const scene::MaterialProperty& property : scene::materialProperties()) {
    Control control = controlOf(material, property, head + property.path);
    const bool own = isCore(property.property) || !same(control.usual, valuesOf({}, property));
    if (!own && !scene::findEdit(edits, control.pointer)) {
      further.push_back(std::move(control));
      continue;
    }
    edit(edits, control);
    if (control.usual.size() == 4) editCoverage(edits, control);
  }
  ImGui::SetNextItemWidth(-FLT_MIN);
  if (!beginList(("##further" + head).c_str(), "further properties")) return;
  for (const Control& control : further)
    if (ImGui::Selectable((control.label + "##" + control.pointer).c_str()))
      scene::setEdit(edits, control.pointer, control.usual);
  ImGui::EndCombo();
}

void editAlphaMode(scene::Edits& edits, const scene::Material& material, const std::string& pointer) {
  constexpr const char* modes[] = {"opaque", "mask", "blend"};
  const scene::Edit* found = scene::findEdit(edits, pointer);
  const auto usual = static_cast<size_t>(material.alphaMode);
  const size_t chosen = found && !found->values.empty() ? static_cast<size_t>(found->values[0]) : usual;
  const std::string label = std::string("alpha mode") + (chosen != usual ? " *" : "") + "###" + pointer;
  if (!beginList(label.c_str(), modes[chosen])) {
    if (resetAsked()) scene::removeEdit(edits, pointer);
    return;
  }
  for (size_t i = 0; i < std::size(modes); ++i) {
    if (!ImGui::Selectable(modes[i], i == chosen)) continue;
    if (i == usual)
      scene::removeEdit(edits, pointer);
    else
      scene::setEdit(edits, pointer, {static_cast<double>(i)});
  }
  ImGui::EndCombo();
}

const ShownTexture* textureOf(const ViewerState& state, int texture) {
  const scene::Model& model = *state.shown.content;
  const int image = model.textures[static_cast<size_t>(texture)].image;
  const auto found = std::ranges::find(state.shown.textures, image, &ShownTexture::image);
  return found == state.shown.textures.end() ? nullptr : &*found;
}

void editTextures(ViewerState& state, const scene::Material& material, const std::string& head) {
  scene::Edits& edits = state.settings.placement.arrangement.edits;
  for (const scene::TextureSlot slot : scene::textureSlots) {
    const scene::TextureRef& ref = scene::textureRef(material, slot);
    if (!ref) continue;
    const std::string pointer = head + std::string(scene::path(slot));
    bool on = !scene::findEdit(edits, pointer);
    const std::string label = labelOf(scene::name(slot)) + (on ? "" : " *") + "###" + pointer;
    if (ImGui::Checkbox(label.c_str(), &on)) {
      if (on)
        scene::removeEdit(edits, pointer);
      else
        scene::setEdit(edits, pointer, {});
    }
    if (const ShownTexture* shown = textureOf(state, ref.texture)) textureHint(*shown);
  }
}

// Degrees about X, Y and Z, from and to a quaternion.
void editRotation(scene::Edits& edits, const std::string& pointer, const glm::dquat& usual) {
  const scene::Edit* found = scene::findEdit(edits, pointer);
  const bool changed = found && found->values.size() == 4;
  const glm::dquat now =
      changed ? glm::dquat(found->values[3], found->values[0], found->values[1], found->values[2]) : usual;
  Values degrees(3);
  const glm::dvec3 angles = glm::degrees(glm::eulerAngles(glm::normalize(now)));
  for (int i = 0; i < 3; ++i) degrees[static_cast<size_t>(i)] = std::round(angles[i] * 1000) / 1000;
  const bool moved =
      vectorControl((std::string("rotation") + (changed ? " *" : "") + "###" + pointer).c_str(), degrees);
  hint("degrees about X, Y, Z");
  if (changed && resetAsked()) return scene::removeEdit(edits, pointer);
  if (!moved) return;
  const glm::dquat q = glm::normalize(glm::dquat(glm::radians(glm::dvec3(degrees[0], degrees[1], degrees[2]))));
  const auto rounded = [](double x) { return std::round(x * 1e6) / 1e6; };
  scene::setEdit(edits, pointer, {rounded(q.x), rounded(q.y), rounded(q.z), rounded(q.w)});
}

void editWeights(scene::Edits& edits, const scene::Model& model, int index) {
  const scene::Node& node = model.nodes[static_cast<size_t>(index)];
  const size_t count = scene::morphTargetCount(model, node.mesh);
  if (count == 0) return;
  const scene::Mesh& mesh = model.meshes[static_cast<size_t>(node.mesh)];
  const std::vector<float>& own = node.weights.empty() ? mesh.weights : node.weights;
  ImGui::TextDisabled("morph targets");
  for (size_t i = 0; i < count; ++i) {
    const bool named = i < mesh.targetNames.size() && !mesh.targetNames[i].empty();
    Control control{pointerTo(Owner::node, index, "weights/" + std::to_string(i)),
                    named ? mesh.targetNames[i] : "target " + std::to_string(i),
                    {i < own.size() ? brief(own[i]) : 0.0}};
    edit(edits, control);
  }
}

}  // namespace

bool isHidden(const ViewerState& state, int node) {
  const std::string pointer = pointerTo(Owner::node, node, "extensions/KHR_node_visibility/visible");
  const scene::Edit* found = scene::findEdit(state.settings.placement.arrangement.edits, pointer);
  if (found && !found->values.empty()) return found->values[0] == 0;
  return !state.shown.content->nodes[static_cast<size_t>(node)].visible;
}

void setHidden(ViewerState& state, int node, bool hidden) {
  const std::string pointer = pointerTo(Owner::node, node, "extensions/KHR_node_visibility/visible");
  scene::Edits& edits = state.settings.placement.arrangement.edits;
  if (hidden != state.shown.content->nodes[static_cast<size_t>(node)].visible)
    scene::removeEdit(edits, pointer);
  else
    scene::setEdit(edits, pointer, {hidden ? 0.0 : 1.0});
}

void editBar(ViewerState& state, PanelResult& result) {
  frame::Arrangement& arrangement = state.settings.placement.arrangement;
  const bool changed = arrangement != frame::Arrangement{};
  if (!changed && state.history.past.empty() && state.history.future.empty()) return;
  const auto button = [](const char* label, bool there, const std::string& explanation) {
    ImGui::BeginDisabled(!there);
    const bool pressed = ImGui::Button(label);
    ImGui::EndDisabled();
    hint(explanation);
    return pressed;
  };
  if (button("undo", !state.history.past.empty(), withKeys("the last change", state.keys, Command::undo)))
    undo(state.history, state.settings);
  ImGui::SameLine();
  if (button("redo", !state.history.future.empty(), withKeys("what was undone", state.keys, Command::redo)))
    redo(state.history, state.settings);
  ImGui::SameLine();
  if (button("as the file", changed, "gives up all that is changed of the model")) arrangement = {};
  ImGui::SameLine();
  if (button("export", changed, "the changed model as .glb into the folder in which facet was started"))
    result.exportModel = true;
}

void editNode(ViewerState& state, int index) {
  const scene::Model& model = *state.shown.content;
  scene::Edits& edits = state.settings.placement.arrangement.edits;
  scene::Node node = model.nodes[static_cast<size_t>(index)];
  scene::decompose(node);
  std::vector<std::string>& only = state.settings.placement.arrangement.only;
  bool shown = !isHidden(state, index);
  if (ImGui::Checkbox("shown", &shown)) setHidden(state, index, !shown);
  ImGui::SameLine();
  const std::string name = std::to_string(index);
  bool alone = only.size() == 1 && only[0] == name;
  if (ImGui::Checkbox("alone", &alone)) only = alone ? std::vector{name} : std::vector<std::string>();
  hint("this and what is below it, nothing else");
  const auto vector = [&](const char* path, const glm::dvec3& usual) {
    edit(edits, {pointerTo(Owner::node, index, path), path, {usual.x, usual.y, usual.z}, Shape::vector});
  };
  vector("translation", node.translation);
  editRotation(edits, pointerTo(Owner::node, index, "rotation"), node.rotation);
  vector("scale", node.scale);
  editWeights(edits, model, index);
}

void editLight(ViewerState& state, int index) {
  const scene::Light& light = state.shown.content->lights[static_cast<size_t>(index)];
  scene::Edits& edits = state.settings.placement.arrangement.edits;
  const auto& nodes = state.shown.content->nodes;
  const bool profiled = light.profile >= 0;  // its numbers are its node's
  const auto node = std::ranges::find(nodes, index, &scene::Node::profiledLight) - nodes.begin();
  const auto pointer = [&](const std::string& path) {
    return profiled ? pointerTo(Owner::node, static_cast<int>(node), ("extensions/EXT_lights_ies/" + path).c_str())
                    : pointerTo(Owner::light, index, path.c_str());
  };
  constexpr double unbounded = std::numeric_limits<double>::infinity(), toDegrees = 180 / glm::pi<double>();
  edit(edits,
       {pointer("color"), "light", {brief(light.color.r), brief(light.color.g), brief(light.color.b)}, Shape::color});
  const bool directional = light.type == scene::LightType::directional;
  edit(edits, {pointer(profiled ? "multiplier" : "intensity"),
               directional ? "lux"
               : profiled  ? "multiplier"
                           : "candela",
               {brief(light.intensity)},
               Shape::number,
               0,
               unbounded});
  if (!directional && std::isfinite(light.range))
    edit(edits, {pointer("range"), "range", {brief(light.range)}, Shape::number, 1e-6, unbounded});
  if (light.type != scene::LightType::spot) return;
  constexpr double right = glm::half_pi<double>();
  edit(edits, {pointer("spot/innerConeAngle"),
               "inner cone",
               {brief(light.innerConeAngle)},
               Shape::number,
               0,
               right,
               toDegrees});
  edit(edits, {pointer("spot/outerConeAngle"),
               "outer cone",
               {brief(light.outerConeAngle)},
               Shape::number,
               0.001,
               right,
               toDegrees});
}

void editMaterial(ViewerState& state, int index) {
  const scene::Material& material = state.shown.content->materials[static_cast<size_t>(index)];
  scene::Edits& edits = state.settings.placement.arrangement.edits;
  const std::string head = pointerTo(Owner::material, index, "");
  if (materialSource(state.settings) != MaterialSource::file)
    ImGui::TextWrapped("Another material is in its place: see Material in the settings.");
  editProperties(edits, material, head);
  editAlphaMode(edits, material, head + "alphaMode");
  editFlag(edits, head + "doubleSided", "double sided", material.doubleSided);
  editTextures(state, material, head);
}

void modelSection(ViewerState& state) {
  if (!section(state.layout, "Model", false)) return;
  frame::Arrangement& arrangement = state.settings.placement.arrangement;
  chooseEnum("up", arrangement.up, frame::upAxes, frame::UpAxis::y, "the model's axis that points up");
  const auto vector = [](const char* label, glm::dvec3& value, const char* explanation) {
    Values values = {value.x, value.y, value.z};
    if (vectorControl(label, values)) value = {values[0], values[1], values[2]};
    if (resetAsked()) value = glm::dvec3(0);
    resettableHint(explanation);
  };
  vector("rotation##model", arrangement.rotationDeg, "degrees about the axes of the world, X first");
  arrangement.rotationDeg = glm::clamp(arrangement.rotationDeg, glm::dvec3(-36000), glm::dvec3(36000));
  vector("position##model", arrangement.position, "metres");
  arrangement.position = glm::clamp(arrangement.position, glm::dvec3(-1e9), glm::dvec3(1e9));
  auto scale = static_cast<float>(arrangement.scale);
  if (ImGui::DragFloat("scale##model", &scale, 0.01f * scale, 1e-9f, 1e9f, "%.4g", ImGuiSliderFlags_AlwaysClamp))
    arrangement.scale = std::clamp(brief(scale), 1e-9, 1e9);
  if (resetAsked()) arrangement.scale = 1;
  resettableHint("of the model");
  secondModelChoice(state);
}

void materialLayers(frame::PictureSettings& settings) {
  scene::Edits& edits = settings.look.material.edits;
  std::vector<Control> further;
  for (const scene::MaterialProperty& property : scene::materialProperties()) {
    const std::string_view path = property.path;
    const bool ofLayer = path.starts_with("extensions/") && path.find("Texture/") == std::string_view::npos;
    if (!ofLayer || path.ends_with("/ior")) continue;
    Control control = controlOf({}, property, "/" + std::string(path));
    if (scene::findEdit(edits, control.pointer))
      edit(edits, control);
    else
      further.push_back(std::move(control));
  }
  ImGui::SetNextItemWidth(-FLT_MIN);
  if (!beginList("##layers", "coat, sheen, glass and others")) return;
  for (const Control& control : further)
    if (ImGui::Selectable((control.label + "##" + control.pointer).c_str())) {
      scene::setEdit(edits, control.pointer, control.usual);
    }
  ImGui::EndCombo();
}

}  // namespace facet::view
