#include "frame/picture.hpp"

namespace facet::frame {

Result<Drawable> preparePicture(const PictureSettings& settings, const PictureRequest& request, LoadedScene& scene,
                                const Supply& supply, shading::ProgramStore& programs, PictureStatistics& statistics,
                                Notes& notes, Stages& stages) {
  const shading::ProgramStatistics before = programs.statistics();
  const int decodedBefore = scene.gpu.imagesDecoded;
  Plan plan;
  plan.precise = request.precise();
  Step step;
  do {
    const Result<Step> made = advance(plan, scene, settings, nullptr, supply, programs);
    if (!made) return tl::unexpected(made.error());
    step = *made;
    stages.mark(step.did);
  } while (step.progress == Progress::working);
  assert(step.progress == Progress::done && "the supply gives everything at once");
  notes.insert(notes.end(), plan.next.notes.begin(), plan.next.notes.end());
  statistics.tables = plan.next.environment->tables.statistics;
  statistics.methods = plan.next.environment->chosen;
  statistics.imagesDecoded = scene.gpu.imagesDecoded - decodedBefore;
  statistics.programsCompiled = programs.statistics().compiled - before.compiled;
  statistics.programsFromDisk = programs.statistics().fromDisk - before.fromDisk;
  return std::move(plan.next);
}

}  // namespace facet::frame
