#include "rays/traced_scene.hpp"

#include <catch2/catch.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <random>
#include <set>

using namespace facet;
using rays::Triangle;

namespace {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  float in(float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine_); }
  glm::vec3 point(float size) { return {in(-size, size), in(-size, size), in(-size, size)}; }

 private:
  std::mt19937 engine_;
};

std::vector<Triangle> randomTriangles(Random& random, size_t count, float size, float edge) {
  std::vector<Triangle> triangles;
  for (size_t i = 0; i < count; ++i)
    triangles.push_back({random.point(size), 3, random.point(edge), static_cast<uint32_t>(i), random.point(edge), 0});
  return triangles;
}

struct Crossing {
  uint32_t triangle;
  double distance;
};

// In double precision, one triangle after another.
std::optional<Crossing> nearest(const std::vector<Triangle>& triangles, const glm::dmat4& place, const rays::Ray& ray) {
  std::optional<Crossing> best;
  for (const Triangle& t : triangles) {
    const glm::dmat3 m(place);
    const glm::dvec3 a = m * glm::dvec3(t.edge1), b = m * glm::dvec3(t.edge2);
    const glm::dvec3 s = glm::dvec3(ray.origin) - glm::dvec3(place * glm::dvec4(t.corner, 1));
    const glm::dvec3 d = ray.direction, p = glm::cross(d, b), q = glm::cross(s, a);
    const double determinant = glm::dot(a, p);
    const double u = glm::dot(s, p) / determinant, v = glm::dot(d, q) / determinant;
    const double distance = glm::dot(b, q) / determinant;
    if (!(u >= 0 && v >= 0 && u + v <= 1 && distance > double(ray.from) && distance < double(ray.to))) continue;
    if (!best || distance < best->distance) best = Crossing{t.triangle, distance};
  }
  return best;
}

}  // namespace

TEST_CASE("Rays meet the triangle that is nearest, as one after another in double precision", "[rays]") {
  Random random(1);
  const std::vector<Triangle> triangles = randomTriangles(random, 3000, 1, 0.1f);
  const rays::TracedScene scene = rays::tracedScene({{triangles, {}}});
  CHECK(scene.placements.empty());
  int met = 0, wrong = 0;
  for (int i = 0; i < 4000; ++i) {
    rays::Ray ray{random.point(1.5f), random.point(1)};
    if (i % 5 == 0) ray.direction[i % 3] = 0;
    if (i % 7 == 0) ray.from = 0.3f, ray.to = 0.9f;
    const auto hit = rays::meet(scene, ray);
    const auto truth = nearest(triangles, glm::dmat4(1), ray);
    met += truth.has_value();
    CHECK(rays::isBlocked(scene, ray) == hit.has_value());
    if (hit.has_value() != truth.has_value() || (hit && hit->triangle != truth->triangle)) {
      ++wrong;
      continue;
    }
    if (!hit) continue;
    CHECK(double(hit->distance) == Approx(truth->distance).epsilon(1e-4).margin(1e-5));
    CHECK(hit->primitive == 3);
    const Triangle& t = triangles[hit->triangle];
    const glm::vec3 at = t.corner + hit->weights.x * t.edge1 + hit->weights.y * t.edge2;
    CHECK(glm::length(at - ray.origin - hit->distance * ray.direction) < 1e-4f);
  }
  CHECK(met > 500);
  CHECK(wrong <= 1);  // an edge, met by rounding
}

TEST_CASE("Rays meet what stands in several places: turned, mirrored, stretched, far and small", "[rays]") {
  Random random(2);
  const std::vector<Triangle> single = randomTriangles(random, 300, 1, 0.2f);
  std::vector<Triangle> shared = randomTriangles(random, 200, 1, 0.3f);
  for (Triangle& t : shared)
    t.primitive = 7 | layout::rayHoled, t.instance = layout::rayOfPlacement, t.triangle += 1000;
  rays::TracedMesh placed{shared, {}};
  for (int i = 0; i < 40; ++i) {
    glm::dmat4 m = glm::translate(glm::dmat4(1), glm::dvec3(random.point(6)));
    m = glm::rotate(m, double(random.in(0, 6)), glm::normalize(glm::dvec3(random.point(1))));
    m = glm::scale(m, glm::dvec3(i % 3 == 0 ? -0.4 : 0.4, 0.1 + 0.02 * i, i == 5 ? 1e-3 : 0.5));
    placed.places.push_back({m, 100u + static_cast<uint32_t>(i)});
  }
  placed.places.push_back({glm::dmat4(0), 999});  // no volume: left out
  const rays::TracedScene scene = rays::tracedScene({{single, {}}, placed});
  CHECK(scene.placements.size() == 41);
  CHECK(scene.holed);
  std::set<uint32_t> instances;
  int wrong = 0;
  for (int i = 0; i < 3000; ++i) {
    const rays::Ray ray{random.point(8), random.point(1)};
    std::optional<Crossing> truth = nearest(single, glm::dmat4(1), ray);
    uint32_t instance = 0;
    for (size_t k = 0; k < 40; ++k) {
      const auto there = nearest(shared, placed.places[k].worldFromMesh, ray);
      if (there && (!truth || there->distance < truth->distance)) truth = there, instance = placed.places[k].instance;
    }
    const auto hit = rays::meet(scene, ray);
    if (hit.has_value() != truth.has_value() || (hit && hit->triangle != truth->triangle)) {
      ++wrong;
      continue;
    }
    if (!hit) continue;
    CHECK(double(hit->distance) == Approx(truth->distance).epsilon(1e-3));
    CHECK(hit->instance == instance);
    CHECK(hit->primitive == (hit->triangle >= 1000 ? 7u : 3u));
    instances.insert(hit->instance);
  }
  CHECK(instances.size() > 20);
  CHECK(wrong <= 2);
}

