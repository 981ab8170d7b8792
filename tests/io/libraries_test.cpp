// The libraries that facet is linked with: libdraco brings symbols of others, which must not be found first.

#include <dlfcn.h>

#include <catch2/catch.hpp>
#include <string>

#include "support/command.hpp"
#include "support/gltf_builder.hpp"

namespace {

std::string libraryOf(const char* symbol) {
  void* address = dlsym(RTLD_DEFAULT, symbol);
  Dl_info info{};
  return address != nullptr && dladdr(address, &info) != 0 ? info.dli_fname : std::string("nowhere");
}

}  // namespace

TEST_CASE("tinygltf and stb come from their own libraries", "[io]") {
  CHECK(libraryOf("_ZN8tinygltf8TinyGLTF17RemoveImageLoaderEv").find("libtinygltf") != std::string::npos);
  CHECK(libraryOf("stbi_load_from_memory").find("libstb") != std::string::npos);
}

TEST_CASE("The executable reads a model", "[io]") {
  facet::test::TemporaryFolder folder;
  folder.write("m.glb", facet::test::triangle().glb());
  const auto outcome = facet::test::runFacet({"inspect", folder.file("m.glb")});
  INFO(outcome.text);
  CHECK(outcome.status == 0);
}
