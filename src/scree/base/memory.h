// The memory of this machine.
#pragma once

#include <optional>

namespace scree {

/// Memory that a program may still get without swapping [bytes]: what the system calls available, or what is left of
/// the limit of the group of processes (cgroup v2) if that is less. Nothing where the system does not tell.
std::optional<double> available_memory();

}  // namespace scree
