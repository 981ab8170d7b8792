// facet render --frames into films, as a user runs it.

#include <webp/demux.h>

#include <catch2/catch.hpp>

#include "io/image.hpp"
#include "support/command.hpp"
#include "support/gltf_builder.hpp"
#include "support/picture.hpp"
#include "support/skip.hpp"
#include "support/temporary_folder.hpp"

using namespace facet;

namespace {

const std::vector<std::string> filmSize = {"--size", "32x24", "--visibility", "none", "--env", "builtin:sky"};

test::Outcome filmOf(const std::string& output, std::vector<std::string> more) {
  std::vector<std::string> words = {"render", "builtin:poster", "-o", output};
  words.insert(words.end(), filmSize.begin(), filmSize.end());
  words.insert(words.end(), more.begin(), more.end());
  return test::runFacet(words);
}

// Frames as RGBA, and when each ends.
struct Moving {
  std::vector<std::vector<uint8_t>> frames;
  std::vector<int> ends;
  int loops = -1;
};

Moving readWebp(const std::string& file) {
  const std::string bytes = test::runShell("cat " + file).text;
  const WebPData data = {reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()};
  WebPAnimDecoder* decoder = WebPAnimDecoderNew(&data, nullptr);
  REQUIRE(decoder);
  WebPAnimInfo info;
  REQUIRE(WebPAnimDecoderGetInfo(decoder, &info));
  Moving moving;
  moving.loops = static_cast<int>(info.loop_count);
  while (WebPAnimDecoderHasMoreFrames(decoder)) {
    uint8_t* pixels = nullptr;
    int end = 0;
    REQUIRE(WebPAnimDecoderGetNext(decoder, &pixels, &end));
    moving.frames.emplace_back(pixels, pixels + size_t{4} * info.canvas_width * info.canvas_height);
    moving.ends.push_back(end);
  }
  WebPAnimDecoderDelete(decoder);
  return moving;
}

std::vector<uint8_t> pixelsOf(const std::string& file) {
  const auto read = io::readImage(file);
  if (!read) FAIL(describe(read.error()));
  return read->data;
}

// A shell script in place of ffmpeg; the rest of the path stays.
std::string withFfmpeg(const test::TemporaryFolder& folder, const std::string& script) {
  const std::string file = folder.write("bin/ffmpeg", "#!/bin/sh\n" + script).string();
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  return "PATH=" + folder.file("bin") + ":$PATH ";
}

}  // namespace

TEST_CASE("film: a turntable as animated WebP has the pictures of the numbered files, at their times") {
  const test::TemporaryFolder folder;
  const std::vector<std::string> turn = {"--frames", "4", "--fps", "8", "--turntable", "--quality", "100"};
  const test::Outcome outcome = filmOf(folder.file("turn.webp"), turn);
  INFO(outcome.text);
  REQUIRE(outcome.status == 0);
  CHECK_THAT(outcome.text, Catch::Contains("turn.webp: 4 pictures"));
  REQUIRE(filmOf(folder.file("turn_%d.png"), turn).status == 0);
  const Moving moving = readWebp(folder.file("turn.webp"));
  REQUIRE(moving.frames.size() == 4);
  CHECK(moving.ends == std::vector<int>{125, 250, 375, 500});
  CHECK(moving.loops == 0);
  for (size_t i = 0; i < 4; ++i) CHECK(moving.frames[i] == pixelsOf(folder.file("turn_" + std::to_string(i) + ".png")));
  CHECK(moving.frames[0] != moving.frames[1]);
  // Halfway round is the camera that one would give.
  const std::string still = folder.file("still.png");
  REQUIRE(filmOf(still, {}).status == 0);
  CHECK(moving.frames[0] == pixelsOf(still));
}

