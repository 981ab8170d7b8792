#include "options/picture_options.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <vector>

#include "base/nearest.hpp"
#include "base/srgb.hpp"
#include "base/text.hpp"
#include "frame/material_choice.hpp"
#include "frame/settings.hpp"
#include "io/sources.hpp"
#include "optics/presets.hpp"
#include "options/arrangement_options.hpp"
#include "options/viewpoint_options.hpp"
#include "shading/features.hpp"

namespace facet::options {

namespace {

using frame::PictureSettings;
using S = PictureSettings;
using Text = std::string_view;

// ---- Rows of one number, one name, one text -------------------------------------------------------------------------

// What the members lead to, one inside the other.
template <auto member, auto... inner, class T>
auto& at(T& object) {
  if constexpr (sizeof...(inner) == 0)
    return object.*member;
  else
    return at<inner...>(object.*member);
}

template <int min, int max, auto... members>
Result<void> parseNumberInto(Text text, PictureSettings& settings) {
  auto& setting = at<members...>(settings);
  using Member = std::remove_cvref_t<decltype(setting)>;
  if constexpr (std::is_same_v<Member, int>) {
    return parseWhole(text, min, max).map([&](int value) { setting = value; });
  } else {
    using Value = std::conditional_t<std::is_same_v<Member, float>, float, double>;
    return parseNumber(text, min, max).map([&](double value) { setting = static_cast<Value>(value); });
  }
}

template <auto... members>
std::string writeNumber(const PictureSettings& settings) {
  const auto& setting = at<members...>(settings);
  if constexpr (requires { setting.has_value(); }) {
    return setting ? number(*setting) : std::string();
  } else {
    return number(setting);
  }
}

template <class T, size_t count>
tl::unexpected<Error> unknownWord(Text text, const Choice<T> (&choices)[count]) {
  std::vector<Text> words;
  for (const Choice<T>& choice : choices) words.push_back(choice.word);
  return fail({}, {}, inQuotes(text) + " is not known", suggestion(text, words));
}

template <const auto& choices, auto... members>
Result<void> parseName(Text text, PictureSettings& settings) {
  const auto* choice = rowOfWord(choices, text);
  if (!choice) return unknownWord(text, choices);
  at<members...>(settings) = choice->value;
  return {};
}

template <const auto& choices, auto... members>
std::string writeName(const PictureSettings& settings) {
  return std::string(rowOf(choices, at<members...>(settings)).word);
}

// The words; what the automatic choice means, too.
template <const auto& choices>
std::string wordsWithNote() {
  std::string words = wordsOf(choices);
  if (choices[0].word == "auto") words += "; auto: " + std::string(choices[0].note);
  return words;
}

// A row of a choice: the values that its help lists are the table's.
template <const auto& choices, auto... members>
constexpr PictureOption choiceOption(Text name, Text help) {
  PictureOption option{name, "NAME", help, parseName<choices, members...>, writeName<choices, members...>};
  option.choices = wordsWithNote<choices>;
  return option;
}

template <auto... members>
Result<void> parseText(Text text, PictureSettings& settings) {
  if (text.empty()) return fail({}, {}, "the value is empty", "give a name or leave the option out");
  at<members...>(settings) = text;
  return {};
}

template <auto... members>
std::string writeString(const PictureSettings& settings) {
  return at<members...>(settings);
}

// ---- Rows of their own kind -----------------------------------------------------------------------------------------

Result<void> parseSize(Text text, PictureSettings& settings) {
  const std::vector<Text> parts = split(text, 'x');
  if (parts.size() != 2) return fail({}, {}, inQuotes(text) + " is not a size", "give WIDTHxHEIGHT such as 1280x720");
  const Result<int> width = parseWhole(parts[0], 1, 16384), height = parseWhole(parts[1], 1, 16384);
  if (!width) return tl::unexpected(width.error());
  if (!height) return tl::unexpected(height.error());
  settings.frame.width = *width, settings.frame.height = *height;
  return {};
}

std::string writeSize(const PictureSettings& settings) {
  return number(settings.frame.width) + "x" + number(settings.frame.height);
}

Result<void> parseScene(Text text, PictureSettings& settings) {
  return parseNumberInto<0, 1'000'000, &S::placement, &frame::Placement::scene>(text, settings);
}

std::string writeScene(const PictureSettings& settings) {
  return settings.placement.scene < 0 ? std::string() : number(settings.placement.scene);
}

std::string writeBumpScale(const PictureSettings& settings) {
  return settings.sources.bump.empty() ? std::string() : number(settings.sources.bumpScale);
}

std::string writeBrdfSamples(const PictureSettings& settings) {
  return settings.look.brdfSamples == 0 ? std::string() : number(settings.look.brdfSamples);
}

// Nothing is compared where nothing is measured.
std::string writeBrdfCompare(const PictureSettings& settings) {
  if (settings.sources.brdf.empty() || settings.comparison.brdfCompare == frame::BrdfCompare::none) return {};
  return writeName<frame::brdfComparisons, &S::comparison, &frame::BrdfComparison::brdfCompare>(settings);
}

std::string writeTime(const PictureSettings& settings) {
  return settings.placement.animation.empty() ? std::string() : number(settings.placement.timeSeconds);
}

constexpr char repeatedSeparator = ';';

Result<void> parseWith(Text text, PictureSettings& settings) {
  settings.sources.with.clear();
  for (const Text model : split(text, repeatedSeparator)) {
    if (model.empty()) return fail({}, {}, inQuotes(text) + " names no model", "give a file or builtin:NAME");
    settings.sources.with.emplace_back(model);
  }
  return {};
}

std::string writeWith(const PictureSettings& settings) {
  std::string text;
  for (const std::string& model : settings.sources.with) text += (text.empty() ? "" : ";") + model;
  return text;
}

Result<void> parseChannel(Text text, PictureSettings& settings) {
  const Choice<int>* channel = rowOfWord(shading::channels, text);
  if (!channel) return unknownWord(text, shading::channels);
  settings.look.channel = shading::channelSetting(channel->value);
  return {};
}

int channelOf(const PictureSettings& settings) { return std::max(0, shading::channelIndex(settings.look.channel)); }

std::string writeChannel(const PictureSettings& settings) {
  return std::string(rowOf(shading::channels, channelOf(settings)).word);
}

bool showsLightInFalseColors(const PictureSettings& settings) {
  return settings.display.falseColors && shading::showsLight(channelOf(settings));
}

// Whether --range can say what its colours stand for, and whether both ends need to be above 0 for that.
bool hasRange(const PictureSettings& settings) {
  return shading::channelKind(channelOf(settings)) == shading::ChannelKind::quantity ||
         showsLightInFalseColors(settings);
}
bool hasLogarithmicRange(const PictureSettings& settings) {
  return channelOf(settings) == static_cast<int>(shading::Channel::texelDensity) || showsLightInFalseColors(settings);
}

Result<void> parseRange(Text text, PictureSettings& settings) {
  const std::vector<Text> parts = split(text, ',');
  const auto end = [&](size_t i) { return parseNumber(parts[i], -1e30, 1e30); };
  if (parts.size() != 2 || !end(0) || !end(1) || !(*end(0) < *end(1)))
    return fail({}, {}, inQuotes(text) + " is no range", "give FROM,TO such as 0,2.5");
  settings.display.range = glm::dvec2(*end(0), *end(1));
  return {};
}

std::string writeRange(const PictureSettings& settings) {
  const std::optional<glm::dvec2>& range = settings.display.range;
  const bool counts = range && hasRange(settings) && (range->x > 0 || !hasLogarithmicRange(settings));
  return counts ? number(range->x) + "," + number(range->y) : std::string();
}

// "#rrggbb", sRGB, or three linear numbers; [0, 1]. Linear Rec. 709.
Result<glm::vec3> parseColor(Text text) {
  glm::vec3 color;
  unsigned rgb = 0;
  if (text.size() == 7 && text[0] == '#' &&
      std::from_chars(text.data() + 1, text.data() + 7, rgb, 16).ptr == text.data() + 7) {
    for (int c = 0; c < 3; ++c) color[c] = static_cast<float>(linearFromSrgb(((rgb >> (16 - 8 * c)) & 255u) / 255.0));
    return color;
  }
  const std::vector<Text> parts = split(text, ',');
  if (parts.size() != 3)
    return fail({}, {}, inQuotes(text) + " is no colour", "give #rrggbb or three linear numbers such as 0.8,0.2,0.1");
  for (size_t c = 0; c < 3; ++c) {
    const Result<double> value = parseNumber(parts[c], 0, 1);
    if (!value) return tl::unexpected(value.error());
    color[static_cast<int>(c)] = static_cast<float>(*value);
  }
  return color;
}

// #rrggbb where that is the same colour to the last bit.
std::string writeColor(const glm::vec3& color) {
  std::string text = "#";
  for (int c = 0; c < 3; ++c) {
    const auto byte = static_cast<unsigned>(std::lround(srgbFromLinear(glm::clamp<double>(color[c], 0, 1)) * 255));
    text += "0123456789abcdef"[byte >> 4];
    text += "0123456789abcdef"[byte & 15];
  }
  if (*parseColor(text) == color) return text;
  return number(color.r) + "," + number(color.g) + "," + number(color.b);
}

// One material for everything: each of its options is one of that material, so that it switches it on.

std::vector<std::string> materialNames() {
  std::vector<std::string> names = {"plain"};
  for (const optics::MetalPreset& metal : optics::metalPresets()) names.emplace_back(metal.name);
  for (const optics::DielectricPreset& dielectric : optics::dielectricPresets()) names.emplace_back(dielectric.name);
  return names;
}

Result<void> parseMaterial(Text text, PictureSettings& settings) {
  const std::vector<std::string> names = materialNames();
  if (std::ranges::find(names, text) == names.end())
    return fail({}, {}, inQuotes(text) + " is not known",
                suggestion(text, std::vector<Text>(names.begin(), names.end())));
  settings.look.material.on = true;
  choosePreset(settings.look.material, text == "plain" ? Text() : text);
  return {};
}

std::string writeMaterial(const PictureSettings& settings) {
  if (!settings.look.material.on) return {};
  return settings.look.material.preset.empty() ? "plain" : settings.look.material.preset;
}

Result<void> parseMaterialColor(Text text, PictureSettings& settings) {
  return parseColor(text).map([&](const glm::vec3& color) {
    settings.look.material.on = true;
    settings.look.material.baseColor = color;
  });
}

// What --material alone would make.
frame::MaterialChoice presetAlone(const frame::MaterialChoice& choice) {
  frame::MaterialChoice alone;
  choosePreset(alone, choice.preset);
  return alone;
}

std::string writeMaterialColor(const PictureSettings& settings) {
  const frame::MaterialChoice& choice = settings.look.material;
  return choice.on && choice.baseColor != presetAlone(choice).baseColor ? writeColor(choice.baseColor) : std::string();
}

template <auto member, int min, int max>
Result<void> parseMaterialNumber(Text text, PictureSettings& settings) {
  return parseNumber(text, min, max).map([&](double value) {
    settings.look.material.on = true;
    settings.look.material.*member = static_cast<float>(value);
  });
}

template <auto member>
std::string writeMaterialNumber(const PictureSettings& settings) {
  const frame::MaterialChoice& choice = settings.look.material;
  return choice.on && choice.*member != presetAlone(choice).*member ? number(choice.*member) : std::string();
}

Result<void> parseBackground(Text text, PictureSettings& settings) {
  if (text == "env" || text == "transparent") {
    settings.frame.background = text == "env" ? frame::Background::environment : frame::Background::transparent;
    return {};
  }
  const Result<glm::vec3> color = parseColor(text);
  if (!color) return fail({}, {}, inQuotes(text) + " is no background", "give env, transparent or a colour as #rrggbb");
  settings.frame.background = frame::Background::color;
  settings.frame.backgroundColor = *color;
  return {};
}

std::string writeBackground(const PictureSettings& settings) {
  if (settings.frame.background == frame::Background::color) return writeColor(settings.frame.backgroundColor);
  return settings.frame.background == frame::Background::environment ? "env" : "transparent";
}

// Names with commas between, bit i for name i; "none": none.
Result<uint32_t> parseBits(Text text, const std::vector<Text>& names) {
  uint32_t bits = 0;
  if (text == "none") return bits;
  for (const Text name : split(text, ',')) {
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) return fail({}, {}, inQuotes(name) + " is not known", suggestion(name, names));
    bits |= 1u << (found - names.begin());
  }
  return bits;
}
std::string writeBits(uint32_t bits, const std::vector<Text>& names, Text separator = ",") {
  std::string text;
  for (size_t i = 0; i < names.size(); ++i)
    if (bits & 1u << i) text += (text.empty() ? "" : std::string(separator)) + std::string(names[i]);
  return text;
}

Result<void> parseWithout(Text text, PictureSettings& settings) {
  const Result<uint32_t> without = parseBits(text, frame::layerWords());
  if (!without) return tl::unexpected(without.error());
  settings.look.without = *without;
  return {};
}
std::string writeWithout(const PictureSettings& settings) {
  return writeBits(settings.look.without, frame::layerWords());
}
std::string layerWords() { return writeBits(~0u, frame::layerWords(), ", "); }
constexpr PictureOption withoutOption(Text name, Text help) {
  PictureOption option{name, "LAYER,...", help, parseWithout, writeWithout};
  option.choices = layerWords;
  return option;
}

Result<void> parseMaxError(Text text, PictureSettings& settings) {
  const bool percent = text.ends_with('%');
  const Result<double> value = parseNumber(text.substr(0, text.size() - (percent ? 1 : 0)), 0, percent ? 100 : 1);
  if (!value || *value == 0)
    return fail({}, {}, inQuotes(text) + " is no error that a picture could keep to",
                "give a share such as 0.01 or 1%");
  settings.quality.maxError = percent ? *value / 100 : *value;
  return {};
}

std::vector<Text> overlayNames() {
  std::vector<Text> names;
  for (const auto& choice : frame::overlayChoices) names.push_back(choice.word);
  return names;
}
Result<void> parseOverlays(Text text, PictureSettings& settings) {
  const Result<uint32_t> shown = parseBits(text, overlayNames());
  if (!shown) return tl::unexpected(shown.error());
  settings.overlays.shown = *shown;
  return {};
}
std::string writeOverlays(const PictureSettings& settings) {
  return writeBits(settings.overlays.shown, overlayNames());
}
std::string overlayWords() { return wordsOf(frame::overlayChoices); }
constexpr PictureOption overlayOption(Text name, Text help) {
  PictureOption option{name, "NAME,...", help, parseOverlays, writeOverlays};
  option.choices = overlayWords;
  return option;
}

template <auto Group, auto Member>
Result<void> parseFlag(Text text, PictureSettings& settings) {
  if (text != "true" && text != "false") return fail({}, {}, inQuotes(text) + " is neither", "give true or false");
  settings.*Group.*Member = text == "true";
  return {};
}
std::string writeGround(const PictureSettings& settings) { return settings.frame.ground ? "true" : ""; }
std::string writeFalseColors(const PictureSettings& settings) {
  return showsLightInFalseColors(settings) ? "true" : "";
}
constexpr PictureOption flagOption(Text name, Text help, Result<void> (*parse)(Text, PictureSettings&),
                                   std::string (*write)(const PictureSettings&)) {
  PictureOption option{name, "", help, parse, write};
  option.flag = true;
  return option;
}

// As choiceOption, but for how they are written.
constexpr PictureOption comparisonOption(Text name, Text help) {
  PictureOption option =
      choiceOption<frame::brdfComparisons, &S::comparison, &frame::BrdfComparison::brdfCompare>(name, help);
  option.write = writeBrdfCompare;
  return option;
}
constexpr PictureOption materialOption(Text name, Text help) {
  PictureOption option{name, "NAME", help, parseMaterial, writeMaterial};
  option.names = materialNames;
  return option;
}
std::string channelWords() { return wordsOf(shading::channels); }
constexpr PictureOption channelOption(Text name, Text help) {
  PictureOption option{name, "NAME", help, parseChannel, writeChannel};
  option.choices = channelWords;
  return option;
}

// ---- The table ------------------------------------------------------------------------------------------------------

using M = frame::MaterialChoice;

constexpr PictureOption repeatedOption(Text name, Text value, Text help, Result<void> (*parse)(Text, PictureSettings&),
                                       std::string (*write)(const PictureSettings&), bool isPath = false) {
  PictureOption option{name, value, help, parse, write, repeatedSeparator, isPath};
  option.repeated = true;
  return option;
}

constexpr PictureOption optionTable[] = {
    {"size", "WxH", "size in pixels (1024x1024)", parseSize, writeSize, 'x'},
    {"orbit", "THETA,PHI,RADIUS", "camera around the target: degrees from +Z towards +X, degrees from +Y, metres",
     parseOrbit, writeOrbit},
    {"target", "X,Y,Z", "what the camera looks at, metres (the scene's centre)", parseTarget, writeTarget},
    {"fov-y", "DEG", "vertical field of view (the camera's, else 45)",
     parseNumberInto<1, 179, &S::viewpoint, &frame::Viewpoint::fovYDeg>,
     writeNumber<&S::viewpoint, &frame::Viewpoint::fovYDeg>},
    choiceOption<frame::projections, &S::viewpoint, &frame::Viewpoint::projection>(
        "projection", "whether what is farther away looks smaller"),
    {"view-height", "M", "metres of what is seen at the target, in the place of the orbit's RADIUS (by that)",
     parseViewHeight, writeNumber<&S::viewpoint, &frame::Viewpoint::viewHeight>},
    {"up", "x|y|z|X,Y,Z", "axis that the orbit's angles are about; with z THETA 0 looks from -Y (y)", parseUp, writeUp},
    {"roll", "DEG", "turns the picture about its middle, counterclockwise (0)",
     parseNumberInto<-36000, 36000, &S::viewpoint, &frame::Viewpoint::rollDeg>,
     writeNumber<&S::viewpoint, &frame::Viewpoint::rollDeg>},
    {"camera", "NAME|INDEX", "a camera of the file", parseText<&S::viewpoint, &frame::Viewpoint::camera>,
     writeString<&S::viewpoint, &frame::Viewpoint::camera>},
    {"scene", "N", "index of the scene (the file's default)", parseScene, writeScene},
    {"variant", "NAME|INDEX", "the file's material variant (none: its own materials)",
     parseText<&S::look, &frame::Look::variant>, writeString<&S::look, &frame::Look::variant>},
    materialOption("material",
                   "one material for everything: plain, or a substance of the panel's such as gold, silver, water, "
                   "diamond (none)"),
    {"material-color", "#rrggbb|R,G,B", "its base colour; as numbers linear (0.8,0.8,0.8; a metal's own)",
     parseMaterialColor, writeMaterialColor},
    {"material-metallic", "0..1", "its metallic (0; a metal's 1)", parseMaterialNumber<&M::metallic, 0, 1>,
     writeMaterialNumber<&M::metallic>},
    {"material-roughness", "0..1", "its perceptual roughness (0.4)", parseMaterialNumber<&M::perceptualRoughness, 0, 1>,
     writeMaterialNumber<&M::perceptualRoughness>},
    {"material-ior", "1..3", "its index of refraction (1.5; a substance's own)", parseMaterialNumber<&M::ior, 1, 3>,
     writeMaterialNumber<&M::ior>},
    repeatedOption("material-set", "NAME=VALUE",
                   "a property of its extensions, such as clearcoatFactor=1, sheenColorFactor=0,0,1", parseMaterialSet,
                   writeMaterialSet),
    repeatedOption("set", "POINTER=VALUE",
                   "a value in place of the file's, by its JSON pointer or the end of it: "
                   "/materials/0/roughnessFactor=0.2, /materials/Gold/baseColorTexture=none, "
                   "/nodes/Lid/rotation=0,0,0.7,0.7, /nodes/3/visible=false, /nodes/Face/weights/2=1, "
                   "/lights/0/intensity=50; * for all",
                   parseSet, writeSet),
    {"only", "NODE,...", "shows these nodes and what is below them alone, by names or indices (all)", parseOnly,
     writeOnly},
    choiceOption<frame::upAxes, &S::placement, &frame::Placement::arrangement, &frame::Arrangement::up>(
        "model-up", "the model's axis that points up"),
    {"model-rotation", "X,Y,Z", "turns the model about the axes of the world, in this order, degrees (0,0,0)",
     parseRotation, writeRotation},
    {"model-position", "X,Y,Z", "moves the model, metres (0,0,0)", parsePosition, writePosition},
    {"model-scale", "X", "scales the model (1)", parseScale, writeScale},
    withoutOption("without", "layers of the materials that are left out, one or several of"),
    {"bump", "HEIGHT.png", "grey height map for the materials of a built-in scene (none)",
     parseText<&S::sources, &frame::Sources::bump>, writeString<&S::sources, &frame::Sources::bump>, ',', true},
    {"bump-scale", "X", "height of its white above its black, in widths of the map (0.02)",
     parseNumberInto<-1000, 1000, &S::sources, &frame::Sources::bumpScale>, writeBumpScale},
    {"allow-outside", "DIR", "folder that files of the model may lie in, too: links and paths out of its own (none)",
     parseText<&S::sources, &frame::Sources::allowOutside>, writeString<&S::sources, &frame::Sources::allowOutside>,
     ',', true},
    repeatedOption(
        "with", "MODEL",
        "a further model in the same scene, as it lies in its own file; its objects are numbered behind those "
        "of the one before",
        parseWith, writeWith, true),
    {"animation", "NAME|INDEX|all", "an animation of the file, or all at once (none: at rest)",
     parseText<&S::placement, &frame::Placement::animation>, writeString<&S::placement, &frame::Placement::animation>},
    {"time", "S", "seconds at which the animation stands (0)",
     parseNumberInto<0, 1'000'000, &S::placement, &frame::Placement::timeSeconds>, writeTime},
    {"env", "FILE|builtin:NAME|none", "environment: .hdr, .exr, builtin:studio, builtin:sky, builtin:white",
     parseText<&S::sources, &frame::Sources::environment>, writeString<&S::sources, &frame::Sources::environment>, ',',
     true},
    {"layer", "NAME", "layer of a multilayer OpenEXR environment (the picture's own: Combined, beauty ...)",
     parseText<&S::sources, &frame::Sources::environmentLayer>,
     writeString<&S::sources, &frame::Sources::environmentLayer>},
    {"env-rotation", "DEG", "turns the environment about +Y (0)",
     parseNumberInto<-36000, 36000, &S::frame, &frame::FrameSettings::environmentRotationDeg>,
     writeNumber<&S::frame, &frame::FrameSettings::environmentRotationDeg>},
    {"env-strength", "X", "factor on the environment's radiance (1)",
     parseNumberInto<0, 1'000'000, &S::frame, &frame::FrameSettings::environmentStrength>,
     writeNumber<&S::frame, &frame::FrameSettings::environmentStrength>},
    {"background", "env|transparent|#rrggbb", "what is behind the model (env); also a colour as R,G,B, linear",
     parseBackground, writeBackground},
    {"background-blur", "0..1",
     "of the environment where it is seen behind the model: as a surface of that perceptual roughness reflects it (0)",
     parseNumberInto<0, 1, &S::frame, &frame::FrameSettings::backgroundBlur>,
     writeNumber<&S::frame, &frame::FrameSettings::backgroundBlur>},
    choiceOption<frame::lightChoices, &S::look, &frame::Look::lights>("lights",
                                                                      "the file's lights, none, or four more"),
    choiceOption<optics::diffuseModels, &S::look, &frame::Look::models, &optics::Models::diffuse>("diffuse",
                                                                                                  "diffuse model"),
    choiceOption<optics::fresnelModels, &S::look, &frame::Look::models, &optics::Models::fresnel>(
        "fresnel",
        "what an interface reflects by angle, for lights; exact is for dielectrics and metals whose index is known, "
        "f82 for the latter"),
    choiceOption<optics::distributions, &S::look, &frame::Look::models, &optics::Models::distribution>(
        "ndf", "distribution of microfacets for lights"),
    choiceOption<optics::maskings, &S::look, &frame::Look::models, &optics::Models::masking>(
        "masking", "shadowing of microfacets for lights"),
    choiceOption<optics::imageLights, &S::look, &frame::Look::models, &optics::Models::imageLight>(
        "image-light", "specular light of the environment"),
    choiceOption<optics::energyModels, &S::look, &frame::Look::models, &optics::Models::energy>(
        "energy", "light of further bounces in a rough lobe"),
    {"brdf", "FILE|NAME|builtin:NAME", "a measured BRDF (MERL, UTIA) in the place of all materials (their own)",
     parseText<&S::sources, &frame::Sources::brdf>, writeString<&S::sources, &frame::Sources::brdf>, ',', true, true},
    {"brdf-dir", "DIR", "looks for databases of measured BRDFs here first",
     parseText<&S::sources, &frame::Sources::brdfDir>, writeString<&S::sources, &frame::Sources::brdfDir>, ',', true},
    choiceOption<optics::lookUps, &S::look, &frame::Look::brdfLookUp>("brdf-lookup", "between its cells"),
    {"brdf-samples", "N",
     "environment samples a pixel of measured BRDFs, in pictures of at most 4 --samples (by the BRDF's sharpness)",
     parseNumberInto<1, 1024, &S::look, &frame::Look::brdfSamples>, writeBrdfSamples},
    choiceOption<io::utiaDecodes, &S::sources, &frame::Sources::utiaDecode>("utia-decode", "what UTIA's numbers are"),
    comparisonOption(
        "brdf-compare",
        "the model fitted to it, GGX over --diffuse, in its place, at its right, or how they differ on the screen"),
    {"brdf-split", "0..1", "where the fitted model begins, in widths of the picture (0.5)",
     parseNumberInto<0, 1, &S::comparison, &frame::BrdfComparison::brdfSplit>,
     writeNumber<&S::comparison, &frame::BrdfComparison::brdfSplit>},
    {"brdf-difference-scale", "X", "factor on that difference (4)",
     parseNumberInto<0, 1000, &S::comparison, &frame::BrdfComparison::brdfDifferenceScale>,
     writeNumber<&S::comparison, &frame::BrdfComparison::brdfDifferenceScale>},
    flagOption("ground", "a floor below the scene that shows nothing but its shadow and what it reflects",
               parseFlag<&S::frame, &frame::FrameSettings::ground>, writeGround),
    {"occlusion", "0..1", "scales the occlusion textures' strength (1)",
     parseNumberInto<0, 1, &S::frame, &frame::FrameSettings::occlusion>,
     writeNumber<&S::frame, &frame::FrameSettings::occlusion>},
    {"exposure", "STOPS", "factor 2^STOPS before tone mapping (0)",
     parseNumberInto<-32, 32, &S::display, &frame::Display::exposureStops>,
     writeNumber<&S::display, &frame::Display::exposureStops>},
    choiceOption<optics::toneMappers, &S::display, &frame::Display::toneMapper>(
        "tonemap", "how radiance becomes what a screen shows"),
    flagOption(
        "false-colors",
        "the luminance of what is shown as colours that stand for numbers, in the tone mapper's place; what is no "
        "number is magenta",
        parseFlag<&S::display, &frame::Display::falseColors>, writeFalseColors),
    choiceOption<frame::transports, &S::quality, &frame::Quality::transport>("light", "how light gets to a surface"),
    choiceOption<frame::visibilities, &S::quality, &frame::Quality::visibility>(
        "visibility", "whether a drawn picture knows what stands in the light's way"),
    choiceOption<frame::blendings, &S::quality, &frame::Quality::blending>(
        "blending", "in which order blended surfaces of a drawn picture lie over one another"),
    choiceOption<frame::causticsChoices, &S::quality, &frame::Quality::caustics>(
        "caustics", "of path-traced light, by way of mirrors and glass"),
    {"bounces", "N", "surfaces that a traced path leaves at most (16)",
     parseNumberInto<0, 64, &S::quality, &frame::Quality::bounces>, writeNumber<&S::quality, &frame::Quality::bounces>},
    {"samples", "N", "samples a pixel (4); above 4 the environment is sampled too, and the picture converges",
     parseNumberInto<1, 4096, &S::quality, &frame::Quality::samples>,
     writeNumber<&S::quality, &frame::Quality::samples>},
    choiceOption<frame::textureFilters, &S::quality, &frame::Quality::textureFilter>(
        "texture-filter", "how slanted textures are read in pictures of at most 4 samples"),
    {"seed", "N", "of the numbers that samples are drawn with: another one gives independent noise (0)",
     parseNumberInto<0, frame::largestSeed, &S::quality, &frame::Quality::seed>,
     writeNumber<&S::quality, &frame::Quality::seed>},
    {"max-error", "E",
     "takes as many samples as the picture's estimated error needs, --samples at most (4096): root mean square of what "
     "one sees, 0.01 or 1% of white; light tables keep to it, too (none: as many as --samples says, tables to 1%)",
     parseMaxError, writeNumber<&S::quality, &frame::Quality::maxError>},
    channelOption("channel", "what is shown"),
    overlayOption("overlay", "lines over a picture that is shown, one or several of"),
    {"range", "FROM,TO",
     "what the ends of the colours stand for, of a --channel that shows quantities, such as depth (what the scene "
     "has), "
     "and with --false-colors (sixteen stops, ten of them below white)",
     parseRange, writeRange},
    {"shader-dir", "DIR", "reads shaders from here instead of the embedded ones",
     parseText<&S::sources, &frame::Sources::shaderDir>, writeString<&S::sources, &frame::Sources::shaderDir>, ',',
     true},
};

}  // namespace

