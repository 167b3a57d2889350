#include "scree/particles/device/fields.h"

#include <fmt/format.h>

#include <algorithm>

#include "scree/particles/device/formula.h"
#include "scree/physics/shape/octant_table.h"

namespace scree {
namespace {

/// Whether something acts that may be no number.
bool is_watched(const Fields& f) { return act_locally(f) && may_fail(f); }

}  // namespace

DeviceFields::DeviceFields(const opencl::Device& device, const Fields& f, const Particles& particles, bool prescribed)
    : place_(place(f, particles.coupled(), prescribed)), watched_(is_watched(f)), turns_(f.forces.turn()) {
  around_.force = body_force_of(f, 0);
  around_.flow = flow_of(f);
  around_.density = f.density;
  around_.viscosity = f.viscosity;
  around_.interval = f.interval;
  if (!apart()) return;
  make_room(device, particles.size());
  lost_ = opencl::DeviceBuffer(device, SC_MOST_GIVEN * sizeof(std::int32_t));
  send_shapes(device, f.forces.shapes);
}

void DeviceFields::make_room(const opencl::Device& device, std::size_t particles) {
  if (apart() && found_.bytes() < particles * sizeof(sc_field))
    found_ = opencl::DeviceBuffer(device, particles * sizeof(sc_field));
}

int DeviceFields::place(const Fields& f, bool coupled, bool prescribed) {
  // Forces of a fluid that is solved for come from it, but for the torques.
  const bool much = (f.forces.push() && !coupled) || f.forces.turn();
  if (much || is_watched(f) || prescribed) return SC_FIELDS_APART;
  return act_locally(f) ? SC_FIELDS_HERE : SC_FIELDS_NONE;
}

std::string DeviceFields::options(const Fields& f, bool coupled, bool prescribed) {
  const sc_fluid_forces& k = f.forces;
  const int where = place(f, coupled, prescribed);
  std::string text;
  for (const auto& [name, value] : {std::pair<const char*, int>{"FIELDS", where},
                                    {"BODY_FORCE", body_force_number(f)},
                                    {"FLOW", flow_number(f)},
                                    {"DRAG", where == SC_FIELDS_NONE ? SC_DRAG_NONE : f.drag},
                                    {"BUOYANCY", f.buoyancy},
                                    {"WATCHED", is_watched(f)},
                                    {"COUPLED", coupled},
                                    {"PUSHES", f.forces.push() && !coupled},
                                    {"TURNS", f.forces.turn()},
                                    {"FORCE_DRAG", k.drag},
                                    {"BODY_DRAG", k.body_drag},
                                    {"LIFT", k.lift},
                                    {"PITCHING", k.pitching},
                                    {"VISCOUS_TURN", k.viscous_turn},
                                    {"SAFFMAN", k.saffman},
                                    {"MAGNUS", k.magnus},
                                    {"CARRIED", k.carried},
                                    {"ADDED_MASS", k.added_mass}})
    text += fmt::format(" -DSC_CHOSEN_{}={}", name, value);
  return text;
}

std::string DeviceFields::formulas(const Fields& f) {
  std::string text;
  const auto define = [&](const char* what, const std::optional<VectorExpression>& formula) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string component =
          formula ? formula_for_device((*formula)[k].text(), {"x", "y", "z", "t"}).text : "R(0)";
      text += fmt::format("#define SC_FORMULA_{}_{} {}\n", what, "XYZ"[k], component);
    }
  };
  define("ACCELERATION", f.acceleration);
  define("VELOCITY", f.velocity);
  return text;
}

void DeviceFields::send_shapes(const opencl::Device& device, const std::vector<FlowShape>& shapes) {
  std::vector<sc_flow_shape> numbers;
  std::vector<double> tables;
  for (const FlowShape& s : shapes) {
    numbers.push_back(s.shape);
    for (const std::vector<double>* table : {&s.shadow, &s.mean}) {
      tables.insert(tables.end(), table->begin(), table->end());
      tables.resize(tables.size() + (table->empty() ? SC_OCTANT_NODES : 0));  // which nobody reads
    }
  }
  shapes_ = opencl::DeviceBuffer(device, numbers.size() * sizeof numbers[0]);
  shapes_.write(numbers.data(), shapes_.bytes());
  tables_ = opencl::DeviceBuffer(device, tables.size() * sizeof tables[0]);
  tables_.write(tables.data(), tables_.bytes());
}

sc_surroundings DeviceFields::around(double now) const {
  sc_surroundings out = around_;
  out.now = now;
  return out;
}

std::optional<std::ptrdiff_t> DeviceFields::take_first_lost(std::size_t steps) {
  if (!watched_) return std::nullopt;
  const auto marks = lost_.values<std::int32_t>(steps);
  const auto first = std::find_if(marks.begin(), marks.end(), [](std::int32_t mark) { return mark != 0; });
  if (first == marks.end()) return std::nullopt;
  lost_.clear();
  return first - marks.begin();
}

std::size_t DeviceFields::bytes() const { return shapes_.bytes() + tables_.bytes() + found_.bytes() + lost_.bytes(); }

}  // namespace scree
