#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "selftest/numerics.hpp"
#include "support/command.hpp"
#include "support/schema.hpp"

using namespace facet;

namespace {

// One test case per function, so that a failure names it.
void checkFunction(const std::string& name) {
  static const std::vector<selftest::Check> checks = selftest::numericalChecks();
  bool found = false;
  for (const selftest::Check& check : checks) {
    if (check.name != name) continue;
    found = true;
    const Result<selftest::CheckResult> result = selftest::runCheck(check, shading::shaderReader());
    REQUIRE(result);
    INFO("error " << result->error << ", allowed " << result->allowed << " (" << check.reason << ") at "
                  << result->input << ": got " << result->got << ", expected " << result->expected);
    INFO("first value that is not finite: at " << result->firstNonFinite);
    CHECK(result->nonFinite == 0);
    CHECK(result->error <= result->allowed);
    CHECK(result->passed);
  }
  REQUIRE(found);
}

}  // namespace

#define TWIN(function) \
  TEST_CASE("Twin: " function) { checkFunction(function); }

TWIN("D_GGX")
TWIN("V_SmithGGXCorrelated")
TWIN("G1_GGX")
TWIN("F_Schlick")
TWIN("roughnessOverPixel")
TWIN("footprintReads")
TWIN("maskAlpha")
TWIN("bentNormal")
TWIN("Fd_Lambert")
TWIN("singleScatterAlbedo")
TWIN("multipleScatterAlbedo")
TWIN("energyCompensation")
TWIN("evaluateBsdf")
TWIN("makeSpecularGlossinessSurface")
TWIN("irradianceAlbedo")
TWIN("sampleVisibleNormal")
TWIN("specularMeanDirection")
TWIN("f0FromIor")
TWIN("iorFromF0")
TWIN("F_Dielectric")
TWIN("F_Conductor")
TWIN("F_82Tint")
TWIN("Fd_Burley")
TWIN("Fd_Frostbite")
TWIN("Fd_OrenNayar")
TWIN("albedoFujii")
TWIN("Fd_Eon")
TWIN("Fd_CallOfDuty")
TWIN("D_Beckmann")
TWIN("D_Blinn")
TWIN("V_BeckmannCorrelated")
TWIN("V_SchlickGGX")
TWIN("V_SchlickRemapped")
TWIN("V_Cavity")
TWIN("albedoBurley")
TWIN("albedoFrostbite")
TWIN("albedoOrenNayar")
TWIN("albedoEon")
TWIN("albedoCallOfDuty")
TWIN("V_BeckmannRational")
TWIN("evaluateBsdf, Burley")
TWIN("evaluateBsdf, Frostbite")
TWIN("evaluateBsdf, Oren-Nayar")
TWIN("evaluateBsdf, EON")
TWIN("evaluateBsdf, Call of Duty")
TWIN("evaluateBsdf, exact Fresnel")
TWIN("evaluateBsdf, F82-tint")
TWIN("evaluateBsdf, Beckmann")
TWIN("evaluateBsdf, Blinn")
TWIN("evaluateBsdf, approximate masking")
TWIN("evaluateBsdf, V-cavities")
TWIN("evaluateBsdf, remapped masking")
TWIN("missingOnAverage")
TWIN("multipleScatterKullaConty")
TWIN("multipleShapeKullaConty")
TWIN("evaluateBsdf, single scattering")
TWIN("evaluateBsdf, Fdez-Aguera")
TWIN("evaluateBsdf, Kulla and Conty")
TWIN("evaluateBsdf, Turquin")
TWIN("irradianceAlbedo, single scattering")
TWIN("irradianceAlbedo, Fdez-Aguera")
TWIN("irradianceAlbedo, Kulla and Conty")
TWIN("irradianceAlbedo, Turquin")
TWIN("alphaFromAnisotropy")
TWIN("D_GGXAnisotropic")
TWIN("V_GGXAnisotropic")
TWIN("G1_GGXAnisotropic")
TWIN("sampleVisibleNormalAnisotropic")
TWIN("D_Charlie")
TWIN("Lambda_Charlie")
TWIN("V_Charlie")
TWIN("sheenScaling")
TWIN("sheenGainGuard")
TWIN("interferenceColor")
TWIN("F_ThinFilm")
TWIN("f0FromSchlick")
TWIN("refractedDirection")
TWIN("volumeTransmittance")
TWIN("dispersedIors")
TWIN("transmissionRoughness")
TWIN("F_Coat")
TWIN("coatLobe")
TWIN("layerTransmittance")
TWIN("evaluateBsdf of all layers")
TWIN("evaluateBsdf of all layers, Burley, exact Fresnel")
TWIN("evaluateBsdf of all layers, Kulla and Conty")
TWIN("dfgAnisotropic")
TWIN("dfgAnisotropic, against the integral")
TWIN("transmittedAlpha")
TWIN("transmittedLobe")
TWIN("behindVariance")
TWIN("findBehindLevel")
TWIN("sampleGgx")
TWIN("sampleGgx, anisotropic")
TWIN("sampleCoat")
TWIN("sampleCosine")
TWIN("sampleSheen")
TWIN("sampleTransmitted")
TWIN("sampleRefraction")
TWIN("ggxValue")
TWIN("ggxDensity")
TWIN("ggxValue, anisotropic")
TWIN("ggxDensity, anisotropic")
TWIN("cosineDensity")
TWIN("sheenDensity")
TWIN("transmittedDensity")
TWIN("refractionDensity")
TWIN("refractionValue")
TWIN("sampleProxy, pdfProxy")
TWIN("sampleBsdf, bsdfDensity")
TWIN("owenSobol2")
TWIN("pixelSeed")
TWIN("spiralPoint")
TWIN("distanceAttenuation")
TWIN("coneAttenuation")
TWIN("luminance")
TWIN("displayed")
TWIN("displayedLuminance")
TWIN("falseColor")
TWIN("encodeSrgb")
TWIN("toneMap")
TWIN("toneReinhard")
TWIN("toneReinhardPower")
TWIN("toneUncharted2")
TWIN("toneAces")
TWIN("toneAgx")
TWIN("toneNeutral")
TWIN("equirectFromDirection")
TWIN("directionFromCube")
TWIN("cubeSolidAngleDensity")
TWIN("cubeTexelSolidAngle")
TWIN("alphaOfDisc")
TWIN("directionInDisc")
TWIN("frameAround")
TWIN("findLdLayer")
TWIN("spreadCosine")
TWIN("spreadZonalKernel")
TWIN("openArc")
TWIN("interreflection")
TWIN("arcTangent")
TWIN("halfDifference")
TWIN("merlPosition")
TWIN("utiaPosition")
TWIN("heldAxis, wrappedAxis")
TWIN("lookUpMeasured, MERL")
TWIN("lookUpMeasured, MERL, nearest")
TWIN("lookUpMeasured, UTIA")
TWIN("lookUpMeasured, UTIA, nearest")
TWIN("lookUpDfg")
TWIN("lookUpSheenAlbedo")
TWIN("lookUpTap, 1 of 1")
TWIN("lookUpTap, 2 of 2")
TWIN("lookUpTap, 3 of 3")

