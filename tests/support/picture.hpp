#pragma once

// Pictures of models made in a test, in the test's own context.

#include <string>

#include "frame/session.hpp"
#include "frame/settings.hpp"
#include "io/gltf.hpp"
#include "support/gltf_builder.hpp"

namespace facet::test {

io::LoadedModel loadBuilt(const GltfBuilder& builder);
io::LoadedModel loadBuiltin(const std::string& name);  // "builtin:furnace"

// The model must outlive it.
frame::LoadedScene sceneOf(const io::LoadedModel& model);

// Environments, their tables and programs are shared by its pictures; each picture uploads its model anew.
class Studio {
 public:
  Studio();
  explicit Studio(shading::ShaderReader reader);  // of shaders that are other ones
  // radiance and display are both filled (see below).
  frame::Picture render(const io::LoadedModel& model, const frame::PictureSettings& settings);
  // What the model has on the GPU stays for further pictures.
  frame::Picture render(frame::LoadedScene& scene, const frame::PictureSettings& settings);
  Notes notes;            // of the last picture
  bool estimate = false;  // of their noise, too
  bool display = true;    // false: radiance alone, in single precision

 private:
  shading::ProgramStore programs_;
  frame::Shelf shelf_;
};

// A grid of width x height samples a pixel 1, no environment, transparent background: for pictures with known values.
frame::PictureSettings bareSettings(int width, int height);

const glm::vec4& pixel(const io::RadianceImage& image, int x, int y);  // y down from the top

// Adds vertices of a sphere around the origin with normals; returns the primitive's JSON without a material.
nlohmann::json addSphere(GltfBuilder& builder, double radius, int stacks = 24, int slices = 48);
// A quad in z = 0 with normals to +Z, from corner to corner.
nlohmann::json addQuad(GltfBuilder& builder, glm::vec2 low, glm::vec2 high);
// A mesh of one primitive and a node for it, also a root of scene 0; extra goes into the node. Returns the node's
// index.
int addMeshNode(GltfBuilder& builder, nlohmann::json primitive, int material, const nlohmann::json& extra = {});
// Sees [-x, x] x [-y, y] from z = 10 towards -Z.
void addOrthographicCamera(GltfBuilder& builder, double x, double y);

// Materials as JSON.
nlohmann::json material(const glm::vec4& baseColor, double metallic = 0, double roughness = 1);
nlohmann::json unlit(const glm::vec4& baseColor, const nlohmann::json& extra = nlohmann::json::object());
GltfBuilder emptyScene();                         // with the extensions in use declared
nlohmann::json at(double x, double y, double z);  // a node's translation

// Each channel within margin.
void checkPixel(const glm::vec4& got, const glm::vec4& expected, float margin = 1e-3f);

}  // namespace facet::test
