#pragma once

// Many pictures in one process: the context, the programs, environments with their tables and the current model are
// shared, so that the second picture pays only for what is new.

#include <map>
#include <memory>
#include <string>

#include "frame/picture.hpp"
#include "gl/context.hpp"
#include "io/bump.hpp"
#include "io/gltf.hpp"

namespace facet::frame {

// What is read and kept for several pictures.
struct Shelf {
  ibl::TableCache tableCache;  // the default: none
  std::map<std::string, std::unique_ptr<LoadedEnvironment>> environments = {};
  MeasuredStore measured = {};
};

// Everything at once, from the shelf or read; the notes of what is read, too. All of them must outlive the supply.
Supply supplyAtOnce(Shelf& shelf, shading::ProgramStore& programs, Notes& notes);

struct SessionOptions {
  std::string shaderDir;  // empty: the embedded shaders
  bool diskCache = true;  // program binaries, tables
  bool debug = false;     // KHR_debug
  bool among = false;     // gl::HeadlessContext
};

class Session {
 public:
  // Errors: no usable OpenGL.
  static Result<std::unique_ptr<Session>> create(const SessionOptions& options);

  // Reads a model unless it is there already; the next picture of it finds it. After an error there is none.
  Result<void> load(const std::string& model, const PictureSettings& settings, Notes& notes);

  // Loads what the picture names and is not there yet, then renders it. Notes: the model's (only when it was loaded by
  // this call), the environment's, the picture's. After an error of the driver (gl::isOfDriver) what the session keeps
  // is not to be relied on: another one begins anew.
  Result<Picture> render(const std::string& model, const PictureSettings& settings, const PictureRequest& request,
                         Notes& notes, Stages& stages);

  const gl::ContextInfo& context() const { return context_.info(); }
  // The model of the last picture.
  const io::LoadedModel* model() const { return model_.get(); }
  std::string environmentName() const { return environmentName_; }

 private:
  explicit Session(gl::HeadlessContext context, const SessionOptions& options);
  Result<Picture> draw(const std::string& model, const PictureSettings& settings, const PictureRequest& request,
                       Notes& notes, Stages& stages);

  gl::HeadlessContext context_;  // first: everything below is freed before it
  shading::ProgramStore programs_;
  Shelf shelf_;
  std::shared_ptr<io::LoadedModel> model_;  // of the scene
  std::string allowOutside_;                // with which it was read
  std::unique_ptr<LoadedScene> scene_;
  std::string environmentName_;
};

}  // namespace facet::frame
