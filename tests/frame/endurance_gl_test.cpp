// Many pictures in one process: what the first fifty have taken is all that is ever taken.

#include <epoxy/gl.h>
#include <malloc.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>

#include "support/command.hpp"
#include "support/picture.hpp"

using namespace facet;

namespace {

// Live names by kind; none is above the largest that was ever given.
std::map<std::string, int> liveObjects() {
  constexpr GLuint largest = 20'000;
  struct Kind {
    const char* name;
    GLboolean (*is)(GLuint);
  };
  const Kind kinds[] = {{"textures", [](GLuint id) { return glIsTexture(id); }},
                        {"buffers", [](GLuint id) { return glIsBuffer(id); }},
                        {"framebuffers", [](GLuint id) { return glIsFramebuffer(id); }},
                        {"samplers", [](GLuint id) { return glIsSampler(id); }},
                        {"programs", [](GLuint id) { return glIsProgram(id); }},
                        {"shaders", [](GLuint id) { return glIsShader(id); }},
                        {"vertex arrays", [](GLuint id) { return glIsVertexArray(id); }},
                        {"queries", [](GLuint id) { return glIsQuery(id); }}};
  std::map<std::string, int> counts;
  for (const Kind& kind : kinds)
    for (GLuint id = 1; id <= largest; ++id) counts[kind.name] += kind.is(id) == GL_TRUE;
  return counts;
}

// Bytes that the C library has given and not got back.
size_t heapBytes() {
  malloc_trim(0);
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

std::string text(const std::map<std::string, int>& counts) {
  std::string out;
  for (const auto& [name, count] : counts) out += std::to_string(count) + " " + name + "\n";
  return out;
}

// Ten kinds of jobs, one after the other.
frame::PictureSettings settingsOf(int job) {
  frame::PictureSettings settings = test::bareSettings(16 + 8 * (job % 3), 16);
  const int kind = job % 10;
  if (kind % 2 == 0) settings.sources.environment = kind % 4 == 0 ? "builtin:studio" : "builtin:sky";
  if (kind == 1) settings.quality.samples = 8;
  if (kind == 3) settings.quality.visibility = frame::Visibility::automatic;
  if (kind == 4) settings.quality.visibility = frame::Visibility::screen;
  if (kind == 5) settings.sources.brdf = "builtin:ggx-0.35";
  if (kind == 6) settings.quality.visibility = frame::Visibility::rays, settings.quality.samples = 2;
  if (kind == 7) settings.display.toneMapper = optics::ToneMapper::agx;
  if (kind == 8) settings.frame.background = frame::Background::color;
  return settings;
}

// llvmpipe's threads: pictures that wait for one another when the machine is busy, each of which holds the textures
// of what it drew last until it is busy again. Without these threads every byte is of what is drawn now. True where the
// test ran in a process without them.
bool ranWithoutThreads(const std::string& test) {
  if (std::getenv("LP_NUM_THREADS") != nullptr) return false;
  const std::string itself = std::filesystem::read_symlink("/proc/self/exe").string();
  const test::Outcome outcome = test::runShell("LP_NUM_THREADS=0 " + itself + " '" + test + "'");
  INFO(outcome.text);
  CHECK(outcome.status == 0);
  return true;
}

// A triangle that is to and fro for an hour, 15 s each way.
io::LoadedModel hourLong() {
  test::GltfBuilder builder = test::triangle();
  std::vector<float> times, places;
  for (int i = 0; i <= 242; ++i) {
    times.push_back(15.0f * static_cast<float>(i));
    places.insert(places.end(), {i % 2 == 0 ? 0.0f : 2.0f, 0, 0});
  }
  const int input = builder.add(times, test::floatType, "SCALAR"),
            output = builder.add(places, test::floatType, "VEC3");
  builder.json["animations"] = {{{"name", "hour"},
                                 {"samplers", {{{"input", input}, {"output", output}}}},
                                 {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
  test::addOrthographicCamera(builder, 4, 4);
  return test::loadBuilt(builder);
}

}  // namespace

TEST_CASE("endurance: two hundred mixed jobs take no more than the first fifty", "[gl]") {
  if (ranWithoutThreads("endurance: two hundred*")) return;
  test::Studio studio;
  std::map<std::string, int> objects;
  size_t heap = 0;
  for (int job = 0; job < 200; ++job) {
    if (job == 50) objects = liveObjects(), heap = heapBytes();
    const char* models[] = {"builtin:metals", "builtin:spheres", "builtin:poster"};
    studio.render(test::loadBuiltin(models[job % 5 < 3 ? 0 : job % 5 - 2]), settingsOf(job));
  }
  const size_t after = heapBytes();
  INFO("heap after 50: " << heap << ", after 200: " << after);
  CHECK(text(liveObjects()) == text(objects));
  CHECK(after < heap + (256 << 10));
}

TEST_CASE("endurance: an hour of an animation is drawn without growth, and its last seconds are as its first", "[gl]") {
  if (ranWithoutThreads("endurance: an hour*")) return;
  test::Studio studio;
  const io::LoadedModel model = hourLong();
  frame::LoadedScene scene = test::sceneOf(model);
  frame::PictureSettings settings = test::bareSettings(32, 16);
  settings.placement.animation = "hour", settings.viewpoint.camera = "0";
  std::vector<frame::Picture> first;
  std::map<std::string, int> objects;
  size_t heap = 0, wrong = 0;
  for (int i = 0; i <= 240; ++i) {
    if (i == 50) objects = liveObjects(), heap = heapBytes();
    settings.placement.timeSeconds = 15.0 * i + 3.75;
    frame::Picture picture = studio.render(scene, settings);
    if (i < 2)
      first.push_back(std::move(picture));
    else
      wrong += picture.radiance.pixels != first[static_cast<size_t>(i) % 2].radiance.pixels;
  }
  const size_t after = heapBytes();
  INFO("heap after 50: " << heap << ", after 240: " << after);
  CHECK(first[0].radiance.pixels != first[1].radiance.pixels);
  CHECK(wrong == 0);
  CHECK(text(liveObjects()) == text(objects));
  CHECK(after < heap + (64 << 10));
}
