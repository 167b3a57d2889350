#include "scree/data/face_tree.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace scree {
namespace {

constexpr std::uint32_t leaf_faces = 4;
constexpr std::array axes{&sc_vec::x, &sc_vec::y, &sc_vec::z};

/// The middle of a box along an axis. One that is unbounded on both sides has none, and counts as lying at zero.
double middle(const FaceBox& box, double sc_vec::*axis) {
  const double twice = box.low.*axis + box.high.*axis;
  return twice == twice ? 0.5 * twice : 0;
}

}  // namespace

FaceTree::FaceTree(const std::vector<FaceBox>& boxes) : faces_(boxes.size()) {
  std::iota(faces_.begin(), faces_.end(), 0);
  nodes_.reserve(boxes.size());
  if (!boxes.empty()) build(boxes, 0, static_cast<std::uint32_t>(boxes.size()));
  boxes_.reserve(boxes.size());
  for (int face : faces_) boxes_.push_back(boxes[face]);
}

/// Appends the node of the faces [first, last) and everything below it. Half of the faces go to either side of the axis
/// along which their middles are farthest apart, so the depth is that of a balanced tree whatever the faces are.
void FaceTree::build(const std::vector<FaceBox>& boxes, std::uint32_t first, std::uint32_t last) {
  const std::size_t here = nodes_.size();
  Node node{FaceBox::empty(), first, last, 0};
  std::array<double, 3> low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (std::uint32_t i = first; i < last; ++i) {
    const FaceBox& box = boxes[faces_[i]];
    node.box.extend(box);
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], middle(box, axes[k]));
      high[k] = std::max(high[k], middle(box, axes[k]));
    }
  }
  nodes_.push_back(node);
  if (last - first > leaf_faces) {
    std::size_t longest = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (high[k] - low[k] > high[longest] - low[longest]) longest = k;
    const auto order = [&](int face) { return std::tuple{middle(boxes[face], axes[longest]), face}; };
    const std::uint32_t half = first + (last - first) / 2;
    std::ranges::nth_element(faces_.begin() + first, faces_.begin() + half, faces_.begin() + last, {}, order);
    nodes_[here].last = first;
    build(boxes, first, half);
    build(boxes, half, last);
  }
  nodes_[here].next = static_cast<std::uint32_t>(nodes_.size());
}

}  // namespace scree
