// Blended surfaces in the order of each pixel, against closed forms and against path-traced pictures.

#include <catch2/catch.hpp>
#include <cmath>

#include "frame/blend_lists.hpp"
#include "support/picture.hpp"
#include "support/skip.hpp"

namespace facet::test::blend_lists {

namespace {

constexpr int size = 64;  // pixels; the camera sees [-2, 2]^2

frame::PictureSettings settings(frame::Blending blending, int samples = 1) {
  frame::PictureSettings s = test::bareSettings(size, size);
  s.viewpoint.camera = "0";
  s.quality.samples = samples, s.quality.blending = blending;
  return s;
}

nlohmann::json blended(const glm::vec4& color, bool doubleSided = false) {
  return test::unlit(color, {{"alphaMode", "BLEND"}, {"doubleSided", doubleSided}});
}

glm::dvec4 over(const glm::dvec4& color, const glm::dvec4& behind) {  // behind: associated alpha
  return glm::dvec4(glm::dvec3(color) * color.w, color.w) + behind * (1 - color.w);
}

constexpr glm::vec4 red(0.9f, 0.1f, 0.1f, 0.5f), green(0.1f, 0.8f, 0.1f, 0.6f), blue(0.1f, 0.1f, 0.7f, 0.4f);

// Three quads of one primitive, nearest first, as no sorting of objects can put right.
GltfBuilder stack() {
  GltfBuilder b = test::emptyScene();
  std::vector<float> positions, colors;
  std::vector<uint32_t> indices;
  for (const auto& [z, color] : {std::pair(0.5f, red), std::pair(0.0f, green), std::pair(-0.5f, blue)}) {
    const auto first = static_cast<uint32_t>(positions.size() / 3);
    for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
      positions.insert(positions.end(), {corner.x, corner.y, z});
      colors.insert(colors.end(), {color.x, color.y, color.z, color.w});
    }
    for (const uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) indices.push_back(first + i);
  }
  nlohmann::json primitive = {
      {"attributes",
       {{"POSITION", b.add(positions, test::floatType, "VEC3")}, {"COLOR_0", b.add(colors, test::floatType, "VEC4")}}},
      {"indices", b.add(indices, test::uintType, "SCALAR")}};
  test::addMeshNode(b, std::move(primitive), b.append("materials", blended({1, 1, 1, 1})));
  test::addOrthographicCamera(b, 2, 2);
  return b;
}

// Two quads that cross along x = 0.
GltfBuilder crossed() {
  GltfBuilder b = test::emptyScene();
  for (const auto& [turn, color] : {std::pair(0.6, red), std::pair(-0.6, green)})
    test::addMeshNode(b, test::addQuad(b, {-1, -1}, {1, 1}), b.append("materials", blended(color, true)),
                      {{"rotation", {0, std::sin(turn / 2), 0, std::cos(turn / 2)}}});
  test::addOrthographicCamera(b, 2, 2);
  return b;
}

double worst(const io::RadianceImage& a, const io::RadianceImage& b) {
  double most = 0;
  for (size_t i = 0; i < a.pixels.size(); ++i)
    for (int c = 0; c < 4; ++c) most = std::max(most, std::abs(double{a.pixels[i][c]} - double{b.pixels[i][c]}));
  return most;
}

}  // namespace

TEST_CASE("Blending: lists put the triangles of one object in order", "[gl]") {
  if (!frame::listsAvailable()) return test::skip("the driver lacks ARB_post_depth_coverage");
  const io::LoadedModel model = test::loadBuilt(stack());
  test::Studio studio;
  const glm::dvec4 right = over(red, over(green, over(blue, glm::dvec4(0)))),
                   wrong = over(blue, over(green, over(red, glm::dvec4(0))));
  for (const int samples : {1, 4, 16}) {
    INFO(samples << " samples");
    const frame::Picture lists = studio.render(model, settings(frame::Blending::lists, samples)),
                         sorted = studio.render(model, settings(frame::Blending::sorted, samples));
    test::checkPixel(test::pixel(lists.radiance, size / 2, size / 2), glm::vec4(right), 2e-3f);
    test::checkPixel(test::pixel(sorted.radiance, size / 2, size / 2), glm::vec4(wrong), 2e-3f);
    CHECK(test::pixel(lists.radiance, 2, 2) == glm::vec4(0));
  }
}