std::span<const PictureOption> pictureOptions() { return optionTable; }

std::string helpOf(const PictureOption& option) {
  std::string help(option.help);
  if (!option.choices) return help;
  const std::string usual = option.write({});
  return help + ": " + option.choices() + " (" + (usual.empty() ? "none" : usual) + ")";
}

std::vector<std::string> wordsFor(const PictureOption& option) {
  if (option.names) return option.names();
  std::vector<std::string> words;
  if (!option.choices) return words;
  const std::string listed = option.choices();  // "auto, mirror; auto: ..."
  for (const Text word : split(Text(listed).substr(0, listed.find(';')), ','))
    words.emplace_back(word.substr(word.starts_with(' ') ? 1 : 0));
  return words;
}

std::vector<Text> optionNames() {
  std::vector<Text> names;
  for (const PictureOption& option : optionTable) names.push_back(option.name);
  return names;
}

const PictureOption* findOption(Text name) {
  for (const PictureOption& option : optionTable) {
    if (option.name == name) return &option;
  }
  return nullptr;
}

std::string placedBelow(const std::string& folder, const PictureOption& option, const std::string& text) {
  if (!option.isPath) return text;
  if (option.repeated) {
    PictureOption one = option;
    one.repeated = false;
    std::string all;
    for (const Text part : split(text, option.separator))
      all += (all.empty() ? "" : std::string(1, option.separator)) + placedBelow(folder, one, std::string(part));
    return all;
  }
  if (text.empty() || text == "none" || text.starts_with("builtin:")) return text;
  const std::filesystem::path path = std::filesystem::path(folder) / text;
  std::error_code error;
  const bool word = text.find('/') == std::string::npos && !text.ends_with(".binary") && !text.ends_with(".bin");
  return option.mayBeName && word && !std::filesystem::exists(path, error) ? text : path.string();
}

