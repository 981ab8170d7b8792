// The C example by facet.hpp.

#include <facet.hpp>
#include <fstream>
#include <iostream>

int main(int argc, char** argv) {
  facet::Renderer renderer;
  for (int i = 3; renderer && i + 1 < argc; i += 2) renderer.set(argv[i], argv[i + 1]);
  if (renderer) renderer.load(argv[1]);
  facet::Image<std::uint8_t> image;
  if (renderer) image = renderer.render();
  if (!image) return std::cerr << "example: " << renderer.message() << '\n', renderer.status();
  std::ofstream out(argv[2], std::ios::binary);
  out << "P7\nWIDTH " << image.width << "\nHEIGHT " << image.height
      << "\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n";
  out.write(reinterpret_cast<const char*>(image.samples.data()), static_cast<std::streamsize>(image.samples.size()));
}
