#include "view/scene_panel.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <string_view>

#include "scene/geometry.hpp"
#include "scene/nodes.hpp"
#include "view/edit_panel.hpp"
#include "view/inspector.hpp"
#include "view/scene_tree.hpp"
#include "view/statistics_panel.hpp"
#include "view/style.hpp"
#include "view/text_fit.hpp"
#include "view/widgets.hpp"

namespace facet::view {

namespace {

std::string format(const char* pattern, double a, double b = 0, double c = 0) {
  char text[96];
  std::snprintf(text, sizeof text, pattern, a, b, c);
  return text;
}

std::string vectorText(const glm::dvec3& v, const char* pattern = "%.4g  %.4g  %.4g") {
  return format(pattern, v.x, v.y, v.z);
}

size_t triangleCount(const scene::Mesh& mesh) {
  size_t count = 0;
  for (const scene::Primitive& p : mesh.primitives) {
    const size_t corners = p.indices.empty() ? p.positions.size() : p.indices.size();
    if (p.topology == scene::Topology::triangles) count += corners / 3;
    if (p.topology == scene::Topology::triangleStrip || p.topology == scene::Topology::triangleFan)
      count += corners > 2 ? corners - 2 : 0;
  }
  return count;
}

std::string meshText(const scene::Mesh& mesh) {
  size_t vertices = 0;
  for (const scene::Primitive& p : mesh.primitives) vertices += p.positions.size();
  return std::to_string(mesh.primitives.size()) + (mesh.primitives.size() == 1 ? " primitive, " : " primitives, ") +
         grouped(triangleCount(mesh)) + " triangles, " + grouped(vertices) + " vertices";
}

void chooseMaterial(ViewerState& state, PanelResult& result, int material) {
  state.inspection = {};
  state.selection = {-1, material, false};
  result.describeMaterial = true;
}

// A material's name, which chooses it.
void materialLink(ViewerState& state, PanelResult& result, int material) {
  const scene::Model& model = *state.shown.content;
  if (material < 0 || material >= static_cast<int>(model.materials.size())) {
    ImGui::TextDisabled("glTF's default");
    return;
  }
  ImGui::PushID(material);
  const float room = ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().FramePadding.x;
  if (ImGui::SmallButton(middleCut(materialName(model, material), room, textWidth).c_str()))
    chooseMaterial(state, result, material);
  ImGui::PopID();
  hint("shows the material");
}

// ---- The tree -------------------------------------------------------------------------------------------------------

void treeSearch(SceneTree& tree) {
  ImGui::SetNextItemWidth(-7.5f * ImGui::GetFontSize() - ImGui::GetStyle().ItemSpacing.x);
  if (searchField("##search", "search by name", tree.filter)) tree.stale = true;
  ImGui::SameLine();
  static constexpr const char* kinds[] = {"nodes", "meshes", "materials", "textures"};
  ImGui::SetNextItemWidth(7.5f * ImGui::GetFontSize());
  if (!beginList("##kind", kinds[static_cast<int>(tree.kind)])) return;
  for (int i = 0; i < static_cast<int>(std::size(kinds)); ++i)
    if (ImGui::Selectable(kinds[i], static_cast<int>(tree.kind) == i))
      tree.kind = static_cast<TreeKind>(i), tree.stale = true;
  ImGui::EndCombo();
}

void nodeTooltip(const scene::Model& model, int index) {
  if (!ImGui::IsItemHovered()) return;
  const scene::Node& node = model.nodes[static_cast<size_t>(index)];
  std::string text = nodeName(model, index);
  for (int above = node.parent, levels = 0; above >= 0 && levels < 6; ++levels) {
    text = nodeName(model, above) + " / " + text;
    above = model.nodes[static_cast<size_t>(above)].parent;
  }
  if (node.mesh >= 0) text += "\n" + meshText(model.meshes[static_cast<size_t>(node.mesh)]);
  if (!node.children.empty()) text += "\n" + grouped(node.children.size()) + " below it";
  hint(text);
}

void nodeRow(ViewerState& state, const TreeRow& row) {
  const scene::Model& model = *state.shown.content;
  SceneTree& tree = state.tree;
  const auto index = static_cast<size_t>(row.index);
  const float em = ImGui::GetFontSize();
  const float indent = static_cast<float>(std::min(row.depth, 24)) * 0.9f * em;
  if (indent > 0) ImGui::Dummy({indent, 0}), ImGui::SameLine(0, 0);
  if (row.parent && tree.filter.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Button, 0);
    if (ImGui::ArrowButton("##open", tree.open[index] ? ImGuiDir_Down : ImGuiDir_Right))
      tree.open[index] = !tree.open[index], tree.stale = true;
    ImGui::PopStyleColor();
  } else {
    ImGui::Dummy({ImGui::GetFrameHeight(), 0});
  }
  ImGui::SameLine(0, 0.2f * em);
  bool shown = !isHidden(state, row.index);
  if (ImGui::Checkbox("##shown", &shown)) setHidden(state, row.index, !shown);
  hint("shown; \"alone\", below, shows nothing else");
  ImGui::SameLine(0, 0.3f * em);
  ImGui::AlignTextToFramePadding();
  const std::string kinds = nodeKinds(model.nodes[index]);
  const float kindsWidth = ImGui::CalcTextSize(kinds.c_str()).x, all = ImGui::GetContentRegionAvail().x;
  // The kinds yield where there is no room for both.
  const bool both = !kinds.empty() && all > kindsWidth + 5 * em;
  const std::string name = middleCut(nodeName(model, row.index), both ? all - kindsWidth - 0.7f * em : all, textWidth);
  if (ImGui::Selectable((name + "###node").c_str(), state.selection.node == row.index)) selectNode(state, row.index);
  nodeTooltip(model, row.index);
  if (!both) return;
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - kindsWidth);
  ImGui::TextDisabled("%s", kinds.c_str());
}

