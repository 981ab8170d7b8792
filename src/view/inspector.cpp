#include "view/inspector.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "frame/gather.hpp"
#include "scene/material_properties.hpp"
#include "view/camera_control.hpp"
#include "view/measured_panel.hpp"

namespace facet::view {

namespace {

constexpr double thinTolerance = 4;  // pixels of the window, for lines and points

const scene::Model& modelOf(const Viewport& viewport) { return viewport.scene->loaded->model; }

// The pose of what is shown, which the settings may have left already.
Result<scene::Pose> shownPose(const Viewport& viewport) {
  frame::PictureSettings settings;
  settings.placement.animation = viewport.shown.inputs.list.animation;
  settings.placement.timeSeconds = viewport.shown.inputs.list.timeSeconds;
  settings.placement.arrangement = viewport.shown.inputs.list.arrangement;
  return frame::choosePose(settings.placement, modelOf(viewport));
}

// The draw of a node's primitive; null where it is not drawn.
const frame::Draw* drawOf(const frame::DrawList& list, int node, const scene::Primitive& primitive) {
  for (const std::vector<frame::Draw>* draws : list.classes())
    for (const frame::Draw& draw : *draws) {
      if (draw.primitive != &primitive) continue;
      const auto first = list.instanceNodes.begin() + draw.firstInstance;
      if (std::find(first, first + draw.instanceCount, node) != first + draw.instanceCount) return &draw;
    }
  return nullptr;
}

const scene::Primitive& primitiveOf(const scene::Model& model, const scene::Hit& hit) {
  return model.meshes[static_cast<size_t>(hit.mesh)].primitives[static_cast<size_t>(hit.primitive)];
}

// A part of the list, as a debug channel shows it at one pixel of the picture: drawn as the picture's own band of two
// rows (so that texture levels are the picture's), but for the pixels of one quad. Nothing where it is not there.
Result<std::optional<glm::vec4>> valueAt(Viewport& viewport, const Inspection& at, const frame::PictureSettings& shown,
                                         const scene::Hit& hit, int channel) {
  const scene::Model& model = modelOf(viewport);
  const scene::Primitive* primitive = &primitiveOf(model, hit);
  const frame::DrawList part = frame::partOf(
      viewport.shown.list, [&](int node, const scene::Primitive& p) { return node == hit.node && &p == primitive; },
      channel);
  if (part.opaque.empty() || !frame::isOnGpu(model, part, viewport.scene->gpu)) return std::nullopt;
  frame::PictureSettings settings = shown;
  settings.look.channel = shading::channelSetting(channel);
  settings.quality.samples = 1;
  settings.frame.background = frame::Background::transparent;
  frame::FrameInput in = frame::frameInput(viewport.shown, part, at.view, settings);
  in.firstRow = at.pixel.y & ~1;
  in.precise = true;
  if (Result<void> r = frame::preparePrograms(in, viewport.programs); !r) return tl::unexpected(r.error());
  const frame::Targets targets = frame::createValueTargets(settings.frame.width, 2, GL_RGBA32F);
  frame::setTextureDetail(in.gpu, 1, settings.quality.textureFilter, viewport.context);
  frame::Gathering gathering = frame::beginGathering(in, targets);
  glEnable(GL_SCISSOR_TEST);
  glScissor(at.pixel.x & ~1, 0, 2, 2);
  const Result<void> drawn = frame::gatherRows(in, targets, gathering, targets.height, viewport.programs);
  glDisable(GL_SCISSOR_TEST);
  if (!drawn) return tl::unexpected(drawn.error());
  glm::vec4 value(0);
  glGetTextureSubImage(targets.color.id(), 0, at.pixel.x, at.pixel.y & 1, 0, 1, 1, 1, GL_RGBA, GL_FLOAT, sizeof value,
                       &value.x);
  if (value.a == 0) return std::nullopt;
  return value;
}

// What a measured BRDF has taken the place of.
bool isReplaced(shading::Channel channel) {
  using enum shading::Channel;
  constexpr shading::Channel kept[] = {normal,      geometryNormal, faceNormal,   tangent,  bitangent, handedness,
                                       vertexColor, alpha,          texelDensity, mipLevel, occlusion, emissive};
  return std::ranges::find(kept, channel) == std::ranges::end(kept);
}

// Is it to be looked up there? Not what tells of the pixel alone, nor what is told beside it.
bool isAsked(int channel, const scene::Primitive& primitive, const scene::Material& material, bool measured) {
  using shading::Channel, shading::ChannelKind;
  const ChannelKind kind = shading::channelKind(channel);
  const auto which = static_cast<Channel>(channel);
  if (kind == ChannelKind::pattern || kind == ChannelKind::identity) return false;
  if (which == Channel::depth || which == Channel::overdraw) return false;
  if (measured && isReplaced(which)) return false;
  return shading::hasChannel(channel, material, primitive);
}

glm::ivec2 pixelOf(const frame::PictureSettings& settings, const glm::dvec2& at, const glm::dvec2& windowSize) {
  const glm::dvec2 share = at / windowSize;
  return {std::clamp(static_cast<int>(share.x * settings.frame.width), 0, settings.frame.width - 1),
          std::clamp(static_cast<int>((1 - share.y) * settings.frame.height), 0, settings.frame.height - 1)};
}

// The first hit that is drawn.
const scene::Hit* firstSeen(Viewport& viewport, const ViewerState& state, const Inspection& at,
                            const std::vector<scene::Hit>& hits) {
  const double nearest = at.view.orthographic ? 0 : at.view.zNear / std::sqrt(3.0) * 1e-9;
  for (const scene::Hit& hit : hits) {
    const frame::Draw* draw = drawOf(viewport.shown.list, hit.node, primitiveOf(modelOf(viewport), hit));
    if (!draw || hit.distance < nearest || (!hit.front && !draw->doubleSided)) continue;
    const scene::Material& material = viewport.shown.list.materials[static_cast<size_t>(draw->material)];
    if (material.alphaMode != scene::AlphaMode::mask) return &hit;
    const auto alpha = valueAt(viewport, at, state.settings, hit, static_cast<int>(shading::Channel::alpha));
    if (!alpha || *alpha) return &hit;
  }
  return nullptr;
}

struct Click {
  const scene::FlatScene& flat;
  const scene::Pose& pose;
  double tolerance;  // pixels of the picture
};

// As seen by the view, in pixels from the lower left.
glm::dvec2 pictureOf(const scene::View& view, const frame::PictureSettings& settings, const glm::dvec3& world) {
  const glm::dvec4 clip = view.clipFromWorld * glm::dvec4(world, 1);
  return (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(settings.frame.width, settings.frame.height);
}

PixelRay rayThroughPicture(const scene::View& view, const frame::PictureSettings& settings, const glm::dvec2& pixel) {
  const glm::dvec2 size(settings.frame.width, settings.frame.height);
  return rayThrough(view, {pixel.x, size.y - pixel.y}, size);
}

// How far the surface that a line lies on may rise before it within the tolerance.
double riseAt(const scene::View& view, const frame::PictureSettings& settings, double tolerance,
              const glm::dvec3& world) {
  const double depth = view.orthographic ? 1 : glm::dot(world - view.eye, view.forward);
  return 2 * tolerance * 2 * depth / (view.clipFromView[1][1] * settings.frame.height);
}

// Of the pixels around the place, the nearest one that the line or point covers: how it is rasterised is the driver's.
glm::ivec2 coveredPixel(Viewport& viewport, const ViewerState& state, Inspection at, const scene::Hit& hit,
                        const glm::dvec2& place) {
  const glm::ivec2 last(state.settings.frame.width - 1, state.settings.frame.height - 1);
  const glm::ivec2 middle = glm::clamp(glm::ivec2(glm::floor(place)), glm::ivec2(0), last);
  std::vector<glm::ivec2> around;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) around.push_back(glm::clamp(middle + glm::ivec2(x, y), glm::ivec2(0), last));
  std::ranges::stable_sort(around, {}, [&](glm::ivec2 p) { return glm::distance(glm::dvec2(p) + 0.5, place); });
  for (const glm::ivec2 pixel : around) {
    at.pixel = pixel;
    const auto alpha = valueAt(viewport, at, state.settings, hit, static_cast<int>(shading::Channel::alpha));
    if (alpha && *alpha) return pixel;
  }
  return middle;
}

// Where at.pixel is near to it, the line or point that is seen there, and the pixel where it is. surface: what was
// clicked otherwise; may be null.
std::optional<scene::Hit> thinSeen(Viewport& viewport, const ViewerState& state, const Click& click, Inspection& at,
                                   const scene::Hit* surface) {
  constexpr size_t tried = 16;
  const scene::Model& model = modelOf(viewport);
  const frame::PictureSettings& s = state.settings;
  const glm::dvec2 centre = glm::dvec2(at.pixel) + 0.5;
  const PixelRay ray = rayThroughPicture(at.view, s, centre);
  std::vector<scene::Hit> hits =
      scene::pickThin(model, click.flat, click.pose, {ray.origin, ray.direction},
                      {at.view.clipFromWorld, centre, glm::dvec2(s.frame.width, s.frame.height), click.tolerance});
  if (hits.size() > tried) hits.resize(tried);
  for (const scene::Hit& hit : hits) {
    const double rise = riseAt(at.view, s, click.tolerance, hit.position);
    if (surface && surface->distance < hit.distance - rise) continue;
    Inspection there = at;
    const glm::dvec2 pixel = pictureOf(at.view, s, hit.position);
    there.pixel =
        glm::clamp(glm::ivec2(glm::floor(pixel)), glm::ivec2(0), glm::ivec2(s.frame.width - 1, s.frame.height - 1));
    if (!firstSeen(viewport, state, there, {hit})) continue;
    const PixelRay through = rayThroughPicture(at.view, s, pixel);
    const std::vector<scene::Hit> before =
        scene::pick(model, click.flat, click.pose, {through.origin, through.direction});
    const scene::Hit* hides = firstSeen(viewport, state, there, before);
    const double distance = glm::dot(hit.position - through.origin, through.direction);
    if (hides && hides->distance < distance - rise) continue;
    at.pixel = coveredPixel(viewport, state, there, hit, pixel);
    return hit;
  }
  return std::nullopt;
}

std::string text(const char* format, double a, double b = 0, double c = 0, double d = 0) {
  char line[128];
  std::snprintf(line, sizeof line, format, a, b, c, d);
  return line;
}

std::string formatText(GLint format) {
  switch (format) {
    case GL_R8:
      return "R8";
    case GL_RG8:
      return "RG8";
    case GL_RGB8:
      return "RGB8";
    case GL_RGBA8:
      return "RGBA8";
    case GL_SRGB8:
      return "sRGB8";
    case GL_SRGB8_ALPHA8:
      return "sRGB8 + A8";
    case GL_R16:
      return "R16";
    case GL_RG16:
      return "RG16";
    case GL_RGB16:
      return "RGB16";
    case GL_RGBA16:
      return "RGBA16";
    default:
      return "";
  }
}

void addTextures(const Viewport& viewport, const scene::Material& material, std::vector<Detail>& details) {
  const scene::Model& model = modelOf(viewport);
  const frame::GpuScene& gpu = viewport.scene->gpu;
  for (const scene::TextureSlot slot : scene::textureSlots) {
    const scene::TextureRef& ref = textureRef(material, slot);
    if (!ref) continue;
    const scene::Texture& texture = model.textures[static_cast<size_t>(ref.texture)];
    const std::string name =
        texture.image >= 0 ? model.images[static_cast<size_t>(texture.image)].name : std::string("no image");
    std::string value = name;
    const GLuint id = frame::boundTexture(gpu, model, material, slot).texture;
    if (id == gpu.placeholder.id()) {
      value += scene::usesTexture(material, slot) ? "\nnot loaded: the picture does not read it"
                                                  : "\nnot loaded: it changes nothing";
    } else {
      GLint width = 0, height = 0, format = 0;
      glGetTextureLevelParameteriv(id, 0, GL_TEXTURE_WIDTH, &width);
      glGetTextureLevelParameteriv(id, 0, GL_TEXTURE_HEIGHT, &height);
      glGetTextureLevelParameteriv(id, 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
      value += "\n" + std::to_string(width) + " x " + std::to_string(height) + " " + formatText(format);
    }
    if (ref.texCoord > 0) value += ", TEXCOORD_" + std::to_string(ref.texCoord);
    if (ref.transform != scene::TextureTransform{}) value += ", transformed";
    details.push_back({scene::name(slot), value});
  }
}

}  // namespace

bool isWithin(const scene::Model& model, int node, int ancestor) {
  for (; node >= 0; node = model.nodes[static_cast<size_t>(node)].parent)
    if (node == ancestor) return true;
  return false;
}

scene::Bounds selectionBounds(const Viewport& viewport, const ViewerState& state) {
  const int selected = state.selection.node;
  if (selected < 0 || !viewport.scene) return {};
  return frame::boundsOf(viewport.shown.list, [&](int node) { return isWithin(modelOf(viewport), node, selected); });
}

std::vector<Detail> materialDetails(const Viewport& viewport, int index) {
  const scene::Model& model = modelOf(viewport);
  const auto& known = model.materials;
  scene::Material given, usual;
  if (index >= 0 && index < static_cast<int>(known.size())) given = known[static_cast<size_t>(index)];
  std::vector<Detail> details;
  constexpr const char* modes[] = {"opaque", "mask", "blend"};
  details.push_back({"alpha", modes[static_cast<int>(given.alphaMode)]});
  if (given.doubleSided) details.push_back({"sides", "both"});
  if (given.unlit) details.push_back({"model", "unlit"});
  if (given.specularGlossiness) details.push_back({"model", "specular-glossiness"});
  for (const scene::MaterialProperty& property : scene::materialProperties()) {
    const auto values = components(given, property);
    const std::string_view path = property.path;
    const bool core = path.starts_with("pbrMetallicRoughness/"), extended = path.starts_with("extensions/");
    if (!core && std::ranges::equal(values, components(usual, property))) continue;
    std::string value;
    for (const float v : values) value += (value.empty() ? "" : ", ") + text("%.4g", static_cast<double>(v));
    details.push_back({std::string(core || extended ? path.substr(path.find_last_of('/') + 1) : path), value});
  }
  if (!given.conductor.empty()) details.push_back({"complex index", given.conductor});
  addTextures(viewport, given, details);
  return details;
}

void selectNode(ViewerState& state, int node) {
  state.selection = {node, -1, false};
  state.inspection = {};
}

void clickAt(Viewport& viewport, ViewerState& state, const glm::dvec2& at, const glm::dvec2& windowSize) {
  const std::optional<scene::View> view = currentView(viewport, state);
  if (!view) return;
  selectNode(state, -1);
  const Result<scene::Pose> pose = shownPose(viewport);
  if (!pose) return;
  Inspection inspection;
  inspection.view = *view;
  inspection.pixel = pixelOf(state.settings, at, windowSize);
  inspection.listNumber = viewport.listNumber;
  // Through the pixel's centre, where it is shaded.
  const PixelRay through = rayThroughPicture(*view, state.settings, glm::dvec2(inspection.pixel) + 0.5);
  const scene::Model& model = modelOf(viewport);
  const scene::FlatScene flat = scene::flatten(model, viewport.shown.inputs.list.scene, *pose);
  const std::vector<scene::Hit> hits = scene::pick(model, flat, *pose, {through.origin, through.direction});
  const scene::Hit* surface = firstSeen(viewport, state, inspection, hits);
  const Click click{flat, *pose, thinTolerance * state.settings.frame.height / windowSize.y};
  const std::optional<scene::Hit> thin = thinSeen(viewport, state, click, inspection, surface);
  const scene::Hit* hit = thin ? &*thin : surface;
  if (!hit) return;
  const scene::Primitive& primitive = primitiveOf(model, *hit);
  const frame::Draw* draw = drawOf(viewport.shown.list, hit->node, primitive);
  inspection.on = true;
  inspection.hit = *hit;
  inspection.uv = scene::interpolated(primitive.texCoords[0], *hit);
  inspection.material = draw->material;
  const bool own =
      !viewport.shown.inputs.list.options.material.on && draw->material < static_cast<int>(model.materials.size());
  if (own) inspection.materialName = model.materials[static_cast<size_t>(draw->material)].name;
  if (own && inspection.materialName.empty()) inspection.materialName = "material " + std::to_string(draw->material);
  if (!own)
    inspection.materialName = viewport.shown.inputs.list.options.material.on ? "one for everything" : "glTF's default";
  inspection.materialDetails = own ? materialDetails(viewport, draw->material) : std::vector<Detail>{};
  inspection.measured = shading::isMeasured(draw->key) && state.shown.measured;
  if (inspection.measured) {
    inspection.materialName += ", replaced";
    inspection.materialDetails = measuredDetails(*state.shown.measured, state.settings.look.brdfLookUp);
    if (state.shown.fit)
      std::ranges::move(fitDetails(*state.shown.fit), std::back_inserter(inspection.materialDetails));
  }
  state.inspection = std::move(inspection);
  state.selection = {hit->node, own ? draw->material : -1, true};
  readRadianceThere(viewport, state);
}

void readRadianceThere(const Viewport& viewport, ViewerState& state) {
  Inspection& at = state.inspection;
  if (!at.on || viewport.moving.underWay || !viewport.targets.color || at.listNumber != viewport.listNumber ||
      !viewport.drawn)
    return;
  const std::optional<scene::View> view = currentView(viewport, state);
  if (!view || view->clipFromWorld != at.view.clipFromWorld || viewport.shown.list.features.channel != 0) return;
  const frame::Targets& targets = viewport.targets;
  if (at.pixel.x >= targets.width || at.pixel.y >= targets.height) return;
  glm::vec4 value(0);
  float scale = 1;
  const gl::Texture* source = &targets.color;
  const Refinement& refinement = viewport.refinement;
  if (refinement.shown && refinement.gathering) {
    if (refinement.gathering->rows != 0) return;
    source = &refinement.targets.sum;
    scale = static_cast<float>(refinement.gathering->draws()) / static_cast<float>(refinement.gathering->done);
  }
  glGetTextureSubImage(source->id(), 0, at.pixel.x, at.pixel.y, 0, 1, 1, 1, GL_RGBA, GL_FLOAT, sizeof value, &value.x);
  at.radiance = glm::vec3(value) * scale * frame::radianceUnit(state.settings.display, 0);
}

bool inspectNext(Viewport& viewport, ViewerState& state) {
  Inspection& at = state.inspection;
  constexpr int channels = shading::channelCount;
  if (!at.on || !viewport.scene) return false;
  if (at.listNumber != viewport.listNumber) at.nextChannel = channels;  // what was clicked is no longer there
  while (at.nextChannel < channels) {
    const int channel = at.nextChannel++;
    const scene::Primitive& primitive = primitiveOf(modelOf(viewport), at.hit);
    const scene::Material& material = viewport.shown.list.materials[static_cast<size_t>(at.material)];
    if (!isAsked(channel, primitive, material, at.measured)) continue;
    const auto value = valueAt(viewport, at, state.settings, at.hit, channel);
    if (!value) return state.status = {describe(value.error()), true}, false;
    if (!*value) continue;
    at.values[static_cast<size_t>(channel)] = glm::vec3(**value);
    break;
  }
  return at.nextChannel < channels;
}

}  // namespace facet::view
