#include "options/picture_options.hpp"

#include <CLI/CLI.hpp>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/srgb.hpp"
#include "base/text.hpp"
#include "commands/picture_arguments.hpp"
#include "frame/settings.hpp"
#include "support/command.hpp"

using namespace facet;
using frame::PictureSettings;
using nlohmann::json;
using options::PictureArguments;

namespace {

constexpr std::string_view jobKeys[] = {"model", "output"};

Result<PictureSettings> fromArguments(const PictureArguments& arguments) {
  PictureSettings settings;
  return options::apply(arguments, settings).map([&] { return settings; });
}

Result<PictureSettings> fromJson(const json& object, const std::string& folder = "folder") {
  PictureSettings settings;
  return commands::applyObject(object, jobKeys, folder, "jobs.json", "/jobs/2", settings).map([&] { return settings; });
}

// Words -> CLI11 -> settings, as the window command and render do it.
Result<PictureSettings> fromWords(std::vector<std::string> words, std::string* model = nullptr) {
  CLI::App app;
  PictureArguments arguments;
  std::string ignored;
  app.add_option("MODEL", model ? *model : ignored);
  commands::addPictureOptions(app, arguments);
  std::reverse(words.begin(), words.end());  // CLI11 takes them from the back
  app.parse(words);
  return fromArguments(arguments);
}

void checkEqual(const PictureSettings& a, const PictureSettings& b) {
  for (const options::PictureOption& option : options::pictureOptions()) {
    CAPTURE(option.name);
    CHECK(option.write(a) == option.write(b));
  }
}

// Everything away from its default.
PictureSettings unusual() {
  PictureSettings s;
  s.frame.width = 640, s.frame.height = 1;
  s.frame.ground = true;
  s.viewpoint.orbit = frame::Orbit{.thetaDeg = -30.25, .phiDeg = 0.1, .radius = 0.0105};
  s.viewpoint.target = glm::dvec3(0.0027, -1e-7, 12345678.9);
  s.viewpoint.fovYDeg = 33.3;
  s.viewpoint.projection = frame::Projection::orthographic;
  s.viewpoint.up = {0.25, -1e-3, 2}, s.viewpoint.rollDeg = -12.5;
  s.placement.scene = 3;
  s.look.variant = "night & day";
  s.look.without = 0b101;
  s.look.material = {true,
                     {0.1f, 1.0f / 3, 0.7f},
                     0.25f,
                     0.05f,
                     2.125f,
                     "diamond",
                     {{"/clearcoatFactor", {0.5}}, {"/sheenColorFactor", {0, 0.25, 1}}}};
  s.placement.arrangement = {{{"/materials/0/baseColorTexture", {}}, {"/nodes/3/translation", {1.0 / 3, -2, 1e-9}}},
                             {"lid", "4"},
                             frame::UpAxis::z,
                             {90, 0, -0.5},
                             {1e-7, 2, 3},
                             0.001};
  s.sources.bump = "h.png", s.sources.bumpScale = -0.125;
  s.look.models.diffuse = optics::DiffuseModel::callOfDuty, s.look.models.fresnel = optics::FresnelModel::f82Tint;
  s.look.models.distribution = optics::NormalDistribution::blinn, s.look.models.masking = optics::Masking::cavity;
  s.look.models.imageLight = optics::ImageLight::taps2, s.look.models.energy = optics::EnergyModel::kullaConty;
  s.sources.brdf = "steel", s.sources.brdfDir = "/brdf", s.look.brdfLookUp = optics::LookUp::nearest,
  s.sources.utiaDecode = io::UtiaDecode::srgb;
  s.look.brdfSamples = 128;
  s.comparison.brdfCompare = frame::BrdfCompare::difference, s.comparison.brdfSplit = 0.1f,
  s.comparison.brdfDifferenceScale = 12.5f;
  s.placement.animation = "run's", s.placement.timeSeconds = 1.25;
  s.sources.environment = "it's here/a b.hdr", s.sources.environmentLayer = "View.Combined";
  s.sources.allowOutside = "/data store";
  s.frame.environmentRotationDeg = -0.1f, s.frame.environmentStrength = 1e-3f;
  s.frame.background = frame::Background::color;
  s.frame.backgroundBlur = 0.35f;
  s.frame.backgroundColor = {0.3f, static_cast<float>(linearFromSrgb(7 / 255.0)), 1e-5f};
  s.look.lights = frame::Lights::demo, s.quality.transport = frame::Transport::paths;
  s.quality.visibility = frame::Visibility::rays;
  s.quality.blending = frame::Blending::lists;
  s.quality.caustics = frame::Caustics::soft;
  s.frame.occlusion = 0;
  s.display.exposureStops = -2.5f;
  s.display.toneMapper = frame::ToneMapper::uncharted2;
  s.quality.samples = 16, s.quality.bounces = 3, s.quality.seed = 7;
  s.quality.textureFilter = frame::TextureFilter::isotropic;
  s.quality.maxError = 0.02;
  s.look.channel = "environmentDiffuse", s.display.falseColors = true, s.display.range = glm::dvec2(1.0 / 3, 1e6);
  s.overlays.shown = frame::Overlays::bitOf(frame::Overlay::grid) | frame::Overlays::bitOf(frame::Overlay::sun);
  s.sources.shaderDir = "my $HOME", s.sources.with = {"b c.glb", "builtin:furnace"};
  return s;
}

}  // namespace

