// What contacts remember, apart from any list.
#pragma once

#include <cstdint>
#include <vector>

namespace scree {

/// Contacts with memory, by key: of pairs the ids, with directions from the lower to the higher; of walls id and face.
struct KeyedContacts {
  std::vector<std::int64_t> ids;  // [contacts][2]
  std::vector<double> memory;     // [contacts][9]: slide x y z, approach, roll x y z, twist, slid
  std::vector<double> couple;     // [contacts][3], of walls
  std::vector<double> shape;      // [contacts][what of the memory of shapes lasts], or empty
};

/// Contacts of particles that have come from elsewhere; they wait for the lists to be made.
struct Luggage {
  KeyedContacts pairs, walls;
};

}  // namespace scree