TEST_CASE("Blending: lists are right on both sides of where objects cross, and before and behind what is opaque",
          "[gl]") {
  if (!frame::listsAvailable()) return test::skip("the driver lacks ARB_post_depth_coverage");
  GltfBuilder b = crossed();
  test::addMeshNode(b, test::addQuad(b, {-2, -2}, {2, 0}), b.append("materials", test::unlit({0.5, 0.5, 0.5, 1})),
                    {{"translation", {0, 0, 0.05}}});
  const io::LoadedModel model = test::loadBuilt(b);
  test::Studio studio;
  const frame::Picture picture = studio.render(model, settings(frame::Blending::lists, 4));
  // Turned by 0.6 about +y: at x > 0 the first one lies behind.
  const glm::dvec4 none(0), grey(0.5, 0.5, 0.5, 1);
  test::checkPixel(test::pixel(picture.radiance, 44, 20), glm::vec4(over(green, over(red, none))), 2e-3f);
  test::checkPixel(test::pixel(picture.radiance, 20, 20), glm::vec4(over(red, over(green, none))), 2e-3f);
  // The opaque one at z = 0.05 hides what lies behind it.
  test::checkPixel(test::pixel(picture.radiance, 44, 44), glm::vec4(over(green, grey)), 2e-3f);
  test::checkPixel(test::pixel(picture.radiance, 20, 44), glm::vec4(over(red, grey)), 2e-3f);
}

TEST_CASE("Blending: lists agree with traced pictures where sorted objects do not", "[gl]") {
  if (!frame::listsAvailable()) return test::skip("the driver lacks ARB_post_depth_coverage");
  GltfBuilder b = crossed();  // and something that is lit, without which nothing is traced
  test::addMeshNode(b, test::addQuad(b, {-2, -2}, {-1.5, -1.5}), b.append("materials", test::material({1, 1, 1, 1})));
  const io::LoadedModel model = test::loadBuilt(b);
  test::Studio studio;
  studio.display = false;
  frame::PictureSettings traced = settings(frame::Blending::sorted, 256);
  traced.quality.transport = frame::Transport::paths;
  const auto lit = [](frame::PictureSettings s) {
    s.sources.environment = "builtin:white", s.quality.visibility = frame::Visibility::none;
    return s;
  };
  const frame::Picture truth = studio.render(model, lit(traced)),
                       lists = studio.render(model, lit(settings(frame::Blending::lists, 256))),
                       sorted = studio.render(model, lit(settings(frame::Blending::sorted, 256)));
  const auto difference = [&](const frame::Picture& picture) {
    double sum = 0;
    for (size_t i = 0; i < truth.radiance.pixels.size(); ++i)
      for (int c = 0; c < 3; ++c)
        sum += std::pow(double{picture.radiance.pixels[i][c]} - double{truth.radiance.pixels[i][c]}, 2);
    return std::sqrt(sum / (3.0 * static_cast<double>(truth.radiance.pixels.size())));
  };
  WARN("root mean square of radiance from the traced picture: lists " << difference(lists) << ", sorted "
                                                                      << difference(sorted));
  CHECK(difference(lists) < 0.015);
  CHECK(difference(sorted) > 2 * difference(lists));
}

TEST_CASE("Blending: lists that need more room get it, and what is in order already stays as it is", "[gl]") {
  if (!frame::listsAvailable()) return test::skip("the driver lacks ARB_post_depth_coverage");
  GltfBuilder b = test::emptyScene();
  const int material = b.append("materials", blended({0.2, 0.4, 0.6, 0.05f}));
  const nlohmann::json quad = test::addQuad(b, {-2, -2}, {2, 2});
  for (int i = 0; i < 24; ++i) test::addMeshNode(b, quad, material, {{"translation", {0, 0, -0.1 * i}}});
  test::addOrthographicCamera(b, 2, 2);
  const io::LoadedModel model = test::loadBuilt(b);
  test::Studio studio;
  studio.display = false;  // single precision
  CHECK(worst(studio.render(model, settings(frame::Blending::lists)).radiance,
              studio.render(model, settings(frame::Blending::sorted)).radiance) < 1e-5);
}

}  // namespace facet::test::blend_lists
