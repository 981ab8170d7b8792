#include "layout.h"
#include "scene_by_index.h"

layout(std430, binding = scenePrimitivesBinding) readonly buffer ScenePrimitivesBlock { ScenePrimitive scenePrimitives[]; };
