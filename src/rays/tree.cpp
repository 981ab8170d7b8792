#include "rays/tree.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"

namespace facet::rays {

namespace {

struct Item {
  glm::vec3 min;
  uint32_t index;
  glm::vec3 max;

  glm::vec3 twiceCenter() const { return min + max; }
};

// Of the tree of two children that is made first.
struct Pair {
  Box box;
  uint32_t first = 0, count = 0;  // items; those of a leaf
  uint32_t children = 0;          // the first of two; 0: a leaf
};

constexpr int binCount = 16;

struct Split {
  float cost = std::numeric_limits<float>::infinity();
  int axis = -1, bin = 0;
};

struct Bins {
  glm::vec3 low, scale;  // bin = (twice the centre - low) * scale

  Bins(const Box& centers, int bins) : low(centers.min), scale(0) {
    for (int axis = 0; axis < 3; ++axis) {
      const float extent = centers.max[axis] - centers.min[axis];
      if (extent > 0) scale[axis] = static_cast<float>(bins) * (1 - 1e-6f) / extent;
      if (!std::isfinite(scale[axis])) scale[axis] = 0;
    }
  }
  int of(const Item& item, int axis) const {
    return static_cast<int>((item.min[axis] + item.max[axis] - low[axis]) * scale[axis]);
  }
};

Split bestSplit(std::span<const Item> items, const Bins& bins, int count) {
  struct Bin {
    Box box;
    uint32_t count = 0;
  };
  std::array<std::array<Bin, binCount>, 3> binned;
  for (const Item& item : items)
    for (int axis = 0; axis < 3; ++axis) {
      Bin& bin = binned[static_cast<size_t>(axis)][static_cast<size_t>(std::clamp(bins.of(item, axis), 0, count - 1))];
      bin.box.min = glm::min(bin.box.min, item.min), bin.box.max = glm::max(bin.box.max, item.max);
      ++bin.count;
    }
  Split best;
  for (int axis = 0; axis < 3; ++axis) {
    if (bins.scale[axis] == 0) continue;
    const auto& row = binned[static_cast<size_t>(axis)];
    std::array<float, binCount> right{};
    Box box;
    uint32_t number = 0;
    for (int i = count - 1; i > 0; --i) {
      const Bin& bin = row[static_cast<size_t>(i)];
      box.add(bin.box), number += bin.count;
      right[static_cast<size_t>(i)] = number > 0 ? box.area() * static_cast<float>(number) : 0;
    }
    box = {}, number = 0;
    for (int i = 0; i + 1 < count; ++i) {
      const Bin& bin = row[static_cast<size_t>(i)];
      box.add(bin.box), number += bin.count;
      if (number == 0 || number == items.size()) continue;
      const float cost = box.area() * static_cast<float>(number) + right[static_cast<size_t>(i) + 1];
      if (cost < best.cost) best = {cost, axis, i};
    }
  }
  return best;
}

class Builder {
 public:
  explicit Builder(std::span<const Box> boxes) {
    items_.reserve(boxes.size());
    for (const Box& box : boxes) items_.push_back({box.min, static_cast<uint32_t>(items_.size()), box.max});
    pairs_.resize(std::max<size_t>(2 * boxes.size(), 2));
    pairs_[0].count = static_cast<uint32_t>(boxes.size());
  }

  // Large parts one after another until there are enough for all cores, then each of those on one core.
  Tree build() {
    std::vector<uint32_t> large = {0}, parts;
    const size_t enough = std::max<size_t>(items_.size() / 64, 4096);
    while (!large.empty()) {
      const uint32_t pair = large.back();
      large.pop_back();
      if (pairs_[pair].count <= enough)
        parts.push_back(pair);
      else if (split(pair))
        large.push_back(pairs_[pair].children), large.push_back(pairs_[pair].children + 1);
    }
    parallelFor(parts.size(), [&](size_t i) { splitAll(parts[i]); });
    Tree tree;
    tree.order.reserve(items_.size());
    tree.nodes.reserve(items_.size() / 4 + 1);
    tree.nodes.emplace_back();
    collapse(tree);
    for (const Item& item : items_) tree.order.push_back(item.index);
    return tree;
  }

 private:
  void splitAll(uint32_t root) {
    std::vector<uint32_t> open = {root};
    while (!open.empty()) {
      const uint32_t pair = open.back();
      open.pop_back();
      if (split(pair)) open.push_back(pairs_[pair].children), open.push_back(pairs_[pair].children + 1);
    }
  }