TEST_CASE("Twin: the cases above are the whole table") { CHECK(selftest::numericalChecks().size() == 153); }

TEST_CASE("A check sees a wrong function, and counts what is not finite") {
  selftest::Check check{
      "square", {{"constants.glsl"}, "out0.x = in0.x > 2.0 ? in0.x / in0.y : in0.x * in0.x;"}, {"x"}, {}};
  check.inputs = {{1, 0, 0, 0}, {2, 0, 0, 0}};
  check.twin = [](selftest::CheckVectors in) { return selftest::CheckValues{in[0].x * in[0].x}; };
  check.tolerance = 1e-6;
  const auto run = [&] { return selftest::runCheck(check, shading::shaderReader()); };
  CHECK(run()->passed);
  check.inputs.emplace_back(3, 0, 0, 0);  // 3 / 0
  const auto infinite = run();
  CHECK_FALSE(infinite->passed);
  CHECK(infinite->nonFinite == 1);
  CHECK(infinite->firstNonFinite == "x 3");
  check.inputs.back() = {3, 1, 0, 0};  // 3 in place of 9
  const auto wrong = run();
  CHECK_FALSE(wrong->passed);
  CHECK(wrong->nonFinite == 0);
  CHECK(wrong->error == Approx(6.0 / 9));
  CHECK(wrong->input == "x 3");
  check.conditioning = [](selftest::CheckVectors in) { return in[0].x == 3 ? 1e6 : 1.0; };
  CHECK(run()->passed);
}

TEST_CASE("facet selftest: table, JSON, exit status") {
  const test::Outcome table = test::runFacet({"selftest"});
  INFO(table.text);
  CHECK(table.status == 0);
  CHECK_THAT(table.text, Catch::Contains("D_GGX") && Catch::Contains("165 checks, 0 failed"));
  const auto json = nlohmann::json::parse(test::runFacet({"--log-level", "error", "selftest", "--json"}).text);
  CHECK(test::schemaProblems(json, "selftest") == "");
  CHECK(json["passed"] == true);
  CHECK(json["checks"].size() == 165);
  CHECK(json["checks"][0]["function"] == "D_GGX");
  CHECK(json["checks"][0]["source"] == nlohmann::json({"Walter2007", "Trowbridge1975"}));
  CHECK(json["checks"].back()["source"].is_null());
  CHECK_THAT(table.text, Catch::Contains("Walter2007, Trowbridge1975 ") && Catch::Contains(" facet "));
  CHECK_THAT(table.text, Catch::Contains("functions of the shaders") && Catch::Contains("Not held are:") &&
                             Catch::Contains("passes/picture_error.comp.glsl: displayedPart pixelErrors main"));
  for (const auto& entry : json["functions"])
    CHECK((entry["check"].is_string() ? entry.contains("through") : entry["reason"] != ""));

  // A folder with one broken chunk: the failure is named and the exit status says so.
  const test::TemporaryFolder folder;
  const auto copied = std::filesystem::copy_options::recursive;
  std::filesystem::copy(std::string(FACET_SOURCE_DIR) + "/shaders", folder.file("shaders"), copied);
  std::stringstream chunk;
  chunk << std::ifstream(folder.file("shaders/diffuse.glsl")).rdbuf();
  std::string text = chunk.str();
  const std::string lambert = "float Fd_Lambert() { return 1.0 / PI; }";
  REQUIRE(text.find(lambert) != std::string::npos);
  text.replace(text.find(lambert), lambert.size(), "float Fd_Lambert() { return 1.0; }");
  folder.write("shaders/diffuse.glsl", text);
  const test::Outcome broken = test::runFacet({"selftest", "--shader-dir", folder.file("shaders")});
  CHECK(broken.status == 1);
  CHECK_THAT(broken.text, Catch::Contains("Fd_Lambert failed: got 1, expected 0.31831"));
}
