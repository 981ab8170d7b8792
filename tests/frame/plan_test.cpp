#include "frame/plan.hpp"

#include <catch2/catch.hpp>

#include "frame/settings.hpp"

using namespace facet;
using frame::PictureSettings;

namespace {

frame::ListInputs inputs(const PictureSettings& settings, bool moving = true) {
  return frame::listInputs(settings, nullptr, 0, -1, true, moving);
}

}  // namespace

TEST_CASE("Plan: only what the draw list reads asks for a new one") {
  PictureSettings settings;
  const frame::ListInputs before = inputs(settings);
  settings.display.exposureStops = 3;
  settings.frame.environmentRotationDeg = 90;
  settings.frame.occlusion = 0.5f;
  settings.look.material.metallic = 1;  // switched off
  settings.frame.background = frame::Background::transparent;
  CHECK(inputs(settings) == before);
  const auto changes = [&](auto change, bool moving = true) {
    PictureSettings other = settings;
    change(other);
    return inputs(other, moving) != inputs(settings, moving);
  };
  CHECK(changes([](PictureSettings& s) { s.frame.occlusion = 0; }));
  CHECK(changes([](PictureSettings& s) { s.frame.environmentStrength = 0; }));
  CHECK(changes([](PictureSettings& s) { s.look.channel = "uv"; }));
  CHECK(changes([](PictureSettings& s) { s.look.lights = frame::Lights::demo; }));
  CHECK(changes([](PictureSettings& s) { s.look.material.on = true; }));
  CHECK(changes([](PictureSettings& s) { s.look.models.diffuse = optics::DiffuseModel::eon; }));
  CHECK(changes([](PictureSettings& s) { s.look.models.masking = optics::Masking::cavity; }));
  CHECK(changes([](PictureSettings& s) { s.look.models.energy = optics::EnergyModel::none; }));
  CHECK_FALSE(changes([](PictureSettings& s) { s.quality.samples = 2; }));
  const auto converging = [](PictureSettings& s) { s.quality.samples = 16; };
  CHECK_FALSE(changes(converging));  // only at rest
  CHECK(changes(converging, false));
  CHECK_FALSE(changes([](PictureSettings& s) { s.placement.timeSeconds = 2; }));  // at rest
  settings.placement.animation = "all";
  CHECK(changes([](PictureSettings& s) { s.placement.timeSeconds = 2; }));
  CHECK(frame::listInputs(settings, nullptr, 1, -1, true, true) != inputs(settings));
  CHECK(frame::listInputs(settings, nullptr, 0, 0, true, true) != inputs(settings));
  CHECK(frame::listInputs(settings, nullptr, 0, -1, false, true) != inputs(settings));
}

TEST_CASE("Plan: what will be refined with a measured BRDF begins with the program that refines it") {
  PictureSettings settings;
  settings.sources.brdf = "a.binary";
  CHECK(inputs(settings).options.features.imageLightSamples == 0);
  settings.quality.samples = 16;
  CHECK(inputs(settings).options.features.imageLightSamples == frame::convergedLightSamples);
  settings.look.channel = "normal";  // where no BRDF is seen
  CHECK(inputs(settings).options.features.imageLightSamples == 0);
}
