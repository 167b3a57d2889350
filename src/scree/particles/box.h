// The box of a domain, for the text of passes and kernels.
#pragma once

#include "scree/data/domain.h"
#include "scree/kernels/box.h"

namespace scree {

inline sc_box box_of(const Domain& domain) {
  sc_box box{};
  for (int k = 0; k < 3; ++k) {
    box.low[k] = domain.low(k);
    box.high[k] = domain.high(k);
    box.period[k] = domain.period(k);
    box.half_period[k] = domain.half_period(k);
  }
  return box;
}

}  // namespace scree