TEST_CASE("film: a turntable's third picture is seen from the other side") {
  const test::TemporaryFolder folder;
  const std::string model = folder.write("t.glb", test::triangle().glb()).string();
  const auto draw = [&](const std::string& output, std::vector<std::string> more) {
    std::vector<std::string> words = {"render", model, "-o", folder.file(output)};
    words.insert(words.end(), filmSize.begin(), filmSize.end());
    words.insert(words.end(), more.begin(), more.end());
    return test::runFacet(words).status;
  };
  REQUIRE(draw("t_%d.png", {"--orbit", "10,70,4", "--frames", "4", "--turntable"}) == 0);
  REQUIRE(draw("back.png", {"--orbit", "190,70,4"}) == 0);
  CHECK(pixelsOf(folder.file("t_2.png")) == pixelsOf(folder.file("back.png")));
}

TEST_CASE("film: the camera goes by a file of cameras, its ends are the file's") {
  const test::TemporaryFolder folder;
  const std::string path =
      folder.write("path.txt", "--orbit 0,80,5 --target 0,0,0\n--orbit 60,70,3 --target 0,0.2,0\n").string();
  REQUIRE(filmOf(folder.file("p_%d.png"), {"--frames", "3", "--camera-path", path}).status == 0);
  REQUIRE(filmOf(folder.file("a.png"), {"--orbit", "0,80,5", "--target", "0,0,0"}).status == 0);
  REQUIRE(filmOf(folder.file("b.png"), {"--orbit", "60,70,3", "--target", "0,0.2,0"}).status == 0);
  CHECK(pixelsOf(folder.file("p_0.png")) == pixelsOf(folder.file("a.png")));
  CHECK(pixelsOf(folder.file("p_2.png")) == pixelsOf(folder.file("b.png")));
  CHECK(pixelsOf(folder.file("p_1.png")) != pixelsOf(folder.file("a.png")));
}

TEST_CASE("film: ffmpeg gets the pictures' bytes, and a film is whole or not there") {
  const test::TemporaryFolder folder;
  const auto run = [&](const std::string& script, const std::string& name) {
    return test::runShell(withFfmpeg(folder, script) + test::facetPath() + " render builtin:poster -o " +
                          folder.file(name) +
                          " --size 32x24 --visibility none --env builtin:sky --frames 3 --fps 12.5 --turntable 2>&1");
  };
  // Its last word is file:NAME; what it was called with is kept.
  const std::string keep =
      "for last; do :; done\necho \"$@\" > " + folder.file("words") + "\ncat > \"${last#file:}\"\n";
  const test::Outcome good = run(keep, "a.mp4");
  INFO(good.text);
  REQUIRE(good.status == 0);
  CHECK(std::filesystem::file_size(folder.file("a.mp4")) == 3 * 32 * 24 * 3);
  const std::string words = test::runShell("cat " + folder.file("words")).text;
  CHECK_THAT(words, Catch::Contains("-pix_fmt rgb24 -video_size 32x24 -framerate 12.5") && Catch::Contains("libx264") &&
                        Catch::Contains("bt709"));
  REQUIRE(test::runShell("head -c 2304 " + folder.file("a.mp4") + " > " + folder.file("first.rgb")).status == 0);
  REQUIRE(filmOf(folder.file("first.png"), {}).status == 0);
  const std::vector<uint8_t> first = pixelsOf(folder.file("first.png"));
  const std::string raw = test::runShell("cat " + folder.file("first.rgb")).text;
  bool same = raw.size() == 2304;
  for (size_t i = 0; same && i < 768; ++i)
    for (size_t c = 0; c < 3; ++c) same = same && static_cast<uint8_t>(raw[3 * i + c]) == first[4 * i + c];
  CHECK(same);

  for (const std::string script :
       {"cat > /dev/null\necho Unknown encoder >&2\nexit 1\n", "echo Unknown encoder >&2\nexit 1\n"}) {
    const test::Outcome bad = run(script, "b.webm");
    CHECK(bad.status == 2);
    CHECK_THAT(bad.text, Catch::Contains("b.webm: ffmpeg gave up: Unknown encoder"));
  }
  const test::Outcome none = test::runShell("PATH=/nonexistent " + test::facetPath() + " render builtin:poster -o " +
                                            folder.file("c.gif") + " --size 32x24 --frames 2 --turntable 2>&1");
  CHECK(none.status == 2);
  CHECK_THAT(none.text, Catch::Contains("c.gif: films are made by ffmpeg, which is not installed"));
  std::vector<std::string> left;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    left.push_back(entry.path().filename().string());
  std::ranges::sort(left);
  CHECK(left == std::vector<std::string>{"a.mp4", "bin", "first.png", "first.rgb", "words"});
}

