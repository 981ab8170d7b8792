#include <catch2/catch.hpp>
#include <fstream>

#include "ibl/cache.hpp"
#include "support/command.hpp"
#include "support/gpu.hpp"
#include "support/temporary_folder.hpp"

using namespace facet;

namespace {

namespace fs = std::filesystem;

constexpr ibl::Method quick{.cubeTaps = 1, .steepTaps = 1, .sumSize = 4, .irradianceSize = 4};
constexpr ibl::Needs everything{
    .dfg = true, .irradiance = true, .layers = true, .cube = true, .sheen = true, .background = true};

// Above half range, so that the scale is not 1.
scene::Environment gradient(float brightest = 1e6f) {
  scene::Environment map{"test", 16, 8, {}};
  for (int i = 0; i < 16 * 8; ++i) map.radiance.emplace_back(0.1f * float(i % 16), 0.2f * float(i / 16), 1);
  map.radiance[37] = glm::vec3(brightest);
  return map;
}

struct Run {
  ibl::Tables tables;
  int cached = 0, computed = 0;
};

// Programs are compiled once for a test.
struct Preparing {
  shading::ProgramStore programs = test::makeProgramStore();
  Run operator()(const ibl::TableCache& cache, const scene::Environment& map, const ibl::Needs& needs = everything,
                 const ibl::Method& method = quick);
};

Run Preparing::operator()(const ibl::TableCache& cache, const scene::Environment& map, const ibl::Needs& needs,
                          const ibl::Method& method) {
  Run run;
  std::string content;
  REQUIRE(ibl::prepareTables(run.tables, &map, content, needs, programs, cache, method));
  for (const ibl::TableStatistics& table : run.tables.statistics)
    if (table.name != "background") (table.name.ends_with("(cached)") ? run.cached : run.computed) += 1;
  return run;
}

// Texels of all levels as they are stored, and how they are read.
std::vector<uint8_t> content(const gl::Texture& texture) {
  REQUIRE(texture);
  std::vector<uint8_t> all;
  const gl::TextureDescription& d = texture.description();
  const bool isFloat = d.format == GL_RGBA32F || d.format == GL_R32F;
  const GLenum channels = d.format == GL_R32F ? GL_RED : GL_RGBA;
  for (int level = 0; level < d.levels; ++level) {
    const size_t bytes = size_t(d.width) * size_t(d.height) * 16 * 6 * size_t(d.layers);
    std::vector<uint8_t> texels(bytes, 0);
    glGetTextureImage(texture.id(), level, channels, isFloat ? GL_FLOAT : GL_HALF_FLOAT, GLsizei(bytes), texels.data());
    all.insert(all.end(), texels.begin(), texels.end());
  }
  for (const GLenum parameter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
    GLint value = 0;
    glGetTextureParameteriv(texture.id(), parameter, &value);
    all.push_back(uint8_t(value)), all.push_back(uint8_t(value >> 8));
  }
  return all;
}

void checkSame(const ibl::Tables& a, const ibl::Tables& b) {
  CHECK(a.radianceScale == b.radianceScale);
  for (const auto texture : {&ibl::Tables::dfg, &ibl::Tables::sheen, &ibl::Tables::irradiance,
                             &ibl::Tables::mirrorLayers, &ibl::Tables::roughLayers, &ibl::Tables::cube}) {
    CHECK((a.*texture).description().target == (b.*texture).description().target);
    CHECK(content(a.*texture) == content(b.*texture));
  }
}

ibl::TableCache cacheIn(const test::TemporaryFolder& folder) { return {{folder.path(), 64 << 20}, "build"}; }

}  // namespace

