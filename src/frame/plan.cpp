#include "frame/plan.hpp"

#include <algorithm>
#include <utility>

#include "frame/list_notes.hpp"
#include "frame/settings.hpp"
#include "gl/context.hpp"

namespace facet::frame {

namespace {

// The tables of other methods than those that the wish asks for are dropped.
void chooseMethod(LoadedEnvironment& environment, const std::optional<double>& maxError) {
  environment.chosen = maxError ? ibl::chosenFor(*maxError) : std::vector<const ibl::Candidate*>();
  ibl::Method method = maxError ? ibl::methodFor(*maxError) : ibl::Method();
  method.takeSunOut = environment.method.takeSunOut;
  if (method == environment.method) return;
  environment.method = method;
  environment.tables = {};
}

// The measured BRDF into the inputs. False: it is on its way.
Result<bool> supplyMeasured(const PictureSettings& wish, const Supply& supply, ListInputs& inputs) {
  if (wish.sources.brdf.empty() || !shading::showsLight(inputs.options.features.channel)) return true;
  const MeasuredSource source = measuredSource(wish.sources);
  auto found = supply.measured(source);
  if (!found) return tl::unexpected(found.error());
  if (!*found) return false;
  inputs.measured = *found;
  setMeasured(inputs.options.features, wish.look, (*found)->facts.kind, (*found)->facts.proxy);
  if (wish.comparison.brdfCompare == BrdfCompare::none) return true;
  auto fitted = supply.fitted(source, wish.look.models.diffuse);
  if (!fitted) return tl::unexpected(fitted.error());
  inputs.fitted = *fitted;
  if (*fitted) setFitted(inputs.options, wish.comparison.brdfCompare);
  return true;
}

// What of the model the wish names.
struct Chosen {
  int scene = 0, variant = -1;
  std::string environment;
};
Result<Chosen> choose(const LoadedScene& scene, const PictureSettings& wish) {
  const Result<int> index = chooseScene(wish.placement, scene.model());
  if (!index) return tl::unexpected(index.error());
  const Result<int> variant = chooseVariant(wish.look, scene.model());
  if (!variant) return tl::unexpected(variant.error());
  return Chosen{*index, *variant, chooseEnvironment(wish, scene.source, scene.model(), *index)};
}

// Nothing: a measured BRDF is on its way.
Result<std::optional<PlanInputs>> inputsOf(const Plan& plan, const LoadedScene& scene, const PictureSettings& wish,
                                           const Chosen& chosen, const Supply& supply) {
  const bool lit = chosen.environment != "none";
  PlanInputs inputs;
  inputs.list = listInputs(wish, scene.loaded, chosen.scene, chosen.variant, lit, plan.moving);
  inputs.list.options.features.textureReads =
      chooseTextureFilter(wish.quality.textureFilter, gl::drawsBySoftware()) == TextureFilter::reads;
  if (plan.environment) inputs.list.options.sun = plan.environment->sun;
  const Result<bool> measured = supplyMeasured(wish, supply, inputs.list);
  if (!measured) return tl::unexpected(measured.error());
  if (!*measured) return std::optional<PlanInputs>();
  const bool seen = backgroundVisible(wish, lit);
  inputs.tables = {plan.environment, seen, seen ? wish.frame.backgroundBlur : 0, plan.moving && converges(wish),
                   wish.quality.maxError};
  return inputs;
}

Result<void> makeList(Drawable& next, const Placement& placement) {
  const ListInputs& inputs = next.inputs.list;
  const Result<scene::Pose> pose = choosePose(placement, next.scene->model());
  if (!pose) return tl::unexpected(pose.error());
  next.list = buildDrawList(next.scene->model(), inputs.scene, inputs.options, *pose);
  if (next.list.features.shadows || next.list.features.horizons) next.screen = std::make_shared<Screen>();
  next.notes = listNotes(next.list, tableNeeds(next));
  return {};
}

Result<void> makeTables(Drawable& next, const Supply& supply) {
  const TableInputs& inputs = next.inputs.tables;
  ibl::Needs needs = tableNeeds(next);
  needs.samples |= needs.irradiance && inputs.sampled;
  chooseMethod(*next.environment, inputs.maxError);
  return supply.tables(*next.environment, needs);
}

// Images of the uses that are neither on the GPU nor decoded.
std::vector<bool> undecodedImages(const LoadedScene& scene, const std::vector<TextureUse>& uses) {
  std::vector<bool> missing = missingImages(scene.model(), uses, scene.gpu);
  for (size_t i = 0; i < scene.pixels.size(); ++i) missing[i] = missing[i] && scene.pixels[i].width == 0;
  return missing;
}

// False where images that are missing are on their way; did: some were decoded by this call.
Result<bool> askForImages(Drawable& next, const std::vector<TextureUse>& uses, const Supply& supply, bool& did) {
  if (!next.scene->pixels.empty()) return true;
  const std::vector<bool> missing = undecodedImages(*next.scene, uses);
  if (std::ranges::find(missing, true) == missing.end()) return true;
  const Result<bool> there = supply.images(*next.scene, missing);
  did = there && *there;
  return there;
}

Result<Step> nextStep(Plan& plan, const PictureSettings& wish, const Supply& supply, shading::ProgramStore& programs,
                      const KeepGoing& keepGoing) {
  Drawable& next = plan.next;
  if (!plan.listed) {
    if (Result<void> made = makeList(next, wish.placement); !made) return tl::unexpected(made.error());
    plan.uses = textureUses(next.scene->model(), next.list);
    plan.listed = true;
    return Step{Progress::working, "prepare"};
  }
  bool decoded = false;  // they are asked for first: where they come later, tables are made in between
  const Result<bool> images = askForImages(next, plan.uses, supply, decoded);
  if (!images) return tl::unexpected(images.error());
  if (decoded) return Step{Progress::working, "decode"};
  if (!plan.tabled && next.environment) {
    if (Result<void> made = makeTables(next, supply); !made) return tl::unexpected(made.error());
    plan.tabled = true;
    return Step{Progress::working, "precompute"};
  }
  if (!next.environment) return Step{Progress::waiting, "read environment"};
  if (!*images) return Step{Progress::waiting, "decode"};
  LoadedScene& scene = *next.scene;
  if (!plan.uploaded) {
    plan.uploaded = uploadScene(scene.gpu, scene.model(), next.list, keepGoing);
    return Step{Progress::working, "upload"};
  }
  if (!scene.pixels.empty()) {
    if (uploadImages(scene.gpu, scene.model(), plan.uses, scene.pixels, keepGoing)) scene.pixels.clear();
    return Step{Progress::working, "upload"};
  }
  if ((next.list.features.paths || next.list.features.difference || next.list.ground) && !next.paths) {
    Result<PathScene> made = pathScene(pathTrees(next.list), next.list, scene.model(), scene.gpu, programs);
    if (!made) return tl::unexpected(made.error());
    next.paths = std::make_shared<const PathScene>(std::move(*made));
    if (next.list.ground)
      next.ground = std::make_shared<Ground>(
          placedGround(next.list, animatedBounds(scene, next.inputs.list.scene, wish.placement, next.list.bounds)));
    return Step{Progress::working, "trees"};
  }
  const Result<bool> compiled = prepareNextProgram(frameInput(next, {}, wish), programs);
  if (!compiled) return tl::unexpected(compiled.error());
  return Step{*compiled ? Progress::done : Progress::working, "compile"};
}

}  // namespace

scene::Bounds animatedBounds(LoadedScene& scene, int index, const Placement& placement, const scene::Bounds& pose) {
  if (placement.animation.empty()) return pose;
  std::optional<Framing>& known = scene.framing;
  if (!known || known->scene != index || known->animation != placement.animation ||
      known->arrangement != placement.arrangement)
    known = Framing{index, placement.animation, placement.arrangement,
                    framingBounds(placement, scene.model(), index, pose)};
  return known->bounds;
}

void findSun(LoadedEnvironment& environment) {
  environment.sun.reset();
  if (environment.prepared)
    environment.sun = environment.prepared->sun;
  else if (environment.environment && (environment.found = scene::findSun(*environment.environment)))
    environment.sun = environment.found->sun;
  environment.method.takeSunOut = environment.sun.has_value();
}

Result<void> prepareTables(LoadedEnvironment& environment, const ibl::Needs& needs, shading::ProgramStore& programs) {
  return ibl::prepareTables(environment.tables, environment.environment.get(), environment.content, needs, programs,
                            environment.cache, environment.method, environment.prepared.get(),
                            environment.found ? &*environment.found : nullptr);
}

ibl::Needs tableNeeds(const Drawable& drawable) {
  const TableInputs& tables = drawable.inputs.tables;
  return drawable.list.needs(tables.background, tables.backgroundBlur);
}

ListInputs listInputs(const PictureSettings& settings, std::shared_ptr<const io::LoadedModel> model, int scene,
                      int variant, bool hasEnvironment, bool moving) {
  ListInputs inputs;
  inputs.model = std::move(model);
  inputs.scene = scene;
  inputs.options = drawOptions(moving ? movingSettings(settings) : settings, hasEnvironment);
  inputs.options.variant = variant;
  // What will be refined begins with few samples, by the program that refines it.
  if (moving && converges(settings) && !settings.sources.brdf.empty() &&
      shading::showsLight(inputs.options.features.channel))
    inputs.options.features.imageLightSamples = convergedLightSamples;
  inputs.animation = settings.placement.animation;
  inputs.arrangement = settings.placement.arrangement;
  if (!inputs.animation.empty()) inputs.timeSeconds = settings.placement.timeSeconds;
  return inputs;
}

bool differInTimeOnly(PlanInputs a, const PlanInputs& b) {
  a.list.timeSeconds = b.list.timeSeconds;
  return a == b;
}

FrameInput frameInput(const Drawable& drawable, const scene::View& view, const PictureSettings& settings) {
  return frameInput(drawable, drawable.list, view, settings);
}

FrameInput frameInput(const Drawable& drawable, const DrawList& part, const scene::View& view,
                      const PictureSettings& settings) {
  FrameInput in{drawable.scene->model(), part, drawable.scene->gpu, drawable.environment->tables, view, settings};
  if (drawable.inputs.list.measured) in.measured = &drawable.inputs.list.measured->buffer;
  in.paths = drawable.paths.get(), in.ground = drawable.ground.get();
  in.screen = drawable.screen.get();
  in.precise = drawable.precise;
  if (drawable.inputs.list.fitted) in.fittedModel = &drawable.inputs.list.fitted->buffer;
  return in;
}

Result<Step> advance(Plan& plan, LoadedScene& scene, const PictureSettings& wish, const Drawable* shown,
                     const Supply& supply, shading::ProgramStore& programs, const KeepGoing& keepGoing) {
  const Result<Chosen> chosen = choose(scene, wish);
  if (!chosen) return tl::unexpected(chosen.error());
  const Result<LoadedEnvironment*> environment = supply.environment(chosen->environment);
  if (!environment) return tl::unexpected(environment.error());
  if (std::exchange(plan.environment, *environment) != *environment && *environment)
    return Step{Progress::working, "read environment"};
  const Result<std::optional<PlanInputs>> inputs = inputsOf(plan, scene, wish, *chosen, supply);
  if (!inputs) return tl::unexpected(inputs.error());
  if (!*inputs) return Step{Progress::waiting, "read BRDF"};
  if (std::exchange(plan.measured, (*inputs)->list.measured) != (*inputs)->list.measured && plan.measured)
    return Step{Progress::working, "read BRDF"};
  if (plan.failed != **inputs) plan.failed.reset();  // when it is wished for again there may be more memory
  if ((shown && shown->scene == &scene && shown->inputs == **inputs) || plan.failed) return Step{};
  const bool sameList = plan.listed && plan.next.scene == &scene && plan.next.inputs.list == (*inputs)->list;
  if (!sameList) {
    plan.next = {};
    plan.next.scene = &scene;
    plan.next.precise = plan.precise;
    plan.listed = plan.tabled = plan.uploaded = false;
  }
  plan.tabled &= plan.next.inputs.tables == (*inputs)->tables;
  plan.next.inputs = **inputs;
  plan.next.environment = plan.environment;
  Result<Step> step = nextStep(plan, wish, supply, programs, keepGoing);
  if (!step) plan.failed = plan.next.inputs;
  return step;
}

}  // namespace facet::frame
