// EACH_TEXCOORD(DO) is DO(n) for each TEXCOORD_n that the draw reads; src/shading/features.cpp defines it.
#ifndef EACH_TEXCOORD
#define EACH_TEXCOORD(DO)
#endif
