#pragma once

// Several models in one scene.

#include "scene/model.hpp"

namespace facet::scene {

// Adds what `added` shows by itself, its default scene, to all scenes of `model`: below one new node with the name of
// its file. Its objects come behind those that are there. Animations and variants of one name become one, so that both
// walk and both are red; the environment, the asset's properties and metadata are the first model's. Both models are as
// io::loadModel has them.
void addModel(Model& model, Model added);

}  // namespace facet::scene
