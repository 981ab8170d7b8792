// Rays against those of Embree, where it was found when the tests were configured.

#include <catch2/catch.hpp>

#include "support/skip.hpp"

#ifdef FACET_EMBREE
#if FACET_EMBREE == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
#include <cmath>
#include <limits>
#include <memory>
#include <random>

#include "frame/traced.hpp"
#include "support/picture.hpp"

using namespace facet;

namespace {

template <auto release>
struct Release {
  template <class T>
  void operator()(T* t) const {
    release(t);
  }
};

// One mesh of single triangles, in the order of the scene's, and robust, as ours are.
class Yardstick {
 public:
  explicit Yardstick(const rays::TracedScene& scene) {
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
    const std::unique_ptr<RTCGeometryTy, Release<rtcReleaseGeometry>> mesh(
        rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
    const size_t count = scene.triangles.size();
    auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(mesh.get(), RTC_BUFFER_TYPE_VERTEX, 0,
                                                                  RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * count));
    auto* indices = static_cast<uint32_t*>(
        rtcSetNewGeometryBuffer(mesh.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(uint32_t), count));
    for (size_t i = 0; i < count; ++i) {
      const rays::Triangle& t = scene.triangles[i];
      const glm::vec3 corners[] = {t.corner, t.corner + t.edge1, t.corner + t.edge2};
      for (size_t c = 0; c < 3; ++c) {
        for (int axis = 0; axis < 3; ++axis) positions[9 * i + 3 * c + static_cast<size_t>(axis)] = corners[c][axis];
        indices[3 * i + c] = static_cast<uint32_t>(3 * i + c);
      }
    }
    rtcCommitGeometry(mesh.get());
    rtcAttachGeometry(scene_.get(), mesh.get());
    rtcCommitScene(scene_.get());
  }

  // Index of the triangle and the distance; infinite: none.
  std::pair<uint32_t, float> meet(const rays::Ray& ray) const {
    RTCRayHit hit{};
    hit.ray.org_x = ray.origin.x, hit.ray.org_y = ray.origin.y, hit.ray.org_z = ray.origin.z;
    hit.ray.dir_x = ray.direction.x, hit.ray.dir_y = ray.direction.y, hit.ray.dir_z = ray.direction.z;
    hit.ray.tnear = ray.from, hit.ray.tfar = ray.to;
    hit.ray.mask = ~0u;
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if FACET_EMBREE == 4
    rtcIntersect1(scene_.get(), &hit);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_.get(), &context, &hit);
#endif
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {0, std::numeric_limits<float>::infinity()};
    return {hit.hit.primID, hit.ray.tfar};
  }

 private:
  std::unique_ptr<RTCDeviceTy, Release<rtcReleaseDevice>> device_{rtcNewDevice(nullptr)};
  std::unique_ptr<RTCSceneTy, Release<rtcReleaseScene>> scene_{rtcNewScene(device_.get())};
};

struct Agreement {
  int rays = 0, met = 0, differ = 0;
  double share() const { return 1 - static_cast<double>(differ) / rays; }
};

// Where both meet something at the same distance they may disagree about which of two triangles at an edge it is.
void compare(const rays::TracedScene& scene, const Yardstick& yardstick, const rays::Ray& ray, Agreement& agreement) {
  const std::optional<rays::Hit> hit = rays::meet(scene, ray);
  const float other = yardstick.meet(ray).second;
  ++agreement.rays;
  agreement.met += hit ? 1 : 0;
  const bool same = hit ? std::abs(hit->distance - other) <= 1e-4f * hit->distance : std::isinf(other);
  agreement.differ += same ? 0 : 1;
  CHECK(rays::isBlocked(scene, ray) == hit.has_value());
}

}  // namespace

TEST_CASE("Rays: first and second hits in a real scene are Embree's", "[rays]") {
  for (const char* name : {"builtin:poster", "builtin:spheres"}) {
    const io::LoadedModel model = test::loadBuiltin(name);
    const frame::DrawList list = frame::buildDrawList(model.model, 0, {.tracing = frame::Tracing::paths});
    const rays::TracedScene scene = frame::tracedList(list).scene;
    REQUIRE(scene.placements.empty());
    const Yardstick yardstick(scene);
    std::mt19937 engine(7);
    std::normal_distribution<float> normal;
    const auto radius = static_cast<float>(list.bounds.radius());
    const auto direction = [&] {
      return glm::normalize(glm::vec3(normal(engine), normal(engine), normal(engine)) + glm::vec3(1e-9f));
    };
    Agreement first, second;
    for (int i = 0; i < 20000; ++i) {
      const glm::vec3 eye = 2 * radius * direction(), at = 0.6f * radius * direction();
      const rays::Ray ray{.origin = eye, .direction = glm::normalize(at - eye)};
      compare(scene, yardstick, ray, first);
      const std::optional<rays::Hit> hit = rays::meet(scene, ray);
      if (!hit) continue;
      // Away from the surface, by so little as paths start.
      const glm::vec3 p = eye + (hit->distance * (1 - 1e-4f)) * ray.direction;
      compare(scene, yardstick, {.origin = p, .direction = direction()}, second);
    }
    INFO(name << ": " << first.met << " of " << first.rays << " met, " << first.differ << " differ; then " << second.met
              << " of " << second.rays << ", " << second.differ);
    CHECK(first.met > 2000);
    CHECK(second.met > 200);
    CHECK(first.share() >= 0.9999);
    CHECK(second.share() >= 0.9999);
  }
}
#else
TEST_CASE("Rays: first and second hits in a real scene are Embree's", "[rays]") {
  facet::test::skip("Embree was not found when the tests were configured (libembree-dev)");
}
#endif
