#pragma once

// Weights of the blurred copies for each layer of layers.hpp (from perceptual roughness 0.05 on):
// optics::mixtureWeights of its alpha and size. tests/optics/zonal_test.cpp holds them to it and prints them anew.

#include <array>

#include "layout.h"

namespace facet::ibl {

inline constexpr int blurredCopyCount = 14;
inline constexpr int mixturePartCount = blurredCopyCount + 2;  // and the two summed ones

inline constexpr std::array<std::array<float, mixturePartCount>, layout::ldLayerCount - 1> mixtures = {{
    {0.290715f, 0.608725f, 0, 0.023089f, 0.0624677f, 0, 0.00944399f, 0.00262123f, 0.00293742f, 0, 0, 0, 0, 0, 0,
     0},  // 0.05
    {0, 0.0552901f, 0.12753f, 0.240559f, 0.225153f, 0.166252f, 0.0933948f, 0.0418207f, 0.0268179f, 0.0119306f,
     0.00662729f, 0.00318296f, 0.0014419f, 0, 0, 0},  // 0.1
    {0, 0, 0, 0.0135312f, 0.0927699f, 0.246785f, 0.254913f, 0.160695f, 0.113841f, 0.0574035f, 0.0316139f, 0.0163165f,
     0.00696729f, 0.00409135f, 0.0010722f, 0},  // 0.15
    {0, 0, 0, 0, 0, 0.0369105f, 0.164681f, 0.236411f, 0.232277f, 0.152616f, 0.0887447f, 0.0506711f, 0.0210906f,
     0.0132726f, 0.00332634f, 0},  // 0.2
    {0, 0, 0, 0, 0, 0, 0, 0.0127547f, 0.111582f, 0.24763f, 0.246265f, 0.202753f, 0.0942402f, 0.0676806f, 0.0170939f,
     0},                                                                                                 // 0.3
    {0, 0, 0, 0, 0, 0, 0, 0, 0, 0.0428538f, 0.161276f, 0.321477f, 0.216505f, 0.200374f, 0.0575141f, 0},  // 0.4
    {0, 0, 0, 0, 0, 0, 0, 0, 0, 0.00390586f, 0, 0.196959f, 0.242248f, 0.403974f, 0.152913f, 0},          // 0.5
    {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0.0363146f, 0.0958462f, 0.524305f, 0.343534f, 0},                  // 0.6
    {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0.342509f, 0.657491f, 0},                                    // 0.7
    {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0},                                                    // 0.8
    {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0.4314f, 0.5686f},                                        // 0.9
    {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1},                                                    // 1
}};

}  // namespace facet::ibl