TEST_CASE("a time needs an animation") {
  const auto alone = fromArguments({{"time", "1.5"}});
  REQUIRE_FALSE(alone);
  CHECK(describe(alone.error()) ==
        "--time: nothing moves without an animation; give --animation NAME, or --animation all.");
  const auto both = fromArguments({{"time", "1.5"}, {"animation", "all"}});
  REQUIRE(both);
  CHECK(both->placement.timeSeconds == 1.5);
  CHECK(both->placement.animation == "all");
}

TEST_CASE("a message below names no option, what the program says does") {
  CHECK(options::describe(Error{"a.glb", "", "there is no camera", "it has none", Setting::camera}) ==
        "a.glb: there is no camera; it has none (--camera).");
  CHECK(options::describe("a.glb", {Note::Severity::warning, "", "nothing lights the scene", Setting::environment}) ==
        "a.glb: nothing lights the scene (--env).");
  CHECK(options::describe("a.glb", {Note::Severity::warning, "/nodes/1", "is left out"}) ==
        "a.glb: /nodes/1: is left out.");
  // Each setting has an option.
  for (int i = 1; i <= static_cast<int>(Setting::brdfFolder); ++i)
    CHECK(options::describe(Error{"", "", "wrong", "", Setting(i)}).starts_with("wrong (--"));
  CHECK(describe(Error{"", "", "wrong", "", Setting::brdf}) == "wrong.");
}

TEST_CASE("a range is of a channel that shows quantities") {
  const auto both = fromArguments({{"channel", "depth"}, {"range", "-1,2.5"}});
  REQUIRE(both);
  CHECK(both->display.range == glm::dvec2(-1, 2.5));
  CHECK(options::commandLine(*both, "a.glb") == "facet a.glb --channel depth --range -1,2.5");
  PictureSettings other = *both;
  other.look.channel = "normal";  // as the panel leaves it
  CHECK(options::commandLine(other, "a.glb") == "facet a.glb --channel normal");
}

TEST_CASE("false colours are of light, over a range of its logarithm") {
  const auto light = fromArguments({{"false-colors", "true"}, {"range", "0.01,4"}, {"channel", "environmentDiffuse"}});
  REQUIRE(light);
  CHECK(options::commandLine(*light, "a.glb") ==
        "facet a.glb --false-colors --channel environmentDiffuse --range 0.01,4");
  PictureSettings other = *light;
  other.display.range = glm::dvec2(-1, 4);  // as a channel of linear numbers had it
  CHECK(options::commandLine(other, "a.glb") == "facet a.glb --false-colors --channel environmentDiffuse");
  other.look.channel = "depth";
  CHECK(options::commandLine(other, "a.glb") == "facet a.glb --channel depth --range -1,4");
  CHECK(describe(fromArguments({{"false-colors", "true"}, {"range", "0,4"}}).error()) ==
        "--range: the colours stand for logarithms; give ends above 0.");
  CHECK(describe(fromArguments({{"channel", "texelDensity"}, {"range", "-1,4"}}).error()) ==
        "--range: the colours stand for logarithms; give ends above 0.");
  CHECK(describe(fromArguments({{"channel", "depth"}, {"false-colors", "true"}}).error()) ==
        "--false-colors: a channel of what materials and meshes have shows no light; leave out either this or "
        "--channel.");
}

