#include "io/gltf_environment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/parallel.hpp"
#include "base/srgb.hpp"
#include "base/whole_number.hpp"
#include "io/gltf_document.hpp"
#include "io/gltf_image_light.hpp"
#include "io/image.hpp"
#include "io/json_section.hpp"
#include "scene/builtin_environments.hpp"

namespace facet::io {

namespace {

using Json = nlohmann::json;

constexpr const char* lightsPlace = "/extensions/EXT_lights_image_based/lights";
constexpr double pi = 3.14159265358979324;

struct ImageLight {
  std::string name, place;
  double intensity = 1;
  glm::dquat rotation{1, 0, 0, 0};
  std::array<int, 6> faces{};
  std::array<glm::dvec3, 9> irradiance{};  // real spherical harmonics up to l = 2
};

std::optional<std::vector<double>> numbersOf(const Json& list, size_t count) {
  if (!list.is_array() || list.size() != count) return std::nullopt;
  std::vector<double> out;
  for (const Json& value : list) {
    if (!value.is_number() || !std::isfinite(value.get<double>())) return std::nullopt;
    out.push_back(value.get<double>());
  }
  return out;
}

Result<void> readFaces(const Document& doc, const Json& json, ImageLight& light) {
  const auto images = json.find("specularImages");
  const std::string at = light.place + "/specularImages/0";
  const bool found = images != json.end() && images->is_array() && !images->empty() && (*images)[0].is_array();
  if (!found || (*images)[0].size() != 6) return doc.error(at, "is no list of six images");
  for (size_t i = 0; i < 6; ++i) {
    const auto index = readIndex(doc, (*images)[0][i], doc.model.images.size(), pointer(at, i), "image");
    if (!index) return tl::unexpected(index.error());
    light.faces[i] = *index;
  }
  return {};
}

Json lightsOf(const Document& doc) {
  const Json extension = rootExtension(doc, "EXT_lights_image_based");
  const bool has = extension.is_object() && extension.contains("lights") && extension["lights"].is_array();
  return has ? extension["lights"] : Json::array();
}

Result<ImageLight> readImageLight(Document& doc, size_t wanted) {
  const Json lights = lightsOf(doc);
  if (wanted >= lights.size() || !lights[wanted].is_object())
    return doc.error(
        lightsPlace,
        "environment " + std::to_string(wanted) + " does not exist; there are " + std::to_string(lights.size()),
        "name another file as the environment");
  const Json& json = lights[wanted];
  ImageLight light{.name = stringAt(json, "name"), .place = pointer(lightsPlace, wanted)};
  if (auto ok = readFaces(doc, json, light); !ok) return tl::unexpected(ok.error());
  if (json.contains("intensity")) {
    const auto value = json["intensity"].is_number() ? json["intensity"].get<double>() : -1;
    if (value >= 0 && value <= 1e9)
      light.intensity = value;
    else
      doc.warning(light.place + "/intensity", "is no number from 0 on: 1 is used");
  }
  const auto q = json.contains("rotation") ? numbersOf(json["rotation"], 4) : std::nullopt;
  const double largest = q ? std::abs(std::ranges::max(*q, {}, [](double value) { return std::abs(value); })) : 0;
  if (largest > 0)  // squares of the numbers themselves may be none
    light.rotation = glm::dquat((*q)[3] / largest, (*q)[0] / largest, (*q)[1] / largest, (*q)[2] / largest);
  const bool turned = !json.contains("rotation") || largest > 0;
  if (!turned) doc.warning(light.place + "/rotation", "is no quaternion: not turned");
  light.rotation = turned ? glm::normalize(light.rotation) : glm::dquat(1, 0, 0, 0);
  const auto coefficients = json.find("irradianceCoefficients");
  for (size_t i = 0; coefficients != json.end() && coefficients->is_array() && i < 9 && i < coefficients->size(); ++i)
    if (const auto c = numbersOf((*coefficients)[i], 3)) light.irradiance[i] = {(*c)[0], (*c)[1], (*c)[2]};
  return light;
}

// Linear radiance of a face. Four channels are RGBD: the colour divided by alpha.
std::vector<glm::vec3> radianceOf(const Pixels& pixels) {
  const auto channels = static_cast<size_t>(pixels.channels), bytes = static_cast<size_t>(pixels.bytesPerSample);
  const size_t count = static_cast<size_t>(pixels.width) * static_cast<size_t>(pixels.height);
  const auto sample = [&](size_t i) {
    const uint8_t* data = &pixels.data[i * bytes];
    return bytes == 1 ? data[0] / 255.0 : (data[0] | data[1] << 8) / 65535.0;
  };
  std::vector<glm::vec3> out(count);
  for (size_t i = 0; i < count; ++i) {
    const bool grey = channels < 3, divided = channels == 4;
    const double divisor = divided ? std::max(sample(i * channels + 3), 1 / 255.0) : 1;
    for (size_t c = 0; c < 3; ++c)
      out[i][static_cast<int>(c)] = static_cast<float>(linearFromSrgb(sample(i * channels + (grey ? 0 : c))) / divisor);
  }
  return out;
}

Result<CubeMap> decodeFaces(Document& doc, const ImageLight& light) {
  std::vector<bool> wanted(doc.model.images.size());
  for (const int face : light.faces) wanted[static_cast<size_t>(face)] = true;
  const std::vector<Pixels> pixels = decodeImages(doc.model, wanted, doc.notes, doc.limits);
  CubeMap cube;
  for (size_t i = 0; i < 6; ++i) {
    const Pixels& face = pixels[static_cast<size_t>(light.faces[i])];
    const std::string at = pointer(light.place + "/specularImages/0", i);
    if (face.placeholder) return doc.error(at, "the image cannot be read");
    if (i == 0) cube.size = face.width;
    if (face.width != cube.size || face.height != cube.size)
      return doc.error(at, "is " + std::to_string(face.width) + " x " + std::to_string(face.height) +
                               ", not a square as large as the first");
    cube.faces[i] = radianceOf(face);
  }
  return cube;
}

double luminanceOf(const glm::dvec3& c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

// The mean direction that light comes from, by coefficients in the order y, z, x.
glm::dvec3 directionOf(const std::array<glm::dvec3, 9>& c) {
  return {luminanceOf(c[3]), luminanceOf(c[1]), luminanceOf(c[2])};
}

// The specification has the images turned about their vertical axis; some writers have the world mirrored instead, and
// the file's own coefficients tell. True where they agree better with that.
bool isMirrored(const CubeMap& cube, const ImageLight& light) {
  const glm::dvec3 file = directionOf(light.irradiance);
  const glm::dvec3 usual = directionOf(harmonicsOf(cube, false)), other = directionOf(harmonicsOf(cube, true));
  const double scale = glm::length(file) * glm::length(usual);
  return scale > 0 && glm::dot(file, other) - glm::dot(file, usual) > 0.2 * scale;
}

scene::Environment equirectOf(const CubeMap& cube, const ImageLight& light, bool mirrored) {
  scene::Environment out;
  out.height = std::clamp(2 * cube.size, 2, 4096);
  out.width = 2 * out.height;
  out.radiance.resize(static_cast<size_t>(out.width) * static_cast<size_t>(out.height));
  const glm::dquat back = glm::conjugate(light.rotation);
  parallelFor(static_cast<size_t>(out.height), [&](size_t row) {
    const double latitude = pi * (0.5 - (static_cast<double>(row) + 0.5) / out.height);
    for (int column = 0; column < out.width; ++column) {
      const double longitude = 2 * pi * ((column + 0.5) / out.width - 0.5);
      const glm::dvec3 d(std::cos(latitude) * std::cos(longitude), std::sin(latitude),
                         std::cos(latitude) * std::sin(longitude));
      const glm::dvec3 radiance = light.intensity * cubeRadiance(cube, back * d, mirrored);
      out.radiance[row * static_cast<size_t>(out.width) + static_cast<size_t>(column)] = glm::vec3(radiance);
    }
  });
  return out;
}

}  // namespace

size_t imageLightCount(const Document& doc) { return lightsOf(doc).size(); }

bool isGltfName(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
  return ending == ".glb" || ending == ".gltf";
}

Result<scene::Environment> loadGltfEnvironment(const std::filesystem::path& path, const std::string& index,
                                               Notes& notes, const Limits& limits) {
  const auto wanted = index.empty() ? std::optional(0) : wholeNumber(index);
  if (!wanted || *wanted < 0)
    return fail(path.string(), "", "an environment of it is called by its number", "leave out what follows the #");
  return withImages(path, limits, [&](Document& doc) -> Result<scene::Environment> {
    const auto light = readImageLight(doc, static_cast<size_t>(*wanted));
    if (!light) return tl::unexpected(light.error());
    const auto cube = decodeFaces(doc, *light);
    if (!cube) {  // the model is worth more than its own light
      doc.lost(cube.error(), "builtin:studio takes the environment's place");
      std::ranges::move(doc.notes, std::back_inserter(notes));
      return scene::builtinEnvironment("builtin:studio");
    }
    const bool mirrored = isMirrored(*cube, *light);
    scene::Environment environment = equirectOf(*cube, *light, mirrored);
    environment.name = light->name.empty() ? path.filename().string() : light->name;
    if (mirrored) doc.info(light->place, "its irradiance coefficients say that its images are mirrored: taken so");
    scene::mend(environment);
    std::ranges::move(doc.notes, std::back_inserter(notes));
    return environment;
  });
}

}  // namespace facet::io
