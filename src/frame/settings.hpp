#pragma once

// What a picture is to look like: plain structs, one for each step that reads them, made from the command line, a job
// file or the panel by options/picture_options. A default that is "not given" leaves the choice to the reader.

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "base/choice.hpp"
#include "frame/arrangement.hpp"
#include "frame/material_choice.hpp"
#include "io/utia.hpp"
#include "optics/color.hpp"
#include "optics/measured.hpp"
#include "optics/models.hpp"

namespace facet::frame {

// Eye = target + radius (sin phi sin theta, cos phi, sin phi cos theta).
struct Orbit {
  double thetaDeg = 0;           // azimuth; 0 puts the eye on +Z, positive turns it towards +X
  double phiDeg = 90;            // polar angle from +Y, [0, 180]
  std::optional<double> radius;  // metres, > 0; not given: frames the scene's bounds

  bool operator==(const Orbit&) const = default;
};

// Whether what is farther away looks smaller.
enum class Projection { perspective, orthographic };
inline constexpr Choice<Projection> projections[] = {
    {Projection::perspective, "perspective", "perspective", "what is farther away looks smaller"},
    {Projection::orthographic, "orthographic", "orthographic",
     "what is farther away looks as large: as much is seen as the perspective shows at the target"}};
static_assert(inOrder(projections));

enum class Background { environment, transparent, color };
using optics::ToneMapper;
// What is shown of a measured BRDF: itself, the model fitted to it, both with a divider between, how they differ.
enum class BrdfCompare { none, fit, split, difference };
inline constexpr Choice<BrdfCompare> brdfComparisons[] = {
    {BrdfCompare::none, "none", "measured", "the table itself"},
    {BrdfCompare::fit, "fit", "fitted model",
     "GGX over a diffuse model, fitted to the table; as it was fitted, that is without compensation for multiple "
     "scattering"},
    {BrdfCompare::split, "split", "split",
     "measured at the left, fitted at the right of a divider, which can be dragged"},
    {BrdfCompare::difference, "difference", "difference", "absolute, of what the screen shows of both"}};
static_assert(inOrder(brdfComparisons));
enum class Lights { scene, none, demo };
inline constexpr Choice<Lights> lightChoices[] = {
    {Lights::scene, "scene", "the file's", "KHR_lights_punctual"},
    {Lights::none, "none", "none"},
    {Lights::demo, "demo", "the file's and four", "four point lights on a ring above the scene"}};
static_assert(inOrder(lightChoices));

// How light gets to a surface.
enum class Transport { direct, paths };
inline constexpr Choice<Transport> transports[] = {
    {Transport::direct, "direct", "drawn",
     "from lights and tables at each pixel; what stands in its way is up to visibility"},
    {Transport::paths, "paths", "path traced",
     "on all ways that there are: shadows, interreflection, refraction; the picture converges with the samples"}};
static_assert(inOrder(transports));

// How a texture that is seen at a slant is read in pictures of at most 4 samples.
enum class TextureFilter { automatic, isotropic, reads, hardware };
inline constexpr Choice<TextureFilter> textureFilters[] = {
    {TextureFilter::automatic, "auto", "automatic", "reads where the driver draws by software, else hardware"},
    {TextureFilter::isotropic, "isotropic", "isotropic", "one read, blurred along the shorter axis"},
    {TextureFilter::reads, "reads", "several reads", "up to four, where a pixel's footprint is stretched"},
    {TextureFilter::hardware, "hardware", "hardware", "the driver's anisotropic filter, up to 8 to 1"}};
static_assert(inOrder(textureFilters));

// Whether drawn pictures (Transport::direct) know what stands in the light's way.
enum class Visibility { automatic, none, screen, rays };
inline constexpr Choice<Visibility> visibilities[] = {
    {Visibility::automatic, "auto", "as it pays",
     "rays up to 16 samples, path-traced light beyond or where an error is to be kept to; none where nothing can be in "
     "the way"},
    {Visibility::none, "none", "none", "light reaches every surface from everywhere"},
    {Visibility::screen, "screen", "screen space",
     "shadow maps of all lights, and of the environment what the depth buffer's horizons hide: as while something "
     "moves"},
    {Visibility::rays, "rays", "rays",
     "the drawn picture, corrected by one path a sample where something blocks or returns light; smoothed"}};
static_assert(inOrder(visibilities));

// In which order drawn surfaces that are blended lie over one another.
enum class Blending { sorted, lists };
inline constexpr Choice<Blending> blendings[] = {
    {Blending::sorted, "sorted", "by object",
     "each object at once, the farthest first; within one its far sides first, then as its triangles come"},
    {Blending::lists, "lists", "by pixel",
     "what covers a pixel is kept and put in order there: right where objects, or the triangles of one, lie in or "
     "around each other, for the memory and time of lists"}};
static_assert(inOrder(blendings));

// Of light that a surface sees by way of mirrors and glass, which single paths find: slow to converge.
enum class Caustics { all, soft };
inline constexpr Choice<Caustics> causticsChoices[] = {
    {Caustics::all, "all", "all", "as light goes: few paths find them, and those are bright"},
    {Caustics::soft, "soft", "softened",
     "surfaces that a diffuse one sees mirror and refract with alpha 0.25 at least: less noise, and caustics are "
     "spread"}};
static_assert(inOrder(causticsChoices));

// What is read from outside, besides the model.
struct Sources {
  std::vector<std::string> with;  // further models in the same scene (scene::addModel)
  std::string bump;               // grey height map for the materials of a built-in scene; empty: none
  double bumpScale = 0.02;        // height of white above black, in widths of the map
  std::string environment;        // "builtin:NAME", a path (io::withLayer), "none"; empty: a built-in one is chosen
  std::string environmentLayer;   // of a multilayer OpenEXR file; empty: the picture's own, or that of `environment`
  std::string allowOutside;       // folder that the model's files may lie in, too; empty: below its own alone
  // A measured BRDF (a file, builtin:NAME or the name of a database) in the place of all materials but unlit ones:
  // their normal maps, occlusion, alpha and emission stay. Empty: the materials' own.
  std::string brdf;
  std::string brdfDir;  // where databases are looked for first
  io::UtiaDecode utiaDecode = io::UtiaDecode::raw;
  std::string shaderDir;  // shaders are read from here and reloaded on change; empty: the embedded ones

