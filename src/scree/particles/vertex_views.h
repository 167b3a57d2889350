// The vertices of forms as the passes see them.
#pragma once

#include "scree/data/vertices.h"
#include "scree/particles/sweep_view.h"

namespace scree {

inline VertexView view_of(const VertexBlocks& v) {
  return {v.points.data(), v.spheres.data(), v.blocks, 0xffu >> (8 * v.blocks - v.count)};
}

}  // namespace scree
