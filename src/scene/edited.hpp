#pragma once

// What edits come to in a model.

#include <string>
#include <vector>

#include "base/error.hpp"
#include "scene/edit.hpp"
#include "scene/pose.hpp"

namespace facet::scene {

// What one sets of one object.
struct ResolvedEdit {
  enum class Kind { property, alphaMode, doubleSided, noTexture };
  Kind kind = Kind::property;
  AnimationChannel channel;  // object, slot and element; of a property also which
  std::string pointer;       // of this object alone, whole: "/materials/3/pbrMetallicRoughness/roughnessFactor"
};
// Errors: there is no such object or property, or it has another number of values.
Result<std::vector<ResolvedEdit>> resolveEdit(const Model& model, const Edit& edit);

// After what moves: of two that set the same, the later one holds. Values are brought to their ranges.
Result<void> applyEdits(Pose& pose, const Model& model, const Edits& edits);

// A material by itself, of edits that name no object: "/clearcoatFactor". Errors: there is no such property.
Result<Material> edited(Material material, const Edits& edits);

// Whether materials of the pose show something that those of the model do not, so that it may not have been read:
// textures, or a grain, which needs tangents.
bool showsMore(const Model& model, const Pose& pose);

}  // namespace facet::scene
