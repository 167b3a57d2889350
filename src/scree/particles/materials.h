// From materials to the contact constants of every pair of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scree/data/materials.h"

namespace scree {

/// What is known of one material.
struct MaterialProperties {
  std::string name;
  double density = 0;                    // [kg/m3]
  std::optional<double> young, poisson;  // [Pa], [-]
  std::optional<double> stiffness;       // normal spring against itself [N/m]
  double restitution = 1, tangential_restitution = 0;
  double friction = 0;                     // static
  std::optional<double> friction_sliding;  // empty: as friction
  double rolling_friction = 0, twisting_friction = 0;
  double cohesion_stiffness = 0;  // [N/m]
  double adhesion = 0;            // work of adhesion against itself [J/m2]
};

/// What the pair of materials a and b has of its own instead of mixed values. `young` is its effective modulus E*;
/// a friction given here is also the sliding one unless that is given too.
struct PairProperties {
  int a = 0, b = 0;
  std::optional<double> stiffness, young, restitution, tangential_restitution, friction, friction_sliding,
      rolling_friction, twisting_friction, cohesion_stiffness, adhesion;
};

/// What all pairs share.
struct ContactSettings {
  sc_laws laws{};
  bool hard = false;                              // collisions are impulses: springs and dashpots are left out
  double tangential_stiffness_ratio = 2.0 / 7.0;  // k_t / k_n of the linear laws
  std::optional<double> tangential_damping;       // damping ratio; empty: as the normal one
  double rolling_stiffness_ratio = 1.0, rolling_damping = 0.3;
  double twisting_stiffness_ratio = 1.0, twisting_damping = 0.3;
};

/// The constants of every pair of materials. Mixing, where the pair has no value of its own:
/// - moduli: 1/E* = (1 - nu_a^2)/E_a + (1 - nu_b^2)/E_b and 1/G* = (2 - nu_a)/G_a + (2 - nu_b)/G_b with
///   G = E / (2 (1 + nu)) (Johnson 1985, 4.30; Mindlin 1949); an E* of the pair scales G* in proportion;
/// - normal stiffness: k = 2 k_a k_b / (k_a + k_b), each material giving half the compliance, so that equal materials
///   keep theirs;
/// - restitution (normal and tangential), friction, rolling and twisting friction, cohesion stiffness, work of
/// adhesion: the geometric mean, as
///   LAMMPS documents for its granular pair styles, so a frictionless partner makes the pair frictionless.
/// The damping ratio follows from the restitution of the pair for the normal law in use.
/// Throws InputError when the laws need a constant that a material lacks.
Materials make_materials(const std::vector<MaterialProperties>& materials, const std::vector<PairProperties>& pairs,
                         const ContactSettings& settings);

}  // namespace scree