TEST_CASE("Trees hold whatever triangles there are: none, one, equal ones, flat ones, those that are none", "[rays]") {
  const rays::Ray down{{0.1f, 0.1f, 1}, {0, 0, -1}};
  CHECK_FALSE(rays::meet(rays::tracedScene({}), down));
  const Triangle one{{0, 0, 0}, 0, {1, 0, 0}, 0, {0, 1, 0}, 0};
  CHECK(rays::meet(rays::tracedScene({{{one}, {}}}), down)->distance == 1);
  std::vector<Triangle> equal(10000, one);
  CHECK(rays::meet(rays::tracedScene({{equal, {}}}), down)->distance == 1);
  Triangle line = one, lost = one, far = one;
  line.edge2 = line.edge1;
  lost.corner.x = std::numeric_limits<float>::quiet_NaN();
  far.edge1 = glm::vec3(std::numeric_limits<float>::infinity());
  CHECK(rays::tracedScene({{{line, lost, far}, {}}}).triangles.empty());
  CHECK(rays::tracedScene({{{line, one, lost}, {}}}).triangles.size() == 1);
}

TEST_CASE("Rays do not depend on a scene's size: a millionth of a metre and a million", "[rays]") {
  for (const float size : {1e-6f, 1.0f, 1e6f}) {
    Random random(3);
    std::vector<Triangle> triangles = randomTriangles(random, 500, size, 0.2f * size);
    const rays::TracedScene scene = rays::tracedScene({{triangles, {}}});
    int wrong = 0, met = 0;
    for (int i = 0; i < 500; ++i) {
      const rays::Ray ray{random.point(1.5f * size), glm::normalize(random.point(1))};
      const auto hit = rays::meet(scene, ray);
      const auto truth = nearest(triangles, glm::dmat4(1), ray);
      met += truth.has_value();
      wrong += hit.has_value() != truth.has_value() || (hit && hit->triangle != truth->triangle);
    }
    INFO("size " << size);
    CHECK(met > 50);
    CHECK(wrong <= 1);
  }
}

TEST_CASE("Trees: each box once, no box outside its parent's, no more than four to a leaf", "[rays]") {
  Random random(4);
  std::vector<rays::Box> boxes(5000);
  for (rays::Box& box : boxes) {
    box.add(random.point(10));
    box.add(box.min + glm::abs(random.point(0.5f)));
  }
  rays::Tree tree = rays::buildTree(boxes);
  const auto check = [&] {
    std::vector<int> seen(boxes.size(), 0);
    for (size_t n = 0; n < tree.nodes.size(); ++n)
      for (int i = 0; i < 4; ++i) {
        const uint32_t child = tree.nodes[n].children[size_t(i)];
        if (child == layout::rayNone) continue;
        const rays::Box box = tree.nodes[n].box(i);
        rays::Box content;
        if (child & layout::rayLeaf) {
          const uint32_t first = child & layout::rayFirstMask, count = (child >> layout::rayCountShift & 7u) + 1;
          CHECK(count <= layout::rayMostInLeaf);
          for (uint32_t j = first; j < first + count; ++j) ++seen[tree.order[j]], content.add(boxes[tree.order[j]]);
        } else {
          CHECK(child > n);
          for (int j = 0; j < 4; ++j) content.add(tree.nodes[child].box(j));
        }
        CHECK((box.min == content.min && box.max == content.max));
      }
    CHECK(std::all_of(seen.begin(), seen.end(), [](int count) { return count == 1; }));
  };
  check();
  const double built = rays::expectedCost(tree);
  CHECK(tree.nodes.size() < boxes.size());
  // Everything moves a little, then far: the tree still holds it, and its cost says that it should be built anew.
  for (rays::Box& box : boxes) {
    const glm::vec3 way = random.point(0.2f);
    box.min += way, box.max += way;
  }
  rays::refit(tree, boxes);
  check();
  CHECK(rays::expectedCost(tree) < 1.3 * built);
  for (rays::Box& box : boxes) {
    const glm::vec3 way = random.point(10);
    box.min += way, box.max += way;
  }
  rays::refit(tree, boxes);
  check();
  CHECK(rays::expectedCost(tree) > 1.5 * built);
  CHECK(rays::expectedCost(rays::buildTree(boxes)) < 1.5 * built);
}
