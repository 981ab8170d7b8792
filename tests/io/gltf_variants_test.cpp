#include <catch2/catch.hpp>

#include "support/gltf_load.hpp"

namespace {

using namespace facet;
using namespace facet::test;
using Json = nlohmann::json;

// Three variants, three materials; the triangle's own is 0.
GltfBuilder variants(Json mappings) {
  GltfBuilder b = triangle();
  b.json["materials"] = {Json::object(), Json::object(), Json::object()};
  b.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "a"}}, {{"name", "b"}}, {{"name", "c"}}};
  Json& primitive = b.json["meshes"][0]["primitives"][0];
  primitive["material"] = 0;
  primitive["extensions"]["KHR_materials_variants"]["mappings"] = std::move(mappings);
  return b;
}

}  // namespace

TEST_CASE("KHR_materials_variants: names, and a material for each variant that is mapped", "[io][gltf]") {
  const auto model =
      loaded(variants({{{"material", 2}, {"variants", {1}}}, {{"material", 1}, {"variants", Json::array({0})}}}));
  CHECK(notes(model) == "");
  CHECK(model.model.variants == std::vector<std::string>{"a", "b", "c"});
  CHECK(primitive(model).variantMaterials == std::vector<int>{1, 2});
  CHECK(primitive(model).material == 0);
  CHECK(primitive(loaded(triangle())).variantMaterials.empty());
}

TEST_CASE("KHR_materials_variants: what is wrong is told with its place", "[io][gltf]") {
  const auto problem = [](Json mappings) { return notes(loaded(variants(std::move(mappings)))); };
  const std::string at = "! /meshes/0/primitives/0/extensions/KHR_materials_variants/mappings";
  const std::string remedy = ": shown without its variants\n";
  CHECK(problem({{{"material", 3}, {"variants", {0, 1}}}}) ==
        at + "/0/material: material 3 does not exist; there are 3" + remedy);
  CHECK(problem({{{"variants", {0, 1}}}}) == at + "/0/material: is not a whole number" + remedy);
  CHECK(problem({{{"material", 1}, {"variants", {0, -1}}}}) ==
        at + "/0/variants/1: material variant -1 does not exist; there are 3" + remedy);
  CHECK(problem({{{"material", 1}, {"variants", {0, "a"}}}}) == at + "/0/variants/1: is not a whole number" + remedy);
  CHECK(problem({{{"material", 1}}}) == at + "/0/variants: is not a list of variants" + remedy);
  CHECK(problem(3) == at + ": is not a list of mappings" + remedy);
  GltfBuilder b = variants(Json::array());
  b.json["extensions"]["KHR_materials_variants"] = Json::object();
  CHECK(notes(loaded(b)) ==
        "! /extensions/KHR_materials_variants/variants: is not a list of variants: there are none\n" + at +
            ": is not a list of mappings" + remedy);
  b = variants({{{"material", 1}, {"variants", {0, 2}}}, {{"material", 2}, {"variants", {1, 2}}}});
  b.json["extensions"]["KHR_materials_variants"]["variants"][1] = {{"title", "b"}};
  const auto model = loaded(b);
  CHECK(primitive(model).variantMaterials == std::vector<int>{1, 2, 1});
  CHECK(model.model.variants[1].empty());
  CHECK(notes(model) ==
        "! /extensions/KHR_materials_variants/variants/1: has no name: choose it by its index\n"
        "! /meshes/0/primitives/0/extensions/KHR_materials_variants/mappings/1/variants/1: variant 2 has a material "
        "already: this one is ignored\n");
}