Result<void> apply(const PictureArguments& arguments, PictureSettings& settings) {
  for (const auto& [name, text] : arguments)
    if (!findOption(name))
      return fail({}, "--" + std::string(name), "there is no such option", suggestion(name, optionNames()));
  for (const PictureOption& option : optionTable) {
    const auto given = arguments.find(option.name);
    if (given == arguments.end()) continue;
    if (auto parsed = option.parse(given->second, settings); !parsed) {
      return fail({}, "--" + std::string(option.name), parsed.error().problem, parsed.error().remedy);
    }
  }
  return checkTogether(settings);
}

namespace {

// Row i is that of Setting(i).
constexpr Text settingOptions[] = {"",         "scene",         "variant", "animation", "camera",  "bump",
                                   "env",      "layer",         "ndf",     "fresnel",   "samples", "brdf",
                                   "brdf-dir", "allow-outside", "set",     "only"};
static_assert(std::size(settingOptions) == static_cast<size_t>(Setting::only) + 1);
static_assert(std::ranges::all_of(settingOptions, [](Text name) {
  return name.empty() || std::ranges::any_of(optionTable, [&](const PictureOption& o) { return o.name == name; });
}));

}  // namespace

std::string describe(const Error& error) {
  std::string text = facet::describe(error);
  const Text option = settingOptions[static_cast<size_t>(error.about)];
  if (!option.empty()) text.insert(text.size() - 1, " (--" + std::string(option) + ")");
  return text;
}

