// The tables of the case file. Each is declared once, in keys_*.cpp.
#pragma once

#include "scree/input/key.h"

namespace scree {

/// The whole file; every other table hangs on it.
const Section& case_section();

const Section& simulation_section();
const Section& domain_section();
const Section& gravity_section();
const Section& flow_section();
const Section& fluid_section();
const Section& fluid_heat_section();
const Section& fluid_scalars_section();
const Section& fluid_turbulence_section();
const Section& coupling_section();
const Section& heat_section();
const Section& contact_section();
const Section& hard_section();
const Section& materials_section();
const Section& pairs_section();
const Section& particles_section();
const Section& walls_section();
const Section& outlets_section();
const Section& output_section();
const Section& ledger_section();
const Section& analysis_section();
const Section& verify_section();
const Section& expect_section();

}  // namespace scree
