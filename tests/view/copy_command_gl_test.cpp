#include <catch2/catch.hpp>

#include "io/image.hpp"
#include "io/utia.hpp"
#include "optics/synthetic_brdf.hpp"
#include "scene/usage.hpp"
#include "support/picture.hpp"
#include "support/temporary_folder.hpp"
#include "view/camera_control.hpp"
#include "view/copied_command.hpp"
#include "view/inspector.hpp"
#include "view/viewer.hpp"

using namespace facet;

namespace {

// A triangle that rises by 1 m in a second, seen by a camera "gate" of its own and, from the side, by an orthographic
// one, in brass or, as variant "sea", in blue.
std::vector<uint8_t> risingTriangle() {
  test::GltfBuilder b = test::triangle();
  const std::vector<float> normals = {0, 0, 1, 0, 0, 1, 0, 0, 1}, times = {0, 1}, heights = {0, 0, 0, 0, 1, 0};
  nlohmann::json& primitive = b.json["meshes"][0]["primitives"][0];
  primitive["attributes"]["NORMAL"] = b.add(normals, test::floatType, "VEC3");
  primitive["material"] = 0;
  primitive["extensions"]["KHR_materials_variants"]["mappings"] = {{{"material", 1}, {"variants", {0}}}};
  b.append("materials",
           {{"doubleSided", true},
            {"pbrMetallicRoughness", {{"baseColorFactor", {0.9, 0.6, 0.2, 1}}, {"roughnessFactor", 0.3}}}});
  b.append("materials", {{"doubleSided", true},
                         {"pbrMetallicRoughness", {{"baseColorFactor", {0.1, 0.2, 0.8, 1}}, {"metallicFactor", 0}}}});
  b.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "sea"}}};
  b.json["extensionsUsed"] = {"KHR_materials_variants"};
  b.append("cameras", {{"name", "gate"}, {"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}});
  b.append("cameras",
           {{"type", "orthographic"}, {"orthographic", {{"xmag", 1.1}, {"ymag", 1.3}, {"znear", 0.1}, {"zfar", 9}}}});
  for (int camera = 0; camera < 2; ++camera) {
    const int node = b.append("nodes", {{"camera", camera}, {"translation", {0.3 + 0.1 * camera, 0.6, 3}}});
    b.json["scenes"][0]["nodes"].push_back(node);
  }
  b.append(
      "animations",
      {{"name", "rise"},
       {"samplers",
        {{{"input", b.add(times, test::floatType, "SCALAR")}, {"output", b.add(heights, test::floatType, "VEC3")}}}},
       {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}});
  return b.glb();
}

// Six textured, bumpy balls, each below a turned and stretched node of its own; the last of another material, where
// there are several.
std::vector<uint8_t> texturedBalls(const nlohmann::json& last) {
  test::GltfBuilder b = test::emptyScene();
  std::vector<uint8_t> texels;
  for (uint32_t i = 0; i < 32 * 32 * 3; ++i) texels.push_back(static_cast<uint8_t>((i * 2654435761u) >> 24));
  std::vector<uint8_t> normals = texels;
  for (size_t i = 0; i < normals.size(); ++i)
    normals[i] = i % 3 == 2 ? uint8_t{255} : static_cast<uint8_t>(96 + normals[i] / 4);
  for (const auto& data : {texels, normals}) {
    b.append("images", {{"uri", test::dataUri(test::pngBytes(32, 32, 3, 8, data), "image/png")}});
    b.append("textures", {{"source", b.json["images"].size() - 1}});
  }
  nlohmann::json material = test::material({1, 1, 1, 1}, 0.5, 0.3);
  material["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 0;
  material["normalTexture"]["index"] = 1;
  b.append("materials", material);
  material.merge_patch(last);
  b.append("materials", material);
  nlohmann::json ball = test::addSphere(b, 0.5, 12, 24);
  std::vector<float> uv;
  for (int y = 0; y <= 12; ++y)
    for (int x = 0; x <= 24; ++x) uv.push_back(static_cast<float>(x) / 8), uv.push_back(static_cast<float>(y) / 4);
  REQUIRE(b.json["accessors"][ball["attributes"]["POSITION"].get<size_t>()]["count"] == uv.size() / 2);
  ball["attributes"]["TEXCOORD_0"] = b.add(uv, test::floatType, "VEC2");
  for (int i = 0; i < 6; ++i) {
    test::addMeshNode(b, ball, i < 5 ? 0 : 1, {{"rotation", {0.48, 0.6, 0, 0.64}}, {"scale", {1, 1.3, 0.7}}});
    const nlohmann::json child = b.json["scenes"][0]["nodes"].back();
    b.json["scenes"][0]["nodes"].back() = b.append(
        "nodes",
        {{"translation", {i % 3 - 1.1, i / 3 - 0.4, 0.3 * i}}, {"rotation", {0, 0.6, 0.8, 0}}, {"children", {child}}});
  }
  return b.glb();
}

struct Case {
  const char* name;
  void (*set)(view::ViewerState&);
};

}  // namespace

// So large that few samples of it are drawn in bands.
TEST_CASE("copied command: its bytes in a large picture, too, of textures below turned nodes", "[gl]") {
  const nlohmann::json same = nlohmann::json::object();
  const nlohmann::json glass = {{"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 1}}}}}};
  const nlohmann::json veil = {{"alphaMode", "BLEND"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0.5}}}}};
  struct Large {
    nlohmann::json last;
    const char* channel;
    int samples;
  };
  const Large c = GENERATE_COPY(values<Large>({{same, "", 4},
                                               {same, "", 9},
                                               {same, "uv", 2},
                                               {same, "geometryNormal", 4},
                                               {same, "depth", 4},
                                               {veil, "environmentSpecular", 4},
                                               {veil, "", 4},
                                               {veil, "", 5},
                                               {glass, "", 4},
                                               {glass, "", 5}}));
  INFO(c.last << ", channel '" << c.channel << "', " << c.samples << " samples");
  const test::TemporaryFolder folder;
  test::Viewer viewer;
  frame::PictureSettings& settings = viewer.state.settings;
  settings.frame.width = 640, settings.frame.height = 480;
  settings.quality.samples = c.samples;
  settings.look.channel = c.channel;
  settings.sources.environment = "builtin:sky";
  viewer.load(folder.write("balls.glb", texturedBalls(c.last)));
  viewer.converge();
  REQUIRE_FALSE(viewer.state.status.isError);
  test::checkCopiedCommand(viewer, folder);
}

TEST_CASE("copied command: gives the bytes of the picture on the screen", "[gl]") {
  const Case c = GENERATE(values<Case>({
      {"orbit", [](view::ViewerState& s) { s.camera.theta = 33.25, s.camera.phi = 71, s.camera.radius = 2.7182818; }},
      {"file camera", [](view::ViewerState& s) { s.settings.viewpoint.camera = "gate"; }},
      {"floor", [](view::ViewerState& s) { s.settings.frame.ground = true, s.camera.phi = 50; }},
      {"a blurred background",
       [](view::ViewerState& s) {
         s.settings.frame.backgroundBlur = 0.37f, s.settings.sources.environment = "builtin:sky";
         s.settings.frame.environmentRotationDeg = 70;
       }},
      {"a blurred background, path traced",
       [](view::ViewerState& s) {
         s.settings.frame.backgroundBlur = 0.08f, s.settings.sources.environment = "builtin:sky";
         s.settings.quality.samples = 6, s.settings.quality.transport = frame::Transport::paths;
       }},
      {"overlays",
       [](view::ViewerState& s) {
         s.overlaysInPictures = true;
         s.settings.overlays.shown = (1u << std::size(frame::overlayChoices)) - 1;
         s.settings.placement.animation = "rise", s.settings.placement.timeSeconds = 0.4;
         s.settings.look.lights = frame::Lights::demo, s.camera.theta = 33;
       }},
      {"overlays that are not for pictures, path traced",
       [](view::ViewerState& s) {
         s.settings.overlays.shown = frame::Overlays::bitOf(frame::Overlay::grid);
         s.settings.quality.samples = 6, s.settings.quality.transport = frame::Transport::paths;
       }},
      {"without a layer",
       [](view::ViewerState& s) { s.settings.look.without = scene::bitOf(scene::Effect::dielectricSpecular); }},
      {"floor, refined", [](view::ViewerState& s) { s.settings.frame.ground = true, s.settings.quality.samples = 20; }},
      {"orthographic", [](view::ViewerState& s) { s.settings.viewpoint.camera = "1"; }},
      {"orthographic orbit, on its side, another axis up",
       [](view::ViewerState& s) {
         s.camera.orthographic = true, s.camera.roll = 33.3, s.camera.up = {0.1, 0.2, 1}, s.camera.radius = 1.7;
       }},
      {"orthographic, floor, overlays",
       [](view::ViewerState& s) {
         s.camera.orthographic = true, s.camera.phi = 50, s.settings.frame.ground = true, s.overlaysInPictures = true;
         s.settings.overlays.shown = frame::Overlays::bitOf(frame::Overlay::grid);
         s.settings.look.lights = frame::Lights::demo;
       }},
      {"orthographic, refined",
       [](view::ViewerState& s) {
         s.camera.orthographic = true, s.settings.quality.samples = 20, s.settings.sources.environment = "builtin:sky";
         s.settings.look.lights = frame::Lights::demo;
       }},
      {"orthographic, an error to keep to",
       [](view::ViewerState& s) {
         s.camera.orthographic = true, s.settings.quality.maxError = 0.05, s.settings.quality.samples = 64;
       }},
      {"orthographic, measured",
       [](view::ViewerState& s) {
         view::chooseBrdf(s, "builtin:ggx-0.35");
         s.camera.orthographic = true, s.camera.roll = -90, s.settings.quality.samples = 6;
       }},
      {"file camera, time",
       [](view::ViewerState& s) {
         s.settings.viewpoint.camera = "gate", s.settings.placement.animation = "rise",
         s.settings.placement.timeSeconds = 0.4375;
       }},
      {"orbit, time",
       [](view::ViewerState& s) {
         s.settings.placement.animation = "all", s.settings.placement.timeSeconds = 1.0 / 3;
         s.camera.target = {0.1, 0.2, 0.3}, s.camera.fovY = 31.4;
       }},
      {"variant",
       [](view::ViewerState& s) { s.settings.look.variant = "sea", s.settings.display.exposureStops = 1.3f; }},
      {"normal", [](view::ViewerState& s) { s.settings.look.channel = "normal"; }},
      {"roughness",
       [](view::ViewerState& s) { s.settings.look.channel = "roughness", s.settings.sources.environment = "none"; }},
      {"uv, which is not there", [](view::ViewerState& s) { s.settings.look.channel = "uv"; }},
      {"depth, a range, refined",
       [](view::ViewerState& s) {
         s.settings.look.channel = "depth", s.settings.display.range = glm::dvec2(1, 3.75);
         s.settings.quality.samples = 6;
       }},
      {"a part of the light",
       [](view::ViewerState& s) {
         s.settings.look.channel = "environmentDiffuse", s.settings.look.variant = "sea";  // else all is metal
       }},
      {"a part of the light, refined",
       [](view::ViewerState& s) {
         s.settings.look.channel = "lightsSpecular", s.settings.look.lights = frame::Lights::demo;
         s.settings.quality.samples = 6;
       }},
      {"from behind",
       [](view::ViewerState& s) {
         s.camera = view::seenFrom(s.camera, view::ViewFrom::back);
         s.settings.look.lights = frame::Lights::demo, s.settings.display.toneMapper = frame::ToneMapper::agx;
       }},
      {"measured, MERL", [](view::ViewerState& s) { view::chooseBrdf(s, "builtin:ggx-0.35"); }},
      {"measured, UTIA, nearest, converged",
       [](view::ViewerState& s) {
         view::chooseBrdf(s, "builtin:utia-brushed");
         s.settings.look.brdfLookUp = optics::LookUp::nearest, s.settings.quality.samples = 6, s.camera.theta = 21;
       }},
      {"measured, split",
       [](view::ViewerState& s) {
         view::chooseBrdf(s, "builtin:utia-satin");
         s.settings.comparison.brdfCompare = frame::BrdfCompare::split, s.settings.comparison.brdfSplit = 0.4375f;
       }},
      {"measured, difference, converged",
       [](view::ViewerState& s) {
         view::chooseBrdf(s, "builtin:utia-brushed");
         s.settings.comparison.brdfCompare = frame::BrdfCompare::difference,
         s.settings.comparison.brdfDifferenceScale = 17;
         s.settings.look.models.diffuse = optics::DiffuseModel::burley, s.settings.quality.samples = 6;
       }},
      {"fitted",
       [](view::ViewerState& s) {
         view::chooseBrdf(s, "builtin:utia-brushed");
         s.settings.comparison.brdfCompare = frame::BrdfCompare::fit,
         s.settings.look.models.diffuse = optics::DiffuseModel::eon;
       }},
      {"measured, from a folder, decoded",
       [](view::ViewerState& s) {
         view::chooseBrdf(s, "satin");
         s.settings.sources.brdfDir = s.shown.model.substr(0, s.shown.model.rfind('/'));
         s.settings.sources.utiaDecode = io::UtiaDecode::srgb, s.settings.sources.environment = "builtin:sky";
       }},
      {"converged, selected", [](view::ViewerState& s) { s.settings.quality.samples = 6, s.selection.node = 0; }},
  }));
  INFO(c.name);
  const test::TemporaryFolder folder;
  test::Viewer viewer;
  const optics::SyntheticBrdf& satin = *optics::findSynthetic("utia-satin");
  folder.write("satin.bin", io::encodeUtia(optics::makeMeasured(satin.formula, satin.kind, satin.name)));
  viewer.load(folder.write("rise.glb", risingTriangle()));
  c.set(viewer.state);
  viewer.settle();
  viewer.converge();
  view::updateOutline(viewer.viewport, viewer.state, 2);
  view::updateOverlay(viewer.viewport, viewer.state);
  REQUIRE_FALSE(viewer.state.status.isError);
  test::checkCopiedCommand(viewer, folder);
}
