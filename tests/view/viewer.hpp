#pragma once

// The window's loop without a window, and what it has drawn.

#include <catch2/catch.hpp>
#include <thread>

#include "support/gpu.hpp"
#include "view/bring_up.hpp"

namespace facet::test {

// [0, 1], row by row from the top, as pictures are.
inline std::vector<glm::dvec4> texelsOf(const gl::Texture& picture) {
  const auto width = static_cast<size_t>(picture.description().width),
             height = static_cast<size_t>(picture.description().height);
  std::vector<glm::vec4> texels(width * height);
  glGetTextureImage(picture.id(), 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(texels.size() * sizeof(glm::vec4)),
                    texels.data());
  std::vector<glm::dvec4> rows;
  for (size_t y = height; y-- > 0;)
    for (size_t x = 0; x < width; ++x) rows.emplace_back(texels[y * width + x]);
  return rows;
}

struct Viewer {
  view::Loader loader;
  view::ViewerState state;
  view::Viewport viewport{contextInfo(), makeProgramStore()};

  Viewer() {
    state.settings.frame.width = 64;
    state.settings.frame.height = 48;
    state.settings.quality.samples = 1;
    state.environments = view::builtinEnvironmentSources();
    viewport.refinement.restDelay = {};
    viewport.environments.immediateMs = 1e9;  // no previews
  }

  // Until nothing is under way.
  void settle() {
    for (int i = 0; i < 2000; ++i) {
      if (auto model = loader.model.take()) view::takeModel(viewport, state, std::move(*model));
      if (auto map = loader.environment.take()) view::takeEnvironment(viewport, state, std::move(*map));
      if (auto brdf = loader.measured.take()) view::takeMeasured(viewport, state, std::move(*brdf));
      if (auto fit = loader.fit.take()) view::takeFit(viewport, state, std::move(*fit));
      if (auto images = loader.images.take()) view::takeImages(viewport, state, std::move(*images));
      if (auto table = loader.table.take()) view::takeTable(state, std::move(*table));
      view::bringUp(viewport, state, loader);
      view::followSecond(viewport, state, loader);
      view::followLobe(state, loader);
      view::followFileCheck(state, loader);
      if (auto checked = loader.fileCheck.take(state.fileCheck.wanted)) view::takeFileCheck(state, std::move(*checked));
      if (!loader.running() && !viewport.second.loader.running() && !viewport.comingUp) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    REQUIRE_FALSE(loader.running());
  }
  void load(const std::string& source) {
    view::startModel(loader, source, viewport.scene ? view::Opening::other : view::Opening::first);
    settle();
  }
  io::Pixels display() const { return frame::readDisplay(viewport.targets, false); }
  // Draws and refines until the picture has converged; turns that it took.
  int converge() {
    view::drawViewport(viewport, state);
    int turns = 0;
    for (; view::atWork(viewport, state) && turns < 100'000; ++turns) {
      view::drawViewport(viewport, state);
      glFinish();
      if (viewport.trees.making.running()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    REQUIRE_FALSE(view::atWork(viewport, state));
    return turns;
  }
  // The channel of a pixel in the middle of the picture, 8 bit.
  glm::ivec3 middle() {
    view::drawViewport(viewport, state);
    const io::Pixels pixels = display();
    const size_t at = (static_cast<size_t>(pixels.height / 2) * static_cast<size_t>(pixels.width) +
                       static_cast<size_t>(pixels.width / 2)) *
                      3;
    return {pixels.data[at], pixels.data[at + 1], pixels.data[at + 2]};
  }
};

}  // namespace facet::test
