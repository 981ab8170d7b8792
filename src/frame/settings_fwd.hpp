#pragma once

// The names of settings.hpp, for what only passes settings on: most files need not be compiled anew after a new
// setting.

namespace facet::frame {

enum class BrdfCompare;
enum class TextureFilter;
struct Arrangement;
struct BrdfComparison;
struct Display;
struct FrameSettings;
struct Look;
struct Overlays;
struct PictureSettings;
struct Placement;
struct Quality;
struct Sources;
struct Viewpoint;

}  // namespace facet::frame
