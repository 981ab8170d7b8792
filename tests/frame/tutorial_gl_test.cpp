#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>
#include <optional>

#include "optics/color.hpp"
#include "support/picture.hpp"

using namespace facet;

namespace {

constexpr double pi = 3.14159265359;
constexpr double eyeDistance = 28, fovDegrees = 45;  // the tutorial's units: radius 1, spacing 2.5

// learnopengl.com, "PBR: Lighting", as its fragment shader has it; `guard` is what it adds to the specular denominator.
glm::dvec3 tutorialColor(const glm::dvec3& at, const glm::dvec3& N, double metallic, double roughness, double guard) {
  const glm::dvec3 albedo(0.5, 0, 0), V = glm::normalize(glm::dvec3(0, 0, eyeDistance) - at);
  const glm::dvec3 F0 = glm::mix(glm::dvec3(0.04), albedo, metallic),
                   flux = glm::dvec3(23.47, 21.31, 20.79) * 300.0 / 23.47;
  glm::dvec3 Lo(0);
  for (const glm::dvec3 light : {glm::dvec3(-10, 10, 10), {10, 10, 10}, {-10, -10, 10}, {10, -10, 10}}) {
    const glm::dvec3 L = glm::normalize(light - at), H = glm::normalize(V + L);
    const double distance = glm::length(light - at);
    const glm::dvec3 radiance = flux / (distance * distance);
    const double a2 = std::pow(roughness, 4), NdotH = std::max(glm::dot(N, H), 0.0),
                 denom = NdotH * NdotH * (a2 - 1) + 1;
    const double NDF = a2 / (pi * denom * denom), k = (roughness + 1) * (roughness + 1) / 8;
    const double NdotV = std::max(glm::dot(N, V), 0.0), NdotL = std::max(glm::dot(N, L), 0.0);
    const double G = NdotV / (NdotV * (1 - k) + k) * NdotL / (NdotL * (1 - k) + k);
    const glm::dvec3 F = F0 + (1.0 - F0) * std::pow(std::clamp(1 - std::max(glm::dot(H, V), 0.0), 0.0, 1.0), 5);
    const glm::dvec3 specular = NDF * G * F / (4 * NdotV * NdotL + guard);
    Lo += ((1.0 - F) * (1 - metallic) * albedo / pi + specular) * radiance * NdotL;
  }
  const glm::dvec3 color = 0.03 * albedo + Lo;
  return glm::pow(color / (color + 1.0), glm::dvec3(1 / 2.2));
}

// What a ray from the eye meets, nullopt: nothing, or a sphere's rim, where the mesh is not the sphere.
std::optional<glm::dvec3> shownAt(const glm::dvec3& direction, double guard) {
  for (int row = 0; row < 7; ++row)
    for (int column = 3; column < 7; ++column) {
      const glm::dvec3 center(2.5 * (column - 3), 2.5 * (row - 3), 0), to = center - glm::dvec3(0, 0, eyeDistance);
      const double along = glm::dot(to, direction), inside = 1 - (glm::dot(to, to) - along * along);
      if (inside < 0) continue;
      if (inside < 0.1) return std::nullopt;  // N dot V < 0.3
      const glm::dvec3 N = direction * (along - std::sqrt(inside)) - to;
      return tutorialColor(center + N, N, row / 7.0, std::max(column / 7.0, 0.05), guard);
    }
  return std::nullopt;
}

struct Difference {
  double red = 0, rest = 0;  // root mean square, 1/255
  double largest = 0;
  int pixels = 0;
};

Difference differenceFrom(const frame::Picture& picture, double guard) {
  const int size = picture.display.width;
  Difference out;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const double edge = std::tan(fovDegrees / 2 * pi / 180);
      const glm::dvec2 at = (glm::dvec2(x, y) + 0.5) / double(size) * 2.0 - 1.0;
      const auto shown = shownAt(glm::normalize(glm::dvec3(at.x * edge, -at.y * edge, -1)), guard);
      if (!shown) continue;
      ++out.pixels;
      for (int c = 0; c < 3; ++c) {
        const double off = picture.display.data[(size_t(y) * size + x) * 4 + c] - 255 * (*shown)[c];
        (c == 0 ? out.red : out.rest) += c == 0 ? off * off : off * off / 2;
        out.largest = std::max(out.largest, std::abs(off));
      }
    }
  out.red = std::sqrt(out.red / out.pixels), out.rest = std::sqrt(out.rest / out.pixels);
  return out;
}

}  // namespace

// Where its highlights are wider than a pixel: from roughness 3/7 on.
TEST_CASE("builtin:tutorial shows what the tutorial's shader does", "[gl]") {
  const io::LoadedModel model = test::loadBuiltin("builtin:tutorial");
  test::Studio studio;
  frame::PictureSettings settings = test::bareSettings(210, 210);
  settings.viewpoint.orbit = frame::Orbit{0, 90, eyeDistance * std::sqrt(23.47 / 300)};
  settings.viewpoint.fovYDeg = fovDegrees;
  settings.quality.visibility = frame::Visibility::none;
  settings.display.toneMapper = optics::ToneMapper::reinhardPower;
  const frame::Picture picture = studio.render(model, settings);
  const Difference plain = differenceFrom(picture, 1e-9), guarded = differenceFrom(picture, 1e-4);
  std::cout << "tutorial: " << plain.pixels << " pixels; red off by " << plain.red << " / 255, green and blue by "
            << plain.rest << ", at most " << plain.largest << "; with the shader's guard " << guarded.red << ", "
            << guarded.rest << ", " << guarded.largest << "\n";
  CHECK(plain.pixels > 6000);
  CHECK(plain.rest < 0.4);  // half a step of 8 bits is 0.29
  // The diffuse share loses by the lobe's albedo here, by each light's Fresnel there.
  CHECK(plain.red < 2);
  CHECK(guarded.largest < 6);

  settings.look.models.masking = optics::Masking::approximate;  // the material's own word counts
  CHECK(studio.render(model, settings).display.data == picture.display.data);
  settings.display.toneMapper = optics::ToneMapper::reinhard;
  CHECK(differenceFrom(studio.render(model, settings), 1e-4).rest > 4);
}
