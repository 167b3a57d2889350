// Which faces of a wall may be near a place: a tree of boxes around them.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "scree/physics/vec.h"

namespace scree {

/// A box along the axes; unbounded sides are infinite.
struct FaceBox {
  sc_vec low, high;  // [m]

  /// The box that contains nothing, to be extended.
  static FaceBox empty() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {sc_make_vec(infinity, infinity, infinity), sc_make_vec(-infinity, -infinity, -infinity)};
  }

  /// The cube of half width `reach` around a point.
  static FaceBox around(sc_vec x, double reach) {
    return {sc_make_vec(x.x - reach, x.y - reach, x.z - reach), sc_make_vec(x.x + reach, x.y + reach, x.z + reach)};
  }

  void extend(const FaceBox& other) {
    low = sc_make_vec(SC_MIN(low.x, other.low.x), SC_MIN(low.y, other.low.y), SC_MIN(low.z, other.low.z));
    high = sc_make_vec(SC_MAX(high.x, other.high.x), SC_MAX(high.y, other.high.y), SC_MAX(high.z, other.high.z));
  }

  /// Whether the two share a point; boxes that touch do.
  bool meets(const FaceBox& other) const {
    return (low.x <= other.high.x) & (other.low.x <= high.x) & (low.y <= other.high.y) & (other.low.y <= high.y) &
           (low.z <= other.high.z) & (other.low.z <= high.z);
  }
};

/// Nodes in one array, depth first: the first child follows its parent, the other is where the parent says. The search
/// changes nothing, so that any number of threads may search.
class FaceTree {
 public:
  FaceTree() = default;

  /// A tree of the faces with these boxes; their numbers are the places in the list.
  explicit FaceTree(const std::vector<FaceBox>& boxes);

  /// Calls visit(face) for every face whose box meets `box`, each once, in an order that depends on the faces alone.
  template <class Visit>
  void for_each_near(const FaceBox& box, Visit&& visit) const {
    std::size_t at = 0;
    // Without a stack: a node says where to go on when nothing of it is near.
    while (at < nodes_.size()) {
      const Node& node = nodes_[at];
      if (!node.box.meets(box)) {
        at = node.next;
        continue;
      }
      for (std::uint32_t i = node.first; i < node.last; ++i)
        if (boxes_[i].meets(box)) visit(faces_[i]);
      ++at;
    }
  }

  /// The box around all faces.
  FaceBox bounds() const { return nodes_.empty() ? FaceBox::empty() : nodes_[0].box; }

 private:
  struct Node {
    FaceBox box;
    std::uint32_t first, last;  // its faces, where it is a leaf
    std::uint32_t next;         // the node behind its last descendant
  };

  void build(const std::vector<FaceBox>& boxes, std::uint32_t first, std::uint32_t last);

  std::vector<Node> nodes_;
  std::vector<int> faces_;      // in the order of the leaves
  std::vector<FaceBox> boxes_;  // of those
};

}  // namespace scree
