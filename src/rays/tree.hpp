#pragma once

// Trees of boxes, four to a node: built by the surface area heuristic, refitted where what they hold has moved. No
// OpenGL.

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <span>
#include <vector>

#include "rays.h"

namespace facet::rays {

struct Box {
  glm::vec3 min = glm::vec3(std::numeric_limits<float>::infinity());
  glm::vec3 max = glm::vec3(-std::numeric_limits<float>::infinity());

  void add(const glm::vec3& p) { min = glm::min(min, p), max = glm::max(max, p); }
  void add(const Box& b) { min = glm::min(min, b.min), max = glm::max(max, b.max); }
  bool empty() const { return !(min.x <= max.x); }
  float area() const {  // half of the surface
    const glm::vec3 d = max - min;
    return empty() ? 0.0f : d.x * d.y + d.y * d.z + d.z * d.x;
  }
};

// As the shader reads it: four boxes by axis, and what is in them (layout::rayLeaf and its like). An absent child's box
// is empty.
struct Node {
  struct Range {
    std::array<float, 4> min, max;
  };
  std::array<Range, 3> axes;
  std::array<uint32_t, 4> children;

  Box box(int child) const;
  void setBox(int child, const Box& box);
};
static_assert(sizeof(Node) == layout::rayNodeTexels * 16);

// Parents come before their children; the root is node 0. Leaves are runs in `order`.
struct Tree {
  std::vector<Node> nodes;
  std::vector<uint32_t> order;  // indices of the boxes that it was built over

  Box bounds() const;
};

// Over boxes that are finite, at most layout::rayMostInLeaf to a leaf; the same tree from the same boxes on any number
// of cores. Binned surface area heuristic (Wald 2007, "On fast Construction of SAH-based Bounding Volume Hierarchies"),
// nodes of four by opening the larger child (Wald et al. 2008, "Getting Rid of Packets"). No boxes: one empty node.
Tree buildTree(std::span<const Box> boxes);

// The same tree around boxes that have moved, `order` and topology unchanged.
void refit(Tree& tree, std::span<const Box> boxes);

// Expected number of boxes and leaves' entries that a ray which meets the root's box meets, by surface areas: grows as
// refitting makes boxes overlap.
double expectedCost(const Tree& tree);

}  // namespace facet::rays
