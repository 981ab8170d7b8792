#include "io/gltf.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "io/accessors.hpp"
#include "io/glb.hpp"
#include "io/gltf_document.hpp"
#include "io/gltf_image_light.hpp"
#include "io/gltf_views.hpp"
#include "io/json_section.hpp"
#include "io/uri.hpp"

namespace facet::io {

namespace fs = std::filesystem;
using Json = nlohmann::json;

Result<void> checkIndex(const Document& doc, int index, size_t count, const std::string& place, const char* what) {
  if (index >= 0 && static_cast<size_t>(index) < count) return {};
  return doc.error(
      place, std::string(what) + " " + std::to_string(index) + " does not exist; there are " + std::to_string(count));
}

namespace {

Json member(const Document& doc, std::string_view key) {
  const JsonMember* found = doc.outline.find(key);
  if (found == nullptr) return nullptr;
  const std::string_view text = doc.json.substr(found->begin, found->end - found->begin);
  return Json::parse(text.begin(), text.end(), nullptr, false);
}

Result<void> readAsset(Document& doc) {
  const Json asset = member(doc, "asset");
  const std::string version = stringAt(asset, "version"), minVersion = stringAt(asset, "minVersion");
  if (version.empty())
    return doc.error("/asset/version", "is missing, so this is not a glTF 2.0 file", "name a .gltf or .glb file");
  if (!version.starts_with("2.")) {
    return doc.error("/asset/version", "the file is glTF " + inQuotes(version) + "; only 2.0 is known",
                     "convert it to glTF 2.0");
  }
  if (!minVersion.empty() && minVersion != "2.0") {
    return doc.error("/asset/minVersion", "the file needs glTF " + inQuotes(minVersion) + "; only 2.0 is known",
                     "convert it to glTF 2.0");
  }
  doc.model.generator = stringAt(asset, "generator");
  doc.model.copyright = stringAt(asset, "copyright");
  for (const auto& [key, list] : {std::pair("extensionsUsed", &doc.model.extensionsUsed),
                                  std::pair("extensionsRequired", &doc.model.extensionsRequired)}) {
    for (const Json& name : member(doc, key)) {
      if (name.is_string()) list->push_back(name.get<std::string>());
    }
  }
  return {};
}

// The text for tinygltf. Taken out are buffers and images (gltf_data.cpp), animations, because it refuses channels
// without a node, which extensions allow, and skins, because it wants inverse bind matrices. Accessors without a buffer
// view get one past the real ones, because tinygltf refuses indices without; it is taken back in parse().
std::string textForTinygltf(const Document& doc) {
  struct Edit {
    size_t begin, end;
    std::string text;
  };
  std::vector<Edit> edits;
  for (const char* key : {"buffers", "images", "animations", "skins"}) {
    if (const JsonMember* found = doc.outline.find(key)) edits.push_back({found->begin, found->end, "[]"});
  }
  if (!doc.outline.accessorsWithoutView.empty()) {
    const size_t views = doc.outline.elements("bufferViews");
    const std::string view = R"("bufferView":)" + std::to_string(views);
    for (const auto& object : doc.outline.accessorsWithoutView) {
      const bool empty = doc.json[doc.json.find_first_not_of(" \t\r\n", object.begin)] == '}';
      edits.push_back({object.begin, object.begin, view + (empty ? "" : ",")});
    }
    const std::string added = R"({"buffer":0,"byteLength":1})";
    const JsonMember* found = doc.outline.find("bufferViews");
    if (found != nullptr && doc.json[found->begin] == '[') {
      const size_t close = doc.json.rfind(']', found->end - 1);
      edits.push_back({close, close, (views > 0 ? "," : "") + added});
    } else if (found == nullptr) {
      const size_t open = doc.json.find('{') + 1;
      edits.push_back({open, open, R"("bufferViews":[)" + added + "],"});
    }
  }
  std::sort(edits.begin(), edits.end(), [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
  std::string text;
  text.reserve(doc.json.size() + 64 * edits.size());
  size_t at = 0;
  for (const Edit& edit : edits) {
    text.append(doc.json.substr(at, edit.begin - at)).append(edit.text);
    at = edit.end;
  }
  return text.append(doc.json.substr(at));
}

// Finds the first fault of the whole text.
class SyntaxCheck : public nlohmann::json_sax<Json> {
 public:
  size_t offset = 0;
  std::string problem;

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(size_t) override { return true; }
  bool key(string_t&) override { return true; }
  bool end_object() override { return true; }
  bool start_array(size_t) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(size_t position, const std::string&, const nlohmann::detail::exception& e) override {
    offset = position > 0 ? position - 1 : 0;
    problem = e.what();  // "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error while ..."
    for (const char* head : {"syntax error ", "] "}) {
      if (const size_t found = problem.find(head); found != std::string::npos) {
        problem.erase(0, found + std::string_view(head).size());
        break;
      }
    }
    return false;
  }
};

Result<void> checkSyntax(const Document& doc) {
  SyntaxCheck check;
  if (Json::sax_parse(doc.json.begin(), doc.json.end(), &check)) return {};
  return doc.error(lineAndColumn(doc.json, check.offset), "the JSON text is faulty " + check.problem);
}

// tinygltf names no place, but it reads section after section: the first one that is incomplete holds the fault.
std::string incompleteSection(const Document& doc) {
  const auto& g = doc.gltf;
  const std::pair<const char*, size_t> sections[] = {
      {"bufferViews", g.bufferViews.size()}, {"accessors", g.accessors.size()},
      {"meshes", g.meshes.size()},           {"nodes", g.nodes.size()},
      {"scenes", g.scenes.size()},           {"materials", g.materials.size()},
      {"textures", g.textures.size()},       {"samplers", g.samplers.size()},
      {"cameras", g.cameras.size()}};
  for (const auto& [key, read] : sections) {
    if (read < doc.outline.elements(key)) return pointer(std::string("/") + key, read);
  }
  return {};
}

// Its messages in one line, without the last full stop.
std::string oneLine(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '.' || text.back() == ' ')) text.pop_back();
  for (size_t i = text.find('\n'); i != std::string::npos; i = text.find('\n', i)) text.replace(i, 1, " ");
  return text;
}

// Nothing is left to read for it; should it try all the same, it gets nothing.
void refuseFiles(tinygltf::TinyGLTF& loader) {
  tinygltf::FsCallbacks callbacks{};
  callbacks.FileExists = [](const std::string&, void*) { return false; };
  callbacks.ExpandFilePath = [](const std::string& path, void*) { return path; };
  callbacks.ReadWholeFile = [](std::vector<unsigned char>*, std::string*, const std::string&, void*) { return false; };
  callbacks.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
    return false;
  };
  loader.SetFsCallbacks(callbacks);
  loader.SetImageLoader([](tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int,
                           void*) { return false; },
                        nullptr);
}

Result<void> parse(Document& doc) {
  const std::string text = textForTinygltf(doc);
  if (text.size() > std::numeric_limits<unsigned int>::max()) {
    return doc.error("", "the JSON text is larger than 4 GiB", "use a smaller model");
  }
  // Its vectors grow one by one otherwise, and their elements are large.
  doc.gltf.nodes.reserve(doc.outline.elements("nodes"));
  doc.gltf.accessors.reserve(doc.outline.elements("accessors"));
  doc.gltf.bufferViews.reserve(doc.outline.elements("bufferViews"));
  doc.gltf.meshes.reserve(doc.outline.elements("meshes"));
  tinygltf::TinyGLTF loader;
  refuseFiles(loader);
  std::string errors, warnings;
  const bool ok = loader.LoadASCIIFromString(&doc.gltf, &errors, &warnings, text.data(),
                                             static_cast<unsigned int>(text.size()), "");
  // It also says errors while going on without what was wrong, for instance without a primitive.
  if (!ok || !errors.empty()) {
    if (auto syntax = checkSyntax(doc); !syntax) return syntax;
    return doc.error(incompleteSection(doc), errors.empty() ? "is not valid glTF" : oneLine(errors));
  }
  if (!doc.outline.accessorsWithoutView.empty() && !doc.gltf.bufferViews.empty()) {
    doc.gltf.bufferViews.pop_back();
    for (const auto& object : doc.outline.accessorsWithoutView) doc.gltf.accessors[object.index].bufferView = -1;
  }
  return {};
}

// The text and the binary chunk, scanned.
Result<void> readText(Document& doc, std::span<const uint8_t> bytes) {
  doc.bytesRead = bytes.size();
  doc.json = {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  if (isGlb(bytes)) {
    const auto parts = splitGlb(bytes);
    if (!parts) return doc.error(parts.error().place, parts.error().problem, parts.error().remedy);
    doc.json = parts->json;
    doc.binary = parts->binary;
    doc.hasBinary = parts->hasBinary;
    if (parts->unpadded) doc.warning("", "its JSON is not padded to a multiple of four bytes, as a .glb has to be");
  }
  if (auto text = withValidUtf8(doc.json)) {
    doc.warning("", "its text is not all UTF-8: what is not is replaced by \xEF\xBF\xBD");
    doc.validUtf8 = std::move(*text);
    doc.json = doc.validUtf8;
  }
  if (auto text = withWholeNumbers(doc.json)) {
    doc.wholeNumbers = std::move(*text);
    doc.json = doc.wholeNumbers;
  }
  auto outline = scanJson(doc.json, doc.limits.jsonDepth);
  if (!outline) return doc.error(outline.error().place, outline.error().problem, outline.error().remedy);
  doc.outline = std::move(*outline);
  for (const std::string& key : doc.outline.givenTwice) doc.warning("/" + key, "is given twice: the later one counts");
  return {};
}

Result<LoadedModel> load(Document& doc, std::span<const uint8_t> bytes) {
  if (auto ok = readText(doc, bytes); !ok) return tl::unexpected(ok.error());
  // In this order: what a file may ask for first, then bytes, then what refers to them.
  for (const auto step : {readAsset, checkExtensions, readBuffers, parse, decodeMeshopt}) {
    if (auto ok = step(doc); !ok) return tl::unexpected(ok.error());
  }
  if (auto ok = checkBufferViews(doc); !ok) return tl::unexpected(ok.error());
  if (auto ok = checkAccessors(doc); !ok) return tl::unexpected(ok.error());
  for (const auto step : {readImages, readTextures, readMaterials, readVariants, readLights, readCameras, readSkins,
                          readNodes, readProfiledLights, readMeshes, readAnimations, readXmp}) {
    if (auto ok = step(doc); !ok) return tl::unexpected(ok.error());
  }
  doc.model.name = fs::path(doc.name).filename().string();
  return LoadedModel{std::move(doc.model), std::move(doc.notes)};
}

// No exception of the libraries below gets out, and neither does running out of memory.
template <class T, class Function>
Result<T> safely(const std::string& name, const fs::path& baseFolder, const Limits& limits, Function&& read) {
  try {
    Document doc;
    doc.name = name;
    doc.limits = limits;
    std::error_code code;
    if (!baseFolder.empty()) doc.folder = fs::canonical(baseFolder, code);
    return read(doc);
  } catch (const std::bad_alloc&) {
    return fail(name, "", "there is not enough memory to read it", "use a smaller model");
  } catch (const std::exception& e) {
    return fail(name, "", std::string("cannot be read: ") + e.what(), "export the model again");
  }
}

Result<LoadedModel> loadSafely(std::span<const uint8_t> bytes, const std::string& name, const fs::path& baseFolder,
                               const Limits& limits) {
  return safely<LoadedModel>(name, baseFolder, limits, [&](Document& doc) { return load(doc, bytes); });
}

fs::path folderOf(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

}  // namespace

Result<LoadedModel> loadGltf(const fs::path& path, const Limits& limits) {
  auto bytes = readRegularFile(path, std::min(limits.fileBytes, limits.totalBytes));
  if (!bytes) return tl::unexpected(bytes.error());
  return loadSafely(bytes->span(), path.string(), folderOf(path), limits);
}

Result<LoadedModel> loadGltfBytes(std::span<const uint8_t> bytes, const std::string& name, const fs::path& baseFolder,
                                  const Limits& limits) {
  return loadSafely(bytes, name, baseFolder, limits);
}

Result<scene::Environment> withImages(const fs::path& path, const Limits& limits,
                                      const std::function<Result<scene::Environment>(Document&)>& use) {
  auto bytes = readRegularFile(path, std::min(limits.fileBytes, limits.totalBytes));
  if (!bytes) return tl::unexpected(bytes.error());
  return safely<scene::Environment>(path.string(), folderOf(path), limits,
                                    [&](Document& doc) -> Result<scene::Environment> {
                                      if (auto ok = readText(doc, bytes->span()); !ok)
                                        return tl::unexpected(ok.error());
                                      for (const auto step : {readAsset, readBuffers, parse, decodeMeshopt})
                                        if (auto ok = step(doc); !ok) return tl::unexpected(ok.error());
                                      if (auto ok = checkBufferViews(doc); !ok) return tl::unexpected(ok.error());
                                      if (auto ok = readImages(doc); !ok) return tl::unexpected(ok.error());
                                      return use(doc);
                                    });
}

Result<std::vector<uint8_t>> withBuffers(std::span<const uint8_t> bytes, const std::string& name,
                                         const fs::path& baseFolder, const Limits& limits,
                                         const std::function<Result<std::vector<uint8_t>>(Document&)>& use) {
  return safely<std::vector<uint8_t>>(name, baseFolder, limits, [&](Document& doc) -> Result<std::vector<uint8_t>> {
    if (auto ok = readText(doc, bytes); !ok) return tl::unexpected(ok.error());
    for (const auto step : {readAsset, readBuffers})
      if (auto ok = step(doc); !ok) return tl::unexpected(ok.error());
    return use(doc);
  });
}

Result<DecodedViews> decodeViews(std::span<const uint8_t> bytes, const std::string& name, const fs::path& baseFolder,
                                 const Limits& limits) {
  const auto doc = std::make_shared<Document>();
  const auto read = [&]() -> Result<DecodedViews> {
    for (const auto step : {readAsset, readBuffers, parse, decodeMeshopt})
      if (auto ok = step(*doc); !ok) return tl::unexpected(ok.error());
    if (auto ok = checkBufferViews(*doc); !ok) return tl::unexpected(ok.error());
    DecodedViews views{doc, {}};
    for (size_t i = 0; i < doc->gltf.bufferViews.size(); ++i)
      views.bytes.push_back(viewBytes(*doc, static_cast<int>(i)));
    return views;
  };
  return safely<DecodedViews>(name, baseFolder, limits, [&](Document& fresh) -> Result<DecodedViews> {
    *doc = std::move(fresh);
    if (auto ok = readText(*doc, bytes); !ok) return tl::unexpected(ok.error());
    return read();
  });
}

}  // namespace facet::io
