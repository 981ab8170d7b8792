#pragma once

// What the viewer shows and says: plain structs that panel and input change, and pure functions on them.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "frame/draw_list.hpp"
#include "frame/material_choice.hpp"
#include "frame/measured_read.hpp"
#include "frame/settings.hpp"
#include "frame/statistics.hpp"
#include "frame/value_range.hpp"
#include "ibl/choice.hpp"
#include "scene/camera.hpp"
#include "scene/pick.hpp"
#include "shading/features.hpp"
#include "view/bookmarks.hpp"
#include "view/file_check.hpp"
#include "view/history.hpp"
#include "view/keys.hpp"
#include "view/listing.hpp"
#include "view/metadata_panel.hpp"
#include "view/panel_layout.hpp"
#include "view/preferences.hpp"
#include "view/scene_tree.hpp"
#include "view/textures.hpp"

namespace facet::view {

using frame::choosePreset;
using frame::MaterialChoice;

// Where a preset's figures come from and what they are, for a tooltip; empty for unknown names.
std::string presetText(std::string_view name);

struct Status {
  std::string text;
  bool isError = false;
};

// What the status line has told of what went wrong or is not as the file wants it.
struct Message {
  std::string time;  // "14:03:27"
  std::string text;
  bool isError = false;  // else a warning
  bool past = false;     // of a model that was shown before
};

struct ViewerStatistics {
  frame::FrameStatistics frame;
  int variants = 0;  // distinct programs in the draw list
  int programsCompiled = 0, programsFromDisk = 0;
  int imagesDecoded = 0, images = 0;
  double cpuMs = 0, gpuMs = 0;                 // of the last frame that was measured
  std::vector<frame::PassTime> passes;         // of that or of the last sample, where they are looked at
  std::vector<const ibl::Candidate*> methods;  // of the tables, where an error decides
  size_t textureBytes = 0, geometryBytes = 0, tableBytes = 0, targetBytes = 0, measuredBytes = 0;
  size_t treeBytes = 0;         // that rays are traced through
  size_t environmentBytes = 0;  // of environments that were shown before
  size_t secondBytes = 0;       // on the GPU of the model beside it
  size_t mainBytes = 0;         // of the process
};

// A camera of the file's scene: what `--camera` calls it and what the panel does.
struct CameraName {
  std::string option, label;
};

// An animation of the file, or all of them at once: what `--animation` calls it.
struct AnimationName {
  std::string option, label;
  double duration = 0;  // seconds
};

struct Playback {
  bool playing = false, loop = true;
  double speed = 1;  // seconds of the animation per second; negative: backwards
};

// How far a resting picture has converged.
struct RefinementStatus {
  int wanted = 0;    // samples a pixel; 0: the picture is not refined
  int gathered = 0;  // of them
  int shown = 0;     // of them, on the screen; 0: the cheap picture still is
  // Of the picture on the screen, estimated: root mean square in 1/255; below 0: not known yet. Of what is gathered
  // ErrorEstimate::most, of the cheap picture the likely one.
  double error = -1;
  bool lightPreview = false;  // the environment's tables are coarse as yet
  bool softened = false;      // caustics are, which no error tells of
};
// "light is a preview"; "37 of 256 samples, error up to 1.2/255"; empty where there is nothing to say.
std::string refinementText(const RefinementStatus& status);

// The shown BRDF's lobe, drawn for light from a direction that one moves.
struct LobeView {
  bool open = false;                                  // its section is
  float theta = 45, phi = 0;                          // of the light, from the normal and the tangent [degrees]
  frame::MeasuredSource source;                       // of `table`, or of what is being read
  std::shared_ptr<const optics::MeasuredBrdf> table;  // while it is open; null: being read
  bool failed = false;                                // it could not be read
};

// Two pictures at once, and how they are shown.
enum class Beside { off, split, difference };
inline constexpr Choice<Beside> besideChoices[] = {
    {Beside::off, "off", "off", "the picture itself alone"},
    {Beside::split, "split", "split", "both, with a divider between them that can be dragged"},
    {Beside::difference, "difference", "difference", "absolute, of what the screen shows of both"}};
static_assert(inOrder(besideChoices));
struct BesideWish {
  Beside how = Beside::off;
  float split = 0.5f;  // of the window's width
  float scale = 4;     // on the difference of display values

