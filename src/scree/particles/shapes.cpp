#include "scree/particles/shapes.h"

namespace scree {

sc_shape_touch touch_shapes(const sc_body_shape& first, const sc_body_shape& second, const sc_vec& branch, bool warm,
                            const sc_growth_point& start, double limit) {
  return sc_touch_shapes_within(first, second, branch, limit, warm, start);
}

int body_to_wall(const sc_wall& wall, const sc_wall_pose& pose, const sc_body_shape& body, const sc_vec& centre,
                 double reach, sc_body_gap gaps[SC_FRUSTUM_GAPS]) {
  return sc_body_to_wall(wall, pose, body, centre, reach, gaps);
}

}  // namespace scree
