// Which files a model may read, and how much of them.

#include "io/safe_files.hpp"

#include <sys/stat.h>

#include <catch2/catch.hpp>

#include "io/image.hpp"
#include "io/referenced_files.hpp"
#include "io/sources.hpp"
#include "support/gltf_load.hpp"

namespace {

using namespace facet;
using namespace facet::test;
using Json = nlohmann::json;

template <class T>
std::string problem(const Result<T>& result) {
  return result ? "" : describe(result.error());
}

}  // namespace

TEST_CASE("Files that are no files are refused", "[io][gltf]") {
  test::TemporaryFolder folder;
  const auto load = [](const std::filesystem::path& path) { return outcome(io::loadGltf(path)); };
  const auto missing = folder.path() / "none.glb";
  CHECK(load(missing) == missing.string() + ": no such file; check the path.");
  CHECK(load(folder.path()) == folder.path().string() + ": is a folder, not a file; name a file in it.");
  const auto pipe = folder.path() / "pipe.glb";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  CHECK(load(pipe) == pipe.string() + ": is not a regular file; name a regular file.");
  // The same without reading.
  CHECK(problem(io::checkModelSource(missing)) == problem(io::loadGltf(missing)));
  CHECK(problem(io::checkModelSource(folder.path())) == problem(io::loadGltf(folder.path())));
  CHECK(problem(io::checkModelSource(pipe)) == problem(io::loadGltf(pipe)));
  CHECK(problem(io::checkEnvironmentSource(missing)) == missing.string() + ": no such file; check the path.");
  CHECK(load("/dev/zero") == "/dev/zero: is not a regular file; name a regular file.");
  const auto large = folder.write("large.glb", std::string(100, 'x'));
  io::Limits limits;
  limits.fileBytes = 99;
  CHECK(outcome(io::loadGltf(large, limits)) ==
        large.string() + ": has 100 bytes, more than the limit of 99; use a smaller file.");
}

TEST_CASE("Whether a source exists is told without reading it", "[io]") {
  test::TemporaryFolder folder;
  const std::string text = folder.write("not.glb", std::string("no model"));
  CHECK(io::checkModelSource(text));
  CHECK(io::checkEnvironmentSource(text));
  CHECK(io::checkModelSource("builtin:poster"));
  CHECK(io::checkEnvironmentSource("builtin:studio"));
  CHECK(problem(io::checkModelSource("builtin:postre")) == problem(io::loadModel("builtin:postre")));
  CHECK(problem(io::checkModelSource("builtin:postre")).find("poster") != std::string::npos);
  Notes notes;
  CHECK(problem(io::checkEnvironmentSource("builtin:sun")) == problem(io::loadEnvironmentSource("builtin:sun", notes)));
  CHECK(problem(io::checkEnvironmentSource("builtin:sun")).find("studio") != std::string::npos);
  const io::Bump bump{folder.file("missing.png"), 1};
  CHECK(problem(io::checkModelSource(text, {}, bump)).find("a bump is for the built-in scenes") != std::string::npos);
  CHECK(problem(io::checkModelSource("builtin:poster", {}, bump)).find("no such file") != std::string::npos);
}

