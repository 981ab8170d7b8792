#pragma once

// Error against run time of image-based light, measured on this machine under one environment: the topic "light" of
// `facet report`. Truth is optics/reference.hpp for tables and lobes, and the converged picture for pictures.

#include "report/topics.hpp"

namespace facet::report {

Result<Report> lightReport(const ReportInput& input);

// Its parts. The tables by each method: cube, irradiance, layers, their spacing, DFG.
Result<Report> lightTables(const ReportInput& input);
// The specular look-up by each run-time model against the integral over the environment.
Result<Report> lightLobes(const ReportInput& input);
// A picture of the model by each run-time model and number of samples, against the converged one.
Result<Report> lightPictures(const ReportInput& input);

}  // namespace facet::report
