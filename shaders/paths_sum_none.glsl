#include "paths_sum_ground.glsl" if GROUND