  bool operator==(const BesideWish&) const = default;
};

struct Turntable {
  bool on = false;
  double degreesPerSecond = 24;  // about +Y through the target; negative: the other way
};

// What the scene tree has chosen, by itself or by a click into the picture. A material without a node is possible.
struct Selection {
  int node = -1, material = -1;  // of the model; -1: none
  bool reveal = false;           // the tree is to scroll to it
};

// One line of a table of details.
struct Detail {
  std::string name, value;
};

// What the picture shows at the point that was clicked, as the shaders have it there.
struct Inspection {
  bool on = false;
  scene::Hit hit;
  glm::ivec2 pixel = glm::ivec2(0);  // of the picture, from the lower left
  scene::View view;                  // through which it was clicked
  int listNumber = 0;                // of the draw list that it was in
  int material = -1;                 // index in the draw list's materials
  std::string materialName;
  bool measured = false;  // a measured BRDF is in the material's place
  std::optional<glm::vec2> uv;
  std::array<std::optional<glm::vec3>, shading::channelCount> values;  // by channel; not known, not there
  int nextChannel = 1;                                                 // that is looked up next
  std::optional<glm::vec3> radiance;                                   // scene-linear, of the picture on the screen
  std::vector<Detail> materialDetails;  // of its material or the one that the tree has chosen
};

// What is on the screen now.
struct ShownScene {
  std::optional<frame::RangeShown> range;  // of false colours, where a channel is shown in them
  std::shared_ptr<const scene::Model> content;
  std::string model;                  // source: a path or "builtin:NAME"
  std::string environment;            // source, or "none"
  std::optional<double> gridSpacing;  // metres; where a grid is shown
  std::string overlayRemark;          // frame::OverlayLines::remark
  scene::Bounds bounds;
  std::optional<scene::View> view;
  std::vector<CameraName> cameras;
  std::vector<AnimationName> animations;
  std::vector<std::string> scenes;
  int scene = 0;
  std::vector<std::string> variants;
  int variant = -1;                                    // -1: the file's own materials
  int sceneLights = 0;                                 // lights in the file's scene
  std::optional<frame::MeasuredFacts> measured;        // of the BRDF in the materials' place
  std::optional<frame::FittedBrdf> fit;                // where it is drawn
  bool compared = false;                               // both are drawn
  std::optional<frame::ComparisonFigures> comparison;  // of them or of two that are shown
  std::string fastMethod, truthMethod;                 // of two that are on the screen; empty: there are none
  std::string second;                                  // source of the model beside `model`, where it is drawn
  std::optional<double> flip;                          // of the two, mean, where both rest
  std::vector<std::string> warnings, infos;
  std::vector<ShownTexture> textures;
  ViewerStatistics statistics;
};

struct ViewerState {
  // width and height are the framebuffer's. Orbit and target are unused: `camera` holds them, unless
  // settings.viewpoint.camera names one of the file's. An empty environment is chosen by the model.
  frame::PictureSettings settings;
  scene::OrbitCamera camera;
  scene::OrbitCamera startCamera;  // what reset returns to
  Playback playback;
  Turntable turntable;
  Selection selection;
  SceneTree tree;
  FileCheck fileCheck;
  ShownMetadata metadata;
  Preferences preferences;
  Bookmarks bookmarks;
  std::string bookmarkName;  // as it is being typed
  KeyMap keys = usualKeys();
  PanelLayout layout;
  double coveredLeft = 0, coveredRight = 0;  // by panels, of the picture [pixels]
  Inspection inspection;
  std::optional<glm::dvec3> measuredFrom;  // a point that distances are told from, world
  History history;
  std::vector<std::string> environments;  // that are offered: the built-in ones, those that were given, "none"
  std::vector<Entry> databases;           // of measured BRDFs, as the browser has found them
  bool fitting = false;                   // a model is being fitted to the measured BRDF
  LobeView lobe;
  std::string lastBrdf;    // that was chosen, for returning to it
  std::string brdfFilter;  // of the databases

