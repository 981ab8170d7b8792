#include <catch2/catch.hpp>

#include "base/srgb.hpp"
#include "io/merl.hpp"
#include "io/utia.hpp"
#include "optics/synthetic_brdf.hpp"
#include "support/picture.hpp"
#include "support/temporary_folder.hpp"
#include "view/follow.hpp"
#include "view/inspector.hpp"
#include "view/viewer.hpp"

using namespace facet;

namespace {

// A file of UTIA's kind: the same in all directions.
std::vector<uint8_t> matte(const glm::dvec3& albedo) {
  const optics::AnalyticBrdf formula{.f0 = glm::dvec3(0), .f90 = glm::dvec3(0), .albedo = albedo, .alpha = {1, 1}};
  return io::encodeUtia(optics::makeMeasured(formula, optics::MeasuredKind::utia, "matte"));
}

// What a white furnace shows of it.
glm::ivec3 shown(const glm::dvec3& albedo) {
  glm::ivec3 bytes;
  for (int c = 0; c < 3; ++c) bytes[c] = static_cast<int>(std::lround(255 * srgbFromLinear(albedo[c])));
  return bytes;
}

struct Furnace : test::Viewer {
  const test::TemporaryFolder folder;

  // A square that fills the middle, under white light.
  Furnace() {
    state.settings.sources.environment = "builtin:white";
    state.settings.display.toneMapper = frame::ToneMapper::none;
    test::GltfBuilder b = test::emptyScene();
    b.append("materials", test::material({0.9f, 0.9f, 0.9f, 1}, 0.25, 0.5));
    test::addMeshNode(b, test::addQuad(b, {-1, -1}, {1, 1}), 0);
    load(folder.write("square.glb", b.glb()));
    state.camera = {0, 90, 3, {0, 0, 0}, 45};
  }
  void choose(const std::string& source) {
    view::chooseBrdf(state, source);
    view::bringUp(viewport, state, loader);
    settle();
  }
  void checkMiddle(const glm::dvec3& albedo) {
    const glm::ivec3 got = middle(), expected = shown(albedo);
    INFO(got.x << " " << got.y << " " << got.z << " for " << expected.x << " " << expected.y << " " << expected.z);
    for (int c = 0; c < 3; ++c) CHECK(std::abs(got[c] - expected[c]) <= 1);
  }
};

constexpr glm::dvec3 red(0.6, 0.2, 0.1), green(0.1, 0.5, 0.2);

}  // namespace

TEST_CASE("measured BRDF in the window: comes up beside it, a bad file leaves the picture and says why", "[gl]") {
  Furnace viewer;
  const glm::ivec3 own = viewer.middle();
  viewer.choose(viewer.folder.write("red.bin", matte(red)));
  viewer.checkMiddle(red);
  REQUIRE(viewer.state.shown.measured);
  CHECK(viewer.state.shown.measured->name == "red");
  CHECK(viewer.state.shown.measured->kind == optics::MeasuredKind::utia);
  CHECK(viewer.state.shown.warnings.size() == 1);  // no tangents

  viewer.choose(viewer.folder.write("cut.binary", std::string(1000, 'x')));
  CHECK(viewer.state.status.isError);
  CHECK(viewer.state.status.text.find("cut.binary") != std::string::npos);
  CHECK(viewer.state.status.text.find("1000 bytes") != std::string::npos);
  CHECK(viewer.state.settings.sources.brdf == viewer.folder.file("red.bin"));
  viewer.checkMiddle(red);

  view::chooseMaterialSource(viewer.state, view::MaterialSource::file);
  viewer.settle();
  CHECK_FALSE(viewer.state.shown.measured);
  CHECK(viewer.middle() == own);

  viewer.choose("nothing-like-it");
  CHECK(viewer.state.status.isError);
  CHECK(viewer.state.settings.sources.brdf.empty());
  CHECK(viewer.middle() == own);
}

TEST_CASE("measured BRDF in the window: the newest of several is shown, the last ones stay, reading is cancelled",
          "[gl]") {
  Furnace viewer;
  const std::string reds = viewer.folder.write("red.bin", matte(red)),
                    greens = viewer.folder.write("green.bin", matte(green));
  for (const std::string& source : {reds, greens, reds, greens}) {
    view::chooseBrdf(viewer.state, source);
    view::bringUp(viewer.viewport, viewer.state, viewer.loader);
  }
  viewer.settle();
  viewer.checkMiddle(green);
  view::chooseBrdf(viewer.state, reds + "?");
  CHECK_FALSE(view::drawViewport(viewer.viewport, viewer.state));  // the old picture is not drawn anew meanwhile
  viewer.choose(reds);
  viewer.checkMiddle(red);
  view::chooseBrdf(viewer.state, greens);
  CHECK(view::bringUp(viewer.viewport, viewer.state, viewer.loader));  // nothing has to be read
  viewer.checkMiddle(green);

  view::chooseBrdf(viewer.state, "builtin:ggx-0.5");
  view::bringUp(viewer.viewport, viewer.state, viewer.loader);
  CHECK(viewer.loader.running());
  view::cancelLoading(viewer.viewport, viewer.state, viewer.loader);
  viewer.settle();
  CHECK(viewer.state.settings.sources.brdf == greens);
  viewer.checkMiddle(green);
}