TEST_CASE("a comparison needs a measured BRDF") {
  CHECK(describe(fromArguments({{"brdf-compare", "split"}}).error()) ==
        "--brdf-compare: there is no measured BRDF to compare; give --brdf, too.");
  const auto both = fromArguments({{"brdf-compare", "fit"}, {"brdf", "gold"}});
  REQUIRE(both);
  CHECK(both->comparison.brdfCompare == frame::BrdfCompare::fit);
  CHECK(options::commandLine(*both, "a.glb") == "facet a.glb --brdf gold --brdf-compare fit");
  PictureSettings measured = *both;
  measured.comparison.brdfCompare = frame::BrdfCompare::none;
  CHECK(options::commandLine(measured, "a.glb") == "facet a.glb --brdf gold");
  PictureSettings without = *both;
  without.sources.brdf.clear();  // as the panel leaves it
  CHECK(options::commandLine(without, "a.glb") == "facet a.glb");
}

TEST_CASE("each option sets its own field") {
  const auto set = [](std::string_view name, const std::string& text) {
    const Result<PictureSettings> settings = fromArguments({{name, text}});
    INFO(name << " " << text << ": " << (settings ? "" : describe(settings.error())));
    REQUIRE(settings);
    return *settings;
  };
  CHECK(set("size", "640x480").frame.width == 640);
  CHECK(set("size", "640x480").frame.height == 480);
  CHECK(set("orbit", "-25,75.5,0.4").viewpoint.orbit->thetaDeg == -25);
  CHECK(set("orbit", "-25,75.5,0.4").viewpoint.orbit->phiDeg == 75.5);
  CHECK(set("orbit", "-25,75.5,0.4").viewpoint.orbit->radius == 0.4);
  CHECK_FALSE(set("orbit", "+90,180").viewpoint.orbit->radius);
  CHECK(set("target", "1,-2.5,3e2").viewpoint.target == glm::dvec3(1, -2.5, 300));
  CHECK(set("fov-y", "30").viewpoint.fovYDeg == 30);
  CHECK(set("projection", "orthographic").viewpoint.projection == frame::Projection::orthographic);
  CHECK(set("view-height", "2.5").viewpoint.viewHeight == 2.5);
  CHECK(set("up", "z").viewpoint.up == glm::dvec3(0, 0, 1));
  CHECK(set("up", "-x").viewpoint.up == glm::dvec3(-1, 0, 0));
  CHECK(set("up", "0,-2,1").viewpoint.up == glm::dvec3(0, -2, 1));
  CHECK(set("roll", "-90").viewpoint.rollDeg == -90);
  CHECK(set("camera", "Main camera").viewpoint.camera == "Main camera");
  CHECK(set("scene", "2").placement.scene == 2);
  CHECK(set("variant", "beach").look.variant == "beach");
  CHECK(set("env", "builtin:sky").sources.environment == "builtin:sky");
  CHECK(set("env-rotation", "-90").frame.environmentRotationDeg == -90);
  CHECK(set("env-strength", "0").frame.environmentStrength == 0);
  CHECK(set("background-blur", "0.35").frame.backgroundBlur == 0.35f);
  CHECK(set("background", "transparent").frame.background == frame::Background::transparent);
  CHECK(set("background", "env").frame.background == frame::Background::environment);
  CHECK(set("background", "#ff0080").frame.background == frame::Background::color);
  CHECK(set("background", "#ff0080").frame.backgroundColor ==
        glm::vec3(1, 0, static_cast<float>(linearFromSrgb(128 / 255.0))));
  CHECK(set("background", "0.5,0,1").frame.backgroundColor == glm::vec3(0.5f, 0, 1));
  CHECK(set("material", "plain").look.material.on);
  CHECK(set("material", "gold").look.material.preset == "gold");
  CHECK(set("material", "gold").look.material.metallic == 1);
  CHECK(set("material", "water").look.material.ior == Approx(1.333).margin(0.001));
  CHECK(set("material-color", "#ffffff").look.material.baseColor == glm::vec3(1));
  CHECK(set("material-color", "0.25,0,1").look.material.baseColor == glm::vec3(0.25f, 0, 1));
  CHECK(set("material-color", "0.25,0,1").look.material.on);
  CHECK(set("material-metallic", "0.5").look.material.metallic == 0.5f);
  CHECK(set("material-roughness", "0").look.material.perceptualRoughness == 0);
  CHECK(set("material-ior", "2").look.material.ior == 2);
  CHECK(set("energy", "turquin").look.models.energy == optics::EnergyModel::turquin);
  CHECK(set("lights", "none").look.lights == frame::Lights::none);
  CHECK(set("brdf-split", "0.25").comparison.brdfSplit == 0.25f);
  CHECK(set("brdf-difference-scale", "10").comparison.brdfDifferenceScale == 10);
  CHECK(set("blending", "lists").quality.blending == frame::Blending::lists);
  CHECK(set("caustics", "soft").quality.caustics == frame::Caustics::soft);
  CHECK(set("visibility", "screen").quality.visibility == frame::Visibility::screen);
  CHECK(set("occlusion", "0.5").frame.occlusion == 0.5f);
  CHECK(set("ground", "true").frame.ground);
  CHECK_FALSE(set("ground", "false").frame.ground);
  CHECK(set("with", "b.glb;builtin:furnace").sources.with == std::vector<std::string>{"b.glb", "builtin:furnace"});
  CHECK(set("false-colors", "true").display.falseColors);
  CHECK(set("exposure", "-1.5").display.exposureStops == -1.5f);
  CHECK(set("tonemap", "agx").display.toneMapper == frame::ToneMapper::agx);
  CHECK(set("samples", "1").quality.samples == 1);
  CHECK(set("max-error", "0.5%").quality.maxError == 0.005);
  CHECK(set("max-error", "0.02").quality.maxError == 0.02);
  CHECK(set("channel", "baseColor").look.channel == "baseColor");
  CHECK(set("channel", "final").look.channel == "");
  CHECK(set("shader-dir", "shaders").sources.shaderDir == "shaders");
}

