#pragma once

// Settings + model + environment -> one picture. What several pictures share (programs, a scene's GPU data, an
// environment's tables) is passed in and grows on demand.

#include <map>
#include <optional>
#include <string>

#include "base/stages.hpp"
#include "frame/display_pass.hpp"
#include "frame/frame.hpp"
#include "frame/max_error.hpp"
#include "ibl/cache.hpp"

namespace facet::frame {

// framingBounds of an animation.
struct Framing {
  int scene = 0;
  std::string animation;
  scene::Bounds bounds;
};

struct SceneOnGpu {
  std::string source;  // the file, or builtin:NAME
  const scene::Model* model = nullptr;
  GpuScene gpu;
  std::optional<Framing> framing = {};           // the last one
  std::shared_ptr<MeasuredStore> measured = {};  // made when the first is asked for
};

// environment is null for pictures without distant light; the DFG table may still be needed.
struct EnvironmentOnGpu {
  const scene::Environment* environment = nullptr;
  std::shared_ptr<const ibl::PreparedEnvironment> prepared = {};  // null: made when it is needed
  ibl::Tables tables;
  std::optional<scene::Sun> sun = {};  // a light of its own, which the tables do without
  ibl::Method method = {};             // of the tables
  ibl::TableCache cache = {};          // the default: none
  std::string content = {};            // ibl::contentKey, where it is known
};

// The sun of what is prepared, else looks for one in the environment's texels.
void findSun(EnvironmentOnGpu& environment);

// The methods that settings.quality.maxError asks for; the tables of others are dropped. True where they were.
bool chooseMethod(EnvironmentOnGpu& environment, const PictureSettings& settings);

// What of them is not there yet, from the cache or computed.
Result<void> prepareTables(EnvironmentOnGpu& environment, const ibl::Needs& needs, shading::ProgramStore& programs);

// More samples a pixel than this: each is a draw of its own and samples the environment instead of reading the split
// sum's tables, so that its specular part converges to the true integral, not to the approximation.
inline constexpr int convergedAbove = 4;
inline bool converges(const PictureSettings& s) {
  return s.quality.maxError.has_value() || s.quality.samples > convergedAbove;
}
inline constexpr int convergedLightSamples = 4;  // environment samples per draw
inline constexpr int onceLightSamples = 32;      // the same where there is but one draw

// What the settings ask of the draw list, but for the variant, which needs the model: chooseVariant.
DrawOptions drawOptions(const PictureSettings& settings, bool hasEnvironment);

// Errors: no such scene in the model.
Result<int> chooseScene(const PictureSettings& settings, const scene::Model& model);

// Which draws do not show the measured BRDF, or not as it was meant.
void noteMeasured(const DrawList& list, Notes& notes);

// Index in model.variants, -1 for none. Errors: no such variant.
Result<int> chooseVariant(const PictureSettings& settings, const scene::Model& model);

// The pose that the settings ask for, of the chosen scene. Errors: no such animation.
Result<scene::Pose> choosePose(const PictureSettings& settings, const scene::Model& model);

// What a view of everything takes in, world: the scene's bounds; where an animation is chosen, those of its whole
// course (of up to 48 moments, and as many keys), so that each of its frames gets the same view. pose: the chosen one.
scene::Bounds framingBounds(const PictureSettings& settings, const scene::Model& model, int scene,
                            const scene::Bounds& poseBounds);

// The orbit that the settings ask for: what they leave open, a built-in scene's own camera or a view of all of the
// bounds fills in. source: the file, or builtin:NAME.
scene::OrbitCamera chooseOrbit(const PictureSettings& settings, const std::string& source, const scene::Bounds& bounds);

// The file's camera where the settings name one, else chooseOrbit of framing. Errors: no such camera.
Result<scene::View> chooseView(const PictureSettings& settings, const std::string& source, const scene::Model& model,
                               const DrawList& list, const scene::Bounds& framing);

// The environment's name: the one that was chosen, else what a built-in scene is made for, else the studio, or none for
// a scene that nothing could light.
std::string chooseEnvironment(const PictureSettings& settings, const std::string& source, const scene::Model& model,
                              int scene);

// Targets for one draw of settings.quality.samples, or for gathering that many draws.
// rows: of the picture that they hold at once; 0: all.
Targets createTargets(const PictureSettings& settings, const gl::ContextInfo& context, int rows = 0);

struct PictureStatistics {
  FrameStatistics frame;  // of one band
  int bands = 1;
  int imagesDecoded = 0;
  int programsCompiled = 0, programsFromDisk = 0;
  std::vector<ibl::TableStatistics> tables;
  size_t textureBytes = 0, geometryBytes = 0, tableBytes = 0, targetBytes = 0;
  std::map<std::string, int> variants;  // programs by name (shading::variantName) -> draws, before culling
  uint64_t clampedPixels = 0;    // all samples of a channel at the largest half float; counted where radiance is read
  uint64_t nonFinitePixels = 0;  // likewise
  std::vector<double> frameMs;   // the first frame, then the repeated ones; each waited for
  std::optional<ComparisonFigures> comparison;  // of a measured BRDF with the model fitted to it, where both are drawn
  std::vector<Attempt> attempts;                // with more and more samples; only where an error is to be kept to
};

struct Picture {
  io::RadianceImage radiance;  // where asked for
  io::Pixels display;          // where asked for
  PictureStatistics statistics;
};

struct PictureRequest {
  bool radiance = false, display = false;
  int repeat = 0;  // further frames, for timing
  // Nothing is rendered after this: Session frees in main memory what is on the GPU by then.
  bool last = false;
};

// What a picture is drawn from, all of it on the GPU.
struct PreparedPicture {
  DrawList list;
  scene::View view;
  PictureStatistics statistics;
};

// Builds the draw list, computes the tables, decodes and uploads: afterwards neither encoded images nor the
// environment's texels are needed any more.
Result<PreparedPicture> preparePicture(const PictureSettings& settings, SceneOnGpu& scene,
                                       EnvironmentOnGpu& environment, shading::ProgramStore& programs, Notes& notes,
                                       Stages& stages);

// Compiles what is missing, draws, reads back. Band by band where the targets of the whole would be large.
Result<Picture> drawPicture(const PictureSettings& settings, const PictureRequest& request, PreparedPicture prepared,
                            const SceneOnGpu& scene, const EnvironmentOnGpu& environment,
                            shading::ProgramStore& programs, const gl::ContextInfo& context, Stages& stages);

}  // namespace facet::frame
