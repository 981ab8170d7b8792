#include <catch2/catch.hpp>

#include "support/gltf_builder.hpp"
#include "support/temporary_folder.hpp"
#include "view/inspector.hpp"
#include "view/viewer.hpp"

using namespace facet;

namespace {

// Two unit squares, facing +Z: node 0 "near" at z = 1 in x 0 .. 1, whose left half a mask leaves out, node 1 "far" at
// z = 0 twice as large, metallic 0.25, roughness 0.5.
std::vector<uint8_t> squares() {
  test::GltfBuilder b;
  const std::vector<float> positions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, uv = {0, 1, 1, 1, 1, 0, 0, 0};
  const std::vector<float> normals = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
  const std::vector<uint16_t> indices = {0, 1, 2, 0, 2, 3};
  const nlohmann::json attributes = {{"POSITION", b.add(positions, test::floatType, "VEC3")},
                                     {"NORMAL", b.add(normals, test::floatType, "VEC3")},
                                     {"TEXCOORD_0", b.add(uv, test::floatType, "VEC2")}};
  b.json["accessors"][0]["min"] = {0, 0, 0};
  b.json["accessors"][0]["max"] = {1, 1, 0};
  const int index = b.add(indices, test::ushortType, "SCALAR");
  const std::vector<uint8_t> texels = {255, 0, 0, 0, 0, 255, 0, 255};  // red that is left out, green
  b.append("images", {{"uri", test::dataUri(test::pngBytes(2, 1, 4, 8, texels), "image/png")}});
  b.append("samplers", {{"magFilter", 9728}, {"minFilter", 9728}});
  b.append("textures", {{"source", 0}, {"sampler", 0}});
  b.append(
      "materials",
      {{"name", "holes"}, {"alphaMode", "MASK"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  b.append("materials",
           {{"name", "plain"},
            {"emissiveFactor", {0.5, 0.25, 0.125}},
            {"pbrMetallicRoughness",
             {{"baseColorFactor", {0.1, 0.2, 0.3, 1}}, {"metallicFactor", 0.25}, {"roughnessFactor", 0.5}}}});
  for (int material = 0; material < 2; ++material)
    b.append("meshes", {{"primitives", {{{"attributes", attributes}, {"indices", index}, {"material", material}}}}});
  b.append("nodes", {{"name", "near"}, {"mesh", 0}, {"translation", {0, 0, 1}}});
  b.append("nodes", {{"name", "far"}, {"mesh", 1}, {"translation", {-0.5, -0.5, 0}}, {"scale", {2, 2, 1}}});
  b.append("scenes", {{"nodes", {0, 1}}});
  b.json["scene"] = 0;
  return b.glb();
}

struct Clicker : test::Viewer {
  explicit Clicker(const test::TemporaryFolder& folder) {
    state.settings.sources.environment = "builtin:white";
    load(folder.write("squares.glb", squares()));
    state.camera = {0, 90, 4, {0.5, 0.5, 0}, 45};
    view::drawViewport(viewport, state);
  }
  // Where the world point is seen, in a window of twice the picture's size.
  void clickOn(const glm::dvec3& world) {
    const glm::dvec4 clip = view::currentView(viewport, state)->clipFromWorld * glm::dvec4(world, 1);
    const glm::dvec2 size(2 * state.settings.frame.width, 2 * state.settings.frame.height);
    view::clickAt(viewport, state, (glm::dvec2(clip.x, -clip.y) / clip.w * 0.5 + 0.5) * size, size);
    while (view::inspectNext(viewport, state)) {
    }
  }
  std::optional<glm::vec3> value(const char* channel) const {
    return state.inspection.values[static_cast<size_t>(shading::channelIndex(channel))];
  }
};

void checkNear(const std::optional<glm::vec3>& value, const glm::vec3& expected, float tolerance) {
  REQUIRE(value);
  INFO(value->x << " " << value->y << " " << value->z);
  CHECK(glm::distance(*value, expected) < tolerance);
}

}  // namespace

TEST_CASE("inspector: a click selects what is drawn there, through what a mask leaves out", "[gl]") {
  const test::TemporaryFolder folder;
  Clicker viewer(folder);
  viewer.clickOn({0.75, 0.5, 1});
  CHECK(viewer.state.selection.node == 0);
  CHECK(viewer.state.inspection.materialName == "holes");
  checkNear(viewer.value("baseColor"), {0, 1, 0}, 1e-5f);
  viewer.clickOn({0.25, 0.5, 1});
  CHECK(viewer.state.selection.node == 1);
  viewer.clickOn({3, 0.5, 0});
  CHECK(viewer.state.selection.node == -1);
  CHECK_FALSE(viewer.state.inspection.on);
  viewer.state.camera.theta = 180;  // the back faces are not drawn
  view::drawViewport(viewer.viewport, viewer.state);
  viewer.clickOn({0.75, 0.5, 1});
  CHECK(viewer.state.selection.node == -1);
}

TEST_CASE("inspector: the values are the shaders' own, in single precision, and change no picture", "[gl]") {
  const test::TemporaryFolder folder;
  Clicker viewer(folder);
  const std::vector<uint8_t> before = viewer.display().data;
  viewer.clickOn({-0.25, 0.75, 0});
  const view::Inspection& found = viewer.state.inspection;
  REQUIRE(found.on);
  CHECK(found.materialName == "plain");
  // Half a pixel of 48 rows that show 3.3 m.
  CHECK(glm::distance(found.hit.position, {-0.25, 0.75, 0}) < 0.07);
  CHECK(std::abs(found.hit.position.z) < 1e-12);
  REQUIRE(found.uv);
  CHECK(found.uv->x == Approx((found.hit.position.x + 0.5) / 2).epsilon(1e-5));
  checkNear(viewer.value("baseColor"), {0.1f, 0.2f, 0.3f}, 1e-6f);
  checkNear(viewer.value("metallic"), glm::vec3(0.25f), 1e-6f);
  checkNear(viewer.value("roughness"), glm::vec3(0.5f), 1e-6f);
  checkNear(viewer.value("emissive"), {0.5f, 0.25f, 0.125f}, 1e-6f);
  checkNear(viewer.value("normal"), {0, 0, 1}, 1e-6f);
  CHECK_FALSE(viewer.value("occlusion"));  // there is none
  CHECK_FALSE(viewer.value("tangent"));
  // The radiance is the picture's.
  const io::RadianceImage picture = frame::readRadiance(viewer.viewport.targets);
  const auto at = static_cast<size_t>((picture.height - 1 - found.pixel.y) * picture.width + found.pixel.x);
  checkNear(found.radiance, glm::vec3(picture.pixels[at]), 1e-6f);

  CHECK_FALSE(view::drawViewport(viewer.viewport, viewer.state));  // nothing has changed
  CHECK(viewer.display().data == before);
  viewer.viewport.drawn.reset();
  CHECK(view::drawViewport(viewer.viewport, viewer.state));
  CHECK(viewer.display().data == before);
}

TEST_CASE("inspector: the selection's bounds are those of the node and all below it", "[gl]") {
  const test::TemporaryFolder folder;
  Clicker viewer(folder);
  CHECK(view::selectionBounds(viewer.viewport, viewer.state).empty());
  view::selectNode(viewer.state, 1);
  const scene::Bounds bounds = view::selectionBounds(viewer.viewport, viewer.state);
  CHECK(bounds.min == glm::dvec3(-0.5, -0.5, 0));
  CHECK(bounds.max == glm::dvec3(1.5, 1.5, 0));
  const std::vector<view::Detail> details = view::materialDetails(viewer.viewport, 0);
  const auto texture = std::ranges::find(details, std::string("baseColorTexture"), &view::Detail::name);
  REQUIRE(texture != details.end());
  CHECK(texture->value.find("2 x 1 sRGB8 + A8") != std::string::npos);
}

TEST_CASE("inspector: the outline runs around the selection, beside the picture", "[gl]") {
  const test::TemporaryFolder folder;
  Clicker viewer(folder);
  const std::vector<uint8_t> before = viewer.display().data;
  CHECK_FALSE(view::updateOutline(viewer.viewport, viewer.state, 1));
  view::selectNode(viewer.state, 1);
  CHECK(view::updateOutline(viewer.viewport, viewer.state, 1));
  CHECK_FALSE(view::updateOutline(viewer.viewport, viewer.state, 1));
  REQUIRE(viewer.viewport.outline.shown);
  const int width = viewer.state.settings.frame.width, height = viewer.state.settings.frame.height;
  std::vector<uint8_t> line(static_cast<size_t>(width * height) * 4);
  glGetTextureImage(viewer.viewport.outline.line.id(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(line.size()),
                    line.data());
  const auto alpha = [&](const glm::dvec3& world, int right) {
    const glm::dvec4 clip = view::currentView(viewer.viewport, viewer.state)->clipFromWorld * glm::dvec4(world, 1);
    const glm::dvec2 p = (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(width, height);
    return line[static_cast<size_t>((static_cast<int>(p.y) * width + static_cast<int>(p.x) + right) * 4 + 3)];
  };
  CHECK(alpha({0.5, 0.5, 0}, 0) == 0);   // within
  CHECK(alpha({1.5, 0.5, 0}, 1) > 128);  // at the right edge
  CHECK(alpha({1.5, 0.5, 0}, 8) == 0);   // far from it
  CHECK(viewer.display().data == before);
  view::selectNode(viewer.state, -1);
  CHECK(view::updateOutline(viewer.viewport, viewer.state, 1));
  CHECK_FALSE(viewer.viewport.outline.shown);
}

TEST_CASE("inspector: a click near a line or a point selects its node, with the values of its material", "[gl]") {
  // A red line "line" along x at z = 0.5, a blue point "point" above it, and a square "wall" that lies behind the
  // right half of the line and hides nothing but a line "hidden" behind it.
  test::GltfBuilder b;
  const auto vec3 = [&](const std::vector<float>& numbers) { return b.add(numbers, test::floatType, "VEC3"); };
  const auto node = [&](const char* name, int mode, const std::vector<float>& positions,
                        const std::vector<float>& color) {
    const int material = b.append("materials", {{"name", std::string(name) + "'s"},
                                                {"doubleSided", true},
                                                {"pbrMetallicRoughness", {{"baseColorFactor", color}}}});
    const int mesh = b.append(
        "meshes",
        {{"primitives", {{{"attributes", {{"POSITION", vec3(positions)}}}, {"mode", mode}, {"material", material}}}}});
    return b.append("nodes", {{"name", name}, {"mesh", mesh}});
  };
  const int line = node("line", 1, {-1, 0, 0.5, 1, 0, 0.5}, {1, 0, 0, 1});
  const int point = node("point", 0, {0, 0.5, 0.5}, {0, 0, 1, 1});
  const int wall = node("wall", 5, {0.1f, -1, 0, 1, -1, 0, 0.1f, 1, 0, 1, 1, 0}, {0, 1, 0, 1});
  const int hidden = node("hidden", 1, {-1, -0.5, -0.5, 1, -0.5, -0.5}, {1, 1, 0, 1});
  b.append("scenes", {{"nodes", {line, point, wall, hidden}}});
  b.json["scene"] = 0;
  const test::TemporaryFolder folder;
  test::Viewer viewer;
  viewer.state.settings.frame.width = 200, viewer.state.settings.frame.height = 100;
  viewer.state.settings.sources.environment = "builtin:white";
  viewer.load(folder.write("thin.glb", b.glb()));
  viewer.state.camera = {0, 90, 4, {0, 0, 0}, 45};
  view::drawViewport(viewer.viewport, viewer.state);
  const glm::dvec2 size(200, 100);
  // So many pixels above the place where the world point is seen.
  const auto clickAbove = [&](const glm::dvec3& world, double pixels) {
    const glm::dvec4 clip = view::currentView(viewer.viewport, viewer.state)->clipFromWorld * glm::dvec4(world, 1);
    const glm::dvec2 at = (glm::dvec2(clip.x, -clip.y) / clip.w * 0.5 + 0.5) * size;
    view::clickAt(viewer.viewport, viewer.state, at - glm::dvec2(0, pixels), size);
    while (view::inspectNext(viewer.viewport, viewer.state)) {
    }
    return viewer.state.selection.node;
  };
  const view::Inspection& at = viewer.state.inspection;
  const auto value = [&](const char* channel) {
    return at.values[static_cast<size_t>(shading::channelIndex(channel))].value_or(glm::vec3(-1));
  };
  CHECK(clickAbove({-0.5, 0, 0.5}, 3) == line);
  CHECK(at.materialName == "line's");
  CHECK(at.hit.position.x == Approx(-0.5).margin(0.02));
  CHECK(at.hit.position.y == Approx(0).margin(1e-6));
  CHECK(value("baseColor") == glm::vec3(1, 0, 0));
  CHECK(value("roughness").x == 1);
  CHECK(clickAbove({-0.5, 0, 0.5}, 6) == -1);
  CHECK_FALSE(at.on);

  CHECK(clickAbove({0, 0.5, 0.5}, 2) == point);
  CHECK(at.materialName == "point's");
  CHECK(value("baseColor") == glm::vec3(0, 0, 1));
  CHECK(clickAbove({0, 0.5, 0.5}, -6) == -1);

  CHECK(clickAbove({0.6, 0, 0.5}, 2) == line);  // before the wall
  CHECK(clickAbove({0.6, 0, 0.5}, 8) == wall);
  CHECK(clickAbove({0.6, -0.5, -0.5}, 0) == wall);  // before the line
  CHECK(clickAbove({-0.6, -0.5, -0.5}, 0) == hidden);
}
