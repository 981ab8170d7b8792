#pragma once

// What a wish names of a model, and what it leaves open: scene, variant, pose, view, environment, options of the draw
// list. No OpenGL.

#include <string>

#include "base/error.hpp"
#include "frame/draw_list.hpp"
#include "frame/settings_fwd.hpp"
#include "scene/camera.hpp"
#include "scene/model.hpp"
#include "scene/pose.hpp"

namespace facet::frame {

// More samples a pixel than this: each is a draw of its own and samples the environment instead of reading the split
// sum's tables, so that its specular part converges to the true integral, not to the approximation.
inline constexpr int convergedAbove = 4;
// Up to so many samples automatic visibility corrects a drawn picture, above them paths are nearer for the same time.
inline constexpr int correctedUpTo = 16;
// Nothing is drawn, all light comes by paths: they were asked for, or are what a converged picture takes.
bool tracesPaths(const PictureSettings& settings);
// Rays correct the drawn picture, where there is anything that could be in the light's way.
bool correctedByRays(const PictureSettings& settings);
// Shadow maps and horizons do what they can.
bool usesScreen(const PictureSettings& settings);

// What became of a wish for visibility, and why.
struct VisibilityChosen {
  std::string method;  // "none", "screen", "rays", "paths"
  std::string why;
};
VisibilityChosen chosenVisibility(const PictureSettings& settings, const DrawList& list);
// Of the shaded picture, not of a channel.
bool converges(const PictureSettings& settings);
inline constexpr int convergedLightSamples = 2;  // environment samples per draw, of each lobe and of the lamps
inline constexpr int onceLightSamples = 32;      // the same where there is but one draw

// The settings of the picture that is drawn while something changes: of few samples.
PictureSettings movingSettings(const PictureSettings& settings);

// What the automatic choice means; software: the driver draws by software, where anisotropic filtering is dear.
TextureFilter chooseTextureFilter(TextureFilter wish, bool software);

// The settings of the picture that rests in a window: rays do not correct it, which takes all of its rows at once.
PictureSettings restingSettings(const PictureSettings& settings);

// What the settings ask of the draw list, but for the variant, which needs the model, and the measured BRDF.
DrawOptions drawOptions(const PictureSettings& settings, bool hasEnvironment);

// What is behind the picture where that is a colour (Background::color): of parts of its light one has it.
glm::vec3 backgroundColor(const PictureSettings& settings);
// The environment is seen behind the model.
bool backgroundVisible(const PictureSettings& settings, bool hasEnvironment);

// Errors: no such scene in the model.
Result<int> chooseScene(const Placement& placement, const scene::Model& model);

// Index in model.variants, -1 for none. Errors: no such variant.
Result<int> chooseVariant(const Look& look, const scene::Model& model);

// Where an arrangement puts a model: the identity by default.
glm::dmat4 worldFromModel(const Arrangement& arrangement);

// Nodes by name (all of that name), else by index. Errors: there is none such.
Result<std::vector<int>> chooseNodes(const std::vector<std::string>& wanted, const scene::Model& model);

// The pose that is asked for, of the chosen scene. Errors: no such animation, an edit or a node that means nothing.
Result<scene::Pose> choosePose(const Placement& placement, const scene::Model& model);

// What a view of everything takes in, world: the scene's bounds; where an animation is chosen, those of its whole
// course (of up to 48 moments, and as many keys), so that each of its frames gets the same view. scene: the chosen one.
scene::Bounds framingBounds(const Placement& placement, const scene::Model& model, int scene,
                            const scene::Bounds& poseBounds);

// The orbit that the settings ask for: what they leave open, a built-in scene's own camera or a view of all of the
// bounds fills in. source: the file, or builtin:NAME; aspect: width / height.
scene::OrbitCamera chooseOrbit(const Viewpoint& viewpoint, double aspect, const std::string& source,
                               const scene::Bounds& bounds);

// The file's camera where one is named, else chooseOrbit of framing. Errors: no such camera.
Result<scene::View> chooseView(const Viewpoint& viewpoint, double aspect, const std::string& source,
                               const scene::Model& model, const DrawList& list, const scene::Bounds& framing);

// The environment's name: the one that was chosen, else what a built-in scene is made for, else the studio, or none for
// a scene that nothing could light.
std::string chooseEnvironment(const PictureSettings& settings, const std::string& source, const scene::Model& model,
                              int scene);

}  // namespace facet::frame