  ShownScene shown;
  Status status;
  std::vector<Message> messages;  // oldest first
  RefinementStatus refinement;
  std::string loading;       // what is being loaded; empty: nothing
  bool modelFailed = false;  // one at least could not be shown
  std::string openGL;        // version and renderer
  bool helpVisible = false;
  std::string helpFilter;
  bool searchAsked = false;                   // the browser's search is to take the keyboard
  bool messagesAsked = false;                 // the list of messages is to open
  bool screenshotAsked = false;               // as soon as a whole picture is there
  int largeWidth = 3840, largeHeight = 2160;  // of a picture of another size than the window's (large_picture.hpp)
  bool largePictureRuns = false;
  std::filesystem::path screenshotFile;  // its name; empty: a new one in the working directory
  bool screenshotWaits = false;          // for the picture to converge
  bool overlaysInPictures = false;       // screenshots and copied commands have settings.overlays
  bool passesTimed = false;              // the panel shows what each pass takes
  bool errorsShown = false;              // each pixel's, in colours over the picture
  BesideWish truth;                      // the fast picture, and what it converges to
  std::string secondModel;               // source of the one beside the shown one; empty: none
  BesideWish second = {.how = Beside::split};
  bool panelVisible = true;  // the panels that are chosen to be shown; one key hides all
  bool browserVisible = true, settingsVisible = true, timelineVisible = true;
};

// What the status line says; the log has it, too.
void say(ViewerState& state, const std::string& text);
void complain(ViewerState& state, const Error& error);

// Into the list of messages, of which a hundred are kept.
void note(ViewerState& state, const std::string& text, bool isError);
// The same of what the status line says, where it is a new error.
void noteProblem(ViewerState& state);
// How many there are of what is shown, worded: "1 problem", "2 problems, 1 warning"; empty: none.
std::string messageCount(const std::vector<Message>& messages);

// Where materials come from: the file, one for everything, a measured BRDF.
enum class MaterialSource { file, one, measured };
MaterialSource materialSource(const frame::PictureSettings& settings);
// Measured: the last one that was chosen, else the first that was found, else a built-in one.
void chooseMaterialSource(ViewerState& state, MaterialSource source);
// source: a path, builtin:NAME or the name of a database.
void chooseBrdf(ViewerState& state, const std::string& source);
// "MERL", "UTIA"
const char* kindName(optics::MeasuredKind kind);
// "GGX + Lambert"
std::string modelName(optics::DiffuseModel diffuse);
// "RMS 2.31/255 where they differ (31 % of the picture), 40/255 at most"
std::string comparisonText(const frame::ComparisonFigures& figures);

// The settings whose command shows what is on the screen.
frame::PictureSettings commandSettings(const ViewerState& state);

// Errors: the settings name a camera that the scene doesn't have.
Result<scene::View> viewOf(const ViewerState& state, const scene::Model& model, const frame::DrawList& list);

// Width over height of what a view of everything should fit into: as much of the picture's middle as no panel covers.
double framingAspect(const ViewerState& state);

// Leaves the file's camera for an orbit around the same view; nothing changes where there is none.
void freeCamera(ViewerState& state, const scene::View& view);

// Looks from where a text says (options/camera_text.hpp). Errors: it says nothing like that.
Result<void> goToCamera(ViewerState& state, std::string_view text);

// Offers the environment where it is not yet offered; before "none".
void offerEnvironment(ViewerState& state, const std::string& source);

// What the timeline offers: by name, by index where a name is missing or not unique; "all" where there are several.
std::vector<AnimationName> animationNames(const scene::Model& model);

// What the timeline calls what --animation names: "0" and "all" may be the same single animation. Unchanged where there
// is no such animation.
std::string animationOption(const scene::Model& model, const std::string& wanted);

// The built-in environments and "none".
std::vector<std::string> builtinEnvironmentSources();

// The next built-in one, where E is pressed.
std::string nextEnvironment(const std::string& current);

// Statistics of a draw list.
int variantCount(const frame::DrawList& list);

}  // namespace facet::view