TEST_CASE("every way to be wrong has its sentence") {
  struct Row {
    std::string_view name;
    std::string text, message;
  };
  const Row row = GENERATE(values<Row>({
      {"size", "640", "--size: '640' is not a size; give WIDTHxHEIGHT such as 1280x720."},
      {"size", "1x2x3", "--size: '1x2x3' is not a size; give WIDTHxHEIGHT such as 1280x720."},
      {"size", "0x5", "--size: 0 is out of range; give a whole number from 1 to 16384."},
      {"size", "5x16385", "--size: 16385 is out of range; give a whole number from 1 to 16384."},
      {"size", "x5", "--size: '' is not a whole number; give a whole number from 1 to 16384."},
      {"size", "99999999999x5", "--size: 99999999999 is out of range; give a whole number from 1 to 16384."},
      {"orbit", "25", "--orbit: '25' is not an orbit; give THETA,PHI or THETA,PHI,RADIUS such as 25,75,0.4."},
      {"orbit", "25,181,1", "--orbit: 181 is out of range; give a number from 0 to 180."},
      {"orbit", "25,75,0", "--orbit: 0 is out of range; give a number from 1e-09 to 1e+09."},
      {"orbit", "a,75", "--orbit: 'a' is not a number; give a number from -36000 to 36000."},
      {"orbit", "nan,75", "--orbit: 'nan' is not a number; give a number from -36000 to 36000."},
      {"target", "1,2", "--target: '1,2' is not a point; give X,Y,Z in metres such as 0,1.5,0."},
      {"target", "1,2,inf", "--target: inf is out of range; give a number from -1e+09 to 1e+09."},
      {"target", "1,2,", "--target: '' is not a number; give a number from -1e+09 to 1e+09."},
      {"fov-y", "0", "--fov-y: 0 is out of range; give a number from 1 to 179."},
      {"fov-y", "45deg", "--fov-y: '45deg' is not a number; give a number from 1 to 179."},
      {"projection", "ortographic", "--projection: 'ortographic' is not known; perhaps orthographic is meant."},
      {"view-height", "0", "--view-height: 0 is out of range; give a number from 1e-09 to 1e+09."},
      {"up", "w", "--up: 'w' is not a direction; give X,Y,Z such as 0,0,-1; or x, y, z."},
      {"up", "0,0,0", "--up: '0,0,0' is no direction; give x, y, z or X,Y,Z such as 0,0,-1."},
      {"roll", "up", "--roll: 'up' is not a number; give a number from -36000 to 36000."},
      {"camera", "", "--camera: the value is empty; give a name or leave the option out."},
      {"scene", "-1", "--scene: -1 is out of range; give a whole number from 0 to 1000000."},
      {"scene", "1.5", "--scene: '1.5' is not a whole number; give a whole number from 0 to 1000000."},
      {"env", "", "--env: the value is empty; give a name or leave the option out."},
      {"env-rotation", "1e9", "--env-rotation: 1e9 is out of range; give a number from -36000 to 36000."},
      {"env-strength", "-1", "--env-strength: -1 is out of range; give a number from 0 to 1e+06."},
      {"background-blur", "1.5", "--background-blur: 1.5 is out of range; give a number from 0 to 1."},
      {"background", "red", "--background: 'red' is no background; give env, transparent or a colour as #rrggbb."},
      {"background", "#12345",
       "--background: '#12345' is no background; give env, transparent or a colour as #rrggbb."},
      {"background", "#12345g",
       "--background: '#12345g' is no background; give env, transparent or a colour as #rrggbb."},
      {"background", "1,0", "--background: '1,0' is no background; give env, transparent or a colour as #rrggbb."},
      {"material", "gould", "--material: 'gould' is not known; perhaps gold is meant."},
      {"material-color", "red",
       "--material-color: 'red' is no colour; give #rrggbb or three linear numbers such as 0.8,0.2,0.1."},
      {"material-color", "0,0,2", "--material-color: 2 is out of range; give a number from 0 to 1."},
      {"material-metallic", "-1", "--material-metallic: -1 is out of range; give a number from 0 to 1."},
      {"material-roughness", "2", "--material-roughness: 2 is out of range; give a number from 0 to 1."},
      {"material-ior", "0.9", "--material-ior: 0.9 is out of range; give a number from 1 to 3."},
      {"set", "roughness",
       "--set: 'roughness' sets nothing; give POINTER=VALUE such as /materials/0/roughnessFactor=0.2."},
      {"material-set", "clearcoatFacto=1",
       "--material-set: nothing is set by '/materials/0/clearcoatFacto': there is no 'clearcoatFacto'; perhaps "
       "clearcoatFactor "
       "is meant."},
      {"only", ",", "--only: no node is named; give names or indices of nodes."},
      {"model-up", "w", "--model-up: 'w' is not known; choose one of y, z, x."},
      {"model-rotation", "1,2", "--model-rotation: '1,2' is not a rotation; give X,Y,Z in degrees such as 0,90,0."},
      {"model-scale", "0", "--model-scale: 0 is out of range; give a number from 1e-09 to 1e+09."},
      {"without", "clearcoat,shen", "--without: 'shen' is not known; perhaps sheen is meant."},
      {"lights", "secne", "--lights: 'secne' is not known; perhaps scene is meant."},
      {"lights", "all", "--lights: 'all' is not known; choose one of scene, none, demo."},
      {"brdf-compare", "diff", "--brdf-compare: 'diff' is not known; choose one of none, fit, split, difference."},
      {"brdf-split", "1.5", "--brdf-split: 1.5 is out of range; give a number from 0 to 1."},
      {"brdf-difference-scale", "-1", "--brdf-difference-scale: -1 is out of range; give a number from 0 to 1000."},
      {"occlusion", "1.01", "--occlusion: 1.01 is out of range; give a number from 0 to 1."},
      {"with", "a.glb;", "--with: 'a.glb;' names no model; give a file or builtin:NAME."},
      {"ground", "2", "--ground: '2' is neither; give true or false."},
      {"exposure", "1e999", "--exposure: 1e999 is out of range; give a number from -32 to 32."},
      {"exposure", "", "--exposure: '' is not a number; give a number from -32 to 32."},
      {"exposure", "+-1", "--exposure: '+-1' is not a number; give a number from -32 to 32."},
      {"tonemap", "filmic",
       "--tonemap: 'filmic' is not known; choose one of none, reinhard, reinhard-power, uncharted2, aces, agx, "
       "neutral."},
      {"tonemap", "ACES", "--tonemap: 'ACES' is not known; perhaps aces is meant."},
      {"max-error", "0", "--max-error: '0' is no error that a picture could keep to; give a share such as 0.01 or 1%."},
      {"max-error", "120%",
       "--max-error: '120%' is no error that a picture could keep to; give a share such as 0.01 or 1%."},
      {"samples", "0", "--samples: 0 is out of range; give a whole number from 1 to 4096."},
      {"channel", "normals", "--channel: 'normals' is not known; perhaps normal is meant."},
      {"range", "2,1", "--range: '2,1' is no range; give FROM,TO such as 0,2.5."},
      {"range", "0,1",
       "--range: nothing is shown in false colours; give --false-colors, or --channel depth or another quantity."},
      {"overlay", "grid,axis", "--overlay: 'axis' is not known; perhaps axes is meant."},
      {"overlay", "everything",
       "--overlay: 'everything' is not known; choose one of wireframe, bounds, axes, grid, skeleton, normals, lights, "
       "cameras, sun."},
      {"shader-dir", "", "--shader-dir: the value is empty; give a name or leave the option out."},
      {"exposrue", "1", "--exposrue: there is no such option; perhaps exposure is meant."},
  }));
  CAPTURE(row.name, row.text);
  const Result<PictureSettings> settings = fromArguments({{row.name, row.text}});
  REQUIRE_FALSE(settings);
  CHECK(describe(settings.error()) == row.message);
}

