#pragma once

#include <string_view>

#include "frame/settings.hpp"
#include "scene/model.hpp"

namespace facet::frame {

// A metal sets the base colour to its F at normal incidence and metallic to 1, a dielectric the index of refraction and
// metallic to 0. Roughness, and a dielectric's colour, are not the substance's: they stay. Empty: all stays.
void choosePreset(MaterialChoice& choice, std::string_view name);

// What everything is made of where the choice is on.
scene::Material overridingMaterial(const MaterialChoice& choice);

}  // namespace facet::frame
