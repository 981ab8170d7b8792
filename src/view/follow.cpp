#include "view/follow.hpp"

#include "io/sources.hpp"

namespace facet::view {

FilesChanged follow(Followed& followed, const Viewport& viewport, Loader& loader,
                    std::chrono::steady_clock::time_point now) {
  FilesChanged changed;
  if (!viewport.scene || !viewport.environments.shown) return changed;
  const SceneSlot& scene = *viewport.scene;
  if (followed.model != scene.loaded.get()) {
    followed.model = scene.loaded.get();
    followed.modelFiles = scene.watch;
  }
  const EnvironmentSlot& environment = *viewport.environments.shown;
  if (followed.environment != environment.environment.get()) {
    followed.environment = environment.environment.get();
    const bool isFile = environment.environment && !environment.source.starts_with("builtin:");
    followed.environmentFiles = isFile ? watchFiles({io::splitLayer(environment.source).file}, now) : FileWatch{};
  }
  if (followed.measured != viewport.shown.inputs.list.measured.get()) {
    followed.measured = viewport.shown.inputs.list.measured.get();
    const auto watch =
        followed.measured ? viewport.measured.files.find(followed.measured->facts.path) : viewport.measured.files.end();
    followed.measuredFiles = watch != viewport.measured.files.end() ? watch->second : FileWatch{};
  }
  // While something else is being read, its files are told at the next look.
  if (!loader.model.running() && !viewport.next) changed.model = filesChanged(followed.modelFiles, now);
  if (!loader.environment.running()) changed.environment = filesChanged(followed.environmentFiles, now);
  if (!loader.measured.running()) changed.measured = filesChanged(followed.measuredFiles, now);
  if (changed.model) startModel(loader, scene.source, Opening::again, scene.bump);
  if (changed.environment) startEnvironment(loader, environment.source, true);
  if (changed.measured) startMeasured(loader, followed.measured->facts.source, true);
  return changed;
}

}  // namespace facet::view
