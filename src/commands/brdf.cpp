#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "base/log.hpp"
#include "base/nearest.hpp"
#include "base/text.hpp"
#include "commands/commands.hpp"
#include "commands/confine.hpp"
#include "commands/json_file.hpp"
#include "commands/write_tables.hpp"
#include "io/measured.hpp"
#include "io/merl.hpp"
#include "report/lobe_views.hpp"
#include "report/measured.hpp"

namespace facet::commands {

namespace {

namespace fs = std::filesystem;

struct BrdfArguments {
  std::vector<std::string> files, eval;
  std::string brdfDir, format, table, plot, metric = "log", utiaDecode = "raw", synthesize, output, evalFrom, lobes;
  bool fit = false, slices = false, noSandbox = false;
};

constexpr std::string_view metricNames[] = {"log", "cuberoot"};

struct Choices {
  TableFormat format;
  optics::FitMetric metric;
  io::MeasuredOptions reading;
  std::vector<report::EvalPoint> eval;
};

Result<std::vector<report::EvalPoint>> evalPoints(const BrdfArguments& arguments) {
  std::vector<report::EvalPoint> points;
  for (const std::string& text : arguments.eval) {
    const Result<report::EvalPoint> point = report::parseEvalPoint(text);
    if (!point) return fail({}, "--eval", point.error().problem, point.error().remedy);
    points.push_back(*point);
  }
  if (arguments.evalFrom.empty()) return points;
  const Result<std::string> text = readJsonText(arguments.evalFrom);
  if (!text) return tl::unexpected(text.error());
  Result<std::vector<report::EvalPoint>> more = report::parseEvalPoints(*text, arguments.evalFrom);
  if (!more) return more;
  points.insert(points.end(), more->begin(), more->end());
  return points;
}

Result<Choices> choicesOf(const BrdfArguments& arguments) {
  const Result<TableFormat> format = tableFormat(arguments.format);
  if (!format) return tl::unexpected(format.error());
  const auto metric = std::find(std::begin(metricNames), std::end(metricNames), arguments.metric);
  if (metric == std::end(metricNames))
    return fail({}, "--metric", inQuotes(arguments.metric) + " is not known",
                suggestion(arguments.metric, metricNames));
  const Result<io::UtiaDecode> decode = io::parseUtiaDecode(arguments.utiaDecode);
  if (!decode) return fail({}, "--utia-decode", decode.error().problem, decode.error().remedy);
  Result<std::vector<report::EvalPoint>> eval = evalPoints(arguments);
  if (!eval) return tl::unexpected(eval.error());
  return Choices{*format,
                 metric == std::begin(metricNames) ? optics::FitMetric::log : optics::FitMetric::cubeRoot,
                 {.utiaDecode = *decode},
                 std::move(*eval)};
}

int synthesize(const BrdfArguments& arguments) {
  if (arguments.output.empty()) return badInput({{}, "--synthesize", "where to write it is not said", "give -o FILE"});
  const Result<optics::MeasuredBrdf> brdf = io::readMeasured("builtin:" + arguments.synthesize);
  if (!brdf) return badInput(brdf.error());
  const std::vector<uint8_t> bytes =
      brdf->kind == optics::MeasuredKind::merl ? io::encodeMerl(*brdf) : io::encodeUtia(*brdf);
  const Result<void> written = writeText(arguments.output, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  return written ? exitGood : badInput(written.error());
}

// What --brdf and this command take by name.
report::Table databases(const BrdfArguments& arguments) {
  report::Table table{.name = "databases",
                      .title = "Measured BRDFs that are found",
                      .note =
                          "Looked for in --brdf-dir, in resources/brdf/merl and resources/brdf/utia below the "
                          "working directory and beside the program, and in $XDG_DATA_HOME/facet/brdf.",
                      .columns = {"name", "kind", "where"},
                      .rows = {}};
  const auto kind = [](optics::MeasuredKind k) {
    return std::string(k == optics::MeasuredKind::merl ? "MERL" : "UTIA");
  };
  for (const io::MeasuredFile& file : io::findDatabases(arguments.brdfDir))
    table.rows.push_back({file.name, kind(file.kind), file.path.string()});
  for (const optics::SyntheticBrdf& brdf : optics::syntheticBrdfs())
    table.rows.push_back(
        {"builtin:" + std::string(brdf.name), kind(brdf.kind), "made from a formula: " + std::string(brdf.summary)});
  return table;
}

// Folders stand for the databases in them.
Result<std::vector<std::string>> expanded(const BrdfArguments& arguments) {
  std::vector<std::string> files;
  for (const std::string& given : arguments.files) {
    std::error_code error;
    if (fs::is_directory(given, error)) {
      const std::vector<io::MeasuredFile> found = io::findMeasured(given);
      if (found.empty())
        return fail(given, "", "holds no measured BRDF", "MERL's end in .binary, UTIA's in .bin; see facet brdf");
      for (const io::MeasuredFile& file : found) files.push_back(file.path.string());
      continue;
    }
    const Result<std::string> resolved = io::resolveMeasured(given, arguments.brdfDir);
    if (!resolved) return tl::unexpected(resolved.error());
    files.push_back(*resolved);
  }
  return files;
}

int print(const BrdfArguments& arguments, const Choices& choices, std::vector<report::Table> tables) {
  const Result<std::vector<report::Table>> chosen = chosenTables(std::move(tables), arguments.table);
  if (!chosen) return badInput(chosen.error());
  const Result<std::string> text = tablesText(choices.format, *chosen, originOfProcess());
  if (!text) return badInput(text.error());
  std::cout << *text << std::flush;
  return exitGood;
}

// How bright each way of reading makes a UTIA file: only one at most is right.
void addDecodings(report::Table& table, const std::string& file) {
  for (size_t i = 0; i < io::utiaDecodeNames().size(); ++i) {
    const auto brdf = io::readMeasured(file, {.utiaDecode = static_cast<io::UtiaDecode>(i)});
    if (!brdf) continue;
    const glm::dvec3 V(0.5, 0, std::sqrt(0.75));
    const glm::dvec3 albedo = optics::measuredAlbedo(*brdf, optics::fitProxy(*brdf), V, optics::LookUp::interpolated);
    const bool bright = std::max({albedo.x, albedo.y, albedo.z}) > 1.01;
    table.rows.push_back({brdf->name, std::string(io::utiaDecodeNames()[i]), albedo.x, albedo.y, albedo.z,
                          std::string(bright ? "more than comes" : "")});
  }
}

// "; two GGX come within 1.2 %", of the shape whose albedo is off least, where that is much less than GGX' and the rest
// fits no worse.
std::string closerShape(const std::vector<optics::BrdfFit>& shapes) {
  const optics::BrdfFit& ggx = shapes.front();
  const auto least = std::ranges::min_element(shapes, {}, &optics::BrdfFit::albedoError);
  if (least->albedoError > ggx.albedoError / 2 || least->misfit > ggx.misfit) return {};
  const bool several = least->model.shape == optics::LobeShape::twoGgx;
  char text[80];
  std::snprintf(text, sizeof text, "; %s %s within %.2g %%",
                std::string(rowOf(optics::lobeShapes, least->model.shape).label).c_str(), several ? "come" : "comes",
                100 * least->albedoError);
  return text;
}

// One BRDF after the other, so that a folder of them takes no more memory than one.
int describeAll(const BrdfArguments& arguments, const Choices& choices, const std::vector<std::string>& files) {
  report::Table contents = report::measuredContents({}), albedo = report::albedoTable(),
                reciprocity = report::reciprocityTable(), proxies = report::proxyTable(), grid = report::gridTable(),
                fits = report::fitTable(choices.metric), shapes = report::fitShapesTable(choices.metric),
                fitAlbedo = report::fitAlbedoTable(), eval = report::evalTable();
  std::vector<report::Plot> lobes;
  report::Table decodings{.name = "utia-decoding",
                          .title = "Albedo at 30 degrees by the way of reading UTIA's values (--utia-decode)",
                          .note = "",
                          .columns = {"name", "decoding", "red", "green", "blue", "remark"},
                          .rows = {}};
  report::Slices slices = report::measuredSlices();
  int status = exitGood;
  for (const std::string& file : files) {
    const Result<optics::MeasuredBrdf> brdf = io::readMeasured(file, choices.reading);
    if (!brdf) {
      status = badInput(brdf.error());
      continue;
    }
    // MERL's own missing cells are in the table; another grid is worth a line.
    for (const Note& note : io::measuredNotes(*brdf)) {
      if (note.severity == Note::Severity::warning) log::warning(file + ": " + note.text);
      if (note.severity == Note::Severity::info && brdf->phiSteps != optics::merlPhiSteps)
        log::info(file + ": " + note.text);
    }
    contents.rows.push_back(report::measuredContents({*brdf}).rows.front());
    const optics::MeasuredProxy proxy = optics::fitProxy(*brdf);
    report::addAlbedoRows(albedo, *brdf, proxy);
    report::addReciprocityRow(reciprocity, *brdf);
    report::addProxyRow(proxies, *brdf, proxy);
    const bool builtin = file.starts_with("builtin:");
    if (builtin) report::addGridRow(grid, *brdf, optics::findSynthetic(brdf->name)->formula);
    if (!builtin && brdf->kind == optics::MeasuredKind::utia) addDecodings(decodings, file);
    std::vector<optics::BrdfFit> fitted;
    if (arguments.fit) fitted = optics::fitAll(*brdf, choices.metric);
    const std::vector<bool> best = optics::bestFits(fitted);
    const auto first = std::ranges::find(best, true);
    const optics::BrdfFit* chosen = first == best.end() ? nullptr : &fitted[static_cast<size_t>(first - best.begin())];
    if (chosen) {
      report::addFitRows(fits, *brdf, fitted);
      report::addFitAlbedoRows(fitAlbedo, *brdf, *chosen);
      const std::vector<optics::BrdfFit> shaped = optics::fitShapes(*brdf, *chosen, choices.metric);
      report::addFitShapeRows(shapes, *brdf, shaped);
      if (const std::string remark = optics::albedoRemark(*chosen); !remark.empty())
        log::warning(file + ": of the best fit " + remark + ": GGX with Schlick's Fresnel term is not its shape" +
                     closerShape(shaped));
    }
    report::addEvalRows(eval, *brdf, choices.eval);
    if (!arguments.lobes.empty()) std::ranges::move(report::lobePlots(*brdf), std::back_inserter(lobes));
    if (!arguments.plot.empty() || arguments.slices) report::addSlices(slices, *brdf, files.size() == 1, chosen);
  }
  std::vector<report::Table> tables;
  for (report::Table* table :
       {&contents, &albedo, &decodings, &reciprocity, &proxies, &grid, &fits, &shapes, &fitAlbedo, &eval})
    if (!table->rows.empty()) tables.push_back(std::move(*table));
  if (tables.empty()) return status;
  if (arguments.slices) tables.push_back(report::sliceTable(slices));
  if (!arguments.lobes.empty()) {
    const Result<void> written = writeText(arguments.lobes, report::svg(lobes, originOfProcess()));
    if (!written) return badInput(written.error());
  }
  if (!arguments.plot.empty()) {
    const Result<void> written =
        writeText(arguments.plot, report::svg({slices.thetaH, slices.thetaD, slices.inPlane}, originOfProcess()));
    if (!written) return badInput(written.error());
  }
  const int shown = print(arguments, choices, std::move(tables));
  return shown == exitGood ? status : shown;
}

void confineTo(const BrdfArguments& arguments) {
  Needed needed;
  needMeasured(needed, {}, arguments.brdfDir);
  for (const std::string& file : arguments.files) needMeasured(needed, file, {});
  needFiles(needed, arguments.evalFrom);
  for (const std::string& file : {arguments.plot, arguments.lobes, arguments.output}) needOutput(needed, file);
  confine(std::move(needed), false);
}

int runBrdf(const BrdfArguments& arguments) {
  if (!arguments.noSandbox) confineTo(arguments);
  const Result<Choices> choices = choicesOf(arguments);
  if (!choices) return badInput(choices.error());
  if (!arguments.synthesize.empty()) return synthesize(arguments);
  for (const auto& [option, file] : {std::pair("--plot", &arguments.plot), std::pair("--lobes", &arguments.lobes)})
    if (!file->empty() && fs::path(*file).extension() != ".svg")
      return badInput({*file, option, "plots are SVG", "end the name in .svg"});
  if (!arguments.output.empty())
    return badInput({{}, "-o", "only --synthesize writes a file there", "--plot writes the slices"});
  if (arguments.files.empty() && !choices->eval.empty())
    return badInput({{}, "--eval", "of which BRDF is not said", "name one: a file, or builtin:NAME"});
  if (arguments.files.empty()) {
    return print(arguments, *choices, {databases(arguments)});
  }
  const Result<std::vector<std::string>> files = expanded(arguments);
  if (!files) return badInput(files.error());
  return describeAll(arguments, *choices, *files);
}

}  // namespace

std::function<int()> addBrdf(CLI::App& app) {
  auto arguments = std::make_shared<BrdfArguments>();
  app.add_option(
         "FILE", arguments->files,
         "MERL .binary or UTIA .bin files, folders of them, names of found databases, builtin:NAME; none: lists "
         "what is found")
      ->type_name("FILE|builtin:NAME");
  app.add_flag("--fit", arguments->fit, "fit GGX over each diffuse model, and other lobes over the best");
  app.add_option("--metric", arguments->metric, "of the fit (log)")->type_name(alternatives(metricNames));
  app.add_option("--plot", arguments->plot, "write slices by theta_h, theta_d and in the plane of view")
      ->type_name("D.svg");
  app.add_option("--lobes", arguments->lobes, "write the lobes in the plane of view, and one as a solid")
      ->type_name("D.svg");
  app.add_flag("--slices", arguments->slices, "the slices as a table, too (--table slices)");
  app.add_option(
         "--eval", arguments->eval,
         "values at polar angles of V and L and L's azimuth from V's, perhaps V's own, in degrees; several times "
         "for several (--table eval)")
      ->type_name("THETAV,THETAL,PHI")
      ->take_all();
  app.add_option("--eval-from", arguments->evalFrom, "the same of the lines of a CSV with columns thetaV, thetaL, phi")
      ->type_name("FILE");
  app.add_option("--utia-decode", arguments->utiaDecode, "what UTIA's values are (raw)")
      ->type_name(alternatives(io::utiaDecodeNames()));
  app.add_option("--brdf-dir", arguments->brdfDir, "look for databases here first")->type_name("DIR");
  app.add_option("--synthesize", arguments->synthesize, "write the built-in BRDF of that name as a file")
      ->type_name("BRDF");
  app.add_option("-o,--output", arguments->output, "where --synthesize writes")->type_name("FILE");
  app.add_option("--table", arguments->table, "only that one of its tables (all)")->type_name("TABLE");
  app.add_option("--format", arguments->format, "how tables are written (markdown)")
      ->type_name(alternatives(tableFormatNames()));
  addNoSandbox(app, arguments->noSandbox);
  return [arguments] { return runBrdf(*arguments); };
}

}  // namespace facet::commands
