// Owen-scrambled Sobol points (Burley 2020, "Practical Hash-based Owen Scrambling"): every pixel and every use of one
// has a sequence of its own, as good as random to all others. The twin is src/optics/sobol.cpp, bit for bit.

// Every bit of the result hangs on every one of x; one to one (Wellons 2018, lowbias32).
uint hashedBits(uint x) {
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}

// The seed of all points that a pixel uses for one purpose; different for all pixels below 65536 x 65536.
uint pixelSeed(uvec2 pixel, uint use) { return hashedBits((pixel.x + (pixel.y << 16)) ^ hashedBits(use + 0x9e3779b9u)); }

// Owen's scrambling of a number whose bits stand in reverse: each flips by a hash of those below it (Laine and Karras
// 2011, with the constants of Vegdahl 2021).
uint scrambledReverse(uint x, uint seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  return x ^ (x * 0x53a22864u);
}

// The second dimension of Sobol's sequence, in reverse: the first is the index itself. Pascal's triangle modulo 2 times
// the index's bits (Ahmed 2024).
uint sobolReverse(uint index) {
  index ^= index >> 16;
  index ^= (index & 0xff00ff00u) >> 8;
  index ^= (index & 0xf0f0f0f0u) >> 4;
  index ^= (index & 0xccccccccu) >> 2;
  return index ^ ((index & 0xaaaaaaaau) >> 1);
}

uint pairSeed(uint seed, uint pair) { return hashedBits(seed ^ (pair * 0x9e3779b9u)); }

// Point `index` of a sequence, in (0, 1)^2: the middle of one of 2^23 steps along each axis. The first 2^k points, and each
// further 2^k, have one in every box of area 2^-k whose sides are powers of 2.
vec2 scrambledSobol2(uint index, uint seed) {
  uvec2 point = uvec2(scrambledReverse(index, hashedBits(seed + 1u)),
                      scrambledReverse(sobolReverse(index), hashedBits(seed + 2u)));
  return (vec2(bitfieldReverse(point) >> 9) + 0.5) * (1.0 / 8388608.0);
}

// The same for the pairs of dimensions of one integral: each is a sequence of its own, in shuffled order (padding).
vec2 owenSobol2(uint index, uint pair, uint seed) {
  uint own = pairSeed(seed, pair);
  return scrambledSobol2(bitfieldReverse(scrambledReverse(bitfieldReverse(index), own)), own);
}
