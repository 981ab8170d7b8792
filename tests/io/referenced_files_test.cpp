#include "io/referenced_files.hpp"

#include <catch2/catch.hpp>

#include "support/gltf_builder.hpp"
#include "support/temporary_folder.hpp"

using namespace facet;

TEST_CASE("referenced files: buffers and images below the folder, missing ones too, nothing else") {
  const test::TemporaryFolder folder;
  const std::filesystem::path root = std::filesystem::canonical(folder.path());
  folder.write("textures/a b.png", std::string("x"));
  const std::string gltf = folder.write("m.gltf", std::string(R"({"asset":{"version":"2.0"},
    "buffers":[{"uri":"m.bin"},{"uri":"data:application/octet-stream;base64,AAAA"},{"byteLength":3},7,{"uri":7}],
    "images":[{"uri":"textures/a%20b.png"},{"uri":"../outside.png"},{"uri":"http://example.org/x.png"},{"bufferView":0}]})"));
  const auto files = io::referencedFiles(gltf);
  CHECK(files == std::vector<std::filesystem::path>{root / "m.bin", root / "textures/a b.png"});
  CHECK(io::referencedFiles(folder.file("missing.gltf")).empty());
  CHECK(io::referencedFiles(folder.write("broken.gltf", std::string("{\"buffers\":[{\"uri\":\"a"))).empty());
  CHECK(io::referencedFiles(folder.write("odd.gltf", std::string("{\"buffers\":{\"uri\":7},\"images\":3}"))).empty());
}

TEST_CASE("referenced files: of a .glb, and whatever the file is called") {
  const test::TemporaryFolder folder;
  const std::filesystem::path root = std::filesystem::canonical(folder.path());
  const std::string json = R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":3},{"uri":"m.bin"}],)"
                           R"("images":[{"uri":"a.png"},{"bufferView":0}]})";
  const std::vector<std::filesystem::path> wanted = {root / "m.bin", root / "a.png"};
  CHECK(io::referencedFiles(folder.write("m.glb", test::glbBytes(json, std::vector<uint8_t>(3)))) == wanted);
  CHECK(io::referencedFiles(folder.write("M.GLTF", json)) == wanted);
  CHECK(io::referencedFiles(folder.write("cut.glb", std::string("glTF\2\0\0\0", 8))).empty());
}
