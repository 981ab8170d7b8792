#pragma once

// Profiles of a draw list's lights as shaders/light_profile.glsl reads them.

#include <map>
#include <vector>

#include "frame/draw_list.hpp"
#include "optics/light_profile.hpp"

namespace facet::frame {

// Gives a light of the list its profile; one that several lights have is there once.
class ProfileWriter {
 public:
  explicit ProfileWriter(DrawList& list) : list_(list) {}
  void give(layout::LightUniforms& light, const optics::LightProfile& profile, const scene::PlacedLight& placed);

 private:
  DrawList& list_;
  std::map<const optics::LightProfile*, size_t> known_;  // its first number
};

}  // namespace facet::frame