TEST_CASE("measured BRDF in the window: the table of the lobe is there while it is looked at, and of what is shown",
          "[gl]") {
  Furnace viewer;
  const std::string source = viewer.folder.write("a.bin", matte(red));
  viewer.choose(source);
  viewer.settle();
  const auto value = [&] {
    const std::shared_ptr<const optics::MeasuredBrdf>& table = viewer.state.lobe.table;
    REQUIRE(table);
    const glm::dvec3 V(0, 0.6, 0.8);
    return optics::pi * optics::measuredBrdf(*table, V, V, optics::LookUp::interpolated);
  };
  CHECK_FALSE(viewer.state.lobe.table);
  viewer.state.lobe.open = true;
  view::followLobe(viewer.state, viewer.loader);
  viewer.settle();
  CHECK(value().r == Approx(red.r).epsilon(1e-3));
  // The file changes: the next look is at what it holds then.
  viewer.folder.write("a.bin", matte(green));
  view::startMeasured(viewer.loader, viewer.state.shown.measured->source, true);
  viewer.settle();
  view::followLobe(viewer.state, viewer.loader);
  viewer.settle();
  CHECK(value().g == Approx(green.g).epsilon(1e-3));
  viewer.choose("builtin:lambert");
  viewer.settle();
  view::followLobe(viewer.state, viewer.loader);
  viewer.settle();
  CHECK(value().r == Approx(0.5).epsilon(1e-3));
  // What cannot be read again is said so.
  viewer.state.lobe.open = false;
  view::followLobe(viewer.state, viewer.loader);
  viewer.choose(source);
  viewer.folder.write("a.bin", std::string("gone"));
  viewer.state.lobe.open = true;
  view::followLobe(viewer.state, viewer.loader);
  viewer.settle();
  CHECK(viewer.state.lobe.failed);
  CHECK_FALSE(viewer.state.lobe.table);
  CHECK(viewer.state.status.isError);
  viewer.state.lobe.open = false;
  view::followLobe(viewer.state, viewer.loader);
  CHECK_FALSE(viewer.state.lobe.table);
  CHECK_FALSE(viewer.loader.table.running());
}

TEST_CASE("measured BRDF in the window: a file that changes is read again, a faulty one leaves what is shown", "[gl]") {
  Furnace viewer;
  const std::string source = viewer.folder.write("a.bin", matte(red));
  viewer.choose(source);
  view::Followed followed;
  auto now = std::chrono::steady_clock::now();
  const auto look = [&] {
    now += std::chrono::milliseconds(500);
    const bool changed = view::follow(followed, viewer.viewport, viewer.loader, now).measured;
    if (changed) viewer.settle();
    return changed;
  };
  CHECK_FALSE(look());
  viewer.folder.write("a.bin", std::string("half"));
  CHECK_FALSE(look());
  CHECK(look());
  CHECK(viewer.state.status.isError);
  CHECK(viewer.state.settings.sources.brdf == source);
  viewer.checkMiddle(red);
  viewer.folder.write("a.bin", matte(green));
  CHECK_FALSE(look());
  CHECK(look());
  CHECK(viewer.state.status.text == "reloaded: " + source);
  viewer.checkMiddle(green);
  CHECK_FALSE(look());

  // One that changes while another is shown.
  viewer.choose("builtin:utia-lambert");
  CHECK_FALSE(look());
  viewer.folder.write("a.bin", matte({0.3, 0.3, 0.3}));
  viewer.choose(source);
  viewer.checkMiddle(green);
  look();
  look();
  viewer.checkMiddle({0.3, 0.3, 0.3});
}

TEST_CASE("measured BRDF in the window: at rest it becomes what facet render makes, byte by byte", "[gl]") {
  test::Viewer viewer;
  viewer.state.settings.quality.samples = 16;
  viewer.state.settings.sources.brdf = "builtin:ggx-0.5";
  viewer.load("builtin:spheres");
  viewer.converge();
  CHECK(viewer.state.refinement.shown == 16);
  CHECK(viewer.state.refinement.error > 0);
  test::Studio studio;
  CHECK((
      viewer.display().data ==
      studio.render(test::loadBuiltin("builtin:spheres"), frame::restingSettings(viewer.state.settings)).display.data));
}

