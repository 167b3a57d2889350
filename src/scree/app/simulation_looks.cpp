// What one sees of a simulation: samples, measures and frames. Of several ranks each looks at its own particles, and
// what is of the whole is put together from that; the private members are what every rank does.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "scree/app/build_heat.h"
#include "scree/app/columns.h"
#include "scree/app/contact_fields.h"
#include "scree/app/frame_fields.h"
#include "scree/app/simulation.h"

namespace scree {

const Sample& Simulation::sample() {
  if (sampled_step_ == clock_.step) return sample_;
  call(Call::sample);
  take_own_sample();
  return sample_;
}

void Simulation::take_own_sample() {
  retrieve();
  move_walls(clock_.now());
  refresh_neighbours();
  update_ghosts(system_, lists_);
  evaluate_own_fields(clock_.now());
  const Stopwatch watch(stages_, "samples");
  const sc_field* field = fields_matter() ? field_.data() : nullptr;
  take_sample(system_, lists_, move_now(), contact_time_now(), field, sample_);
  turn_by_fluid_around(sample_.system.particles, move_now().lag);
  set_velocities(prescribed_, sample_.system.particles, clock_.now());
  sampled_step_ = clock_.step;
}

const Sample& Simulation::whole_sample() {
  if (ranks_.alone()) return sample();
  if (whole_sampled_step_ != clock_.step) sample_whole();
  return whole_sample_;
}

/// The root looks at the whole with lists of its own.
void Simulation::sample_whole() {
  whole();
  ContactLists lists = prepare_lists(whole_, case_.simulation.skin);
  refresh_lists(whole_, lists, team_);
  Buffer<sc_field> field;
  evaluate_fields(whole_, clock_.now(), field);
  const Stopwatch watch(stages_, "samples");
  take_sample(whole_, lists, move_now(), contact_time_now(), fields_matter() ? field.data() : nullptr, whole_sample_);
  turn_by_fluid_around(whole_sample_.system.particles, move_now().lag);
  set_velocities(prescribed_, whole_sample_.system.particles, clock_.now());
  whole_sampled_step_ = clock_.step;
}

Measured Simulation::measured() {
  sample();
  call(Call::measure);
  return measure_share();
}

Measured Simulation::measure_share() {
  return measure(sample(), fields_, clock_.now(), ranks_.root() ? exchange_.passage() : Passage(), ranks_);
}

RowFacts Simulation::row_facts() {
  sample();
  call(Call::row);
  return look_at_share();
}

RowFacts Simulation::look_at_share() {
  const Sample& now = sample();
  const ParticleSystem& s = now.system;
  RowFacts out;
  out.speeds = measure_speeds(now, ranks_);
  if (!regions_.empty()) {
    const std::vector<std::int32_t> contacts = count_contacts(s);
    for (const Region& region : regions_)
      out.regions.push_back({solid_fraction(region, s.particles, s.forms, s.domain, ranks_),
                             coordination_number(region, s.particles, contacts, ranks_),
                             axis_order(region, s.particles, s.forms, ranks_)});
  }
  if (heat_) out.heat = heat_row(heat_facts(s.particles, ranks_), heat_books_);
  // A particle is on one rank: each looks for each of them.
  for (const std::uint64_t id : case_.output.tracks) {
    const std::vector<double> mine = track_rows(now, {id}, clock_.now());
    Bytes bytes(mine.size() * sizeof(double));
    if (!mine.empty()) std::memcpy(bytes.data(), mine.data(), bytes.size());
    for (const Bytes& said : ranks_.gather(bytes)) {
      const std::size_t before = out.tracks.size();
      out.tracks.resize(before + said.size() / sizeof(double));
      if (!said.empty()) std::memcpy(&out.tracks[before], said.data(), said.size());
    }
  }
  return out;
}

void Simulation::write_frame(FrameWriter& frames, FrameWriter* contacts) {
  case_.analysis.agglomerates ? whole_sample() : sample();
  if (contacts) sample();
  call(Call::frame);
  frame_share(&frames, contacts);
}

/// Ranks other than the root have no writers.
void Simulation::frame_share(FrameWriter* frames, FrameWriter* contacts) {
  const Compression compression = compression_of(case_.output);
  const auto step = static_cast<std::uint64_t>(clock_.step);
  const FrameData data = frame_data_share();
  const FrameRows particles = rows_in_order(frame_columns(data, case_.output), keys_of(data), ranks_);
  frames ? frames->write(clock_.now(), step, particles, ranks_)
         : FrameWriter::write_share(particles, compression, particle_frames, ranks_);
  if (!case_.output.contacts) return;
  std::vector<FrameColumn> columns = contact_columns(sample());
  const std::vector<RowKey> keys = contact_keys(columns, exchange_.next_id());
  const FrameRows found = rows_in_order(std::move(columns), keys, ranks_);
  contacts ? contacts->write(clock_.now(), step, found, ranks_)
           : FrameWriter::write_share(found, compression, contact_frames, ranks_);
}

/// What this rank knows of a frame. In which agglomerate a particle is the whole tells, at the root.
FrameData Simulation::frame_data_share() {
  if (!case_.analysis.agglomerates) return frame_data(sample(), false);
  return ranks_.root() ? frame_data(whole_sample(), true)
                       : no_frame_data({true, system_.particles.shaped(), has_other_shapes(system_.forms),
                                        system_.particles.warm()});
}

bool Simulation::is_finite() {
  call(Call::finite);
  return ranks_.all(is_share_finite());
}

bool Simulation::is_share_finite() {
  retrieve();
  const auto bearable = [](double x) { return std::abs(x) < 1e100; };
  const Particles& p = system_.particles;
  const auto of_own = [&](const auto& column) {
    const auto* values = column.values.data();
    return std::all_of(values, values + p.size() * static_cast<std::size_t>(column.components), bearable);
  };
  return of_own(p.motion) && of_own(p.spin);
}

}  // namespace scree