TEST_CASE("film: what the installed ffmpeg makes has the pictures' number, size and colours") {
  if (test::runShell("ffmpeg -version").status != 0) return test::skip("ffmpeg is not installed");
  const test::TemporaryFolder folder;
  const std::string name = GENERATE("a.mp4", "a.webm", "a.gif");
  CAPTURE(name);
  if (name != "a.gif" && test::runShell("ffmpeg -hide_banner -encoders | grep -q " +
                                        std::string(name == "a.mp4" ? "libx264" : "libvpx-vp9"))
                                 .status != 0)
    return test::skip("ffmpeg has no encoder for " + name);
  const test::Outcome made =
      filmOf(folder.file(name), {"--frames", "5", "--turntable", "--background", "#804020", "--quality", "100"});
  INFO(made.text);
  REQUIRE(made.status == 0);
  REQUIRE(test::runShell("ffmpeg -loglevel error -i " + folder.file(name) + " " + folder.file("back_%d.png") + " 2>&1")
              .status == 0);
  CHECK_FALSE(std::filesystem::exists(folder.file("back_6.png")));
  // Away from the model, whose edges are a film's weak side, the colour is the one that was asked for.
  const std::vector<uint8_t> back = pixelsOf(folder.file("back_1.png"));
  for (const auto& [channel, value] : {std::pair<size_t, int>(0, 0x80), {1, 0x40}, {2, 0x20}})
    CHECK(std::abs(back[channel] - value) <= 3);
  REQUIRE(filmOf(folder.file("first.png"), {"--background", "#804020"}).status == 0);
  const test::Outcome compared = test::runFacet(
      {"compare", folder.file("first.png"), folder.file("back_1.png"), "--metric", "drmse", "--max-error", "12"});
  INFO(compared.text);
  CHECK(compared.status == 0);
}

TEST_CASE("film: every way to be wrong has its sentence") {
  const test::TemporaryFolder folder;
  const auto says = [&](const std::string& name, const std::vector<std::string>& more, const std::string& sentence) {
    const test::Outcome outcome = filmOf(folder.file(name), more);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.text, Catch::Contains(sentence));
  };
  const std::string path = folder.write("p.txt", "--orbit 0,90,1\n").string();
  says("a.webp", {"--frames", "2"},
       "--frames: nothing moves without an animation; give --animation NAME or all, "
       "--turntable or --camera-path FILE.");
  says("a.mp4", {}, "is a film's name; give --frames N.");
  says("a.png", {"--turntable"}, "--turntable: is for several pictures; give --frames N, too.");
  says("a.png", {"--camera-path", path}, "--camera-path: is for several pictures; give --frames N, too.");
  says("a.webp", {"--frames", "2", "--turntable", "--camera-path", path}, "does not go with --camera-path");
  says("a.webp", {"--frames", "2", "--turntable", "--camera", "0"}, "--turntable: moves the camera");
  says("a.webp", {"--frames", "2", "--camera-path", path}, "p.txt: has 1 cameras");
  says("a.webp", {"--frames", "2", "--turntable", "--fps", "1000"}, "no player shows 1000 pictures a second");
  says("a.webp", {"--frames", "2", "--turntable", "--bits", "16"}, "--bits: ");
  says("a.mp4", {"--frames", "2", "--turntable", "--background", "transparent"}, "this film has no transparency");
  says("a.png", {"--frames", "2", "--turntable"}, "does not say where the frame's number goes");
}
