#include "commands/render_statistics.hpp"

#include <algorithm>

#include "base/huge_pages.hpp"
#include "base/origin_json.hpp"
#include "commands/notes_json.hpp"
#include "commands/picture_output.hpp"
#include "frame/left_out.hpp"
#include "frame/max_error.hpp"

namespace facet::commands {

namespace {

// Median of those after the first, which pays for what is done once.
double steadyMs(const std::vector<double>& ms) {
  std::vector<double> steady(ms.begin() + 1, ms.end());
  std::ranges::sort(steady);
  return (steady[(steady.size() - 1) / 2] + steady[steady.size() / 2]) / 2;
}

}  // namespace

nlohmann::ordered_json statisticsJson(const Job& job, const frame::Session& session, const frame::Picture& picture,
                                      const Stages& stages, const Notes& notes, const Confined& confined) {
  using Json = nlohmann::ordered_json;
  const frame::PictureStatistics& s = picture.statistics;
  Json out;
  Origin origin = pictureOrigin(job, session);
  origin.date = originOfProcess().date;
  out["origin"] = originJson(origin);
  out["model"] = job.model;
  out["environment"] = session.environmentName();
  out["command"] = options::commandLine(job.settings, job.model, job.output.string());
  out["opengl"] = {{"platform", session.context().platform},
                   {"renderer", session.context().renderer},
                   {"version", session.context().version}};
  Json times = Json::object();
  for (const Stage& stage : stages.all())
    times[stage.name] = {{"wallMs", stage.wallMs}, {"cpuMs", stage.cpuMs}, {"peakMB", stage.peakMB}};
  out["stages"] = times;
  out["frameMs"] = s.frameMs;
  if (!s.attempts.empty()) {
    Json attempts = Json::array();
    for (const frame::Attempt& a : s.attempts)
      attempts.push_back({{"samples", a.samples},
                          {"likely", a.error.likely / 255},
                          {"most", a.error.most / 255},
                          {"ms", a.milliseconds}});
    out["error"] = {{"wanted", *job.settings.quality.maxError},   {"likely", s.attempts.back().error.likely / 255},
                    {"most", s.attempts.back().error.most / 255}, {"confidence", frame::errorConfidence},
                    {"samples", s.attempts.back().samples},       {"attempts", attempts}};
  }
  if (s.frameMs.size() > 1) out["steadyFrameMs"] = steadyMs(s.frameMs);
  out["peakMemoryMB"] = Stages::peakMegabytes();
  out["hugePages"] = hugePagesHere();
  out["gpuBytes"] = {{"textures", s.textureBytes},
                     {"geometry", s.geometryBytes},
                     {"tables", s.tableBytes},
                     {"targets", s.targetBytes}};
  out["imagesDecoded"] = s.imagesDecoded;
  out["programs"] = {{"compiled", s.programsCompiled}, {"fromDiskCache", s.programsFromDisk}};
  Json variants = Json::array();
  for (const auto& [name, draws] : s.variants) variants.push_back({{"name", name}, {"draws", draws}});
  out["variants"] = variants;
  Json tables = Json::array();
  for (const ibl::TableStatistics& table : s.tables)
    tables.push_back({{"name", table.name},
                      {"bytes", table.bytes},
                      {"fetches", table.fetches},
                      {"ms", table.milliseconds},
                      {"gpuMs", table.gpuMilliseconds}});
  out["tables"] = tables;
  if (job.settings.quality.maxError) {
    Json methods = Json::object();
    constexpr const char* parts[] = {"irradiance", "layers", "dfg"};
    for (const ibl::Candidate* chosen : s.methods)
      methods[parts[static_cast<size_t>(chosen->part)]] = {{"method", chosen->name}, {"error", chosen->error}};
    out["methods"] = methods;
  }
  const frame::TextureFilter filter =
      frame::chooseTextureFilter(job.settings.quality.textureFilter, gl::drawsBySoftware());
  out["textureFilter"] = rowOf(frame::textureFilters, filter).word;
  out["frame"] = {{"passes", s.frame.passes},
                  {"bands", s.bands},
                  {"draws", s.frame.draws},
                  {"instances", s.frame.instances},
                  {"triangles", s.frame.triangles}};
  if (!s.passTimes.empty()) {
    Json passes = Json::array();
    for (const frame::PassTime& pass : s.passTimes)
      passes.push_back({{"name", pass.name}, {"startMs", pass.startMs}, {"gpuMs", pass.gpuMs}, {"runs", pass.runs}});
    out["passTimes"] = passes;
  }
  if (s.gridSpacing) out["overlay"] = {{"gridSpacing", *s.gridSpacing}};
  if (s.range)
    out["range"] = {{"channel", job.settings.look.channel.empty() ? "radiance" : job.settings.look.channel},
                    {"from", s.range->range.from},
                    {"to", s.range->range.to},
                    {"unit", s.range->unit},
                    {"logarithmic", s.range->range.logarithmic}};
  out["visibility"] = {{"method", s.visibility.method}, {"why", s.visibility.why}};
  if (s.traced)
    out["paths"] = {{"bounces", job.settings.quality.bounces},
                    {"rays", s.frame.rays},
                    {"triangles", s.traced->triangles},
                    {"bytes", s.traced->bytes},
                    {"treesMs", s.traced->buildMs}};
  if (s.ground)
    out["ground"] = {{"points", s.ground->size * s.ground->size},
                     {"samples", s.ground->samples},
                     {"rays", s.ground->rays},
                     {"ms", s.ground->milliseconds}};
  if (s.comparison)
    out["brdfComparison"] = {
        {"rms", s.comparison->rms}, {"share", s.comparison->share}, {"largest", s.comparison->largest}};
  if (job.format == io::PictureFormat::exr)
    out["pixels"] = {{"fullyClamped", s.clampedPixels}, {"nonFinite", s.nonFinitePixels}};
  out["leftOut"] = frame::leftOut(session.model()->model, s);
  out["sandbox"] = {{"files", confined.files}, {"calls", confined.calls}};
  out["notes"] = notesJson(notes);
  return out;
}

nlohmann::ordered_json filmJson(double fps, const std::vector<double>& pictureMs) {
  nlohmann::ordered_json out = {{"pictures", pictureMs.size()},
                                {"fps", fps},
                                {"seconds", static_cast<double>(pictureMs.size()) / fps},
                                {"pictureMs", pictureMs}};
  if (pictureMs.size() > 1) out["steadyPictureMs"] = steadyMs(pictureMs);
  return out;
}

}  // namespace facet::commands
