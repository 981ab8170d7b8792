#include "report/topics.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>

#include "base/text.hpp"
#include "report/energy.hpp"
#include "report/estimate.hpp"
#include "report/frame_cost.hpp"
#include "report/light.hpp"
#include "report/measured_cost.hpp"
#include "report/methods.hpp"
#include "report/model_plots.hpp"
#include "report/models.hpp"
#include "report/sampling.hpp"
#include "report/visibility.hpp"

namespace facet::report {

namespace {

template <std::vector<Table> (*tables)(), std::vector<NamedPlot> (*plots)()>
Result<Report> computed(const ReportInput&) {
  return Report{tables(), plots()};
}

constexpr const char* spheres = "builtin:spheres";

constexpr Topic topics[] = {
    {"fresnel", "Schlick's approximation and F82-tint against Fresnel's equations", false,
     computed<fresnelTables, fresnelPlots>, "fresnel-dielectric fresnel-metal"},
    {"diffuse", "energy of the diffuse models", false, computed<diffuseTables, diffusePlots>, "diffuse"},
    {"energy", "what rough lobes return: models of further bounces, for environment and lights", true, energyReport,
     "energy-furnace energy-metal energy-pictures", spheres},
    {"estimate", "--max-error: what it states against true errors, its samples against the fewest that do", true,
     estimateReport, "estimate estimate-samples", spheres},
    {"frame", "a frame: error and time of each way of reading slanted textures", true, frameReport, "frame-textures",
     "builtin:marbles"},
    {"light", "image-based light: error against run time under --env", true, lightReport,
     "light-cube light-irradiance light-ld light-spacing light-dfg light-lobes light-pictures", spheres},
    {"measured", "measured BRDFs: error against run time of samples and formats, look-ups against formulas", true,
     measuredReport, "measured-look-ups measured-formats measured-samples"},
    {"methods", "what --max-error chooses from: error and cost of each table's methods", true, methodsReport,
     "methods"},
    {"ndf", "shadowing terms and energy of GGX, Beckmann and Blinn", false, computed<ndfTables, ndfPlots>,
     "masking lobes"},
    {"sampling",
     "integrals by sums over points, from chance to Owen-scrambled: error against samples, discrepancy",
     false,
     samplingReport,
     "sampling sampling-discrepancy",
     {},
     true},
    {"visibility", "shadows and interreflection: each way of light against converged paths", true, visibilityReport,
     "visibility", "builtin:poster"},
};

}  // namespace

void append(Report& report, Report more) {
  std::ranges::move(more.tables, std::back_inserter(report.tables));
  std::ranges::move(more.plots, std::back_inserter(report.plots));
}

Result<Report> joined(std::span<const ReportPart> parts, const ReportInput& input) {
  Report report;
  for (const ReportPart part : parts) {
    Result<Report> made = part(input);
    if (!made) return made;
    append(report, std::move(*made));
  }
  return report;
}

bool makesTable(const Topic& topic, std::string_view table) {
  return std::ranges::count(split(topic.tables, ' '), table) == 1;
}

Result<Report> reportOf(std::span<const Topic* const> topics, const ReportInput& input) {
  Report report;
  size_t measured = 0;
  for (const Topic* topic : topics) {
    ReportInput own = input;
    if (own.model.empty()) own.model = topic->usualModel;
    Result<Report> made = topic->make(own);
    if (!made) return made;
    for ([[maybe_unused]] const Table& table : made->tables) assert(makesTable(*topic, table.name));
    append(report, std::move(*made));
    input.measured(++measured, topics.size());
  }
  return report;
}

std::span<const Topic> reportTopics() { return topics; }

}  // namespace facet::report