void meshRow(ViewerState& state, int mesh) {
  const scene::Model& model = *state.shown.content;
  const int node = state.selection.node;
  const bool chosen = node >= 0 && model.nodes[static_cast<size_t>(node)].mesh == mesh;
  if (ImGui::Selectable(meshName(model, mesh).c_str(), chosen)) {
    const auto user = std::ranges::find(model.nodes, mesh, &scene::Node::mesh);
    if (user != model.nodes.end()) selectNode(state, static_cast<int>(user - model.nodes.begin()));
  }
  hint(meshText(model.meshes[static_cast<size_t>(mesh)]));
}

void treeList(ViewerState& state, PanelResult& result, float height) {
  const scene::Model& model = *state.shown.content;
  SceneTree& tree = state.tree;
  int scrollTo = -1;
  if (state.selection.reveal && state.selection.node >= 0)
    scrollTo = reveal(tree, model, state.shown.scene, state.selection.node);
  state.selection.reveal = false;
  updateTree(tree, model, state.shown.scene);
  if (!ImGui::BeginChild("tree", {0, height}, true)) return ImGui::EndChild();
  if (tree.kind == TreeKind::textures) {
    textureList(state.shown.textures, tree.filter);
    return ImGui::EndChild();
  }
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 1});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ImGui::GetStyle().FramePadding.x, 1});
  const float rowHeight = ImGui::GetFrameHeightWithSpacing();
  if (scrollTo >= 0)
    ImGui::SetScrollY(std::max(0.0f, static_cast<float>(scrollTo) * rowHeight - 0.4f * ImGui::GetWindowHeight()));
  if (tree.rows.empty()) ImGui::TextDisabled(tree.filter.empty() ? "none" : "nothing is called so");
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(tree.rows.size()), rowHeight);
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const TreeRow row = tree.rows[static_cast<size_t>(i)];
      ImGui::PushID(i);
      if (tree.kind == TreeKind::nodes) nodeRow(state, row);
      if (tree.kind == TreeKind::meshes) ImGui::AlignTextToFramePadding(), meshRow(state, row.index);
      if (tree.kind == TreeKind::materials) {
        ImGui::AlignTextToFramePadding();
        const bool chosen = state.selection.material == row.index;
        if (ImGui::Selectable(materialName(model, row.index).c_str(), chosen)) chooseMaterial(state, result, row.index);
      }
      ImGui::PopID();
    }
  ImGui::PopStyleVar(2);
  ImGui::EndChild();
}

