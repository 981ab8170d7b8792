#pragma once

// What is in measured BRDFs and how far models and grids are from them: `facet brdf`.

#include <vector>

#include "optics/measured_fit.hpp"
#include "report/plot.hpp"
#include "report/table.hpp"

namespace facet::report {

// A row each: kind, size, what is missing and how it was filled, range of the values.
Table measuredContents(const std::vector<optics::MeasuredBrdf>& brdfs);

// Rows of a table's directional albedo, by polar angle of V (azimuth 0): a row each with name, angle, red, green, blue,
// the share that is guessed, and a remark where one is above 1.01 or where values are extrapolated.
Table albedoTable();
void addAlbedoRows(Table& table, const optics::MeasuredBrdf& brdf, const optics::MeasuredProxy& proxy);

// f(V, L) against f(L, V) over 1e5 fixed pairs.
Table reciprocityTable();
void addReciprocityRow(Table& table, const optics::MeasuredBrdf& brdf);

// The sampling lobe.
Table proxyTable();
void addProxyRow(Table& table, const optics::MeasuredBrdf& brdf, const optics::MeasuredProxy& proxy);

// A synthetic table against its formula over 1e5 fixed pairs.
Table gridTable();
void addGridRow(Table& table, const optics::MeasuredBrdf& brdf, const optics::AnalyticBrdf& formula);

Table fitTable(optics::FitMetric metric);
void addFitRows(Table& table, const optics::MeasuredBrdf& brdf, const std::vector<optics::BrdfFit>& fits);

// The other lobes over the best diffuse model: optics::fitShapes.
Table fitShapesTable(optics::FitMetric metric);
void addFitShapeRows(Table& table, const optics::MeasuredBrdf& brdf, const std::vector<optics::BrdfFit>& shapes);

// Directional albedo of a fit beside the table's.
Table fitAlbedoTable();
void addFitAlbedoRows(Table& table, const optics::MeasuredBrdf& brdf, const optics::BrdfFit& fit);

// Three slices: theta_h, theta_d (both at phi_d = 90 degrees) and light in the plane of view at 45 degrees, f_r on a
// logarithmic axis, the zone past 75 degrees marked. Of one BRDF red, green and blue, and the best of the fits dashed;
// of several their luminance.
struct Slices {
  Plot thetaH, thetaD, inPlane;
};
Slices measuredSlices();
void addSlices(Slices& slices, const optics::MeasuredBrdf& brdf, bool byChannel, const optics::BrdfFit* fit);

}  // namespace facet::report
