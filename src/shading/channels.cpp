#include "shading/channels.hpp"

#include <cmath>

#include "scene/geometry.hpp"

namespace facet::shading {

namespace {

// Names in the rows, which are only theirs.
namespace channelRows {

using scene::Effect;
using scene::Material;
using scene::Primitive;
using scene::TextureSlot;

using namespace reads;

bool always(const Material&, const Primitive&) { return true; }
bool isLit(const Material& m, const Primitive&) { return !m.unlit; }
bool hasFaces(const Material&, const Primitive& p) { return scene::hasTriangles(p.topology); }
bool hasNormals(const Material&, const Primitive& p) { return !p.normals.empty(); }
bool hasTangents(const Material&, const Primitive& p) { return !p.tangents.empty(); }
bool hasVertexColors(const Material&, const Primitive& p) { return !p.colors.empty(); }
template <int set>
bool hasTexCoord(const Material&, const Primitive& p) {
  return !p.texCoords[set].empty();
}
bool hasBaseColorTexture(const Material& m, const Primitive& p) {
  return scene::usesTexture(m, p, TextureSlot::baseColor);
}
bool hasOcclusionTexture(const Material& m, const Primitive& p) {
  return scene::usesTexture(m, p, TextureSlot::occlusion);
}
bool hasNormalTexture(const Material& m, const Primitive& p) {
  return scene::usesTexture(m, p, TextureSlot::normal) && !p.tangents.empty();
}
// Extensions are of lit metallic-roughness surfaces.
template <Effect effect>
bool has(const Material& m, const Primitive&) {
  return !m.unlit && !m.specularGlossiness && scene::has(m, effect);
}
bool hasGrain(const Material& m, const Primitive& p) { return has<Effect::anisotropy>(m, p) && !p.tangents.empty(); }
bool attenuates(const Material& m, const Primitive& p) {
  return has<Effect::volume>(m, p) && std::isfinite(m.attenuationDistance);
}

struct ChannelRow {
  ChannelKind kind;
  ChannelReads reads;
  bool (*there)(const Material&, const Primitive&);
};
constexpr ChannelRow rows[] = {
#define CHANNEL(word, label, kind, reads, there, note) {ChannelKind::kind, reads, there},
#include "shading/channels.inc"
#undef CHANNEL
};

const ChannelRow& row(int channel) { return rows[static_cast<size_t>(channel)]; }

}  // namespace channelRows

}  // namespace

ChannelKind channelKind(int channel) { return channelRows::row(channel).kind; }

bool showsLight(int channel) { return channel == 0 || channelKind(channel) == ChannelKind::light; }

std::string channelSetting(int channel) { return channel == 0 ? "" : std::string(rowOf(channels, channel).word); }

int channelIndex(const std::string& setting) {
  for (int i = 0; i < channelCount; ++i)
    if (setting == channelSetting(i)) return i;
  return -1;
}

bool hasChannel(int channel, const scene::Material& material, const scene::Primitive& primitive) {
  return channelRows::row(channel).there(material, primitive);
}

ChannelReads channelReads(int channel) { return channelRows::row(channel).reads; }

}  // namespace facet::shading