TEST_CASE("every option of the table has a row above: its parser refuses something") {
  for (const options::PictureOption& option : options::pictureOptions()) {
    PictureSettings settings;
    CAPTURE(option.name);
    CHECK_FALSE(option.parse("", settings));
    checkEqual(settings, PictureSettings());
  }
}

TEST_CASE("where several may be named, none is a word") {
  for (const char* name : {"overlay", "without"}) {
    CAPTURE(name);
    const Result<PictureSettings> none = fromArguments({{name, "none"}});
    REQUIRE(none);
    checkEqual(*none, PictureSettings());
    CHECK_FALSE(fromArguments({{name, "none,none"}}));
  }
}

TEST_CASE("a substance comes before what differs from it, in whatever order both are given") {
  const Result<PictureSettings> words = fromWords({"--material-metallic", "0.5", "--material", "gold"});
  const Result<PictureSettings> job = fromJson({{"material-metallic", 0.5}, {"material", "gold"}});
  for (const Result<PictureSettings>& settings : {words, job}) {
    REQUIRE(settings);
    CHECK(settings->look.material.metallic == 0.5f);
    CHECK(settings->look.material.preset == "gold");
    CHECK(options::commandLine(*settings, "a.glb") == "facet a.glb --material gold --material-metallic 0.5");
  }
  PictureSettings off = *words;
  off.look.material.on = false;
  CHECK(options::commandLine(off, "a.glb") == "facet a.glb");
}

