// Bodies of any shape on a device, whatever their state is kept in.
#include "scree/kernels/meet_shapes.h"
#include "scree/kernels/move_body.h"
#include "scree/kernels/opencl/pair_contacts.cl"

/// What a pair did, as it is gathered: force on the owner and loss by damping, torque on the owner and loss by sliding, torque
/// on the partner and loss by rolling.
typedef struct {
  real4 force, own, other;
} sc_gathered_pair;

SC_FN sc_quat sc_quat_from(real4 q) { return sc_make_quat(q.x, q.y, q.z, q.w); }
