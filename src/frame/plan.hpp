#pragma once

// The one way from a wish to all that its picture is drawn from, in steps of bounded work. Each step compares what it
// reads with what it was done for, and does nothing where they are equal. The command line runs the steps to their end,
// the window a slice each turn; they differ in where things come from (Supply), not in what is done with them.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frame/arrangement.hpp"
#include "frame/choose.hpp"
#include "frame/fitted_gpu.hpp"
#include "frame/frame.hpp"
#include "frame/ground.hpp"
#include "frame/paths.hpp"
#include "frame/screen.hpp"
#include "ibl/cache.hpp"
#include "ibl/choice.hpp"
#include "io/bump.hpp"
#include "io/gltf.hpp"

namespace facet::frame {

// framingBounds of an animation.
struct Framing {
  int scene = 0;
  std::string animation;
  Arrangement arrangement;
  scene::Bounds bounds;
};

// A model that was read, and what of it is on the GPU.
struct LoadedScene {
  std::string source;                  // the file, or builtin:NAME
  std::vector<std::string> with = {};  // others in the same scene (Sources)
  io::Bump bump = {};
  std::shared_ptr<const io::LoadedModel> loaded;
  GpuScene gpu = {};
  std::vector<io::Pixels> pixels = {};  // decoded, not on the GPU yet: by image, or empty
  std::optional<Framing> framing = {};  // the last one
  Notes notes = {};                     // the model's, and those of its images

  const scene::Model& model() const { return loaded->model; }
};

// Bounds of a pose, or of all poses of the animation where one is chosen; kept in scene.framing.
scene::Bounds animatedBounds(LoadedScene& scene, int index, const Placement& placement, const scene::Bounds& pose);

// An environment that was read, and its tables. "none" has no texels; the DFG table may still be needed.
struct LoadedEnvironment {
  std::string source;
  std::shared_ptr<const scene::Environment> environment;
  std::shared_ptr<const ibl::PreparedEnvironment> prepared = {};  // null: made when it is needed
  ibl::Tables tables = {};
  std::optional<scene::FoundSun> found = {};       // the sun in the texels, where nothing is prepared
  std::optional<scene::Sun> sun = {};              // a light of its own, which the tables do without
  ibl::Method method = {};                         // of the tables
  std::vector<const ibl::Candidate*> chosen = {};  // what makes up the method where an error decides
  ibl::TableCache cache = {};                      // the default: none
  std::string content = {};                        // ibl::contentKey, where it is known
  Notes notes = {};
};

// The sun of what is prepared, else looks for one in the environment's texels.
void findSun(LoadedEnvironment& environment);

// What of the tables is not there yet, from the cache or computed.
Result<void> prepareTables(LoadedEnvironment& environment, const ibl::Needs& needs, shading::ProgramStore& programs);

// Where things come from. What is empty (null, false) is on its way: the plan goes on with it when it is asked again.
struct Supply {
  std::function<Result<LoadedEnvironment*>(const std::string& source)> environment;
  std::function<Result<std::shared_ptr<const MeasuredOnGpu>>(const MeasuredSource& source)> measured;
  // Without it the measured BRDF alone is drawn.
  std::function<Result<std::shared_ptr<const FittedOnGpu>>(const MeasuredSource& source, optics::DiffuseModel diffuse)>
      fitted;
  // All of the missing images or some into scene.pixels.
  std::function<Result<bool>(LoadedScene& scene, const std::vector<bool>& missing)> images;
  // What of the tables is missing; coarse ones may do for a time.
  std::function<Result<void>(LoadedEnvironment& environment, const ibl::Needs& needs)> tables;
};

// All that a draw list is made of.
struct ListInputs {
  std::shared_ptr<const io::LoadedModel> model;
  int scene = 0;        // index
  DrawOptions options;  // the whole wish, as far as a list reads it
  std::string animation;
  double timeSeconds = 0;  // where an animation is chosen
  Arrangement arrangement;
  std::shared_ptr<const MeasuredOnGpu> measured;  // that the options speak of
  std::shared_ptr<const FittedOnGpu> fitted;      // likewise

  bool operator==(const ListInputs&) const = default;
};

// All that decides about the tables besides the list.
struct TableInputs {
  const LoadedEnvironment* environment = nullptr;  // null: on its way
  bool background = false;                         // it is seen
  float backgroundBlur = 0;                        // then
  bool sampled = false;                            // it will be sampled later
  std::optional<double> maxError;

  bool operator==(const TableInputs&) const = default;
};

// What a wish comes to with what is there.
struct PlanInputs {
  ListInputs list;
  TableInputs tables;

  bool operator==(const PlanInputs&) const = default;
};
// The same but for the time: only what moves is new.
bool differInTimeOnly(PlanInputs a, const PlanInputs& b);

// ListInputs of a wish, as far as it does not wait for anything. moving: of the picture of few samples that is drawn
// while something changes; at rest it is refined.
ListInputs listInputs(const PictureSettings& settings, std::shared_ptr<const io::LoadedModel> model, int scene,
                      int variant, bool hasEnvironment, bool moving);

// Everything that a picture is drawn from, all of it on the GPU.
struct Drawable {
  LoadedScene* scene = nullptr;              // null: nothing yet
  LoadedEnvironment* environment = nullptr;  // null: on its way
  PlanInputs inputs;
  DrawList list;
  Notes notes;                                  // what the list leaves out of the wish
  std::shared_ptr<const PathScene> paths = {};  // of the list, where paths are traced
  bool precise = false;                         // FrameInput
  std::shared_ptr<Ground> ground = {};          // likewise, where there is a floor; its light is traced by who draws
  std::shared_ptr<Screen> screen = {};          // likewise, where shadow maps and horizons are; prepared by who draws
};
// What its picture reads of the environment.
ibl::Needs tableNeeds(const Drawable& drawable);
FrameInput frameInput(const Drawable& drawable, const scene::View& view, const PictureSettings& settings);
// Of a part of its list (partOf).
FrameInput frameInput(const Drawable& drawable, const DrawList& part, const scene::View& view,
                      const PictureSettings& settings);

enum class Progress {
  nothing,  // what is wished for is shown already, or cannot be shown
  waiting,  // for the supply
  working,  // there is more to be done
  done      // Plan::next is complete
};

struct Plan {
  bool moving = false;                                 // listInputs
  bool precise = false;                                // FrameInput
  LoadedEnvironment* environment = nullptr;            // null: on its way
  std::shared_ptr<const MeasuredOnGpu> measured = {};  // likewise
  Drawable next = {};                                  // in the making
  std::vector<TextureUse> uses = {};                   // of its list
  bool listed = false, tabled = false, uploaded = false;
  // What was tried and failed: not again before another wish; whoever changes the supply or the shaders clears it.
  std::optional<PlanInputs> failed = {};
};

struct Step {
  Progress progress = Progress::nothing;
  const char* did = "";  // for times: "read BRDF", "prepare", ...
};

// The next step towards the wish; of uploads as much as keepGoing allows. shown: what is drawn now, or null. An error
// leaves the plan as it failed.
Result<Step> advance(Plan& plan, LoadedScene& scene, const PictureSettings& wish, const Drawable* shown,
                     const Supply& supply, shading::ProgramStore& programs, const KeepGoing& keepGoing = {});

}  // namespace facet::frame