  bool operator==(const Sources&) const = default;
};

// What of the model is shown, and in which pose.
struct Placement {
  int scene = -1;          // index; -1: the file's default scene
  std::string animation;   // name or index of an animation in the file, "all"; empty: none, the model is at rest
  double timeSeconds = 0;  // at which the animation stands, [0, 1e6]
  Arrangement arrangement;

  bool operator==(const Placement&) const = default;
};

// From where it is seen.
struct Viewpoint {
  std::string camera;                // name or index of a camera in the file; empty: none. Excludes all but fovYDeg.
  std::optional<Orbit> orbit;        // not given (and no camera): frames the scene's bounds
  std::optional<glm::dvec3> target;  // metres; not given: the centre of the scene's bounds
  std::optional<double> fovYDeg;     // vertical, [1, 179]; not given: the camera's, else 45
  Projection projection = Projection::perspective;
  std::optional<double> viewHeight = {};  // metres of what is seen at the target, > 0: in the place of orbit's radius
  glm::dvec3 up = glm::dvec3(0, 1, 0);    // world, not 0: the axis that the orbit's angles are about
  double rollDeg = 0;                     // turns the picture about its middle, counterclockwise

  bool operator==(const Viewpoint&) const = default;
};

// What its surfaces are and which lights there are: which programs draw it, with which materials.
struct Look {
  std::string variant;  // KHR_materials_variants: name or index; empty: the file's own materials
  MaterialChoice material;
  uint32_t without = 0;  // layers that no material has (scene::Effect, a bit each)
  Lights lights = Lights::scene;
  // Models for comparison. Of the environment: diffuse and energy; Fresnel's terms only where it is sampled; the rest
  // is GGX.
  optics::Models models;
  optics::LookUp brdfLookUp = optics::LookUp::interpolated;
  // Environment samples a pixel of measured BRDFs in pictures of at most 4 samples, [1, 1024]; 0: as many as
  // frame/measured_samples.hpp says.
  int brdfSamples = 0;
  std::string channel;  // a debug view's name (shading/features.hpp lists them); empty: the final picture

  bool operator==(const Look&) const = default;
};

// The picture's size and what is the same for all of its pixels.
struct FrameSettings {
  int width = 1024, height = 1024;  // pixels, [1, 16384]
  Background background = Background::environment;
  glm::vec3 backgroundColor = glm::vec3(0);  // linear Rec. 709; Background::color only
  // Of the environment where it is seen behind the model, also through glass: perceptual roughness of the lobe that
  // sees it, [0, 1]. Its light and its reflections are not blurred.
  float backgroundBlur = 0;
  bool ground = false;               // a floor that shows the scene's shadow (ground.hpp)
  float environmentRotationDeg = 0;  // about +Y
  float environmentStrength = 1;     // factor, [0, 1e6]
  float occlusion = 1;               // scales every material's occlusion strength, [0, 1]

