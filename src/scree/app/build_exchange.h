// From a case to what lets particles in and out of its run.
#pragma once

#include <vector>

#include "scree/input/case.h"
#include "scree/particles/feed.h"
#include "scree/particles/outlet.h"

namespace scree {

/// The outlets of the case in its order.
std::vector<Outlet> build_outlets(const Case& c);

/// The feeds of the case in the order of its groups.
std::vector<Feed> build_feeds(const Case& c);

/// How many particles a feed lets in until the end of the run, if it keeps its rate; `mean_mass` of one [kg].
double expected_count(const Feed& feed, double mean_mass, double end);

}  // namespace scree
