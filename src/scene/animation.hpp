#pragma once

// Animations -> the pose at a time (glTF 2.0, 3.11 and appendix C). Pure functions, double precision.

#include <span>
#include <string>

#include "base/error.hpp"
#include "scene/pose.hpp"

namespace facet::scene {

// The sampler's value at a time; out has sampler.width numbers. Before the first key its value, after the last key its
// value (3.11); a time that is no number counts as before the first. Rotations (isRotation, width 4): linear is a
// spherical interpolation along the shortest way (C.4), the cubic spline's result is normalised (C.5); a result without
// length is the identity.
void sampleAt(const AnimationSampler& sampler, double time, bool isRotation, std::span<double> out);

// Last key of all channels, seconds; 0 for an animation without channels.
double duration(const Animation& animation);

// The one with that name, else with that index; "all" is every one, empty is none. A name wins over an index and over
// "all". Error: there is none such; lists those that there are.
Result<std::vector<int>> chooseAnimations(const Model& model, const std::string& wanted);

// The model when these animations stand at `time` seconds; of two that set the same property the later one wins. A
// node with a matrix that is animated has its matrix taken apart first (it has translation, rotation, scale; shear is
// lost, glTF forbids it). Values are brought to the ranges that model.hpp states, so that every result is finite and
// valid whatever a spline does between its keys; visibility always jumps.
Pose poseAt(const Model& model, std::span<const int> animations, double time);

// The property that a channel names, brought to its range; as many numbers as it has. Rotations: x, y, z, w, of any
// length but 0.
void setProperty(Pose& pose, const Model& model, const AnimationChannel& channel, const std::vector<double>& value);

// What depends on two properties that are set by themselves is made valid when both are: inner < outer cone by 1e-4
// (the falloff divides by the difference of the cosines) and near < far plane.
void reconcile(Pose& pose);

}  // namespace facet::scene
