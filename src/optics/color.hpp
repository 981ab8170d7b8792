#pragma once

// Scene-linear radiance (Rec. 709) to display: tone mapping, then the sRGB transfer function.

#include <array>
#include <glm/glm.hpp>
#include <string_view>

#include "base/choice.hpp"

namespace facet::optics {

// Rec. 709 relative luminance, Y of CIE 1931: of reflectances, too.
double luminance(const glm::dvec3& rgb);

// IEC 61966-2-1. For negative values the straight part continues; no upper clamp.
double encodeSRGB(double linear);
double decodeSRGB(double encoded);
glm::dvec3 encodeSRGB(const glm::dvec3& linear);
glm::dvec3 decodeSRGB(const glm::dvec3& encoded);

// A number's colour as sRGB shows it (viridis). share: of a range, clamped to [0, 1]; NaN: magenta.
glm::dvec3 falseColor(double share);

// Linear in, linear out in [0, 1] (encodeSRGB is the next step for all of them). Exposure comes before.
enum class ToneMapper : uint8_t {
  none,           // clamp
  reinhard,       // Reinhard et al. 2002, eq. 3, per channel: c / (1 + c)
  reinhardPower,  // Reinhard's, encoded by the power 1 / 2.2 in the sRGB curve's place: the bytes of tutorials
  uncharted2,     // Hable 2010, "Filmic Tonemapping Operators": exposure bias 2, white 11.2
  aces,           // Hill 2016: a fit of ACES' RRT + sRGB ODT, without any exposure boost
  agx,  // Sobotka's AgX, base look, as the degree-6 polynomial of Wrensch 2023 with Rec. 709 matrices; encoded for a
        // 2.2 display and made linear by that power
  pbrNeutral,  // PBR Neutral 1.0, Khronos 2024
};
// In the order of toneMap in shaders/color.glsl.
inline constexpr Choice<ToneMapper> toneMappers[] = {
    {ToneMapper::none, "none", "none (clamp)", "what is brighter than white is white"},
    {ToneMapper::reinhard, "reinhard", "Reinhard"},
    {ToneMapper::reinhardPower, "reinhard-power", "Reinhard, power of 1/2.2", "encoded by a power, as in tutorials"},
    {ToneMapper::uncharted2, "uncharted2", "Uncharted 2"},
    {ToneMapper::aces, "aces", "ACES fit"},
    {ToneMapper::agx, "agx", "AgX"},
    {ToneMapper::pbrNeutral, "neutral", "Khronos PBR Neutral", "keeps base colours as they are"}};
static_assert(inOrder(toneMappers));

// Every result is in [0, 1] per channel: NaN and negative channels count as 0, values above largestRadiance (infinity
// included) as largestRadiance, where every mapper has reached its limit to 1e-14.
inline constexpr double largestRadiance = 1e15;
glm::dvec3 toneMap(ToneMapper mapper, const glm::dvec3& radiance);

}  // namespace facet::optics
