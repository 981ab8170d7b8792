#include "frame/light_profiles.hpp"

namespace facet::frame {

void ProfileWriter::give(layout::LightUniforms& light, const optics::LightProfile& profile,
                         const scene::PlacedLight& placed) {
  std::vector<float>& numbers = list_.profileNumbers;
  const auto [entry, fresh] = known_.emplace(&profile, numbers.size());
  if (fresh) {
    numbers.push_back(static_cast<float>(profile.polar.size()));
    numbers.push_back(static_cast<float>(profile.azimuth.size()));
    numbers.push_back(static_cast<float>(profile.photometry));
    for (const std::vector<float>* more : {&profile.polar, &profile.azimuth, &profile.candela})
      numbers.insert(numbers.end(), more->begin(), more->end());
  }
  const auto first = static_cast<float>(entry->second + 1);
  light.profile = glm::vec4(glm::vec3(placed.side), placed.mirrored ? -first : first);
}

}  // namespace facet::frame
