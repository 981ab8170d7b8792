#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <new>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/log.hpp"
#include "base/nearest.hpp"
#include "base/origin.hpp"
#include "base/text.hpp"
#include "frame/session.hpp"
#include "frame/settings.hpp"
#include "library/facet.h"
#include "options/picture_options.hpp"
#include "options/remarks.hpp"

using namespace facet;

namespace {

// A thread that does what it is given, one after the other; OpenGL is current on it alone.
class Worker {
 public:
  Worker() : thread_([this] { work(); }) {}
  ~Worker() {
    give({});
    thread_.join();
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  // Waits for its end.
  void run(const std::function<void()>& task) {
    give(&task);
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !given_; });
  }

 private:
  void give(const std::function<void()>* task) {
    const std::lock_guard lock(mutex_);
    task_ = task, given_ = true;
    changed_.notify_all();
  }
  void work() {
    for (;;) {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return given_; });
      if (!task_) return;
      lock.unlock();
      (*task_)();
      lock.lock();
      given_ = false;
      changed_.notify_all();
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  const std::function<void()>* task_ = nullptr;  // null: to end
  bool given_ = false;
  std::thread thread_;  // last: it uses the rest
};

constexpr const char* noRenderer = "there is no renderer: the memory or the system's threads did not suffice.";

}  // namespace

struct facet_renderer {
  bool cache = true;
  std::string shaderDir;                    // of the session
  std::unique_ptr<frame::Session> session;  // of the worker
  std::string model;
  options::PictureArguments arguments;
  // What the caller may ask for.
  frame::Picture picture;
  std::vector<uint8_t> pixels;  // four bytes each
  std::string message, command;
  std::vector<std::string> warnings;

  std::mutex calls;
  std::unique_ptr<Worker> worker = {};
};

namespace {

// A status, and what is wrong in the renderer.
int tell(facet_renderer& renderer, const Error& error, int status = FACET_BAD_INPUT) {
  renderer.message = options::describe(error);
  return status;
}

void warn(facet_renderer& renderer, const Notes& notes) {
  for (const Note& note : notes)
    if (note.severity == Note::Severity::warning) renderer.warnings.push_back(options::describe(renderer.model, note));
}

// One call: on the renderer's thread; what a library throws becomes a sentence.
int call(facet_renderer* renderer, const std::function<int(facet_renderer&)>& work) {
  if (!renderer) return FACET_BAD_INPUT;
  const std::lock_guard lock(renderer->calls);
  renderer->message.clear(), renderer->warnings.clear();
  int status = FACET_GOOD;
  renderer->worker->run([&] {
    try {
      status = work(*renderer);
    } catch (const std::bad_alloc&) {
      status = tell(*renderer, {{}, {}, "the memory does not suffice", "give a smaller input"});
    } catch (const std::exception& error) {
      status = tell(*renderer, {{}, {}, error.what(), {}});
    }
  });
  return status;
}

int start(facet_renderer& renderer, const std::string& shaderDir) {
  if (renderer.session && renderer.shaderDir == shaderDir) return FACET_GOOD;
  renderer.session.reset();
  Result<std::unique_ptr<frame::Session>> made =
      frame::Session::create({.shaderDir = shaderDir, .diskCache = renderer.cache, .debug = false, .among = true});
  if (!made) return tell(renderer, made.error(), FACET_NO_OPENGL);
  renderer.session = std::move(*made), renderer.shaderDir = shaderDir;
  return FACET_GOOD;
}

int load(facet_renderer& renderer, const std::string& model) {
  renderer.model.clear();
  frame::PictureSettings settings;
  if (const Result<void> r = options::apply(renderer.arguments, settings); !r) return tell(renderer, r.error());
  if (const int status = start(renderer, settings.sources.shaderDir); status != FACET_GOOD) return status;
  Notes notes;
  if (const Result<void> r = renderer.session->load(model, settings, notes); !r) return tell(renderer, r.error());
  renderer.model = model;
  warn(renderer, notes);
  return FACET_GOOD;
}

int set(facet_renderer& renderer, const std::string& name, const char* value) {
  const options::PictureOption* const option = options::findOption(name);
  if (!option)
    return tell(renderer, {{}, inQuotes(name), "there is no such option", suggestion(name, options::optionNames())});
  if (!value) return renderer.arguments.erase(option->name), FACET_GOOD;
  frame::PictureSettings tried;
  if (const Result<void> r = option->parse(value, tried); !r)
    return tell(renderer, {{}, "--" + name, r.error().problem, r.error().remedy});
  renderer.arguments[option->name] = value;
  return FACET_GOOD;
}

std::vector<uint8_t> withAlpha(io::Pixels pixels) {
  if (pixels.channels == 4) return std::move(pixels.data);
  std::vector<uint8_t> out;
  out.reserve(pixels.data.size() / 3 * 4);
  for (size_t i = 0; i + 2 < pixels.data.size(); i += 3)
    out.insert(out.end(), {pixels.data[i], pixels.data[i + 1], pixels.data[i + 2], 255});
  return out;
}

int render(facet_renderer& renderer, int format, facet_picture& out) {
  renderer.picture = {}, renderer.pixels = {};
  const bool radiance = format == FACET_RGBA_FLOAT;
  if (!radiance && format != FACET_RGBA8)
    return tell(renderer, {{}, {}, "there is no format " + std::to_string(format), "give 0 (bytes) or 1 (floats)"});
  if (renderer.model.empty()) return tell(renderer, {{}, {}, "there is no model to draw", "load one"});
  frame::PictureSettings settings;
  if (const Result<void> r = options::apply(renderer.arguments, settings); !r) return tell(renderer, r.error());
  if (const int status = start(renderer, settings.sources.shaderDir); status != FACET_GOOD) return status;
  Notes notes;
  Stages stages;
  Result<frame::Picture> picture =
      renderer.session->render(renderer.model, settings, {.radiance = radiance, .display = !radiance}, notes, stages);
  if (!picture) {
    if (gl::isOfDriver(picture.error())) renderer.session.reset();  // the next one begins anew
    return tell(renderer, picture.error());
  }
  warn(renderer, notes);
  warn(renderer, options::remarksOn(settings, picture->statistics, radiance).notes);
  renderer.command = options::commandLine(settings, renderer.model, radiance ? "picture.exr" : "picture.png");
  renderer.picture = std::move(*picture);
  if (!radiance) renderer.pixels = withAlpha(std::move(renderer.picture.display));
  const std::vector<glm::vec4>& floats = renderer.picture.radiance.pixels;
  out = {settings.frame.width, settings.frame.height, format,
         radiance ? floats.size() * sizeof(glm::vec4) : renderer.pixels.size(),
         radiance ? static_cast<const void*>(floats.data()) : renderer.pixels.data()};
  return FACET_GOOD;
}

struct OptionText {
  std::string name, help;
};
const std::vector<OptionText>& optionTexts() {
  static const std::vector<OptionText> texts = [] {
    std::vector<OptionText> all;
    for (const options::PictureOption& option : options::pictureOptions())
      all.push_back({std::string(option.name), options::helpOf(option)});
    return all;
  }();
  return texts;
}

}  // namespace