TEST_CASE("a camera of the file excludes a place of one's own") {
  CHECK(describe(fromArguments({{"camera", "0"}, {"orbit", "0,90"}}).error()) ==
        "--orbit: the camera of the file has its own place; give either this or --camera.");
  CHECK(describe(fromArguments({{"camera", "0"}, {"target", "0,0,0"}}).error()) ==
        "--target: the camera of the file has its own place; give either this or --camera.");
  CHECK(fromArguments({{"camera", "0"}, {"fov-y", "20"}}));
  for (const auto& [name, text] :
       {std::pair("projection", "orthographic"), {"view-height", "2"}, {"up", "z"}, {"roll", "3"}})
    CHECK(describe(fromArguments({{"camera", "0"}, {name, text}}).error()) ==
          "--" + std::string(name) + ": the camera of the file has its own place; give either this or --camera.");
  CHECK(describe(fromArguments({{"orbit", "0,90,2"}, {"view-height", "3"}}).error()) ==
        "--view-height: the orbit's radius says how much is seen; give either this or THETA,PHI,RADIUS.");
  CHECK(fromArguments({{"orbit", "0,90"}, {"view-height", "3"}}));
}

TEST_CASE("what write gives, parse reads back") {
  const PictureSettings settings = unusual();
  PictureSettings read;
  for (const options::PictureOption& option : options::pictureOptions()) {
    const std::string text = option.write(settings);
    CAPTURE(option.name, text);
    if (option.name == "camera" || option.name == "view-height") continue;  // excluded by the orbit
    REQUIRE_FALSE(text.empty());
    CHECK(text != option.write(PictureSettings()));
    REQUIRE(option.parse(text, read));
    CHECK(option.write(read) == text);
  }
  CHECK(read.viewpoint.target == settings.viewpoint.target);
  CHECK(read.look.material == settings.look.material);
  CHECK(read.frame.backgroundColor == settings.frame.backgroundColor);
  CHECK(read.frame.environmentRotationDeg == settings.frame.environmentRotationDeg);
  CHECK(read.viewpoint.orbit->radius == settings.viewpoint.orbit->radius);
}

