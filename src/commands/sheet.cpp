#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "base/log.hpp"
#include "commands/commands.hpp"
#include "commands/compare_models.hpp"
#include "commands/confine.hpp"
#include "commands/picture_arguments.hpp"
#include "commands/picture_output.hpp"
#include "compare/side_by_side.hpp"
#include "frame/session.hpp"
#include "frame/settings.hpp"
#include "options/picture_options.hpp"

namespace facet::commands {

namespace {

namespace fs = std::filesystem;

constexpr size_t mostModels = 10'000;
constexpr int usualSide = 256;  // pixels

struct SheetArguments {
  std::vector<std::string> sources;
  std::string output;
  int columns = 0;  // 0: about as wide as high
  bool noSandbox = false;
  OutputOptions out;
  PictureArguments picture;
};

// Those in and below a folder, by name.
Result<void> addModelsOf(const fs::path& folder, std::vector<std::string>& models) {
  std::vector<std::string> found;
  std::error_code problem;
  for (fs::recursive_directory_iterator it(folder, fs::directory_options::skip_permission_denied, problem), end;
       !problem && it != end && found.size() <= mostModels; it.increment(problem))
    if (std::error_code ignored; it->is_regular_file(ignored) && isModelSource(it->path().string()))
      found.push_back(it->path().string());
  if (problem) return fail(folder.string(), "", "cannot be read: " + problem.message(), "check its permissions");
  if (found.empty())
    return fail(folder.string(), "", "holds no .gltf and no .glb file", "name another folder, or files");
  std::ranges::sort(found);
  models.insert(models.end(), found.begin(), found.end());
  return {};
}

Result<std::vector<std::string>> listModels(const std::vector<std::string>& sources) {
  std::vector<std::string> models;
  std::error_code ignored;
  for (const std::string& source : sources)
    if (!fs::is_directory(source, ignored))
      models.push_back(source);
    else if (Result<void> r = addModelsOf(source, models); !r)
      return tl::unexpected(r.error());
  if (models.size() > mostModels)
    return fail({}, "MODEL", "these are more than " + std::to_string(mostModels) + " models", "make several sheets");
  return models;
}

// What it is called among the others: scene.gltf of many folders by its folder, too.
std::string titleOf(const std::string& model, const std::vector<std::string>& models) {
  const fs::path path = model;
  const auto called = [&](const std::string& other) { return fs::path(other).stem() == path.stem(); };
  if (std::ranges::count_if(models, called) < 2 || !path.has_parent_path()) return path.stem().string();
  const auto besides = [&](const std::string& other) { return fs::path(other).parent_path() == path.parent_path(); };
  const bool ending = std::ranges::count_if(models, [&](const auto& m) { return called(m) && besides(m); }) > 1;
  return path.parent_path().filename().string() + "/" + (ending ? path.filename() : path.stem()).string();
}

// In the place of one that is not shown.
io::Pixels emptyPlace(const frame::FrameSettings& frame) {
  io::Pixels pixels{frame.width, frame.height, 3, 1, {}};
  pixels.data.assign(static_cast<size_t>(frame.width) * static_cast<size_t>(frame.height) * 3, 0);
  return pixels;
}

// Each model's picture, or an empty place and an error that is told.
bool drawAll(const std::vector<std::string>& models, const frame::PictureSettings& settings, frame::Session& session,
             std::vector<compare::Titled>& pictures) {
  bool good = true;
  for (const std::string& model : models) {
    Notes notes;
    Stages stages;
    Result<frame::Picture> picture =
        session.render(model, settings, {.display = true, .last = &model == &models.back()}, notes, stages);
    for (const Note& note : notes)
      if (note.severity == Note::Severity::warning) log::warning(options::describe(model, note));
    if (!picture) log::error(model + ": " + options::describe(picture.error())), good = false;
    const std::string title = titleOf(model, models);
    pictures.push_back(picture ? compare::Titled{title, std::move(picture->display)}
                               : compare::Titled{title + ": not shown", emptyPlace(settings.frame)});
  }
  return good;
}

Result<Job> sheetJob(const SheetArguments& arguments) {
  Job job{.model = "", .output = arguments.output};
  const Result<io::PictureFormat> format = outputFormat(job.output, arguments.out);
  if (!format) return tl::unexpected(format.error());
  if (*format == io::PictureFormat::exr)
    return fail(arguments.output, "-o", "a sheet is of what one sees", "end it in " + io::pictureEndings(false));
  job.format = *format;
  job.settings.frame.width = job.settings.frame.height = usualSide;
  if (Result<void> r = options::apply(arguments.picture, job.settings); !r) return tl::unexpected(r.error());
  if (Result<void> r = options::checkTogether(job.settings); !r) return tl::unexpected(r.error());
  return job;
}

int runSheet(const SheetArguments& arguments) {
  const Result<Job> job = sheetJob(arguments);
  if (!job) return badInput(job.error());
  const Result<std::vector<std::string>> models = listModels(arguments.sources);
  if (!models) return badInput(models.error());
  if (!arguments.noSandbox) keepDriverCacheApart();
  Result<std::unique_ptr<frame::Session>> session =
      frame::Session::create({.shaderDir = job->settings.sources.shaderDir});
  if (!session) return log::error(describe(session.error())), exitNoOpenGL;
  if (!arguments.noSandbox) {
    Needed needed;
    for (const std::string& model : *models) needPicture(needed, model, job->settings);
    needOutput(needed, job->output);
    confine(std::move(needed), true);
  }
  std::vector<compare::Titled> pictures;
  const bool good = drawAll(*models, job->settings, **session, pictures);
  const int square = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(pictures.size()))));
  const io::Pixels sheet = compare::sideBySide(pictures, arguments.columns > 0 ? arguments.columns : square);
  const Result<void> written = io::writePicture(job->output, job->format, sheet, arguments.out.quality);
  if (!written) return badInput(written.error());
  log::info(job->output.string() + ": " + std::to_string(pictures.size()) + " models");
  return good ? exitGood : exitBadInput;
}

}  // namespace

std::function<int()> addSheet(CLI::App& app) {
  auto arguments = std::make_shared<SheetArguments>();
  app.add_option("MODEL", arguments->sources, "models; of a folder all that are in and below it")
      ->type_name("MODEL|FOLDER")
      ->required();
  app.add_option("-o,--output", arguments->output, "the sheet: .png, .jpg, .webp, .avif; - for standard output")
      ->type_name("FILE")
      ->required();
  app.add_option("--columns", arguments->columns, "pictures in a row (about as many as rows)")
      ->type_name("N")
      ->check(CLI::Range(1, 1000));
  addFileOptions(app, arguments->out);
  addNoSandbox(app, arguments->noSandbox);
  addPictureOptions(app, arguments->picture);
  return [arguments] { return runSheet(*arguments); };
}

}  // namespace facet::commands