TEST_CASE("Table cache: what comes back is what was computed, byte by byte") {
  const test::TemporaryFolder folder;
  const ibl::TableCache cache = cacheIn(folder);
  Preparing prepare;
  const Run first = prepare(cache, gradient());
  CHECK(first.cached == 0);
  CHECK(first.computed > 0);
  const Run second = prepare(cache, gradient());
  CHECK(second.cached == 5);
  CHECK(second.computed == 0);
  checkSame(first.tables, second.tables);
  CHECK(second.tables.radianceScale == 32);
  CHECK(second.tables.background);
  // Only what is needed is read; what is there stays.
  const Run few = prepare(cache, gradient(), {.irradiance = true});
  CHECK(few.cached == 1);
  CHECK_FALSE(few.tables.roughLayers);
  CHECK(few.tables.radianceScale == 32);
  // Without a cache everything is computed, and the same.
  const Run none = prepare({}, gradient());
  CHECK(none.cached == 0);
  checkSame(first.tables, none.tables);
}

TEST_CASE("Table cache: another content, method, build or driver is another table") {
  const test::TemporaryFolder folder;
  const ibl::TableCache cache = cacheIn(folder);
  Preparing prepare;
  const ibl::Needs needs{.irradiance = true};
  prepare(cache, gradient(), needs);
  CHECK(prepare(cache, gradient(), needs).cached == 1);
  CHECK(prepare(cache, gradient(1e6f + 1), needs).cached == 0);
  scene::Environment turned = gradient();
  std::swap(turned.width, turned.height);
  CHECK(prepare(cache, turned, needs).cached == 0);
  ibl::Method method = quick;
  method.steepness = 17;
  CHECK(prepare(cache, gradient(), needs, method).cached == 0);
  CHECK(prepare({cache.disk, "other build"}, gradient(), needs).cached == 0);
  CHECK(prepare(cache, gradient(), needs).cached == 1);
}

TEST_CASE("Table cache: damaged and deleted files are made anew") {
  const test::TemporaryFolder folder;
  const ibl::TableCache cache = cacheIn(folder);
  Preparing prepare;
  const Run first = prepare(cache, gradient());
  const bool cut = GENERATE(true, false);
  for (const auto& file : fs::directory_iterator(folder.path())) {
    const auto size = fs::file_size(file);
    if (cut) {
      fs::resize_file(file, size / 2);
    } else {
      std::fstream stream(file.path(), std::ios::in | std::ios::out | std::ios::binary);
      stream.seekp(std::streamoff(size) - 500);
      stream << "damaged";
    }
  }
  const Run second = prepare(cache, gradient());
  CHECK(second.cached == 0);
  checkSame(first.tables, second.tables);
  CHECK(prepare(cache, gradient()).cached == 5);
  fs::remove_all(folder.path());
  CHECK(prepare(cache, gradient()).cached == 0);
  CHECK(prepare(cache, gradient()).cached == 5);
}

TEST_CASE("Table cache: two processes at once, a second run, none at all: the same picture") {
  const test::TemporaryFolder folder;
  const std::string facet = test::facetPath();
  const auto render = [&](const std::string& name, const std::string& more) {
    return "'" + facet + "' render builtin:furnace --env builtin:sky --size 32x32 -o " + folder.file(name + ".png") +
           " --stats " + folder.file(name + ".json") + more;
  };
  const std::string cache = "export XDG_CACHE_HOME=" + folder.file("cache") + "\n";
  const test::Outcome outcome =
      test::runShell(cache + render("a", " &\nfirst=$!\n") + render("b", "\ntwo=$?\nwait $first && [ $two = 0 ] &&\n") +
                     render("c", " &&\n") + render("d", " --no-cache"));
  INFO(outcome.text);
  REQUIRE(outcome.status == 0);
  const auto text = [&](const std::string& name) {
    std::ifstream file(folder.file(name), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  for (const char* name : {"b.png", "c.png", "d.png"}) CHECK(text(name) == text("a.png"));
  CHECK(text("c.json").find("LD layers (cached)") != std::string::npos);
  CHECK(text("d.json").find("(cached)") == std::string::npos);
  for (const auto& file : fs::directory_iterator(folder.path() / "cache" / "facet" / "tables"))
    CHECK(file.path().extension() == ".bin");
}
