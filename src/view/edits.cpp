#include "view/edits.hpp"

#include "base/whole_file.hpp"
#include "frame/choose.hpp"
#include "frame/export.hpp"
#include "scene/edited.hpp"
#include "view/history.hpp"

namespace facet::view {

namespace {

bool showsMore(const frame::PictureSettings& settings, const scene::Model& model) {
  if (settings.look.material.on &&
      scene::has(frame::overridingMaterial(settings.look.material), scene::Effect::anisotropy))
    return true;
  scene::Pose pose;
  return scene::applyEdits(pose, model, settings.placement.arrangement.edits) && scene::showsMore(model, pose);
}

ModelExported write(const std::string& source, const frame::Arrangement& arrangement, const io::Limits& limits,
                    const std::filesystem::path& file) {
  ModelExported out{file.string(), {}, {}};
  const Result<std::vector<uint8_t>> glb = frame::exportGlb(source, arrangement, out.notes, limits);
  if (!glb)
    out.written = tl::unexpected(glb.error());
  else
    out.written = writeWholeFile(file, std::as_bytes(std::span(*glb)));
  return out;
}

}  // namespace

void followEdits(const Viewport& viewport, ViewerState& state, Loader& loader, bool handOnIt) {
  follow(state.history, state.shown.model, state.settings, handOnIt);
  if (!viewport.scene || viewport.next || loader.model.running() || viewport.scene->loaded->editable) return;
  const frame::ListInputs& shown = viewport.shown.inputs.list;
  if (shown.arrangement.edits.empty() && shown.options.material.edits.empty()) return;
  if (!showsMore(state.settings, viewport.scene->model())) return;
  loader.editable = true;
  startModel(loader, viewport.scene->source, Opening::again, viewport.scene->bump);
}

void followTogether(const Viewport& viewport, const ViewerState& state, Loader& loader) {
  if (!viewport.scene || viewport.next || loader.model.running()) return;
  if (state.settings.sources.with == viewport.scene->with) return;
  loader.with = state.settings.sources.with;
  startModel(loader, viewport.scene->source, Opening::again, viewport.scene->bump);
}

std::filesystem::path exportName(const std::string& model, const std::filesystem::path& folder) {
  const bool builtin = model.starts_with("builtin:");
  const std::string stem = (builtin ? model.substr(8) : std::filesystem::path(model).stem().string()) + "-changed";
  std::filesystem::path path = folder / (stem + ".glb");
  std::error_code ignored;
  for (int i = 2; std::filesystem::exists(path, ignored); ++i)
    path = folder / (stem + "-" + std::to_string(i) + ".glb");
  return path;
}

void startExport(ViewerState& state, Loader& loader, const std::filesystem::path& file) {
  if (!state.settings.sources.with.empty())
    return complain(state, {state.shown.model, "", "an export is of one file", "take out the others in its scene"});
  const io::Limits limits{.allowOutside = loader.allowOutside};
  loader.exported.start([source = state.shown.model, arrangement = state.settings.placement.arrangement, limits, file] {
    try {
      return write(source, arrangement, limits, file);
    } catch (const std::bad_alloc&) {
      return ModelExported{file.string(), fail(source, "", "the memory does not suffice to write it"), {}};
    }
  });
}

void takeExport(ViewerState& state, ModelExported exported) {
  if (!exported.written) return complain(state, exported.written.error());
  for (const Note& note : exported.notes)
    view::note(state, describe({exported.file, note.place, note.text, {}}), false);
  say(state, "exported: " + exported.file);
}

}  // namespace facet::view
