#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>

#include "report/energy.hpp"
#include "support/gpu.hpp"

using namespace facet;
using optics::EnergyModel;

namespace {

ibl::Tables dfgTable(int size) {
  shading::ProgramStore programs = test::makeProgramStore();
  ibl::Tables tables;
  REQUIRE(ibl::computeTables(tables, nullptr, {.dfg = true}, programs, {.dfgSize = size}));
  return tables;
}

}  // namespace

TEST_CASE("White furnace with the GPU's table: distant light within 0.001, lights within 0.005, by energy model") {
  constexpr struct {
    const char* name;
    EnergyModel model;
  } models[] = {{"automatic", EnergyModel::automatic},
                {"none", EnergyModel::none},
                {"Fdez-Aguera", EnergyModel::fdezAguera},
                {"Kulla and Conty", EnergyModel::kullaConty},
                {"Turquin", EnergyModel::turquin}};
  const ibl::Tables tables = dfgTable(ibl::Method{}.dfgSize);
  for (const auto& [name, model] : models)
    for (const double metallic : {1.0, 0.0}) {
      const auto furnace = report::whiteFurnace(tables, shading::shaderReader(), model, metallic);
      REQUIRE(furnace);
      const auto& [distant, lights] = *furnace;
      std::printf("furnace, %-16s metallic %.0f: distant %.5f to %.5f, lights %.5f to %.5f\n", name, metallic,
                  distant.least, distant.most, lights.least, lights.most);
      INFO(name << ", metallic " << metallic);
      CHECK(distant.most < 1.001);
      CHECK(lights.most < 1.005);
      if (model == EnergyModel::none && metallic == 1) {
        CHECK(distant.least == Approx(1 - std::log(2.0)).margin(1e-3));
        CHECK(lights.least == Approx(1 - std::log(2.0)).margin(1e-5));
        continue;
      }
      CHECK(distant.least > 0.999);
      CHECK(lights.least > 0.995);
    }
}
