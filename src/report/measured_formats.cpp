// What a cell of a measured BRDF is stored as, and what its look-up on the GPU is off by.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "frame/measured_gpu.hpp"
#include "gl/buffer.hpp"
#include "layout.h"
#include "optics/synthetic_brdf.hpp"
#include "report/measured_cost.hpp"
#include "selftest/shader_probe.hpp"

namespace facet::report {

namespace {

using optics::LookUp;
using optics::MeasuredBrdf;

constexpr int timedRuns = 25;
constexpr size_t timedPairs = 40000;

optics::MeasuredBrdf synthetic(const optics::SyntheticBrdf& row) {
  return optics::makeMeasured(row.formula, row.kind, row.name);
}

// Where an array of the cells comes after the head.
template <class T>
gl::Buffer bufferOf(const MeasuredBrdf& brdf, float scale, const std::vector<T>& cells) {
  layout::MeasuredUniforms head{};
  head.table = glm::vec4(1, scale, brdf.phiSteps, 0);
  std::vector<std::byte> bytes(sizeof head + cells.size() * sizeof(T));
  std::memcpy(bytes.data(), &head, sizeof head);
  std::memcpy(bytes.data() + sizeof head, cells.data(), cells.size() * sizeof(T));
  return gl::Buffer(bytes, "measured BRDF");
}

struct Stored {
  MeasuredBrdf values;  // as they come back
  gl::Buffer buffer;
};

struct Format {
  const char* name;
  const char* define;  // of measured_table.glsl; empty: what pictures have
  double bytes;        // of a cell
  Stored (*store)(const MeasuredBrdf&);
};

Stored storeHalves(const MeasuredBrdf& brdf) {
  const std::vector<glm::uvec2> cells = frame::packMeasured(brdf);
  return {frame::unpackMeasured(cells, brdf), bufferOf(brdf, 1, cells)};
}
Stored storeThreeFloats(const MeasuredBrdf& brdf) { return {brdf, bufferOf(brdf, 1, brdf.values)}; }
Stored storeFourFloats(const MeasuredBrdf& brdf) {
  std::vector<glm::vec4> cells;
  for (const glm::vec3& v : brdf.values) cells.emplace_back(v, 0);
  return {brdf, bufferOf(brdf, 1, cells)};
}
// In a unit that puts the largest value at 2^14 to 2^15: RGB9_E5 ends at 65408.
Stored storeSharedExponent(const MeasuredBrdf& brdf) {
  constexpr uint32_t missing = 0xffffffff;
  float largest = 1e-30f;
  for (const glm::vec3& v : brdf.values) largest = std::max({largest, v.x, v.y, v.z});
  const float scale = std::ldexp(1.0f, std::ilogb(largest) - 14);
  Stored stored{brdf, {}};
  std::vector<uint32_t> cells;
  for (glm::vec3& v : stored.values.values) {
    cells.push_back(v.x < 0 ? missing : glm::packF3x9_E1x5(v / scale));
    if (v.x >= 0) v = scale * glm::unpackF3x9_E1x5(cells.back());
  }
  stored.buffer = bufferOf(brdf, scale, cells);
  return stored;
}

constexpr Format formats[] = {{"three halves and a unit (default)", "", 8, storeHalves},
                              {"three floats", "MEASURED_THREE_FLOATS", 12, storeThreeFloats},
                              {"four floats", "MEASURED_FOUR_FLOATS", 16, storeFourFloats},
                              {"shared exponent (RGB9_E5)", "MEASURED_SHARED_EXPONENT", 4, storeSharedExponent}};

std::vector<glm::vec4> inputsOf(const std::vector<optics::Directions>& pairs) {
  std::vector<glm::vec4> inputs;
  for (const optics::Directions& pair : pairs) {
    inputs.emplace_back(glm::vec3(pair.V), 0);
    inputs.emplace_back(glm::vec3(pair.L), 0);
  }
  return inputs;
}

selftest::Probe lookUpProbe(const MeasuredBrdf& brdf, LookUp lookUp, const char* formatDefine) {
  selftest::Probe probe{{"measured_table.glsl"}, "out0.xyz = measuredBrdf(in0.xyz, in1.xyz);", 2, 1};
  probe.defines = {{brdf.kind == optics::MeasuredKind::merl ? "MERL_BRDF" : "UTIA_BRDF"}};
  if (*formatDefine != 0) probe.defines.push_back({formatDefine});
  if (lookUp == LookUp::nearest) probe.defines.push_back({"MEASURED_NEAREST"});
  return probe;
}

// Of the valid cells' values: by channel, and of a cell's largest channel.
struct StorageError {
  double rms = 0, largest = 0, largestOfCell = 0;
};
StorageError storageError(const MeasuredBrdf& truth, const MeasuredBrdf& stored) {
  StorageError e;
  double count = 0;
  for (size_t i = 0; i < truth.values.size(); ++i) {
    const glm::dvec3 value(truth.values[i]), off = glm::abs(glm::dvec3(stored.values[i]) - value);
    if (value.x < 0) continue;
    const double most = std::max({value.x, value.y, value.z});
    for (int c = 0; c < 3; ++c) {
      if (value[c] <= 0) continue;
      const double relative = off[c] / value[c];
      e.rms += relative * relative, ++count;
      e.largest = std::max(e.largest, relative);
      e.largestOfCell = std::max(e.largestOfCell, off[c] / most);
    }
  }
  e.rms = std::sqrt(e.rms / std::max(count, 1.0));
  return e;
}

// One core, double precision [ns a look-up].
double timeOnCpu(const MeasuredBrdf& brdf, LookUp lookUp, const std::vector<optics::Directions>& pairs) {
  glm::dvec3 sum(0);
  const auto start = std::chrono::steady_clock::now();
  for (const optics::Directions& pair : pairs) sum += optics::measuredBrdf(brdf, pair.V, pair.L, lookUp);
  const double ns = std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
  return sum.x >= 0 ? ns / static_cast<double>(pairs.size()) : 0;  // the sum is read, so that it is made
}

}  // namespace

Result<LookUpErrors> lookUpErrors(const MeasuredBrdf& brdf, const optics::AnalyticBrdf& formula, LookUp lookUp,
                                  const std::vector<optics::Directions>& pairs, const shading::ShaderReader& reader) {
  const auto onGpu = frame::uploadMeasured(brdf);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::measuredBinding, onGpu->buffer.id());
  const std::vector<glm::vec4> inputs = inputsOf(pairs);
  const auto got = selftest::runProbe(lookUpProbe(brdf, lookUp, ""), inputs, reader);
  if (!got) return tl::unexpected(got.error());
  double arithmetic = 0, grid = 0, total = 0;
  size_t elsewhere = 0;
  for (size_t i = 0; i < pairs.size(); ++i) {
    // The directions that the GPU has.
    const glm::dvec3 V(inputs[2 * i]), L(inputs[2 * i + 1]), gpu((*got)[i]);
    const glm::dvec3 f = optics::analyticBrdf(formula, V, L), table = optics::measuredBrdf(brdf, V, L, lookUp);
    const auto square = [](const glm::dvec3& d) { return glm::dot(d, d) / 3; };
    grid += square((table - f) / f);
    total += square((gpu - f) / f);
    const double off = square((gpu - table) / table);
    if (lookUp == LookUp::nearest && off > 1e-6)
      ++elsewhere;
    else
      arithmetic += off;
  }
  const auto count = static_cast<double>(pairs.size());
  return LookUpErrors{std::sqrt(grid / count), std::sqrt(arithmetic / count), std::sqrt(total / count),
                      static_cast<double>(elsewhere) / count};
}