  // False: it is a leaf.
  bool split(uint32_t index) {
    Pair& pair = pairs_[index];
    const std::span<Item> items = std::span(items_).subspan(pair.first, pair.count);
    Box centers;
    for (const Item& item : items) {
      pair.box.min = glm::min(pair.box.min, item.min), pair.box.max = glm::max(pair.box.max, item.max);
      centers.add(item.twiceCenter());
    }
    if (items.size() <= 1) return false;
    const int count = items.size() > 64 ? binCount : 8;
    const Bins bins(centers, count);
    const Split best = bestSplit(items, bins, count);
    const float area = pair.box.area();
    if (items.size() <= layout::rayMostInLeaf && best.cost + area >= area * static_cast<float>(items.size()))
      return false;
    auto middle = items.begin() + static_cast<ptrdiff_t>(items.size() / 2);
    if (best.axis >= 0)
      middle =
          std::partition(items.begin(), items.end(), [&](const Item& i) { return bins.of(i, best.axis) <= best.bin; });
    const auto left = static_cast<uint32_t>(middle - items.begin());
    pair.children = nextPair_.fetch_add(2);
    pairs_[pair.children].first = pair.first, pairs_[pair.children].count = left;
    pairs_[pair.children + 1].first = pair.first + left, pairs_[pair.children + 1].count = pair.count - left;
    return true;
  }

  // The pairs into nodes of four, parents first.
  void collapse(Tree& tree) {
    std::vector<std::pair<uint32_t, uint32_t>> open = {{0, 0}};  // pair, node
    while (!open.empty()) {
      const auto [root, at] = open.back();
      open.pop_back();
      std::vector<uint32_t> parts = {root};
      if (pairs_[root].children != 0) parts = {pairs_[root].children, pairs_[root].children + 1};
      while (parts.size() < 4) {
        const auto larger = std::ranges::max_element(
            parts, {}, [&](uint32_t p) { return pairs_[p].children != 0 ? pairs_[p].box.area() : -1.0f; });
        if (pairs_[*larger].children == 0) break;
        const uint32_t opened = pairs_[*larger].children;
        *larger = opened;
        parts.push_back(opened + 1);
      }
      for (int i = 0; i < 4; ++i) {
        Node& node = tree.nodes[at];
        const bool there = static_cast<size_t>(i) < parts.size() && pairs_[parts[static_cast<size_t>(i)]].count > 0;
        node.setBox(i, there ? pairs_[parts[static_cast<size_t>(i)]].box : Box());
        uint32_t& child = node.children[static_cast<size_t>(i)];
        child = layout::rayNone;
        if (!there) continue;
        const Pair& pair = pairs_[parts[static_cast<size_t>(i)]];
        child = layout::rayLeaf | (pair.count - 1) << layout::rayCountShift | pair.first;
        if (pair.children == 0) continue;
        child = static_cast<uint32_t>(tree.nodes.size());
        open.emplace_back(parts[static_cast<size_t>(i)], child);
        tree.nodes.emplace_back();
      }
    }
  }

  std::vector<Item> items_;
  std::vector<Pair> pairs_;
  std::atomic<uint32_t> nextPair_ = 1;
};

}  // namespace

Box Node::box(int child) const {
  const auto i = static_cast<size_t>(child);
  return {{axes[0].min[i], axes[1].min[i], axes[2].min[i]}, {axes[0].max[i], axes[1].max[i], axes[2].max[i]}};
}
void Node::setBox(int child, const Box& box) {
  const auto i = static_cast<size_t>(child);
  for (int axis = 0; axis < 3; ++axis) {
    axes[static_cast<size_t>(axis)].min[i] = box.min[axis];
    axes[static_cast<size_t>(axis)].max[i] = box.max[axis];
  }
}

Box Tree::bounds() const {
  Box all;
  for (int i = 0; i < 4; ++i) all.add(nodes[0].box(i));
  return all;
}

Tree buildTree(std::span<const Box> boxes) { return Builder(boxes).build(); }

void refit(Tree& tree, std::span<const Box> boxes) {
  for (size_t n = tree.nodes.size(); n-- > 0;) {
    Node& node = tree.nodes[n];
    for (int i = 0; i < 4; ++i) {
      const uint32_t child = node.children[static_cast<size_t>(i)];
      if (child == layout::rayNone) continue;
      Box box;
      if (child & layout::rayLeaf) {
        const uint32_t first = child & layout::rayFirstMask, count = (child >> layout::rayCountShift & 7u) + 1;
        for (uint32_t item = first; item < first + count; ++item) box.add(boxes[tree.order[item]]);
      } else {
        for (int below = 0; below < 4; ++below) box.add(tree.nodes[child].box(below));
      }
      node.setBox(i, box);
    }
  }
}

double expectedCost(const Tree& tree) {
  const double whole = static_cast<double>(tree.bounds().area());
  if (!(whole > 0)) return 0;
  double cost = 0;
  for (const Node& node : tree.nodes)
    for (int i = 0; i < 4; ++i) {
      const uint32_t child = node.children[static_cast<size_t>(i)];
      if (child == layout::rayNone) continue;
      const double entries = child & layout::rayLeaf ? (child >> layout::rayCountShift & 7u) + 1 : 1;
      cost += static_cast<double>(node.box(i).area()) / whole * entries;
    }
  return cost;
}

}  // namespace facet::rays
