#include "report/catalogue.hpp"

#include <string>

#include "optics/presets.hpp"
#include "optics/synthetic_brdf.hpp"
#include "scene/builtin_environments.hpp"
#include "scene/builtin_scenes.hpp"

namespace facet::report {

std::vector<Table> presetTables() {
  Table metals{
      .name = "metals",
      .title = "Metals by name",
      .note =
          "Complex index of refraction eta + i k at three wavelengths that stand for red, green and blue; "
          "reflectance facing (f0) and at a cosine of 1/7 (f82), linear Rec. 709 without spectral integration. "
          "A metal whose material is named so is drawn with it by --fresnel exact or f82.",
      .columns = {"name", "f0 red", "f0 green", "f0 blue", "f82 red", "f82 green", "f82 blue", "eta red", "eta green",
                  "eta blue", "k red", "k green", "k blue", "red [nm]", "green [nm]", "blue [nm]", "source"},
      .rows = {}};
  for (const optics::MetalPreset& m : optics::metalPresets()) {
    const glm::dvec3 f0 = m.f0(), f82 = m.f82();
    metals.rows.push_back({std::string(m.name), f0.x, f0.y, f0.z, f82.x, f82.y, f82.z, m.eta.x, m.eta.y, m.eta.z, m.k.x,
                           m.k.y, m.k.z, m.wavelengthNm.x, m.wavelengthNm.y, m.wavelengthNm.z, std::string(m.source)});
  }
  Table dielectrics{.name = "dielectrics",
                    .title = "Dielectrics by name",
                    .note =
                        "Index of refraction at 587.6 or 589.3 nm, reflectance facing, Abbe number and "
                        "KHR_materials_dispersion's 20 / Abbe where it is known.",
                    .columns = {"name", "ior", "f0", "Abbe number", "dispersion", "source"},
                    .rows = {}};
  for (const optics::DielectricPreset& d : optics::dielectricPresets()) {
    const auto known = [&](double value) { return d.abbe > 0 ? Cell(value) : Cell(std::string()); };
    dielectrics.rows.push_back(
        {std::string(d.name), d.ior, d.f0(), known(d.abbe), known(d.dispersion()), std::string(d.source)});
  }
  return {std::move(metals), std::move(dielectrics)};
}

std::vector<Table> builtinTables() {
  Table scenes{.name = "scenes",
               .title = "Built-in scenes",
               .note = "For MODEL; each with the environment that it is made for.",
               .columns = {"name", "environment", "what it shows"},
               .rows = {}};
  for (const scene::BuiltinScene& s : scene::builtinScenes())
    scenes.rows.push_back({"builtin:" + std::string(s.name), std::string(s.environment), std::string(s.description)});
  Table environments{.name = "environments",
                     .title = "Built-in environments",
                     .note = "For --env.",
                     .columns = {"name", "what it is"},
                     .rows = {}};
  for (const scene::BuiltinEnvironment& e : scene::builtinEnvironments())
    environments.rows.push_back({"builtin:" + std::string(e.name), std::string(e.description)});
  Table brdfs{.name = "brdfs",
              .title = "Built-in BRDFs",
              .note = "For --brdf; facet brdf lists those that are found as files, too.",
              .columns = {"name", "what it is"},
              .rows = {}};
  for (const optics::SyntheticBrdf& b : optics::syntheticBrdfs())
    brdfs.rows.push_back({"builtin:" + std::string(b.name), std::string(b.summary)});
  return {std::move(scenes), std::move(environments), std::move(brdfs)};
}

}  // namespace facet::report
