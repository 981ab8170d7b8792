#include "view/trees.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "support/picture.hpp"

using namespace facet;

namespace {

struct Listed {
  frame::ListInputs inputs;
  frame::DrawList list;
};
Listed spheres(int count) {
  test::GltfBuilder builder = test::emptyScene();
  const int material = builder.append("materials", test::material({1, 1, 1, 1}));
  for (int i = 0; i < count; ++i)
    test::addMeshNode(builder, test::addSphere(builder, 1), material, test::at(3.0 * i, 0, 0));
  Listed out;
  out.inputs.model = std::make_shared<const io::LoadedModel>(test::loadBuilt(builder));
  out.inputs.options.features.environment = true;
  out.inputs.options.tracing = frame::Tracing::paths;
  out.list = frame::buildDrawList(out.inputs.model->model, 0, out.inputs.options);
  return out;
}

frame::PathTrees waitedFor(view::Trees& trees, const Listed& of) {
  for (int i = 0; i < 2000; ++i) {
    auto found = view::findOrMakeTrees(trees, of.inputs, of.list);
    REQUIRE(found);
    if (*found) return std::move(**found);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  FAIL("no trees");
  return {};
}

}  // namespace

TEST_CASE("Trees: they are made beside who asks, once, and are those of the list") {
  view::Trees trees;
  const Listed three = spheres(3);
  const auto first = view::findOrMakeTrees(trees, three.inputs, three.list);
  REQUIRE(first);
  CHECK_FALSE(*first);
  CHECK(trees.making.running());
  const frame::PathTrees made = waitedFor(trees, three);
  CHECK_FALSE(trees.making.running());
  CHECK(made.list.scene.triangles.size() == frame::pathTrees(three.list).list.scene.triangles.size());
  CHECK_FALSE(made.drawn);
}

TEST_CASE("Trees: who asks for another list gets its own, and not those that were under way") {
  view::Trees trees;
  const Listed three = spheres(3), two = spheres(2);
  CHECK_FALSE(*view::findOrMakeTrees(trees, three.inputs, three.list));
  const size_t triangles = waitedFor(trees, two).list.scene.triangles.size();
  CHECK(triangles == frame::pathTrees(two.list).list.scene.triangles.size());
  // The same model shaded otherwise has others, too.
  Listed drawn = two;
  drawn.inputs.options.tracing = frame::Tracing::none;
  drawn.list = frame::buildDrawList(drawn.inputs.model->model, 0, drawn.inputs.options);
  CHECK_FALSE(*view::findOrMakeTrees(trees, two.inputs, two.list));
  CHECK(waitedFor(trees, drawn).drawn);
}

TEST_CASE("Trees: what is not wanted any more is forgotten, and its model with it") {
  view::Trees trees;
  std::weak_ptr<const io::LoadedModel> model;
  {
    const Listed three = spheres(3);
    model = three.inputs.model;
    CHECK_FALSE(*view::findOrMakeTrees(trees, three.inputs, three.list));
    view::forgetTrees(trees);
  }
  CHECK_FALSE(trees.making.running());
  for (int i = 0; i < 2000 && !model.expired(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    view::forgetTrees(trees);
  }
  CHECK(model.expired());
  const Listed two = spheres(2);
  waitedFor(trees, two);
  CHECK(trees.asked.inputs.model == nullptr);
}
