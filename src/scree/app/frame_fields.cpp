#include "scree/app/frame_fields.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "scree/analysis/agglomerates.h"
#include "scree/app/columns.h"

namespace scree {
namespace {

/// In every frame; in those of a case that chooses nothing (of agglomerates: with their analysis; of shapes: where some
/// particle is no sphere; of others: where some is no superellipsoid; of heat: where they have one); on request only.
enum class Part { always, usual, of_agglomerates, of_shapes, of_others, of_heat, extra };

struct FrameField {
  const char *name, *unit, *meaning;
  Part part;
  Element element;
  std::uint64_t components;
  const void* (*values)(const FrameData&);
};

#define SCREE_VALUES(member) [](const FrameData& d) -> const void* { return d.member.data(); }

constexpr FrameField fields[] = {
    {"id", "1", "Number of the particle, for life.", Part::always, Element::int64, 1, SCREE_VALUES(id)},
    {"position", "m", "Centre, inside the periodic box.", Part::always, Element::float64, 3, SCREE_VALUES(position)},
    {"velocity", "m/s", "Velocity of the centre.", Part::usual, Element::float64, 3, SCREE_VALUES(velocity)},
    {"angular_velocity", "rad/s", "Angular velocity in the frame of the domain.", Part::usual, Element::float64, 3,
     SCREE_VALUES(angular_velocity)},
    {"diameter", "m", "Diameter of the body, or of the sphere of equal volume.", Part::usual, Element::float64, 1,
     SCREE_VALUES(diameter)},
    {"mass", "kg", "Mass.", Part::usual, Element::float64, 1, SCREE_VALUES(mass)},
    {"material", "1", "Place of the material in the case, from 0.", Part::usual, Element::int32, 1,
     SCREE_VALUES(material)},
    {"group", "1", "Place of the particle group in the case, from 0.", Part::usual, Element::int32, 1,
     SCREE_VALUES(group)},
    {"orientation", "1", "Quaternion w, x, y, z of the rotation from the axes of the particle to those of the domain.",
     Part::of_shapes, Element::float64, 4, SCREE_VALUES(orientation)},
    {"half_axes", "m", "Half axes along the x, y and z of the particle.", Part::of_shapes, Element::float64, 3,
     SCREE_VALUES(half_axes)},
    {"exponents", "1", "e1 (along z) and e2 (in the plane of x and y) of the superellipsoid; 1 and 1: ellipsoid.",
     Part::of_shapes, Element::float64, 2, SCREE_VALUES(exponents)},
    {"shape_file", "1",
     "Number in the name of the file shape_N.obj with the surface over the half axes; -1: superellipsoid.",
     Part::of_others, Element::int32, 1, SCREE_VALUES(shape_file)},
    {"temperature", "K", "Temperature.", Part::of_heat, Element::float64, 1, SCREE_VALUES(temperature)},
    {"agglomerate", "1", "Smallest id in the agglomerate; -1 for a single particle.", Part::of_agglomerates,
     Element::int64, 1, SCREE_VALUES(agglomerate)},
    {"agglomerate_size", "1", "Number of particles in the agglomerate.", Part::of_agglomerates, Element::int32, 1,
     SCREE_VALUES(agglomerate_size)},
    {"force", "N", "Total force: contacts, body forces and drag.", Part::extra, Element::float64, 3,
     SCREE_VALUES(force)},
    {"unwrapped_position", "m", "Centre, with the periods travelled.", Part::extra, Element::float64, 3,
     SCREE_VALUES(unwrapped_position)},
    {"effect_diameter", "m", "Diameter within which cohesion acts.", Part::extra, Element::float64, 1,
     SCREE_VALUES(effect_diameter)},
    {"contacts", "1", "Number of particles and wall faces in touch.", Part::extra, Element::int32, 1,
     SCREE_VALUES(contacts)}};

#undef SCREE_VALUES

bool chosen(const FrameField& field, const OutputKeys& output, FrameParts there) {
  if (field.part == Part::of_shapes && !there.shapes) return false;
  if (field.part == Part::of_others && !there.others) return false;
  if (field.part == Part::of_heat && !there.heat) return false;
  if (field.part == Part::always) return true;
  if (!output.fields.empty()) return std::ranges::find(output.fields, field.name) != output.fields.end();
  return field.part == Part::usual || field.part == Part::of_shapes || field.part == Part::of_others ||
         field.part == Part::of_heat || (field.part == Part::of_agglomerates && there.agglomerates);
}

bool in_single(const FrameField& field, const OutputKeys& output) {
  return field.element == Element::float64 && output.precision == "single";
}

void add_shape(const ParticleSystem& s, std::size_t i, bool others, FrameData& d) {
  const double *q = s.particles.orientation.row(i), radius = s.particles.motion.row(i)[lane::radius];
  const Form& form = s.forms[static_cast<std::size_t>(s.particles.form[i])];
  d.orientation.insert(d.orientation.end(), q, q + 4);
  for (const double axis : form.half_axes()) d.half_axes.push_back(radius * axis);
  d.exponents.insert(d.exponents.end(), form.exponents.begin(), form.exponents.end());
  if (others) d.shape_file.push_back(form.other() ? s.particles.form[i] : -1);
}

/// The doubles rounded to floats, owned by the column.
void round_to_single(FrameColumn& column) {
  const auto* from = static_cast<const double*>(column.values.data);
  const auto rounded = std::make_shared<std::vector<float>>(from, from + column.values.rows * column.values.columns);
  column.values.element = Element::float32;
  column.values.data = rounded->data();
  column.owner = rounded;
}

}  // namespace

FrameData frame_data(const Sample& sample, bool agglomerates) {
  const Particles& p = sample.system.particles;
  const std::vector<std::int32_t> contacts = count_contacts(sample.system);
  FrameData d;
  const bool others = has_other_shapes(sample.system.forms);
  d.there = {agglomerates, p.shaped(), others, p.warm()};
  Agglomerates found;
  if (agglomerates) found = find_agglomerates(p, sample.system.domain, bonds_of(sample.system));
  for (const std::uint32_t i : order_by_id(p)) {
    const double *m = p.motion.row(i), *spin = p.spin.row(i), *force = &sample.force[4 * std::size_t{i}];
    d.id.push_back(p.id[i]);
    d.position.insert(d.position.end(), m, m + 3);
    d.velocity.insert(d.velocity.end(), m + 4, m + 7);
    for (int k = 0; k < 3; ++k) d.angular_velocity.push_back(spin[k] * spin[3]);
    d.diameter.push_back(2 * p.radius_by_volume(i));
    d.mass.push_back(p.mass[i]);
    d.material.push_back(p.material[i]);
    d.group.push_back(p.group[i]);
    d.force.insert(d.force.end(), force, force + 3);
    for (int k = 0; k < 3; ++k)
      d.unwrapped_position.push_back(m[k] + p.image.row(i)[k] * sample.system.domain.length(k));
    d.effect_diameter.push_back(2 * (p.radius_by_volume(i) + p.effect_excess[i]));
    if (p.shaped()) add_shape(sample.system, i, others, d);
    if (p.warm()) d.temperature.push_back(p.heat.row(i)[lane::temperature]);
    d.contacts.push_back(contacts[i]);
    if (!agglomerates) continue;
    d.agglomerate.push_back(found.label[i]);
    d.agglomerate_size.push_back(found.size[i]);
  }
  return d;
}

FrameData no_frame_data(FrameParts there) {
  FrameData d;
  d.there = there;
  return d;
}

std::vector<RowKey> keys_of(const FrameData& data) {
  std::vector<RowKey> keys;
  for (const std::int64_t id : data.id) keys.push_back({id, 0});
  return keys;
}

std::vector<FrameColumn> frame_columns(const FrameData& d, const OutputKeys& output) {
  std::vector<FrameColumn> out;
  for (const FrameField& field : fields) {
    if (!chosen(field, output, d.there) || (field.part == Part::of_agglomerates && !d.there.agglomerates)) continue;
    FrameColumn column{
        field.name, field.unit, field.meaning, {field.element, d.id.size(), field.components, field.values(d)}};
    if (in_single(field, output)) round_to_single(column);
    out.push_back(std::move(column));
  }
  return out;
}

Compression compression_of(const OutputKeys& output) {
  if (output.compression == "none") return Compression::none;
  if (output.compression == "fast") return Compression::fast;
  return output.compression == "small" ? Compression::small : Compression::whole_numbers;
}

std::size_t frame_bytes_per_particle(const OutputKeys& output, FrameParts there) {
  std::size_t bytes = sizeof(std::int32_t);  // of the list of vertices
  for (const FrameField& field : fields)
    if (chosen(field, output, there))
      bytes += field.components * element_size(in_single(field, output) ? Element::float32 : field.element);
  return bytes;
}

std::vector<std::string> frame_field_names() {
  std::vector<std::string> names;
  for (const FrameField& field : fields) names.emplace_back(field.name);
  return names;
}

}  // namespace scree
