// How the state and the contacts of particles are kept on a device.
#pragma once

namespace scree {

enum class Precision {
  full,  // in double: the bits of the CPU
  mixed  // positions as whole numbers, contacts between particles in single precision, the rest in double
};

}  // namespace scree
