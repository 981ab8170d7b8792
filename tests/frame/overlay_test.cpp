#include <catch2/catch.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <set>

#include "frame/choose.hpp"
#include "frame/overlay_lines.hpp"
#include "frame/settings.hpp"
#include "optics/color.hpp"
#include "scene/deformation.hpp"
#include "support/gltf_load.hpp"
#include "support/picture.hpp"

using namespace facet;
using frame::Overlay;

namespace {

frame::Overlays only(Overlay overlay) { return {frame::Overlays::bitOf(overlay)}; }

frame::OverlayLines linesOf(const scene::Model& model, const frame::DrawList& list, Overlay overlay,
                            const frame::Placement& placement = {}) {
  return *frame::overlayLines({model, list, 0, {}, 0, 1}, placement, only(overlay));
}

double lengthOf(const frame::OverlayLine& line) { return double{glm::length(line.to - line.from)}; }

}  // namespace

TEST_CASE("A grid's spacing is 1, 2 or 5 times a power of ten, at any size") {
  CHECK(frame::gridSpacing(20) == Approx(1));
  CHECK(frame::gridSpacing(21) == Approx(2));
  CHECK(frame::gridSpacing(41) == Approx(5));
  CHECK(frame::gridSpacing(101) == Approx(10));
  CHECK(frame::gridSpacing(2e-5) == Approx(1e-6));
  CHECK(frame::gridSpacing(3.9e7) == Approx(2e6));
}

TEST_CASE("Overlays: a scene of a micrometre and one of a thousand kilometres have the same lines") {
  std::vector<frame::OverlayLines> grids, axes, boxes;
  for (const double size : {1e-6, 1.0, 1e6}) {
    test::GltfBuilder builder = test::emptyScene();
    test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {1, 1}),
                      builder.append("materials", test::unlit({1, 1, 1, 1})), {{"scale", {size, size, size}}});
    const io::LoadedModel model = test::loadBuilt(builder);
    const frame::DrawList list = frame::buildDrawList(model.model, 0, {});
    grids.push_back(linesOf(model.model, list, Overlay::grid));
    axes.push_back(linesOf(model.model, list, Overlay::axes));
    boxes.push_back(linesOf(model.model, list, Overlay::bounds));
    CHECK(*grids.back().gridSpacing / size == Approx(0.5));  // 4 radii of 1.41 m
    CHECK(lengthOf(axes.back().lines[0]) / size == Approx(1.2 * std::sqrt(2.0)));
    CHECK(lengthOf(boxes.back().lines[0]) / size == Approx(2));
  }
  for (const auto* lines : {&grids, &axes, &boxes})
    for (const frame::OverlayLines& of : *lines) {
      REQUIRE(of.lines.size() == lines->front().lines.size());
      CHECK(of.lines.size() > 12);
    }
}

TEST_CASE("Overlays: what is farther away than a grid can count has none to speak of") {
  test::GltfBuilder builder = test::emptyScene();
  test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {1, 1}),
                    builder.append("materials", test::unlit({1, 1, 1, 1})), {{"translation", {1e17, 0, -1e17}}});
  const io::LoadedModel model = test::loadBuilt(builder);
  const frame::DrawList list = frame::buildDrawList(model.model, 0, {});
  CHECK(linesOf(model.model, list, Overlay::grid).lines.size() <= 100);
}

TEST_CASE("Overlays: edges are those of places, and what is not there or too much is told") {
  test::GltfBuilder builder = test::emptyScene();
  // Two triangles without indices: the diagonal's ends are two vertices each. And one of no extent.
  const int position =
      builder.add(std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0},
                  test::floatType, "VEC3");
  test::addMeshNode(builder, {{"attributes", {{"POSITION", position}}}},
                    builder.append("materials", test::unlit({1, 1, 1, 1})));
  const io::LoadedModel model = test::loadBuilt(builder);
  const frame::DrawList list = frame::buildDrawList(model.model, 0, {});
  CHECK(linesOf(model.model, list, Overlay::wireframe).lines.size() == 5);
  CHECK(linesOf(model.model, list, Overlay::wireframe).remark.empty());
  for (const Overlay absent : {Overlay::skeleton, Overlay::lights, Overlay::cameras, Overlay::sun})
    CHECK(linesOf(model.model, list, absent).remark.starts_with("there is nothing to show of: "));
  const io::LoadedModel crowd = test::loadBuiltin("builtin:crowd");
  const frame::OverlayLines many = linesOf(crowd.model, frame::buildDrawList(crowd.model, 0, {}), Overlay::wireframe);
  CHECK(many.lines.empty());
  CHECK(many.remark == "not shown, having more than 2796202 lines: wireframe");
}

