#include "report/topics.hpp"

#include <algorithm>
#include <iterator>

#include "report/energy.hpp"
#include "report/estimate.hpp"
#include "report/frame_cost.hpp"
#include "report/light.hpp"
#include "report/measured_cost.hpp"
#include "report/methods.hpp"
#include "report/models.hpp"
#include "report/visibility.hpp"

namespace facet::report {

namespace {

template <std::vector<Table> (*tables)()>
Result<Report> computed(const ReportInput&) {
  return Report{tables(), {}};
}

constexpr Topic topics[] = {
    {"fresnel", "Schlick's approximation and F82-tint against Fresnel's equations", false, computed<fresnelTables>},
    {"diffuse", "energy of the diffuse models", false, computed<diffuseTables>},
    {"energy", "what rough lobes return: models of further bounces, for environment and lights", true, energyReport},
    {"estimate", "--max-error: what it states against true errors, its samples against the fewest that do", true,
     estimateReport},
    {"frame", "a frame: error and time of each way of reading slanted textures", true, frameReport},
    {"light", "image-based light: error against run time under --env", true, lightReport},
    {"measured", "measured BRDFs: error against run time of samples and formats, look-ups against formulas", true,
     measuredReport},
    {"methods", "what --max-error chooses from: error and cost of each table's methods", true, methodsReport},
    {"ndf", "shadowing terms and energy of GGX, Beckmann and Blinn", false, computed<ndfTables>},
    {"visibility", "shadows and interreflection: each way of light against converged paths", true, visibilityReport},
};

}  // namespace

Result<Report> joined(std::span<const ReportPart> parts, const ReportInput& input) {
  Report report;
  for (const ReportPart part : parts) {
    Result<Report> made = part(input);
    if (!made) return made;
    std::ranges::move(made->tables, std::back_inserter(report.tables));
    std::ranges::move(made->plots, std::back_inserter(report.plots));
  }
  return report;
}

std::span<const Topic> reportTopics() { return topics; }

}  // namespace facet::report