TEST_CASE("measured BRDF in the window: the inspector tells of it in the place of the material", "[gl]") {
  Furnace viewer;
  viewer.choose(viewer.folder.write("red.bin", matte(red)));
  view::drawViewport(viewer.viewport, viewer.state);
  view::clickAt(viewer.viewport, viewer.state, {32, 24}, {64, 48});
  while (view::inspectNext(viewer.viewport, viewer.state)) {
  }
  const view::Inspection& found = viewer.state.inspection;
  REQUIRE(found.on);
  CHECK(found.measured);
  const auto value = [&](const char* channel) {
    return found.values[static_cast<size_t>(shading::channelIndex(channel))];
  };
  CHECK_FALSE(value("baseColor"));
  CHECK_FALSE(value("metallic"));
  CHECK_FALSE(value("roughness"));
  REQUIRE(value("normal"));
  CHECK(value("normal")->z == Approx(1));
  REQUIRE(found.radiance);
  CHECK(found.radiance->x == Approx(red.x).epsilon(0.01));
  const auto told = [&](const std::string& name) {
    const auto row = std::ranges::find(found.materialDetails, name, &view::Detail::name);
    return row == found.materialDetails.end() ? std::string() : row->value;
  };
  CHECK(told("measured") == "red");
  CHECK(told("kind") == "UTIA, anisotropic");
  CHECK(told("file") == viewer.folder.file("red.bin"));
  CHECK(told("cells") == "82 944");
}

TEST_CASE("measured BRDF in the window: the fit comes beside it, the divider moves without a new picture", "[gl]") {
  Furnace viewer;
  viewer.state.settings.quality.samples = 8;
  viewer.choose("builtin:utia-satin");
  viewer.state.settings.comparison.brdfCompare = frame::BrdfCompare::split;
  view::bringUp(viewer.viewport, viewer.state, viewer.loader);
  CHECK(viewer.loader.fit.running());
  CHECK_FALSE(viewer.state.shown.compared);  // until it has come
  viewer.settle();
  REQUIRE(viewer.state.shown.fit);
  CHECK(viewer.state.shown.compared);
  // What the table was made from.
  const optics::AnalyticBrdf& model = viewer.state.shown.fit->fit.model;
  CHECK(model.alpha.t == Approx(0.8).epsilon(1e-2));
  CHECK(model.alpha.b == Approx(0.4).epsilon(1e-2));
  CHECK(model.f0.x == Approx(0.06).epsilon(1e-2));
  viewer.converge();
  REQUIRE(viewer.state.shown.comparison);
  CHECK(viewer.state.shown.comparison->share > 0.1);
  CHECK(viewer.state.shown.comparison->rms > 0);
  CHECK(viewer.state.shown.comparison->rms < 4);
  const auto half = viewer.display().data;

  viewer.state.settings.comparison.brdfSplit = 0;
  CHECK_FALSE(view::bringUp(viewer.viewport, viewer.state, viewer.loader));
  CHECK(view::drawViewport(viewer.viewport, viewer.state));
  CHECK(viewer.state.refinement.gathered == 8);  // nothing was thrown away
  CHECK((viewer.display().data != half));
  CHECK_FALSE(view::drawViewport(viewer.viewport, viewer.state));
  viewer.state.settings.comparison.brdfCompare = frame::BrdfCompare::difference;
  CHECK(view::drawViewport(viewer.viewport, viewer.state));
  CHECK(viewer.state.refinement.gathered == 8);
  viewer.state.settings.comparison.brdfCompare = frame::BrdfCompare::split;
  viewer.state.settings.comparison.brdfSplit = 0.5f;
  CHECK(view::drawViewport(viewer.viewport, viewer.state));
  CHECK((viewer.display().data == half));

  viewer.state.settings.comparison.brdfCompare = frame::BrdfCompare::none;
  viewer.settle();
  CHECK_FALSE(viewer.state.shown.compared);
  CHECK_FALSE(viewer.state.shown.fit);
  viewer.state.settings.comparison.brdfCompare = frame::BrdfCompare::fit;  // it is still there
  CHECK(view::bringUp(viewer.viewport, viewer.state, viewer.loader));
  CHECK(viewer.state.shown.fit);

  // One that is off is told.
  const auto told = [&] {
    std::string fit;
    for (const std::string& warning : viewer.state.shown.warnings)
      if (warning.find("its albedo is off by") != std::string::npos) fit += warning;
    return fit;
  };
  CHECK(told().empty());
  viewer.state.settings.look.models.diffuse = optics::DiffuseModel::callOfDuty;
  viewer.settle();
  REQUIRE(viewer.state.shown.fit);
  CHECK(viewer.state.shown.fit->fit.albedoError > optics::toldAlbedoError);
  CHECK_THAT(told(), Catch::Contains("its albedo is off by 5.4 %"));
}