const char* facet_version() {
  static const std::string version = programVersion();
  return version.c_str();
}

int facet_interface() { return FACET_INTERFACE; }

int facet_open(unsigned flags, facet_renderer** renderer) {
  if (!renderer) return FACET_BAD_INPUT;
  *renderer = nullptr;
  try {
    log::setLevel(log::Level::quiet);
    auto made = std::make_unique<facet_renderer>();
    made->cache = (flags & FACET_NO_CACHE) == 0;
    made->worker = std::make_unique<Worker>();
    *renderer = made.release();
  } catch (const std::exception&) {
    return FACET_BAD_INPUT;
  }
  return call(*renderer, [](facet_renderer& r) { return start(r, {}); });
}

void facet_close(facet_renderer* renderer) {
  if (!renderer) return;
  call(renderer, [](facet_renderer& r) { return r.session.reset(), FACET_GOOD; });
  renderer->worker.reset();
  delete renderer;
}

int facet_load(facet_renderer* renderer, const char* model) {
  return call(renderer, [&](facet_renderer& r) {
    return model && *model ? load(r, model) : tell(r, {{}, {}, "no model is named", "give a file or builtin:NAME"});
  });
}

int facet_set(facet_renderer* renderer, const char* option, const char* value) {
  return call(renderer, [&](facet_renderer& r) { return set(r, option ? option : "", value); });
}

int facet_render(facet_renderer* renderer, int format, facet_picture* picture) {
  if (picture) *picture = {};
  return call(renderer, [&](facet_renderer& r) {
    return picture ? render(r, format, *picture) : tell(r, {{}, {}, "there is no place for the picture", {}});
  });
}

const char* facet_message(const facet_renderer* renderer) { return renderer ? renderer->message.c_str() : noRenderer; }

const char* facet_warning(const facet_renderer* renderer, size_t index) {
  return renderer && index < renderer->warnings.size() ? renderer->warnings[index].c_str() : nullptr;
}

const char* facet_command(const facet_renderer* renderer) { return renderer ? renderer->command.c_str() : ""; }

const char* facet_option_name(size_t index) {
  return index < optionTexts().size() ? optionTexts()[index].name.c_str() : nullptr;
}

const char* facet_option_help(size_t index) {
  return index < optionTexts().size() ? optionTexts()[index].help.c_str() : nullptr;
}
