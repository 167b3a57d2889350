// Whether lists and plan are what a pass relies on. Costs far more than making them: for builds that audit.
#pragma once

#include "scree/particles/system.h"

namespace scree {

/// Aborts if a pair is listed twice or from the wrong side, if a pair that is near enough is missing (checked against
/// all pairs up to `brute_force_limit` particles), if a slot would be written before both partners have read it, or if
/// some particle would gather another set of slots than that of its pairs, or in another order than that of its
/// partners' ids. Of several ranks all must call it: pairs of two of them must be remembered alike.
void audit_lists(const ParticleSystem& system, const ContactLists& lists);

inline constexpr std::size_t brute_force_limit = 3000;

}  // namespace scree
