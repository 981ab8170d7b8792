#include <catch2/catch.hpp>

#include "support/gltf_load.hpp"

namespace {

using namespace facet;
using namespace facet::test;
using Json = nlohmann::json;

}  // namespace

TEST_CASE("External files: spaces, unicode, per cent signs, sub-folders", "[io][gltf]") {
  test::TemporaryFolder folder;
  GltfBuilder b = triangle();
  const struct {
    const char *uri, *file;
  } rows[] = {{"data.bin", "data.bin"},
              {"with space.bin", "with space.bin"},
              {"with%20space.bin", "with space.bin"},
              {"sub/deep%2Fx.bin", "sub/deep/x.bin"},
              {"\u2764\u267b.bin", "\u2764\u267b.bin"},
              {"%E2%9D%A4.bin", "\u2764.bin"},
              {"a+b.bin", "a+b.bin"},
              {"100%.bin", "100%.bin"},
              {"lit%41.bin", "lit%41.bin"},
              {"colon/a:b.bin", "colon/a:b.bin"}};
  for (const auto& row : rows) {
    INFO(row.uri);
    folder.write(row.file, b.bytes);
    b.json["buffers"] = {{{"byteLength", 36}, {"uri", row.uri}}};
    b.json["images"] = {
        {{"uri", row.uri}}, {{"uri", "missing.png"}, {"name", "paint"}}, {{"uri", "sub"}}, Json::object()};
    const auto model = io::loadGltf(folder.write("m \u2764.gltf", b.text()));
    REQUIRE(model);
    CHECK(primitive(*model).positions[1] == glm::vec3(1, 0, 0));
    CHECK(model->model.name == "m \u2764.gltf");
    const auto& images = model->model.images;
    CHECK(images[0].file == folder.path() / row.file);
    CHECK(images[0].name == std::filesystem::path(row.file).filename());
    CHECK(images[0].problem == "");
    CHECK(images[1].name == "paint");
    CHECK(images[1].problem == "the file \"missing.png\" does not exist");
    CHECK(images[3].problem == "it has neither a file nor data");
  }
}

TEST_CASE("A file may be longer than its buffer", "[io][gltf]") {
  test::TemporaryFolder folder;
  GltfBuilder b = triangle();
  b.json["buffers"] = {{{"byteLength", 36}, {"uri", "x.bin"}}};
  b.bytes.resize(100);
  folder.write("x.bin", b.bytes);
  CHECK(io::loadGltf(folder.write("m.gltf", b.text())));
}

TEST_CASE("Forms of data URIs and JSON text", "[io][gltf]") {
  GltfBuilder b = triangle();
  std::string percent = "data:,";
  for (const uint8_t byte : b.bytes) {
    const char digits[] = "0123456789abcdef";
    percent += {'%', digits[byte / 16], digits[byte % 16]};
  }
  std::string urlAlphabet = test::dataUri(b.bytes);
  for (char& c : urlAlphabet) c = c == '+' ? '-' : c;
  for (const std::string& uri : {percent, test::dataUri(b.bytes), "DATA:;base64," + test::base64(b.bytes)}) {
    b.json["buffers"] = {{{"byteLength", 36}, {"uri", uri}}};
    const std::string text = "\xEF\xBB\xBF \n" + b.json.dump(2) + "\n";  // byte order mark
    const auto model = io::loadGltfBytes({reinterpret_cast<const uint8_t*>(text.data()), text.size()}, "m");
    REQUIRE(model);
    CHECK(primitive(*model).positions[2] == glm::vec3(0, 1, 0));
  }
}

TEST_CASE("Images in buffer views are kept encoded", "[io][gltf]") {
  GltfBuilder b = triangle();
  const int view = b.addView(std::vector<uint8_t>{9, 8, 7});
  b.append("images", {{"bufferView", view}, {"mimeType", "image/png"}});
  const auto model = loaded(b);
  CHECK(model.model.images[0].encoded == std::vector<uint8_t>{9, 8, 7});
  CHECK(model.model.images[0].name == "images/0");
}

TEST_CASE("An image that may not be read costs its place, a buffer that nothing uses nothing", "[io][gltf]") {
  const test::TemporaryFolder folder;
  folder.write("outside.png", std::string("x"));
  folder.write("m/textures/in.png", std::string("x"));
  GltfBuilder b = triangle();
  const std::pair<const char*, const char*> images[] = {
      {"http://example.org/a.png", "the URI \"http://example.org/a.png\" is not a relative path"},
      {"../outside.png", "the URI \"../outside.png\" leads out of the model's folder"},
      {"..\\outside.png", "the file \"..\\outside.png\" does not exist"},
      {"/etc/passwd", "the URI \"/etc/passwd\" leads out of the model's folder"},
      {"file:///etc/passwd", "the URI \"file:///etc/passwd\" is not a relative path"},
      {"textures", "\"textures\" is not a regular file"},
      {"textures\\in.png", ""}};
  for (const auto& [uri, problem] : images) b.append("images", {{"uri", uri}});
  b.json["buffers"] = {{{"byteLength", b.bytes.size()}, {"uri", test::dataUri(b.bytes)}},
                       {{"byteLength", 7}, {"uri", "no.bin"}}};
  const auto path = folder.write("m/m.gltf", b.json.dump());
  auto model = io::loadGltf(path);
  REQUIRE(outcome(model) == "loaded");
  for (size_t i = 0; i < std::size(images); ++i) {
    INFO(images[i].first);
    CHECK(model->model.images[i].problem == images[i].second);
    CHECK(model->model.images[i].file.empty() == (images[i].second[0] != '\0'));
  }
  CHECK(notes(*model) ==
        "/buffers/1/uri: the file \"no.bin\": no such file: nothing uses the buffer\n"
        "/images/6/uri: its backslashes are taken for slashes\n");
  b.append("bufferViews", {{"buffer", 1}, {"byteLength", 4}});
  CHECK(outcome(io::loadGltf(folder.write("m/m.gltf", b.json.dump()))) ==
        path.string() + ": /buffers/1/uri: the file \"no.bin\": no such file; put the file beside the model.");
}
