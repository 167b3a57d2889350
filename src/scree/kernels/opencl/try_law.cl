// What a device run begins with: the chosen law gives the host's numbers.
#include "scree/kernels/opencl/parameters.h"

/// Sizes of what the law is given and returns.
__kernel void sc_law_sizes(__global int* out) {
  if (get_global_id(0) != 0) return;
  out[0] = (int)sizeof(sc_pair_law);
  out[1] = (int)sizeof(sc_contact_time);
  out[2] = (int)sizeof(sc_touch);
  out[3] = (int)sizeof(sc_contact_state);
  out[4] = (int)sizeof(sc_contact_result);
}

/// The chosen law for given contacts.
__kernel void sc_try_law(const int n, const sc_contact_time time, __global const sc_pair_law* law,
                         __global const sc_touch* touch, __global const sc_contact_state* state,
                         __global sc_contact_result* out) {
  const sc_laws chosen = SC_CHOSEN_LAWS;
  const size_t i = get_global_id(0);
  if (i < (size_t)n) out[i] = sc_contact_act(chosen, law[0], touch[i], time, state[i]);
}
