#include "view/describe.hpp"

#include <unistd.h>

#include <fstream>

namespace facet::view {

namespace {

void describeNotes(const Viewport& viewport, ShownScene& shown) {
  shown.warnings.clear();
  shown.infos.clear();
  const auto add = [&](const std::string& source, const Notes& notes) {
    for (const Note& note : notes) {
      const std::string text = describe({source, note.place, note.text, {}});
      (note.severity == Note::Severity::warning ? shown.warnings : shown.infos).push_back(text);
    }
  };
  add(viewport.scene->loaded->model.name, viewport.scene->notes);
  add(viewport.environments.shown->source, viewport.environments.shown->notes);
  if (const auto& measured = viewport.shown.inputs.list.measured) add(measured->facts.path, measured->facts.notes);
  if (const auto& fitted = viewport.shown.inputs.list.fitted) add("", frame::fitNotes(fitted->fitted));
  add("", viewport.shown.notes);
}

}  // namespace

void describeShown(const Viewport& viewport, ViewerState& state) {
  const scene::Model& model = viewport.scene->loaded->model;
  ShownScene& shown = state.shown;
  shown.content = {viewport.scene->loaded, &model};
  shown.model = viewport.scene->source;
  shown.environment = viewport.environments.shown->source;
  shown.scene = viewport.shown.inputs.list.scene;
  shown.bounds = viewport.shown.list.bounds;
  shown.cameras.clear();
  for (const frame::FileCamera& camera : viewport.shown.list.cameras) {
    const std::string& node = model.nodes[static_cast<size_t>(camera.placed.node)].name;
    const std::string& name = camera.lens.name.empty() ? node : camera.lens.name;
    const std::string index = std::to_string(camera.placed.camera);
    shown.cameras.push_back({name.empty() ? index : name, name.empty() ? "camera " + index : name});
  }
  shown.animations = animationNames(model);
  shown.scenes.clear();
  for (size_t i = 0; i < model.scenes.size(); ++i)
    shown.scenes.push_back(model.scenes[i].name.empty() ? "scene " + std::to_string(i) : model.scenes[i].name);
  shown.variants.clear();
  for (size_t i = 0; i < model.variants.size(); ++i)
    shown.variants.push_back(model.variants[i].empty() ? "variant " + std::to_string(i) : model.variants[i]);
  shown.variant = viewport.shown.inputs.list.options.variant;
  shown.sceneLights = static_cast<int>(scene::flatten(model, shown.scene).lights.size());
  shown.measured.reset();
  if (viewport.shown.inputs.list.measured) shown.measured = viewport.shown.inputs.list.measured->facts;
  shown.fit.reset();
  if (viewport.shown.inputs.list.fitted) shown.fit = viewport.shown.inputs.list.fitted->fitted;
  shown.compared = viewport.shown.list.compared;
  shown.comparison.reset();
  shown.statistics.methods = viewport.environments.shown->chosen;
  shown.statistics.variants = variantCount(viewport.shown.list);
  shown.statistics.images = static_cast<int>(model.images.size());
  shown.textures = shownTextures(model, viewport.scene->gpu);
  describeNotes(viewport, shown);
}

namespace {

// Of this process, as the system counts them.
size_t residentBytes() {
  std::ifstream statm("/proc/self/statm");
  size_t all = 0, resident = 0;
  statm >> all >> resident;
  return resident * static_cast<size_t>(::sysconf(_SC_PAGESIZE));
}

}  // namespace

void measureMemory(const Viewport& viewport, ViewerStatistics& statistics) {
  const frame::GpuScene& gpu = viewport.scene->gpu;
  statistics.imagesDecoded = gpu.imagesDecoded;
  statistics.textureBytes = gpu.textureBytes();
  statistics.geometryBytes = gpu.geometryBytes();
  statistics.tableBytes = viewport.environments.shown->tables.bytes();
  statistics.targetBytes = frame::targetBytes(viewport.targets) + frame::targetBytes(viewport.moving.small) +
                           frame::targetBytes(viewport.refinement.targets);
  if (viewport.errorView.picture) statistics.targetBytes += viewport.errorView.picture.bytes();
  statistics.measuredBytes = 0;
  for (const auto& kept : viewport.measured.store.kept) statistics.measuredBytes += kept->buffer.bytes();
  statistics.treeBytes = viewport.shown.paths ? viewport.shown.paths->bytes() : 0;
  statistics.environmentBytes = 0;
  for (const auto& slot : viewport.environments.slots)
    if (slot.get() != viewport.environments.shown) statistics.environmentBytes += slot->bytes();
  const SecondModel& second = viewport.second;
  statistics.secondBytes = (second.scene ? second.scene->gpu.textureBytes() + second.scene->gpu.geometryBytes() : 0) +
                           frame::targetBytes(second.targets);
  statistics.mainBytes = residentBytes();
  statistics.programsCompiled = viewport.programs.statistics().compiled;
  statistics.programsFromDisk = viewport.programs.statistics().fromDisk;
}

}  // namespace facet::view