TEST_CASE("the command line names only what differs from the defaults") {
  CHECK(options::commandLine({}, "a.glb") == "facet a.glb");
  CHECK(options::commandLine({}, "") == "facet");
  CHECK(options::commandLine({}, "a b.glb", "o'c.png") == "facet render 'a b.glb' -o 'o'\\''c.png'");
  PictureSettings settings;
  settings.display.exposureStops = 1.5f, settings.frame.width = 640,
  settings.frame.background = frame::Background::transparent;
  CHECK(options::commandLine(settings, "a.glb") ==
        "facet a.glb --size 640x1024 --background transparent --exposure 1.5");
}

TEST_CASE("a command line goes through a shell and the parser and comes back the same") {
  PictureSettings settings = GENERATE(PictureSettings(), unusual());
  const bool ofTheFile = GENERATE(false, true);
  if (ofTheFile)
    settings.viewpoint = {.camera = "-- $(date) \"Kamera\" 1;2 `x`", .orbit = {}, .target = {}, .fovYDeg = 33.3};
  const std::string model = "dir with space/it's.glb";
  const std::string line = options::commandLine(settings, model);
  CAPTURE(line);
  REQUIRE(line.starts_with("facet "));
  const test::Outcome outcome = test::runShell("printf '%s\\n' " + line.substr(6));
  std::vector<std::string> words;
  std::istringstream stream(outcome.text);
  for (std::string word; std::getline(stream, word);) words.push_back(word);
  std::string readModel;
  const Result<PictureSettings> read = fromWords(words, &readModel);
  REQUIRE(read);
  CHECK(readModel == model);
  checkEqual(*read, settings);
  CHECK(options::commandLine(*read, readModel) == line);
}

TEST_CASE("negative values and equals signs pass through the command line") {
  const Result<PictureSettings> settings =
      fromWords({"--exposure", "-2", "--orbit=-25,75,0.4", "--target", "-1,-2,-3"});
  REQUIRE(settings);
  CHECK(settings->display.exposureStops == -2);
  CHECK(settings->viewpoint.orbit->thetaDeg == -25);
  CHECK(settings->viewpoint.target == glm::dvec3(-1, -2, -3));
}

TEST_CASE("JSON: numbers, arrays and texts mean the same") {
  const Result<PictureSettings> numbers = fromJson({{"model", 0},
                                                    {"size", {640, 480}},
                                                    {"orbit", {25, 75, 0.4}},
                                                    {"target", {0.5, 0, -1}},
                                                    {"exposure", -1.5},
                                                    {"samples", 8},
                                                    {"env-rotation", 30},
                                                    {"camera", "2"}});
  const Result<PictureSettings> texts = fromJson({{"size", "640x480"},
                                                  {"orbit", "25,75,0.4"},
                                                  {"target", "0.5,0,-1"},
                                                  {"exposure", "-1.5"},
                                                  {"samples", "8"},
                                                  {"env-rotation", "30"},
                                                  {"camera", 2}});
  REQUIRE(numbers);
  REQUIRE(texts);
  CHECK(numbers->frame.width == 640);
  CHECK(numbers->frame.height == 480);
  CHECK(numbers->viewpoint.orbit->radius == 0.4);
  CHECK(numbers->viewpoint.target == glm::dvec3(0.5, 0, -1));
  CHECK(numbers->display.exposureStops == -1.5f);
  CHECK(numbers->quality.samples == 8);
  CHECK(numbers->viewpoint.camera == "2");
  checkEqual(*numbers, *texts);
}