TEST_CASE("A buffer's file stays below the model's folder", "[io][gltf]") {
  test::TemporaryFolder folder;
  const std::vector<uint8_t> secret(36, 1);
  folder.write("secret.bin", secret);
  folder.write("models/inside.bin", secret);
  std::filesystem::create_symlink(folder.path() / "secret.bin", folder.path() / "models/link.bin");
  REQUIRE(::mkfifo((folder.path() / "models/pipe").c_str(), 0600) == 0);
  const auto path = (folder.path() / "models/m.gltf").string();
  const auto load = [&](const std::string& uri) {
    GltfBuilder builder = triangle();
    builder.json["buffers"] = {{{"byteLength", 36}, {"uri", uri}}};
    folder.write("models/m.gltf", builder.text());
    return outcome(io::loadGltf(path));
  };
  const auto outside = [&](const std::string& uri) {
    return path + ": /buffers/0/uri: the URI \"" + uri +
           "\" leads out of the model's folder; put the file below that folder and name it by a relative path.";
  };
  const auto scheme = [&](const std::string& uri) {
    return path + ": /buffers/0/uri: the URI \"" + uri +
           "\" is not a relative path; only data: URIs and files below the model's folder are read.";
  };
  const auto file = [&](const std::string& uri, const std::string& rest) {
    return path + ": /buffers/0/uri: the file \"" + uri + "\": " + rest;
  };
  CHECK(load("inside.bin") == "loaded");
  CHECK(load("./inside.bin") == "loaded");
  CHECK(load("x/../inside.bin") == "loaded");
  for (const char* uri :
       {"../secret.bin", "..%2Fsecret.bin", "..%2fsecret.bin", "%2e%2e/secret.bin", "x/../../secret.bin", "link.bin",
        "..", ".", "", "../models", "../models.bin", "%2Fetc%2Fhostname"}) {
    CHECK(load(uri) == outside(uri));
  }
  CHECK(load("/etc/hostname") == outside("/etc/hostname"));
  CHECK(load(folder.path().string() + "/models/inside.bin") == outside(folder.path().string() + "/models/inside.bin"));
  for (const char* uri : {"file:///etc/hostname", "http://localhost/x.bin", "HTTPS://x", "C:/x.bin"}) {
    CHECK(load(uri) == scheme(uri));
  }
  CHECK(load("a%00b") == path + ": /buffers/0/uri: the URI \"a%00b\" holds a zero byte; rename the file.");
  CHECK(load("pipe") == file("pipe", "is not a regular file; name a regular file."));
  CHECK(load("none.bin") == file("none.bin", "no such file; put the file beside the model."));
  // No shell: a name is a name.
  CHECK(load("`touch x`.bin") == file("`touch x`.bin", "no such file; put the file beside the model."));
}

TEST_CASE("An image's file stays below the model's folder", "[io][gltf]") {
  test::TemporaryFolder folder;
  GltfBuilder builder = triangle();
  builder.append("images", {{"uri", "..%2Fsecret.png"}});
  const auto path = folder.write("m.gltf", builder.text());
  const auto model = io::loadGltf(path);
  REQUIRE(outcome(model) == "loaded");
  CHECK(model->model.images[0].file.empty());
  CHECK(model->model.images[0].problem == "the URI \"..%2Fsecret.png\" leads out of the model's folder");
}

TEST_CASE("The current folder is not searched", "[io][gltf]") {
  test::TemporaryFolder here, there;
  here.write("data.bin", std::vector<uint8_t>(36, 0));
  GltfBuilder builder = triangle();
  builder.json["buffers"] = {{{"byteLength", 36}, {"uri", "data.bin"}}};
  const auto path = there.write("m.gltf", builder.text());
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(here.path());
  const std::string result = outcome(io::loadGltf(path));
  // A bare name: the model's folder is the current one, and the root is not below it.
  here.write("bare.gltf", [] {
    GltfBuilder b = triangle();
    b.json["buffers"] = {{{"byteLength", 1}, {"uri", "/etc/hostname"}}};
    return b.text();
  }());
  const std::string bare = outcome(io::loadGltf("bare.gltf"));
  std::filesystem::current_path(before);
  CHECK(result ==
        path.string() + ": /buffers/0/uri: the file \"data.bin\": no such file; put the file beside the model.");
  CHECK(bare ==
        "bare.gltf: /buffers/0/uri: the URI \"/etc/hostname\" leads out of the model's folder; put the file "
        "below that folder and name it by a relative path.");
}

