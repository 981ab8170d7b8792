#include "commands/picture_output.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include "base/text.hpp"
#include "io/radiance.hpp"
#include "shading/channels.hpp"

namespace facet::commands {

namespace {

using io::PictureFormat;

constexpr const char* standardOutput = "-";

std::string commandEnding(const OutputOptions& options) {
  std::string text = std::string(options.errorLayer ? " --error-layer" : "");
  if (!options.layers.empty()) text += " --layers " + options.layers;
  return text;
}

std::vector<std::string_view> namesOf(const OutputOptions& options) {
  return options.layers.empty() ? std::vector<std::string_view>() : split(options.layers, ',');
}

// What its numbers are called in a layer (io::ExrLayerImage).
const char* componentsOf(int channel) {
  switch (shading::channelKind(channel)) {
    case shading::ChannelKind::color:
    case shading::ChannelKind::light:
    case shading::ChannelKind::pattern:
      return "RGB";
    case shading::ChannelKind::direction:
      return "XYZ";
    case shading::ChannelKind::number:
    case shading::ChannelKind::quantity:
    case shading::ChannelKind::identity:
      break;
  }
  return shading::channelSetting(channel) == "depth" ? "Z" : "X";
}

Result<void> checkLayers(const OutputOptions& options) {
  std::vector<std::string_view> seen;
  for (const std::string_view name : namesOf(options)) {
    if (name.empty() || shading::channelIndex(std::string(name)) <= 0)
      return fail({}, "--layers", inQuotes(std::string(name)) + " is no channel", "see the list of --channel");
    if (std::ranges::find(seen, name) != seen.end())
      return fail({}, "--layers", inQuotes(std::string(name)) + " is named twice", "name it once");
    seen.push_back(name);
  }
  return {};
}

// As the picture is, but of one channel.
Result<std::vector<io::RadianceImage>> drawLayers(const Job& job, const OutputOptions& options,
                                                  frame::Session& session) {
  std::vector<io::RadianceImage> drawn;
  for (const std::string_view name : namesOf(options)) {
    frame::PictureSettings settings = job.settings;
    settings.look.channel = name;
    Notes told;  // by the picture
    Stages stages;
    Result<frame::Picture> layer = session.render(job.model, settings, {.radiance = true}, told, stages);
    if (!layer) return tl::unexpected(layer.error());
    drawn.push_back(std::move(layer->radiance));
  }
  return drawn;
}

Result<void> writeLayers(const Job& job, const OutputOptions& options, frame::Session& session,
                         const frame::Picture& picture) {
  const Origin origin = pictureOrigin(job, session, options);
  const Result<std::vector<io::RadianceImage>> drawn = drawLayers(job, options, session);
  if (!drawn) return tl::unexpected(drawn.error());
  std::vector<io::ExrLayerImage> layers;
  if (!picture.standardError.pixels.empty()) layers.push_back({"error", &picture.standardError});
  size_t i = 0;
  for (const std::string_view name : namesOf(options))
    layers.push_back({std::string(name), &(*drawn)[i++], componentsOf(shading::channelIndex(std::string(name)))});
  return io::writeExr(job.output, picture.radiance, origin, layers);
}

}  // namespace

void addFileOptions(CLI::App& app, OutputOptions& options) {
  app.add_option("--format", options.format, "of -o -, standard output (png)")->type_name("png|jpg|webp|avif|exr");
  app.add_option("--quality", options.quality,
                 "of JPEG, WebP and AVIF, 1 to 100 (90); 100 loses nothing in WebP and AVIF")
      ->type_name("N")
      ->check(CLI::Range(1, 100));
}

void addOutputOptions(CLI::App& app, OutputOptions& options) {
  addFileOptions(app, options);
  app.add_option("--bits", options.bits, "of a channel in a PNG: 8 or 16 (8)")
      ->type_name("N")
      ->check(CLI::IsMember({8, 16}));
  app.add_flag("--error-layer", options.errorLayer,
               "in an EXR of more than 4 samples that converges: each pixel's standard error as the layer \"error\"");
  app.add_option("--layers", options.layers,
                 "in an EXR: further layers, each what --channel NAME draws, such as baseColor,normal,depth,node")
      ->type_name("CHANNEL,...");
}

Result<PictureFormat> outputFormat(const std::filesystem::path& output, const OutputOptions& options) {
  if (output == standardOutput) {
    const auto named = io::pictureFormatNamed(options.format.empty() ? "png" : options.format);
    if (named) return *named;
    return fail({}, "--format", inQuotes(options.format) + " is none", "give png, jpg, webp, avif or exr");
  }
  if (!options.format.empty())
    return fail({}, "--format", "is for standard output (-o -)", "the name's ending says it: leave --format out");
  return formatOfName(output);
}

Result<void> checkOutput(const Job& job, const OutputOptions& options) {
  const io::PictureFormatRow& row = rowOf(job.format);
  const bool exr = job.format == PictureFormat::exr;
  const std::string name = job.output.string();
  if (Result<void> r = checkLayers(options); !r) return r;
  if (!options.layers.empty() && !exr) return fail(name, "--layers", "only an EXR holds layers", "end -o in .exr");
  if (!options.layers.empty() && !job.settings.look.channel.empty())
    return fail(name, "--layers", "is of a picture, and --channel has another in its place", "leave one of them out");
  if (options.bits == 16 && (!row.deep || exr))
    return fail(name, "--bits", std::string(row.name) + (exr ? " holds 32 bits" : " holds 8 bits") + " a channel",
                exr ? "leave it out" : "end -o in .png, or leave it out");
  if (!row.alpha && job.settings.frame.background == frame::Background::transparent)
    return fail(name, "--background", std::string(row.name) + " has no transparency",
                "end -o in .png, .webp or .avif, or give a colour");
  return io::checkPictureSize(job.format, job.settings.frame.width, job.settings.frame.height, name);
}

frame::PictureRequest pictureRequest(const Job& job, const OutputOptions& options, int repeat, bool last) {
  const bool exr = job.format == PictureFormat::exr;
  return {.radiance = exr,
          .display = !exr,
          .deep = options.bits == 16,
          .standardError = exr && options.errorLayer,
          .repeat = repeat,
          .last = last && options.layers.empty()};
}

Origin pictureOrigin(const Job& job, const frame::Session& session, const OutputOptions& options) {
  Origin origin = gl::originOn(session.context());
  origin.date.clear();
  origin.command = options::commandLine(job.settings, job.model, "picture" + std::string(rowOf(job.format).ending)) +
                   commandEnding(options);
  origin.environment = session.environmentName(), origin.model = job.model;
  origin.seed = job.settings.quality.seed;
  return origin;
}

Result<void> writeOutput(const Job& job, const OutputOptions& options, frame::Session& session,
                         const frame::Picture& picture) {
  return job.format == PictureFormat::exr ? writeLayers(job, options, session, picture)
                                          : io::writePicture(job.output, job.format, picture.display, options.quality);
}

}  // namespace facet::commands