TEST_CASE("JSON: paths are taken below the folder, names are not") {
  CHECK(fromJson({{"env", "maps/a.hdr"}})->sources.environment == "folder/maps/a.hdr");
  CHECK(fromJson({{"env", "/maps/a.hdr"}})->sources.environment == "/maps/a.hdr");
  CHECK(fromJson({{"env", "builtin:sky"}})->sources.environment == "builtin:sky");
  CHECK(fromJson({{"env", "none"}})->sources.environment == "none");
  CHECK(fromJson({{"shader-dir", "s"}})->sources.shaderDir == "folder/s");
  CHECK(fromJson({{"with", {"a.glb", "builtin:furnace", "/b.glb"}}})->sources.with ==
        std::vector<std::string>{"folder/a.glb", "builtin:furnace", "/b.glb"});
  CHECK(fromJson({{"env", "a.hdr"}}, "")->sources.environment == "a.hdr");
}

TEST_CASE("JSON: an error leads with file and pointer") {
  const auto message = [](const json& object) { return describe(fromJson(object).error()); };
  CHECK(message({{"exposure", 99}}) ==
        "jobs.json: /jobs/2/exposure: 99 is out of range; give a number from -32 to 32.");
  CHECK(message({{"size", {1, 2, 3}}}) ==
        "jobs.json: /jobs/2/size: '1x2x3' is not a size; give WIDTHxHEIGHT such as 1280x720.");
  CHECK(message({{"samples", true}}) ==
        "jobs.json: /jobs/2/samples: a value of type boolean is no N; give a text, a number or an array of numbers.");
  CHECK(message({{"samples", nullptr}}) ==
        "jobs.json: /jobs/2/samples: a value of type null is no N; give a text, a number or an array of numbers.");
  CHECK(message({{"orbit", {25, "75", 1}}}) ==
        "jobs.json: /jobs/2/orbit: a value of type string is no THETA,PHI,RADIUS; give a text, a number or an array of "
        "numbers.");
  CHECK(message({{"orbit", json::array()}}) ==
        "jobs.json: /jobs/2/orbit: '' is not an orbit; give THETA,PHI or THETA,PHI,RADIUS such as 25,75,0.4.");
  CHECK(message({{"expo/sure~", 1}}) ==
        "jobs.json: /jobs/2/expo~1sure~0: there is no such option; perhaps exposure is meant.");
  CHECK(message({{"ouptut", "a.png"}}) ==
        "jobs.json: /jobs/2/ouptut: there is no such option; perhaps output is meant.");
  CHECK(message({{"samples", uint64_t{18446744073709551615u}}}) ==
        "jobs.json: /jobs/2/samples: 18446744073709551615 is out of range; give a whole number from 1 to 4096.");
}

TEST_CASE("every row of a choice is an option's word, comes back as it was given, and is in its help") {
  size_t choices = 0;
  for (const options::PictureOption& option : options::pictureOptions()) {
    if (!option.choices) continue;
    ++choices;
    const std::string listed = option.choices(), words = listed.substr(0, listed.find(';'));
    size_t rows = 0;
    for (size_t start = 0; start < words.size(); ++rows) {
      const size_t end = std::min(words.find(", ", start), words.size());
      const std::string word = words.substr(start, end - start);
      start = end + 2;
      INFO(option.name << " " << word);
      PictureSettings settings;
      settings.sources.brdf = "gold";  // without which nothing is compared
      REQUIRE(option.parse(word, settings));
      const std::string written = option.write(settings);
      CHECK((written == word || (written.empty() && word == "none")));
    }
    CHECK(rows >= 2);
    PictureSettings settings;
    const Result<void> wrong = option.parse("nonsense", settings);
    REQUIRE_FALSE(wrong);
    CHECK(wrong.error().problem == "'nonsense' is not known");
  }
  CHECK(choices == 21);
}