TEST_CASE("All files of a model together stay within the budget", "[io][gltf]") {
  test::TemporaryFolder folder;
  folder.write("a.bin", std::vector<uint8_t>(600, 0));
  GltfBuilder builder;
  builder.json["buffers"] = {{{"byteLength", 600}, {"uri", "a.bin"}}, {{"byteLength", 600}, {"uri", "a.bin"}}};
  // What nothing uses is let pass.
  for (int i = 0; i < 2; ++i) builder.append("bufferViews", {{"buffer", i}, {"byteLength", 4}});
  const auto path = folder.write("m.gltf", builder.text());
  io::Limits limits;
  limits.totalBytes = std::filesystem::file_size(path) + 1000;
  CHECK(outcome(io::loadGltf(path, limits)) ==
        path.string() +
            ": /buffers/1/uri: the file \"a.bin\": has 600 bytes, more than the limit of 400; use a smaller file.");
}

TEST_CASE("Files of another folder are read where it is allowed, and nowhere else") {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "model/maps");
  std::filesystem::create_directories(folder.path() / "store/objects");
  std::filesystem::create_directories(folder.path() / "storeroom");
  const auto model = std::filesystem::canonical(folder.path() / "model"), store = folder.path() / "store";
  folder.write("store/objects/a1", std::string("a"));
  folder.write("storeroom/b", std::string("b"));
  folder.write("model/own", std::string("c"));
  std::filesystem::create_symlink(store / "objects/a1", model / "maps/linked.png");
  std::filesystem::create_symlink(folder.path() / "storeroom/b", model / "maps/other.png");
  const auto target = std::filesystem::canonical(store / "objects/a1");
  const auto found = [&](const std::string& uri, const std::filesystem::path& outside) {
    const auto path = io::resolveBelow(model, uri, outside);
    return path ? path->string() : path.error().problem.substr(path.error().problem.find("leads"));
  };
  const std::string refused = "leads out of the model's folder";
  for (const std::string& uri : {std::string("maps/linked.png"), std::string("../store/objects/a1"), target.string()}) {
    INFO(uri);
    CHECK(found(uri, {}) == refused);
    CHECK(found(uri, store) == target);
    CHECK(found(uri, folder.path() / "storeroom") == refused);
    CHECK(found(uri, folder.path() / "missing") == refused);
  }
  for (const char* uri : {"maps/other.png", "../storeroom/b", "/etc/hostname", "../store/../storeroom/b"})
    CHECK(found(uri, store) == refused);
  CHECK(found("own", store) == model / "own");
  CHECK(io::resolveBelow(model, "../x").error().about == Setting::allowOutside);
  CHECK_FALSE(io::resolveBelow(model, "file://" + target.string(), store));
}

TEST_CASE("A model of links shows its images where their folder is allowed, and says what to allow") {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "model");
  std::filesystem::create_directories(folder.path() / "store");
  const auto png = test::pngBytes(1, 1, 3, 8, std::vector<uint8_t>{1, 2, 3});
  folder.write("store/a1", png);
  std::filesystem::create_symlink(folder.path() / "store/a1", folder.path() / "model/a.png");
  const auto gltf =
      folder.write("model/m.gltf", std::string(R"({"asset":{"version":"2.0"},"images":[{"uri":"a.png"}]})"));
  const auto load = [&](const std::string& outside) {
    auto model = io::loadGltf(gltf, {.allowOutside = outside});
    REQUIRE(model);
    io::decodeImages(model->model, {true}, model->notes);
    return model->notes;
  };
  const Notes notes = load("");
  REQUIRE(notes.size() == 1);
  CHECK(notes[0].text.find("leads out of the model's folder") != std::string::npos);
  CHECK(notes[0].about == Setting::allowOutside);
  CHECK(load((folder.path() / "store").string()).empty());
  CHECK(io::referencedFiles(gltf).empty());
  CHECK(io::referencedFiles(gltf, (folder.path() / "store").string()) ==
        std::vector{std::filesystem::canonical(folder.path() / "store/a1")});
}
