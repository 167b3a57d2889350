// The columns of particles that a step of the fluid reads and writes: what has to be at hand where particles are kept
// elsewhere from step to step.
#pragma once

#include <string_view>

namespace scree {

inline constexpr std::string_view read_by_fluid[] = {"motion",  "spin",   "mass",      "form",         "orientation",
                                                     "inertia", "stream", "pull",      "drag_impulse", "expected",
                                                     "before",  "met_at", "met_turned"};
inline constexpr std::string_view written_by_fluid[] = {"stream", "pull",   "drag_impulse", "expected",
                                                        "before", "met_at", "met_turned",   "gradient"};

}  // namespace scree
