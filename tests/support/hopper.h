// A case in which particles come and go.
#pragma once

#include <string>

namespace scree::test {

/// A hopper: a box with a hole in its floor, fed from above, drained through the open lower face of the domain and by a
/// region in the middle of the bed.
inline const std::string hopper = R"(
[simulation]
end = 1
time_step = 2e-5
max_overlap = 0.9
[domain]
min = [-0.01, -0.01, -0.004]
max = [0.01, 0.01, 0.03]
[gravity]
type = "uniform"
acceleration = [0.5, 0, -9.81]
[contact]
normal = "linear"
tangential = "history"
rolling = "spring"
cohesion = "none"
[[materials]]
name = "glass"
density = 2000
stiffness = 100
restitution = 0.6
friction = 0.4
rolling_friction = 0.1
[[materials]]
name = "clay"
density = 1500
stiffness = 70
restitution = 0.5
friction = 0.3
rolling_friction = 0.1
[[particles]]
name = "bed"
material = "glass"
insert = "random"
count = 120
region_min = [-0.01, -0.01, 0]
region_max = [0.01, 0.01, 0.018]
diameter = { distribution = "uniform", min = 2e-3, max = 4e-3 }
velocity = { type = "random", value = [0, 0, -0.5], deviation = 0.1 }
[[particles]]
name = "rain"
material = "clay"
insert = "rate"
mass_rate = 1e-2
region_min = [-0.009, -0.009, 0.022]
region_max = [0.009, 0.009, 0.03]
diameter = { distribution = "uniform", min = 1.5e-3, max = 3e-3 }
velocity = { type = "random", value = [0, 0, -0.8], deviation = 0.1 }
angular_velocity = [30, 0, 20]
[[particles]]
name = "pebbles"
material = "glass"
insert = "rate"
number_rate = 400
from = 0.004
total_count = 12
region_min = [-0.008, -0.008, 0.025]
region_max = [0.008, 0.008, 0.025]
diameter = 3e-3
velocity = [0.1, 0, -1]
[[walls]]
name = "left"
type = "plane"
material = "glass"
point = [-0.01, 0, 0]
normal = [1, 0, 0]
[[walls]]
name = "right"
type = "plane"
material = "glass"
point = [0.01, 0, 0]
normal = [-1, 0, 0]
[[walls]]
name = "front"
type = "plane"
material = "glass"
point = [0, -0.01, 0]
normal = [0, 1, 0]
[[walls]]
name = "back"
type = "plane"
material = "glass"
point = [0, 0.01, 0]
normal = [0, -1, 0]
[[walls]]
name = "floor"
type = "rectangle"
material = "glass"
min = [-0.01, -0.01, 0]
max = [0.004, 0.01, 0]
[[outlets]]
name = "drain"
type = "region"
min = [-0.01, 0.004, 0]
max = [-0.006, 0.01, 0.004]
[[outlets]]
name = "below"
face = "z_min"
)";

}  // namespace scree::test
