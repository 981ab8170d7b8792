// corner_tangents IN OUT: IN holds little-endian floats, 8 per corner of unindexed triangles (position, normal, uv);
// OUT gets 4 per corner. Prints milliseconds and the number of vertices.

#include <chrono>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "scene/tangents.hpp"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  std::ifstream in(argv[1], std::ios::binary);
  const std::vector<char> bytes((std::istreambuf_iterator<char>(in)), {});
  const auto* f = reinterpret_cast<const float*>(bytes.data());
  facet::scene::Primitive p;
  for (size_t i = 0; i < bytes.size() / 32; ++i, f += 8) {
    p.positions.emplace_back(f[0], f[1], f[2]);
    p.normals.emplace_back(f[3], f[4], f[5]);
    p.texCoords[0].emplace_back(f[6], f[7]);
  }
  const auto start = std::chrono::steady_clock::now();
  const facet::scene::Primitive out = facet::scene::withTangents(p, 0);
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  std::ofstream file(argv[2], std::ios::binary);
  for (const uint32_t i : out.indices) file.write(reinterpret_cast<const char*>(&out.tangents[i]), 16);
  std::printf("%.1f %zu\n", spent.count(), out.positions.size());
}