// ---- What is chosen -------------------------------------------------------------------------------------------------

void nodeDetails(ViewerState& state, PanelResult& result) {
  const scene::Model& model = *state.shown.content;
  const int index = state.selection.node;
  const scene::Node& node = model.nodes[static_cast<size_t>(index)];
  if (!section(state.layout, "Node")) return;
  if (!beginDetails("node")) return;
  detail("name", nodeName(model, index));
  if (node.parent >= 0) detail("below", nodeName(model, node.parent));
  if (!node.children.empty()) detail("children", grouped(node.children.size()));
  detail("translation", vectorText(node.translation));
  detail("rotation", format("%.3g  %.3g  %.3g", node.rotation.x, node.rotation.y, node.rotation.z) +
                         format("  %.3g", node.rotation.w));
  detail("scale", vectorText(node.scale));
  if (!node.instances.empty()) detail("instances", grouped(node.instances.size()));
  if (node.skin >= 0) {
    const scene::Skin& skin = model.skins[static_cast<size_t>(node.skin)];
    detail("skin", grouped(skin.joints.size()) + " joints");
  }
  if (node.light >= 0) {
    const scene::Light& light = model.lights[static_cast<size_t>(node.light)];
    constexpr const char* types[] = {"directional", "point", "spot"};
    detail("light", types[static_cast<int>(light.type)] +
                        format(light.type == scene::LightType::directional ? ", %.4g lx" : ", %.4g cd",
                               static_cast<double>(light.intensity)));
  }
  if (node.profiledLight >= 0) {
    const scene::Light& light = model.lights[static_cast<size_t>(node.profiledLight)];
    const optics::LightProfile& profile = model.lightProfiles[static_cast<size_t>(light.profile)];
    detail("light profile", profile.name + format(", up to %.4g cd", static_cast<double>(profile.mostCandela)) +
                                format(" x %.4g", static_cast<double>(light.intensity)));
  }
  if (node.mesh >= 0) {
    const scene::Mesh& mesh = model.meshes[static_cast<size_t>(node.mesh)];
    detail("mesh", meshName(model, node.mesh) + "\n" + meshText(mesh));
    std::vector<int> used;
    for (const scene::Primitive& p : mesh.primitives)
      if (std::ranges::find(used, p.material) == used.end() && used.size() < 32) used.push_back(p.material);
    detailName(used.size() == 1 ? "material" : "materials");
    ImGui::TableNextColumn();
    for (const int material : used) materialLink(state, result, material);
  }
  ImGui::EndTable();
  if (ImGui::Button("frame")) result.frameSelection = true;
  hint(withKeys("brings it into the middle of the picture", state.keys, Command::frameSelection));
  ImGui::SameLine();
  if (ImGui::Button("deselect")) selectNode(state, -1);
}

void swatch(const char* id, const glm::vec3& linear) {
  const glm::vec3 c = glm::clamp(linear, glm::vec3(0), glm::vec3(1));
  const auto encoded = [](float x) { return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f; };
  const float size = ImGui::GetFontSize();
  ImGui::ColorButton(id, {encoded(c.r), encoded(c.g), encoded(c.b), 1},
                     ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop, {size, size});
  ImGui::SameLine();
}

