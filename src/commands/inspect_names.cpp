#include "commands/inspect_names.hpp"

#include <nlohmann/json.hpp>
#include <ostream>
#include <string>

#include "base/text.hpp"
#include "scene/animation.hpp"

namespace facet::commands {

namespace {

using NamesJson = nlohmann::ordered_json;

template <class T, class Add>
NamesJson listed(const std::vector<T>& things, const Add& add) {
  NamesJson list = NamesJson::array();
  for (const T& thing : things) {
    NamesJson row = {{"index", list.size()}};
    add(row, thing, static_cast<int>(list.size()));
    list.push_back(row);
  }
  return list;
}

// A camera without a name goes by that of its node.
std::string cameraName(const scene::Model& model, const scene::Camera& camera, int index) {
  if (!camera.name.empty()) return camera.name;
  for (const scene::Node& node : model.nodes)
    if (node.camera == index) return node.name;
  return {};
}

}  // namespace

NamesJson describeNames(const scene::Model& model) {
  NamesJson out;
  out["file"] = model.name;
  const auto named = [](NamesJson& row, const auto& thing, int) { row["name"] = thing.name; };
  out["scenes"] = listed(model.scenes, [&](NamesJson& row, const scene::Scene& scene, int index) {
    row["name"] = scene.name, row["default"] = index == model.defaultScene;
  });
  out["cameras"] = listed(model.cameras, [&](NamesJson& row, const scene::Camera& camera, int index) {
    row["name"] = cameraName(model, camera, index);
    row["projection"] = camera.perspective ? "perspective" : "orthographic";
  });
  out["animations"] = listed(model.animations, [](NamesJson& row, const scene::Animation& animation, int) {
    row["name"] = animation.name, row["seconds"] = scene::duration(animation);
  });
  out["variants"] =
      listed(model.variants, [](NamesJson& row, const std::string& variant, int) { row["name"] = variant; });
  out["materials"] = listed(model.materials, named);
  return out;
}

void printNames(const NamesJson& described, std::ostream& out) {
  for (const auto& [kinds, rows] : described.items()) {
    if (!rows.is_array()) continue;
    for (const NamesJson& row : rows) {
      out << kinds.substr(0, kinds.size() - 1) << "\t" << row["index"] << "\t"
          << printable(row["name"].get<std::string>());
      if (row.value("default", false)) out << "\tdefault";
      if (row.contains("projection")) out << "\t" << row["projection"].get<std::string>();
      if (row.contains("seconds")) out << "\t" << number(row["seconds"].get<double>()) << " s";
      out << "\n";
    }
  }
}

}  // namespace facet::commands
