#pragma once

// Blocks of 4 x 4 texels to RGBA8, row by row. Internal to io/. False: these bytes are no block of the format; nothing
// is written.

#include <cstdint>

namespace facet::io {

// KDFS 1.4, chapter 21 (ETC1): what is added to a colour or taken from it, of ETC1S and ETC2.
inline constexpr int etcModifiers[8][2] = {{2, 8},   {5, 17},  {9, 29},   {13, 42},
                                           {18, 60}, {24, 80}, {33, 106}, {47, 183}};

// uastc.cpp: 16 bytes
bool decodeUastc(const uint8_t* block, uint8_t* rgba);

// bc.cpp: 8 bytes for BC1 and BC4, else 16. Channels that a format lacks are 0, alpha 255.
bool decodeBc1(const uint8_t* block, uint8_t* rgba);  // black of three colours and black is opaque
bool decodeBc1Alpha(const uint8_t* block, uint8_t* rgba);
bool decodeBc2(const uint8_t* block, uint8_t* rgba);
bool decodeBc3(const uint8_t* block, uint8_t* rgba);
bool decodeBc4(const uint8_t* block, uint8_t* rgba);
bool decodeBc5(const uint8_t* block, uint8_t* rgba);

// bc7.cpp: 16 bytes
bool decodeBc7(const uint8_t* block, uint8_t* rgba);

// etc2.cpp: 8 bytes, 16 with alpha and for RG11
bool decodeEtc2(const uint8_t* block, uint8_t* rgba);
bool decodeEtc2Punch(const uint8_t* block, uint8_t* rgba);  // alpha of one bit
bool decodeEtc2Alpha(const uint8_t* block, uint8_t* rgba);
bool decodeEacR11(const uint8_t* block, uint8_t* rgba);
bool decodeEacRg11(const uint8_t* block, uint8_t* rgba);

}  // namespace facet::io