std::string describe(const std::string& source, const Note& note) {
  return describe({source, note.place, note.text, {}, note.about});
}

namespace {

Result<void> checkViewpoint(const frame::Viewpoint& viewpoint) {
  if (viewpoint.viewHeight && viewpoint.orbit && viewpoint.orbit->radius)
    return fail({}, "--view-height", "the orbit's radius says how much is seen",
                "give either this or THETA,PHI,RADIUS");
  if (viewpoint.camera.empty()) return {};
  const frame::Viewpoint usual;
  const std::pair<const char*, bool> given[] = {{"--orbit", viewpoint.orbit.has_value()},
                                                {"--target", viewpoint.target.has_value()},
                                                {"--projection", viewpoint.projection != usual.projection},
                                                {"--view-height", viewpoint.viewHeight.has_value()},
                                                {"--up", viewpoint.up != usual.up},
                                                {"--roll", viewpoint.rollDeg != usual.rollDeg}};
  for (const auto& [name, is] : given)
    if (is) return fail({}, name, "the camera of the file has its own place", "give either this or --camera");
  return {};
}

}  // namespace

Result<void> checkTogether(const PictureSettings& settings) {
  if (settings.placement.timeSeconds != 0 && settings.placement.animation.empty())
    return fail({}, "--time", "nothing moves without an animation", "give --animation NAME, or --animation all");
  const std::string& environment = settings.sources.environment;
  const bool file = !environment.empty() && environment != "none" && !environment.starts_with(io::builtinPrefix);
  if (!settings.sources.environmentLayer.empty() && !file)
    return fail({}, "--layer", "only an OpenEXR environment has layers", "give --env FILE.exr, too");
  if (settings.comparison.brdfCompare != frame::BrdfCompare::none && settings.sources.brdf.empty())
    return fail({}, "--brdf-compare", "there is no measured BRDF to compare", "give --brdf, too");
  if (settings.display.falseColors && !shading::showsLight(channelOf(settings)))
    return fail({}, "--false-colors", "a channel of what materials and meshes have shows no light",
                "leave out either this or --channel");
  if (settings.display.range && !hasRange(settings))
    return fail({}, "--range", "nothing is shown in false colours",
                "give --false-colors, or --channel depth or another quantity");
  if (settings.display.range && hasLogarithmicRange(settings) && settings.display.range->x <= 0)
    return fail({}, "--range", "the colours stand for logarithms", "give ends above 0");
  return checkViewpoint(settings.viewpoint);
}

std::vector<std::string> commandWords(const PictureSettings& settings, const std::string& model,
                                      const std::string& output) {
  std::vector<std::string> words;
  if (!output.empty()) words.push_back("render");
  if (!model.empty()) words.push_back(model);
  if (!output.empty()) words.insert(words.end(), {"-o", output});
  const PictureSettings defaults;
  for (const PictureOption& option : optionTable) {
    const std::string text = option.write(settings);
    if (text.empty() || text == option.write(defaults)) continue;
    words.push_back("--" + std::string(option.name));
    if (!option.flag) words.push_back(text);
  }
  return words;
}

std::string commandLine(const PictureSettings& settings, const std::string& model, const std::string& output) {
  std::string line = "facet";
  for (const std::string& word : commandWords(settings, model, output)) line += " " + shellWord(word);
  return line;
}

}  // namespace facet::options