TEST_CASE("Overlays: each edge once where instances are, and normals as long everywhere") {
  test::GltfBuilder builder = test::emptyScene();
  test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {1, 1}),
                    builder.append("materials", test::material({1, 1, 1, 1})));
  test::addMeshNode(builder, builder.json["meshes"][0]["primitives"][0], 0, {{"translation", {5, 0, 0}}});
  const io::LoadedModel model = test::loadBuilt(builder);
  const frame::DrawList list = frame::buildDrawList(model.model, 0, {});
  const frame::OverlayLines wire = linesOf(model.model, list, Overlay::wireframe);
  CHECK(wire.lines.size() == 2 * 5);
  double right = 0;
  for (const frame::OverlayLine& line : wire.lines) right = std::max(right, double{line.to.x} + list.origin.x);
  CHECK(right == Approx(6));
  const frame::OverlayLines normals = linesOf(model.model, list, Overlay::normals);
  CHECK(normals.lines.size() == 8);
  CHECK(normals.remark.empty());
  for (const frame::OverlayLine& line : normals.lines) {
    CHECK(lengthOf(line) == Approx(0.03 * list.bounds.radius()));
    CHECK(line.to.z > line.from.z);
  }
}

TEST_CASE("Overlays: a skeleton is where the animation puts its joints, a light has its range, a camera its lens") {
  test::GltfBuilder b = test::triangle();
  b.json["nodes"] = {{{"mesh", 0}, {"skin", 0}},
                     {{"translation", {1, 0, 0}}, {"children", {2}}},
                     {{"translation", {0, 2, 0}}},
                     {{"camera", 0}, {"translation", {0, 0, 9}}}};
  b.json["scenes"][0]["nodes"] = {0, 1, 3};
  b.json["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}, {"aspectRatio", 2.0}}}}};
  const std::vector<uint8_t> joints = {0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0};
  const std::vector<float> weights = {1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0};
  nlohmann::json& attributes = b.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] = b.add(joints, test::ubyteType, "VEC4");
  attributes["WEIGHTS_0"] = b.add(weights, test::floatType, "VEC4");
  b.json["skins"] = {{{"joints", {1, 2}}}};
  const std::vector<float> times = {0, 1}, moves = {1, 0, 0, 4, 0, 0};
  const int input = b.add(times, test::floatType, "SCALAR"), output = b.add(moves, test::floatType, "VEC3");
  b.json["animations"] = {{{"name", "go"},
                           {"samplers", {{{"input", input}, {"output", output}}}},
                           {"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}}}}};
  io::LoadedModel model = test::loadBuilt(b);
  // The first joint is 1 m to the right at rest, the second 2 m above it.
  model.model.skins[0].inverseBindMatrices = {glm::translate(glm::dmat4(1), {-1, 0, 0}),
                                              glm::translate(glm::dmat4(1), {-1, -2, 0})};
  for (const double time : {0.0, 0.5}) {
    const frame::Placement placement{.scene = -1, .animation = "go", .timeSeconds = time, .arrangement = {}};
    const frame::DrawList list = frame::buildDrawList(model.model, 0, {}, *frame::choosePose(placement, model.model));
    const frame::OverlayLines skeleton = linesOf(model.model, list, Overlay::skeleton, placement);
    REQUIRE(skeleton.lines.size() == 3);  // a bone and two joints
    // What each joint moves: the edges of its vertices by its share, before the skeleton; the mesh's node moves none.
    for (const auto& [joint, shares] :
         std::map<int, std::vector<double>>{{1, {0.5, 1, 0.5}}, {2, {0.5, 0.5}}, {0, {}}}) {
      const frame::OverlayLines moved =
          *frame::overlayLines({model.model, list, 0, {}, 0, 1, joint}, placement, only(Overlay::skeleton));
      REQUIRE(moved.lines.size() == 3 + shares.size());
      std::vector<double> found;
      for (size_t i = 0; i < shares.size(); ++i)
        for (const double share : {0.5, 1.0})
          if (glm::distance(glm::dvec3(moved.lines[i].color), optics::falseColor(share)) < 1e-6) found.push_back(share);
      CHECK(std::multiset<double>(found.begin(), found.end()) == std::multiset<double>(shares.begin(), shares.end()));
    }
    const glm::dvec3 from = glm::dvec3(skeleton.lines[0].from) + list.origin,
                     to = glm::dvec3(skeleton.lines[0].to) + list.origin;
    CHECK(from.x == Approx(1 + 3 * time));
    CHECK(to.x == Approx(1 + 3 * time));
    CHECK(to.y - from.y == Approx(2));
  }
  const frame::DrawList list = frame::buildDrawList(model.model, 0, {.demoLights = true});
  CHECK(linesOf(model.model, list, Overlay::lights).lines.size() >= 4 * (1 + 3 * 48));
  const frame::OverlayLines cameras = linesOf(model.model, list, Overlay::cameras);
  const double wide = lengthOf(cameras.lines[0]), high = lengthOf(cameras.lines[1]);
  CHECK(wide / high == Approx(2));
  CHECK(high == Approx(2 * std::tan(0.5) * 0.4 * list.bounds.radius()));
  CHECK(linesOf(model.model, list, Overlay::sun).lines.empty());
}
