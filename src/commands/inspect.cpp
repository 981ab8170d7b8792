#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/log.hpp"
#include "base/origin_json.hpp"
#include "commands/commands.hpp"
#include "commands/confine.hpp"
#include "commands/inspect_findings.hpp"
#include "commands/inspect_names.hpp"
#include "commands/inspect_parts.hpp"
#include "commands/notes_json.hpp"
#include "commands/picture_arguments.hpp"
#include "frame/choose.hpp"
#include "frame/gpu_scene.hpp"
#include "frame/left_out.hpp"
#include "frame/list_notes.hpp"
#include "frame/measured_gpu.hpp"
#include "frame/settings.hpp"
#include "io/image.hpp"
#include "io/measured.hpp"
#include "io/sources.hpp"
#include "io/validate/validate.hpp"
#include "scene/geometry.hpp"

namespace facet::commands {

namespace {

using Json = nlohmann::ordered_json;

struct InspectArguments {
  std::string model;
  PictureArguments picture;
  bool asJson = false, strict = false, all = false, list = false, noSandbox = false;
};

struct Counts {
  size_t primitives = 0, vertices = 0, triangles = 0;
};

Counts countGeometry(const scene::Model& model) {
  Counts counts;
  for (const scene::Mesh& mesh : model.meshes)
    for (const scene::Primitive& p : mesh.primitives) {
      ++counts.primitives;
      counts.vertices += p.positions.size();
      const size_t corners = p.indices.empty() ? p.positions.size() : p.indices.size();
      if (p.topology == scene::Topology::triangles)
        counts.triangles += corners / 3;
      else if (scene::hasTriangles(p.topology) && corners > 2)
        counts.triangles += corners - 2;
    }
  return counts;
}

Json describeMaterials(const scene::Model& model, const frame::DrawList& list) {
  Json out = Json::array();
  for (const frame::MaterialUsage& usage : frame::materialUsage(model, list)) {
    const size_t index = out.size();  // the model's materials come first
    Json material = {{"name", usage.name}, {"variants", usage.variants}, {"textures", usage.textures}};
    const Json effects = index < model.materials.size() ? describeEffects(model.materials[index]) : Json();
    if (!effects.is_null()) material["effects"] = effects;
    if (usage.variants.empty()) material["leftOut"] = "not drawn in this scene";
    if (!usage.variants.empty() && !usage.unusedTextures.empty()) material["unusedTextures"] = usage.unusedTextures;
    out.push_back(material);
  }
  return out;
}

Json describeLeftOut(const scene::Model& model, const frame::DrawList& list) {
  const bool measured = list.features.measured != shading::Measured::none;
  Json out = Json::array();
  const std::vector<bool> wanted = frame::missingImages(model, list, {});
  size_t unused = 0, bytes = 0;
  for (size_t i = 0; i < wanted.size(); ++i)
    if (!wanted[i]) ++unused, bytes += model.images[i].encoded.size();
  if (unused > 0)
    out.push_back(std::to_string(unused) + " of " + std::to_string(wanted.size()) + " images are not decoded (" +
                  std::to_string(bytes / 1024) + " KiB of embedded data): nothing that the scene draws reads them" +
                  (measured ? ", the measured BRDF stands in the place of what materials reflect" : ""));
  const ibl::Needs needs = list.needs(false);
  const auto none = [&](const char* what, const char* measuredWhy, const char* why) {
    out.push_back(std::string(what) + (measured ? measuredWhy : why));
  };
  if (!needs.dfg) none("no DFG table is computed: ", "a measured BRDF needs none", "nothing is lit");
  if (!needs.irradiance)
    none("no environment is filtered: ", "a measured BRDF samples it at each pixel", "nothing reflects one");
  if (measured)
    out.push_back(
        "no code for what materials reflect is compiled: colour, metallic, roughness and the layers of lit ones");
  if (list.lights.empty()) out.push_back("no code for punctual lights is compiled: the scene has none");
  if (list.transmitting.empty()) out.push_back("nothing is copied for what is behind glass: nothing transmits light");
  if (list.blended.empty()) out.push_back("no blend pass is drawn: no drawn material asks for it");
  return out;
}

Json describeModel(const scene::Model& model, const Notes& notes, const frame::DrawList& list, int scene,
                   const Json& measured) {
  Json out;
  const Counts counts = countGeometry(model);
  out["file"] = model.name;
  if (!model.generator.empty()) out["generator"] = model.generator;
  if (!model.copyright.empty()) out["copyright"] = model.copyright;
  out["scene"] = scene;
  out["counts"] = {
      {"scenes", model.scenes.size()},       {"nodes", model.nodes.size()},       {"meshes", model.meshes.size()},
      {"primitives", counts.primitives},     {"vertices", counts.vertices},       {"triangles", counts.triangles},
      {"materials", model.materials.size()}, {"textures", model.textures.size()}, {"images", model.images.size()},
      {"lights", model.lights.size()},       {"cameras", model.cameras.size()}};
  const auto corner = [](const glm::dvec3& v) { return Json{v.x, v.y, v.z}; };
  if (!list.bounds.empty()) out["bounds"] = {{"min", corner(list.bounds.min)}, {"max", corner(list.bounds.max)}};
  out["extensionsUsed"] = model.extensionsUsed;
  out["extensionsRequired"] = model.extensionsRequired;
  out["drawCalls"] = list.opaque.size() + list.transmitting.size() + list.blended.size();
  if (!measured.is_null()) out["measured"] = measured;
  out["materials"] = describeMaterials(model, list);
  describeParts(model, out);
  out["leftOut"] = describeLeftOut(model, list);
  out["notes"] = notesJson(notes);
  return out;
}

std::string joinedOrNone(const Json& list) {
  std::string text;
  for (const Json& item : list) text += (text.empty() ? "" : ", ") + item.get<std::string>();
  return text.empty() ? "none" : text;
}

// "    clearcoat: clearcoatFactor 1.0, clearcoatTexture 3"
void printEffects(const Json& material) {
  if (!material.contains("effects")) return;
  for (const auto& [effect, values] : material["effects"].items()) {
    const char* separator = ": ";
    std::cout << "    " << effect;
    for (const auto& [key, value] : values.items()) std::cout << std::exchange(separator, ", ") << key << " " << value;
    std::cout << "\n";
  }
}

void print(const Json& out) {
  std::cout << out["file"].get<std::string>() << "\n";
  for (const char* key : {"generator", "copyright"})
    if (out.contains(key)) std::cout << "  " << key << ": " << out[key].get<std::string>() << "\n";
  std::cout << " ";
  for (const auto& [name, count] : out["counts"].items()) std::cout << " " << count << " " << name;
  std::cout << "\n";
  if (out.contains("bounds"))
    std::cout << "  bounds: " << out["bounds"]["min"] << " to " << out["bounds"]["max"] << " m\n";
  std::cout << "  extensions used: " << joinedOrNone(out["extensionsUsed"])
            << "; required: " << joinedOrNone(out["extensionsRequired"]) << "\n";
  if (out.contains("measured")) printMeasured(out["measured"], std::cout);
  std::cout << "  draw calls: " << out["drawCalls"] << "\n\nMaterials and their shader variants\n";
  for (const Json& material : out["materials"]) {
    std::cout << "  " << material["name"].get<std::string>() << "\n";
    printEffects(material);
    for (const Json& variant : material["variants"]) std::cout << "    variant: " << variant.get<std::string>() << "\n";
    if (material.contains("leftOut")) std::cout << "    left out: " << material["leftOut"].get<std::string>() << "\n";
    if (material.contains("unusedTextures"))
      std::cout << "    textures that change nothing: " << joinedOrNone(material["unusedTextures"]) << "\n";
  }
  printParts(out, std::cout);
  printImages(out["images"], std::cout);
  std::cout << "\nLeft out, because the scene does not need it\n";
  for (const Json& text : out["leftOut"]) std::cout << "  " << text.get<std::string>() << "\n";
  if (out["leftOut"].empty()) std::cout << "  nothing\n";
  std::cout << "\nNotes\n";
  for (const Json& note : out["notes"]) {
    const std::string place = note["place"].get<std::string>();
    std::cout << "  " << note["severity"].get<std::string>() << ": " << place << (place.empty() ? "" : ": ")
              << note["text"].get<std::string>() << "\n";
  }
  if (out["notes"].empty()) std::cout << "  none\n";
}

// Images that a picture would decode are decoded here too, so that a corrupt one is told.
void checkImages(const scene::Model& model, const frame::DrawList& list, Notes& notes) {
  io::decodeImages(model, frame::missingImages(model, list, {}), notes);
}

// As a picture would find and read it; null without --brdf.
Result<Json> readMeasured(const frame::PictureSettings& settings, frame::DrawOptions& options, Notes& notes) {
  if (settings.sources.brdf.empty()) return Json();
  const Result<std::string> source = io::resolveMeasured(settings.sources.brdf, settings.sources.brdfDir);
  if (!source) return tl::unexpected(source.error());
  const Result<optics::MeasuredBrdf> brdf = io::readMeasured(*source, {.utiaDecode = settings.sources.utiaDecode});
  if (!brdf) return tl::unexpected(brdf.error());
  std::ranges::move(io::measuredNotes(*brdf), std::back_inserter(notes));
  frame::setMeasured(options.features, settings.look, brdf->kind, optics::fitProxy(*brdf));
  return describeMeasured(*brdf, *source);
}

// The file is checked to the letter all the same.
int tellRefused(const InspectArguments& arguments, const Error& error, const io::validate::Report& report) {
  if (arguments.asJson) {
    const Json out = {{"file", arguments.model},
                      {"refused", describe(error)},
                      {"validation", describeValidation(report)},
                      {"origin", originJson(originOfProcess())}};
    std::cout << out.dump(2, ' ', false, Json::error_handler_t::replace) << std::endl;
  } else {
    printValidation(report, arguments.all, std::cout);
  }
  return badInput(error);
}

// Names alone: nothing is checked, decoded or sorted into draws.
int listNames(const InspectArguments& arguments, const io::Limits& limits) {
  const Result<io::LoadedModel> loaded = io::loadModel(arguments.model, limits);
  if (!loaded) return badInput(loaded.error());
  Json out = describeNames(loaded->model);
  if (!arguments.asJson) return printNames(out, std::cout), exitGood;
  out["origin"] = originJson(originOfProcess());
  std::cout << out.dump(2, ' ', false, Json::error_handler_t::replace) << std::endl;
  return exitGood;
}

int runInspect(const InspectArguments& arguments) {
  frame::PictureSettings settings;
  if (const Result<void> applied = options::apply(arguments.picture, settings); !applied)
    return badInput(applied.error());
  if (!arguments.noSandbox) {
    Needed needed;
    needPicture(needed, arguments.model, settings);
    confine(std::move(needed), false);
  }
  const io::Limits limits = {.allowOutside = settings.sources.allowOutside};
  if (arguments.list) return listNames(arguments, limits);
  const Result<io::ModelBytes> read = io::readModelBytes(arguments.model, limits);
  if (!read) return badInput(read.error());
  const io::validate::Report report = io::validateBytes(read->bytes(), read->name, read->folder, limits);
  Result<io::LoadedModel> loaded = io::loadModel(*read, limits);
  if (!loaded) return tellRefused(arguments, loaded.error(), report);
  const scene::Model& model = loaded->model;
  const Result<int> scene = frame::chooseScene(settings.placement, model);
  if (!scene) return badInput(scene.error());
  const Result<int> variant = frame::chooseVariant(settings.look, model);
  if (!variant) return badInput(variant.error());
  frame::DrawOptions options = frame::drawOptions(settings, true);
  options.variant = *variant;
  const Result<Json> measured = readMeasured(settings, options, loaded->notes);
  if (!measured) return badInput(measured.error());
  const frame::DrawList list = frame::buildDrawList(model, *scene, options);
  checkImages(model, list, loaded->notes);
  if (!measured->is_null())
    std::ranges::move(frame::listNotes(list, list.needs(false)), std::back_inserter(loaded->notes));
  Json out = describeModel(model, loaded->notes, list, *scene, *measured);
  out["images"] = describeImages(model, frame::missingImages(model, list, {}));
  if (arguments.asJson) {
    out["validation"] = describeValidation(report);
    out["origin"] = originJson(originOfProcess());
    std::cout << out.dump(2, ' ', false, Json::error_handler_t::replace) << std::endl;
  } else {
    print(out);
    printValidation(report, arguments.all, std::cout);
  }
  bool warned = report.count(io::validate::Severity::error) > 0;
  for (const Note& note : loaded->notes) warned = warned || note.severity == Note::Severity::warning;
  return warned && arguments.strict ? exitBadInput : exitGood;
}

}  // namespace

std::function<int()> addInspect(CLI::App& app) {
  auto arguments = std::make_shared<InspectArguments>();
  app.add_option("MODEL", arguments->model, "a .gltf or .glb file, or builtin:NAME")->type_name("MODEL")->required();
  constexpr std::string_view wanted[] = {"scene",       "variant",     "brdf",         "brdf-dir",
                                         "brdf-lookup", "utia-decode", "allow-outside"};
  addPictureOptions(app, arguments->picture, wanted);
  app.add_flag(
      "--list", arguments->list,
      "only what other commands can name: scenes, cameras, animations, variants, materials; kind, index, name");
  app.add_flag("--json", arguments->asJson, "for scripts");
  app.add_flag("--all", arguments->all, "every finding, not the first five of each code");
  app.add_flag("--strict", arguments->strict, "any warning or error makes the exit status 2");
  addNoSandbox(app, arguments->noSandbox);
  return [arguments] { return runInspect(*arguments); };
}

}  // namespace facet::commands