Result<Report> measuredLookUps(const ReportInput& input) {
  Table table{"measured-look-ups",
              "Look-ups on the GPU against the formula that the table was made of",
              "Root mean square of the relative error over 1e5 fixed pairs within 75 degrees. Grid: double look-up "
              "against the formula. Arithmetic: GPU against double look-up, halves included; of nearest look-ups "
              "without the pairs for which rounding chose the next cell, whose share is beside it.",
              {"database", "look-up", "grid", "arithmetic", "next cell", "both"},
              {}};
  const std::vector<optics::Directions> pairs = optics::testPairs();
  for (const optics::SyntheticBrdf& row : optics::syntheticBrdfs()) {
    input.progress("measured: look-ups of " + std::string(row.name));
    const MeasuredBrdf brdf = synthetic(row);
    for (const LookUp lookUp : {LookUp::interpolated, LookUp::nearest}) {
      const auto e = lookUpErrors(brdf, row.formula, lookUp, pairs, shading::shaderReader(input.shaderDir));
      if (!e) return tl::unexpected(e.error());
      table.rows.push_back({std::string(row.name), std::string(lookUp == LookUp::nearest ? "nearest" : "interpolated"),
                            e->grid, e->arithmetic, e->nextCell, e->total});
    }
  }
  return Report{{table}, {}};
}

Result<Report> measuredFormats(const ReportInput& input) {
  Table table{"measured-formats",
              "What a cell is stored as",
              "Relative error of the stored values: root mean square and largest by channel, and largest of a cell's "
              "largest channel. ns: of a look-up, least of " +
                  std::to_string(timedRuns) + " runs of a compute shader over " + std::to_string(timedPairs) +
                  " fixed pairs; double precision: one core.",
              {"database", "format", "bytes a cell", "MB", "RMS", "largest", "largest of the cell", "ns, interpolated",
               "ns, nearest"},
              {}};
  const std::vector<optics::Directions> pairs = optics::testPairs(timedPairs);
  const std::vector<glm::vec4> inputs = inputsOf(pairs);
  for (const char* name : {"lambert", "plastic-0.2", "ggx-0.1", "ggx-0.35", "utia-brushed", "utia-satin"}) {
    input.progress(std::string("measured: formats of ") + name);
    const MeasuredBrdf brdf = synthetic(*optics::findSynthetic(name));
    const auto cells = static_cast<double>(brdf.values.size());
    table.rows.push_back({std::string(name), std::string("double look-up, CPU"), 12.0, cells * 12e-6, 0.0, 0.0, 0.0,
                          timeOnCpu(brdf, LookUp::interpolated, pairs), timeOnCpu(brdf, LookUp::nearest, pairs)});
    for (size_t f = 0; f < std::size(formats); ++f) {
      const Stored stored = formats[f].store(brdf);
      glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::measuredBinding, stored.buffer.id());
      double ns[2];
      for (const LookUp lookUp : {LookUp::interpolated, LookUp::nearest}) {
        const auto run = selftest::timeProbe(lookUpProbe(brdf, lookUp, formats[f].define), inputs,
                                             shading::shaderReader(input.shaderDir), timedRuns);
        if (!run) return tl::unexpected(run.error());
        ns[lookUp == LookUp::nearest] = run->milliseconds * 1e6 / static_cast<double>(pairs.size());
      }
      const StorageError e = storageError(brdf, stored.values);
      table.rows.push_back({std::string(name), std::string(formats[f].name), formats[f].bytes,
                            cells * formats[f].bytes * 1e-6, e.rms, e.largest, e.largestOfCell, ns[0], ns[1]});
    }
  }
  return Report{{table}, {}};
}

}  // namespace facet::report
