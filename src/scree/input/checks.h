// What must hold between the keys of a case, beyond what each key's own line says.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "scree/input/bind.h"
#include "scree/input/case.h"
#include "scree/input/problem.h"

namespace scree {

struct Check {
  const Case& c;
  const Origins& origins;
  std::vector<Problem>& problems;

  /// Adds a problem at the key's value, or at the table around it where the key is not given.
  void fail(const char* code, const std::string& path, std::string message, std::string note,
            std::string help = "") const;
  /// Whether all these keys were read without a problem; checks on the others would only echo it.
  bool sound(std::initializer_list<std::string> paths) const;
};

/// A run of more steps cannot tell one from the next by its time in double precision, which has 53 bits.
inline constexpr double most_steps = 9007199254740992;

/// The problem of a run of more than `most_steps` (E132), still without a place.
Problem too_many_steps(double end, double time_step);

/// "(1, 2, 3)".
std::string in_words(const Vec3& v);

/// "materials.2", the path of a table in a list.
std::string item_path(const char* list, std::size_t index);

void check_materials(const Check& check);  // names, references, what the laws need
void check_hard(const Check& check);       // hard collisions
void check_vertices(const Check& check);   // contacts by vertices
void check_geometry(const Check& check);   // domain, regions, positions
void check_walls(const Check& check);      // shapes, meshes, motions
void check_particles(const Check& check);  // sizes, insertion, flow
void check_fields(const Check& check);     // flows and body forces on periodic axes
void check_fluid(const Check& check);      // a flow that is solved for: grid, blocks, boundary
void check_heat(const Check& check);       // temperatures of particles
void check_carried(const Check& check);    // what such a flow carries: heat, what is dissolved, eddies
void check_output(const Check& check);     // fields of the frames
void check_exchange(const Check& check);   // particles that come and go: rates, outlets
void check_analysis(const Check& check);   // planes, averages, surfaces
void check_verify(const Check& check);     // variants and expectations

}  // namespace scree