  bool operator==(const FrameSettings&) const = default;
};

// What becomes of the picture's radiance on the screen.
struct Display {
  float exposureStops = 0;  // factor 2^stops before tone mapping, [-32, 32]
  ToneMapper toneMapper = ToneMapper::pbrNeutral;
  // What the ends of false colours stand for, x < y; not given: frame/value_range.hpp. Of a channel that shows
  // quantities, or of light where falseColors.
  std::optional<glm::dvec2> range;
  bool falseColors = false;  // the luminance of light as a colour that stands for a number, in the tone mapper's place

  bool operator==(const Display&) const = default;
};

// How a measured BRDF and the model fitted to it are shown.
struct BrdfComparison {
  BrdfCompare brdfCompare = BrdfCompare::none;  // with GGX over models.diffuse
  float brdfSplit = 0.5f;                       // where the fitted model begins, in widths of the picture, [0, 1]
  float brdfDifferenceScale = 4;                // factor on the difference of display values, [0, 1000]

  bool operator==(const BrdfComparison&) const = default;
};

inline constexpr int largestSeed = (1 << 24) - 1;  // what a float holds

// How far the picture goes towards the converged one.
struct Quality {
  int samples = 4;  // a pixel, [1, 4096]; 1: no antialiasing; above 4 the light converges too
  // The picture takes as many samples as its estimated error needs (frame/max_error.hpp), and the tables the cheapest
  // methods that keep to it (ibl/choice.hpp): relative, (0, 1]. Above 4, samples is the most that it may take.
  std::optional<double> maxError;
  TextureFilter textureFilter = TextureFilter::automatic;
  // Of the numbers that samples are drawn with: pictures of different seeds differ by their noise, which is
  // independent.
  int seed = 0;  // [0, largestSeed]
  Transport transport = Transport::direct;
  Visibility visibility = Visibility::automatic;
  Blending blending = Blending::sorted;  // of drawn pictures; paths meet surfaces in their order
  Caustics caustics = Caustics::all;     // of path-traced light
  int bounces = 16;  // likewise: surfaces that a path leaves at most, [0, 64]; 0: what shines by itself

  bool operator==(const Quality&) const = default;
};

// Width over height.
inline double aspectOf(const FrameSettings& frame) { return static_cast<double>(frame.width) / frame.height; }

// What is drawn over the picture as lines.
enum class Overlay { wireframe, bounds, axes, grid, skeleton, normals, lights, cameras, sun };
inline constexpr Choice<Overlay> overlayChoices[] = {
    {Overlay::wireframe, "wireframe", "wireframe", "edges of triangles; those behind surfaces are hidden"},
    {Overlay::bounds, "bounds", "boxes", "around the scene, and around each thing that is drawn"},
    {Overlay::axes, "axes", "axes", "of the world: X red, Y green, Z blue"},
    {Overlay::grid, "grid", "grid", "below the scene, in metres; every tenth line is stronger"},
    {Overlay::skeleton, "skeleton", "skeleton", "joints of skins, and what joins them"},
    {Overlay::normals, "normals", "normals", "of vertices"},
    {Overlay::lights, "lights", "lights", "point, spot and directional ones: where, which way, how far"},
    {Overlay::cameras, "cameras", "cameras", "of the file: what they see"},
    {Overlay::sun, "sun", "sun", "of the environment, where it has one"}};
static_assert(inOrder(overlayChoices));
struct Overlays {
  uint32_t shown = 0;  // a bit each

  static constexpr uint32_t bitOf(Overlay overlay) { return 1u << static_cast<int>(overlay); }
  bool has(Overlay overlay) const { return (shown & bitOf(overlay)) != 0; }
  bool operator==(const Overlays&) const = default;
};

struct PictureSettings {
  Sources sources;
  Placement placement;
  Viewpoint viewpoint;
  Look look;
  FrameSettings frame;
  Display display;
  BrdfComparison comparison;
  Quality quality;
  Overlays overlays;

  bool operator==(const PictureSettings&) const = default;
};

}  // namespace facet::frame
