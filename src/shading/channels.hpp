#pragma once

// What can be shown in place of the picture: the rows of channels.inc.

#include <cstdint>
#include <string>

#include "base/choice.hpp"
#include "scene/model.hpp"
#include "scene/usage.hpp"

namespace facet::shading {

enum class Channel : uint8_t {
#define CHANNEL(word, ...) word,
#include "shading/channels.inc"
#undef CHANNEL
};

// The row's word is the setting, but for the first row, whose setting is empty.
inline constexpr Choice<int> channels[] = {
#define CHANNEL(word, label, kind, reads, there, note) {static_cast<int>(Channel::word), #word, label, note},
#include "shading/channels.inc"
#undef CHANNEL
};
static_assert(inOrder(channels));
inline constexpr int channelCount = static_cast<int>(std::size(channels));

// What a channel's numbers are, and how they are shown.
enum class ChannelKind {
  color,      // linear Rec. 709: through the sRGB curve
  direction,  // of the world, unit: [-1, 1] as [0, 1]
  number,     // in [0, 1]: as grey
  quantity,   // any number: in false colours over a range (frame/value_range.hpp)
  identity,   // which of several: a colour for each
  light,      // radiance, a part of the picture's: as the picture
  pattern,    // three numbers in [0, 1]: as they are
};
ChannelKind channelKind(int channel);
// The setting: empty for the final picture.
std::string channelSetting(int channel);
// -1 where there is none of that name.
int channelIndex(const std::string& setting);
constexpr bool isChannel(int channel, Channel which) { return channel == static_cast<int>(which); }

// The picture, or a part of its light.
bool showsLight(int channel);

// Is there such a thing? Without it, checks are shown.
bool hasChannel(int channel, const scene::Material& material, const scene::Primitive& primitive);

// What the channel reads, bits of the following.
using ChannelReads = uint64_t;
namespace reads {
inline constexpr ChannelReads nothing = 0, normals = 1, tangents = 2, vertexColors = 4;
inline constexpr ChannelReads baseColor = 8;  // factor, vertex colours and texture
constexpr ChannelReads texCoord(int set) { return ChannelReads{16} << set; }
constexpr ChannelReads slot(scene::TextureSlot slot) {
  return texCoord(scene::maxTexCoordSets + static_cast<int>(slot));
}
static_assert(4 + scene::maxTexCoordSets + scene::textureSlotCount <= 64);
}  // namespace reads
ChannelReads channelReads(int channel);

}  // namespace facet::shading
