#pragma once

// Reading and decoding beside the window: never calls OpenGL. Of each kind only the newest request counts; an older one
// that still runs ends unheard.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "frame/measured_read.hpp"
#include "ibl/prepared.hpp"
#include "io/bump.hpp"
#include "io/gltf.hpp"
#include "io/image.hpp"
#include "scene/environment.hpp"
#include "view/file_check.hpp"
#include "view/file_watch.hpp"
#include "view/latest.hpp"
#include "view/metadata_panel.hpp"

namespace facet::view {

// What a model is opened as.
enum class Opening {
  other,  // scene, camera, animation and variant that are chosen mean nothing in it
  first,  // what facet was started with: they are those of the command line, meant for it
  again   // it is shown already and its file has changed: they stay where the file still has them
};

struct ModelLoaded {
  std::string source;
  Opening opening = Opening::other;
  Result<std::shared_ptr<const io::LoadedModel>> model;
  FileWatch watch = {};  // of all that it consists of, as it was before it was read; none for built-in scenes
  std::vector<std::string> with = {};  // others in the same scene
  io::Bump bump = {};
};

struct EnvironmentLoaded {
  std::string source;
  bool again = false;
  Result<std::shared_ptr<const scene::Environment>> environment;  // null for "none"
  Notes notes;
  std::string content;                                            // ibl::contentKey
  std::shared_ptr<const ibl::PreparedEnvironment> prepared = {};  // its sun taken out
};

struct MeasuredLoaded {
  frame::MeasuredSource source;
  bool again = false;
  Result<frame::MeasuredBytes> read;
  FileWatch watch = {};  // of the file, as it was before it was read; none for built-in ones
};

struct FitMade {
  frame::MeasuredSource source;
  optics::DiffuseModel diffuse = optics::DiffuseModel::lambert;
  Result<frame::FittedBrdf> fit;
};

// A table to look values up in.
struct TableRead {
  frame::MeasuredSource source;
  Result<std::shared_ptr<const optics::MeasuredBrdf>> table;
};

struct ImagesDecoded {
  std::shared_ptr<const io::LoadedModel> model;
  Result<std::vector<io::Pixels>> pixels;
  Notes notes;
};

// A changed model, as a file.
struct ModelExported {
  std::string file;
  Result<void> written;
  Notes notes;
};

// What images are decoded of a model.
struct ImagesAsked {
  std::shared_ptr<const io::LoadedModel> model;
  std::vector<bool> wanted;  // by image
};

struct Loader {
  Latest<ModelLoaded> model;
  Latest<EnvironmentLoaded> environment;
  Latest<MeasuredLoaded> measured;
  Latest<FitMade> fit;
  Latest<TableRead> table;
  Latest<ImagesDecoded> images;
  Latest<FileChecked> fileCheck;
  Latest<MetadataRead> metadata;
  Latest<ModelExported> exported;
  ImagesAsked imagesAsked;             // the newest request for them
  std::string allowOutside;            // of models (frame::Sources)
  std::vector<std::string> with = {};  // others in the scene of the model that is read next (frame::Sources)
  bool editable = false;               // likewise: materials will be changed (io::Limits)

  bool running() const {
    return model.running() || environment.running() || measured.running() || fit.running() || table.running() ||
           images.running();
  }
};

void startModel(Loader& loader, const std::string& source, Opening opening = Opening::other, const io::Bump& bump = {});
void startEnvironment(Loader& loader, const std::string& source, bool again = false);
void startMeasured(Loader& loader, const frame::MeasuredSource& source, bool again = false);
void startFit(Loader& loader, const frame::MeasuredSource& source, optics::DiffuseModel diffuse);
void startTable(Loader& loader, const frame::MeasuredSource& source);
void startImages(Loader& loader, std::shared_ptr<const io::LoadedModel> model, std::vector<bool> wanted);
// All of these are on their way.
bool decodes(const Loader& loader, const std::shared_ptr<const io::LoadedModel>& model,
             const std::vector<bool>& wanted);

}  // namespace facet::view