void pointValues(PanelLayout& layout, const Inspection& at, std::optional<glm::dvec3>& measuredFrom,
                 const scene::Model& model) {
  if (!section(layout, "At the point")) return;
  if (!beginDetails("point")) return;
  const scene::Mesh& mesh = model.meshes[static_cast<size_t>(at.hit.mesh)];
  detail("position", vectorText(at.hit.position, "%.4g  %.4g  %.4g") + " m");
  if (measuredFrom && *measuredFrom != at.hit.position) {
    const glm::dvec3 way = at.hit.position - *measuredFrom;
    detail("distance", format("%.5g m", glm::length(way)) + "\n" + vectorText(glm::abs(way), "%.4g  %.4g  %.4g"));
    hint("of the point that was chosen to measure from; along X, Y and Z");
  }
  detail("pixel", std::to_string(at.pixel.x) + ", " + std::to_string(at.pixel.y) + " from the lower left");
  if (at.uv) detail("uv", format("%.5f  %.5f", static_cast<double>(at.uv->x), static_cast<double>(at.uv->y)));
  if (mesh.primitives.size() > 1) detail("primitive", std::to_string(at.hit.primitive));
  const scene::Topology topology = mesh.primitives[static_cast<size_t>(at.hit.primitive)].topology;
  const char* thin = topology == scene::Topology::points ? "point" : "line";
  detail(scene::hasTriangles(topology) ? "triangle" : thin, grouped(at.hit.element));
  for (int channel = 1; channel < shading::channelCount; ++channel) {
    const std::optional<glm::vec3>& value = at.values[static_cast<size_t>(channel)];
    if (!value) continue;
    const shading::ChannelKind kind = shading::channelKind(channel);
    const std::string name(shading::channels[channel].label);
    detailName(name);
    ImGui::TableNextColumn();
    if (kind == shading::ChannelKind::color) swatch(name.c_str(), *value);
    const glm::dvec3 v(*value);
    if (kind == shading::ChannelKind::number || kind == shading::ChannelKind::quantity)
      wrappedText(format(kind == shading::ChannelKind::number ? "%.4f" : "%.5g", v.x));
    else
      wrappedText(format("%.3f  %.3f  %.3f", v.x, v.y, v.z));
  }
  if (at.radiance) {
    const glm::dvec3 v(*at.radiance);
    detailName("radiance");
    hint("what the picture has at this pixel, before exposure and tone mapping; linear Rec. 709");
    ImGui::TableNextColumn();
    wrappedText(format("%.3g  %.3g  %.3g", v.x, v.y, v.z));
  }
  ImGui::EndTable();
  if (ImGui::SmallButton("measure from here")) measuredFrom = at.hit.position;
  hint("the next points that are clicked tell how far they are from this one");
  if (at.nextChannel < shading::channelCount) ImGui::TextDisabled("reading ...");
}

void materialTable(ViewerState& state, const std::string& name) {
  if (!section(state.layout, "Material###point's material")) return;
  if (!beginDetails("material")) return;
  detail("name", name);
  for (const Detail& row : state.inspection.materialDetails) detail(row.name, row.value);
  ImGui::EndTable();
}

}  // namespace

void scenePanel(ViewerState& state, PanelResult& result) {
  if (!state.shown.content) return;
  const scene::Model& model = *state.shown.content;
  editBar(state, result);
  treeSearch(state.tree);
  const bool chosen = state.selection.node >= 0 || state.selection.material >= 0;
  const float all = ImGui::GetContentRegionAvail().y;
  const float below = (state.metadata.wanted ? 12.0f : 1.0f) * ImGui::GetFrameHeightWithSpacing();
  treeList(state, result, chosen ? 0.36f * all : std::max(all - below, 1.0f));
  if (!chosen) {
    if (ImGui::BeginChild("file")) metadataSection(state);
    return ImGui::EndChild();
  }
  if (ImGui::BeginChild("chosen")) {
    if (state.inspection.on) pointValues(state.layout, state.inspection, state.measuredFrom, model);
    const int material = state.selection.material;
    if (state.inspection.on)
      materialTable(state, state.inspection.materialName);
    else if (material >= 0)
      materialTable(state, materialName(model, material));
    const int changed = state.inspection.on ? state.inspection.material : material;
    const bool ofFile = changed >= 0 && changed < static_cast<int>(model.materials.size());
    if (ofFile && (!state.inspection.on || materialSource(state.settings) == MaterialSource::file) &&
        section(state.layout, "Change###change material"))
      editMaterial(state, changed);
    const int node = state.selection.node;
    if (node >= 0) nodeDetails(state, result);
    if (node >= 0 && section(state.layout, "Change###change node", false)) {
      editNode(state, node);
      const scene::Node& its = model.nodes[static_cast<size_t>(node)];
      for (const int light : {its.light, its.profiledLight})
        if (light >= 0) editLight(state, light);
    }
    metadataSection(state);
  }
  ImGui::EndChild();
}

}  // namespace facet::view
