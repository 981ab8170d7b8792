// Triangles as they lie in space and on their textures: what has no area, texels a metre, memory for textures.

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "io/validate/checks.hpp"
#include "io/validate/elements.hpp"
#include "io/validate/formats.hpp"
#include "io/validate/material_textures.hpp"

namespace facet::io::validate {

namespace {

constexpr double unevenRatio = 16;                    // of texels a metre, told
constexpr uint64_t muchMemory = uint64_t{512} << 20;  // bytes of textures, told

template <class V>
std::vector<V> vectorsOf(Asset& asset, int index, std::string_view attribute) {
  std::vector<V> out;
  if (index < 0) return out;
  const Accessor& a = asset.accessors[static_cast<size_t>(index)];
  if (!a.wellFormed || !isAttributeFormat(asset, attribute, false, a)) return out;
  forEachElement(asset, a, true, [&](uint64_t, std::span<const double> v) {
    V vector;
    for (int i = 0; i < V::length(); ++i) vector[i] = v[static_cast<size_t>(i)];
    out.push_back(vector);
  });
  return out;
}

// Corners of triangles, three after three; none where they can't be told.
std::vector<uint32_t> cornersOf(Asset& asset, const Json& primitive, size_t vertices) {
  std::vector<uint32_t> out;
  if (wholeAt(primitive, "mode").value_or(4) != 4) return out;
  if (member(primitive, "indices").is_null()) {
    for (uint32_t i = 0; i < vertices; ++i) out.push_back(i);
  } else if (const int index = indexAt(asset, primitive, "indices", "accessors"); index >= 0) {
    const Accessor& a = asset.accessors[static_cast<size_t>(index)];
    if (a.type != "SCALAR" || isFloat(a.componentType)) return out;
    forEachElement(asset, a, false, [&](uint64_t, std::span<const double> v) {
      out.push_back(static_cast<uint32_t>(std::max(v[0], 0.0)));
    });
  }
  out.resize(out.size() / 3 * 3);
  if (std::ranges::any_of(out, [&](uint32_t i) { return i >= vertices; })) out.clear();
  return out;
}

// Twice the area, of each triangle.
double areaOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) { return length(cross(b - a, c - a)); }
double areaOf(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

// The value below which that share of the weight lies; the pairs in order.
double quantile(const std::vector<std::pair<double, double>>& sorted, double share) {
  double all = 0, sum = 0;
  for (const auto& [value, weight] : sorted) all += weight;
  for (const auto& [value, weight] : sorted)
    if ((sum += weight) >= share * all) return value;
  return sorted.back().first;
}

// Texels of the texture's image, as KHR_texture_transform scales them; 0 where its size is not known.
double texelsOf(const Asset& asset, const TextureUse& use, const Json& info) {
  const int image = indexAt(asset, element(asset, "textures", use.texture), "source", "images");
  if (image < 0) return 0;
  const auto size = asset.imageSizes.find(at("/images", static_cast<size_t>(image)));
  if (size == asset.imageSizes.end()) return 0;
  double texels = double(size->second.first) * double(size->second.second);
  const Json& scale = member(extension(info, "KHR_texture_transform"), "scale");
  if (scale.is_array() && scale.size() == 2 && scale[0].is_number() && scale[1].is_number())
    texels *= std::abs(scale[0].get<double>() * scale[1].get<double>());
  return texels;
}

struct Mesh {
  std::vector<glm::dvec3> positions;
  std::vector<uint32_t> corners;
};

void checkDensity(Asset& asset, const Mesh& mesh, const std::vector<glm::dvec2>& coordinates, const TextureUse& use,
                  double texels, const std::string& place) {
  std::vector<std::pair<double, double>> densities;  // texels a metre, area
  for (size_t i = 0; i < mesh.corners.size(); i += 3) {
    const uint32_t* c = &mesh.corners[i];
    const double area = areaOf(mesh.positions[c[0]], mesh.positions[c[1]], mesh.positions[c[2]]);
    const double flat = areaOf(coordinates[c[0]], coordinates[c[1]], coordinates[c[2]]);
    if (area > 0 && std::isfinite(area) && std::isfinite(flat))
      densities.emplace_back(std::sqrt(flat / area * texels), area);
  }
  if (densities.empty()) return;
  std::ranges::sort(densities);
  const TexelDensity density{place, use.place, quantile(densities, 0.05), quantile(densities, 0.5),
                             quantile(densities, 0.95)};
  asset.report.densities.push_back(density);
  if (density.high > unevenRatio * density.low)
    asset.add(Code::FACET_TEXEL_DENSITY_UNEVEN, place,
              "a twentieth of the area has fewer than " + numberText(std::round(density.low)) + " texels a metre of " +
                  use.place + ", another more than " + numberText(std::round(density.high)));
}

void checkSurface(Asset& asset, const Json& primitive, const std::string& place) {
  const Json& attributes = member(primitive, "attributes");
  const auto accessorOf = [&](const std::string& name) { return indexAt(asset, attributes, name, "accessors"); };
  Mesh mesh;
  mesh.positions = vectorsOf<glm::dvec3>(asset, accessorOf("POSITION"), "POSITION");
  mesh.corners = cornersOf(asset, primitive, mesh.positions.size());
  size_t flat = 0;
  for (size_t i = 0; i < mesh.corners.size(); i += 3) {
    const uint32_t* c = &mesh.corners[i];
    const bool named = c[0] == c[1] || c[1] == c[2] || c[2] == c[0];  // told by the indices
    if (!named && areaOf(mesh.positions[c[0]], mesh.positions[c[1]], mesh.positions[c[2]]) == 0) ++flat;
  }
  if (flat > 0)
    asset.add(Code::FACET_TRIANGLES_WITHOUT_AREA, place,
              std::to_string(flat) + " of " + std::to_string(mesh.corners.size() / 3) +
                  " triangles have no area, though their indices differ");
  const int material = indexAt(asset, primitive, "material", "materials");
  if (material < 0 || mesh.corners.empty()) return;
  const MaterialTextures textures = texturesOf(asset, material);
  const bool made = textures.hasNormalMap && accessorOf("TANGENT") < 0;
  bool measured = false;
  for (const TextureUse& use : textures.uses) {
    const bool normal = use.place.ends_with("/normalTexture");
    if (measured && !(normal && made)) continue;
    const auto coordinates =
        vectorsOf<glm::dvec2>(asset, accessorOf("TEXCOORD_" + std::to_string(use.texCoord)), "TEXCOORD");
    if (coordinates.size() != mesh.positions.size()) continue;
    const Json info = asset.json.value(Json::json_pointer(use.place), Json());
    if (const double texels = texelsOf(asset, use, info); texels > 0 && !measured) {
      measured = true;
      checkDensity(asset, mesh, coordinates, use, texels, place);
    }
    if (!normal || !made) continue;
    size_t none = 0;
    for (size_t i = 0; i < mesh.corners.size(); i += 3) {
      const uint32_t* c = &mesh.corners[i];
      if (areaOf(coordinates[c[0]], coordinates[c[1]], coordinates[c[2]]) == 0 &&
          areaOf(mesh.positions[c[0]], mesh.positions[c[1]], mesh.positions[c[2]]) > 0)
        ++none;
    }
    if (none > 0)
      asset.add(
          Code::FACET_TEXCOORDS_WITHOUT_AREA, place,
          std::to_string(none) + " triangles have no area on the normal texture, and the primitive has no tangents");
  }
}

}  // namespace

void checkSurfaces(Asset& asset) {
  const Json& meshes = collection(asset, "meshes");
  for (size_t m = 0; m < meshes.size(); ++m) {
    const Json& primitives = member(meshes[m], "primitives");
    for (size_t p = 0; primitives.is_array() && p < primitives.size(); ++p)
      checkSurface(asset, primitives[p], at(at("/meshes", m) + "/primitives", p));
  }
  for (const auto& [place, size] : asset.imageSizes)  // four channels of 8 bits, with mip levels
    asset.report.textureBytes += uint64_t(size.first) * uint64_t(size.second) * 16 / 3;
  if (asset.report.textureBytes > muchMemory)
    asset.add(Code::FACET_TEXTURE_MEMORY, "/images",
              "the images take " + std::to_string(asset.report.textureBytes >> 20) +
                  " MiB as textures of 8-bit RGBA with mip levels");
}

}  // namespace facet::io::validate
