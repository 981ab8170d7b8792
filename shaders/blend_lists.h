// Lists of blended surfaces (src/frame/blend_lists.hpp), read by C++ and by GLSL alike.
#pragma once
#include "both_languages.h"

LAYOUT_BEGIN

// Storage buffers: of compute passes while nothing is drawn.
LAYOUT_UINT blendHeadsBinding = 2;
LAYOUT_UINT blendNodesBinding = 3;

// Locations of uniforms.
LAYOUT_UINT blendOrderLocation = 0;
LAYOUT_UINT blendWidthLocation = 0;

LAYOUT_END
