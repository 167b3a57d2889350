// Particles on an OpenCL device: they stay there from step to step, with their contacts and their books.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "scree/compute/opencl/device.h"
#include "scree/kernels/counting_plane.h"
#include "scree/kernels/opencl/parameters.h"
#include "scree/particles/device/bodies.h"
#include "scree/particles/device/borders.h"
#include "scree/particles/device/fields.h"
#include "scree/particles/device/mixed_state.h"
#include "scree/particles/device/planes.h"
#include "scree/particles/device/precision.h"
#include "scree/particles/device/shapes.h"
#include "scree/particles/keyed_contacts.h"
#include "scree/particles/reach.h"
#include "scree/particles/system.h"

namespace scree {

/// What steps on a device have found since they were last asked for; of several ranks together.
struct DeviceFindings {
  SweepFindings last;                                                           // of the last step
  SweepFindings own;                                                            // of this rank in the last step
  std::int64_t contacts = 0, wall_contacts = 0, impacts = 0, impact_speed = 0;  // summed over the steps
  std::int64_t steps = 0;                                                       // done
  std::int64_t undone = 0;  // steps given that were not done, because one before them went wrong
  bool field_lost = false;  // the first of these was not done because what acts in it is no number somewhere
};

/// Where walls are in a step, and how far at most any part of them near particles goes in it [m].
struct WallsOfStep {
  std::vector<sc_wall_pose> poses;
  double way = 0;
};

/// A step as it is given to a device.
struct DeviceStep {
  sc_move move;
  sc_contact_time time;
  WallsOfStep walls;
  std::vector<sc_prescribed> bodies;  // of all groups whose motion is prescribed
  double now;                         // when it begins [s]
};

/// Some particles of a device with the contacts they take part in.
struct PartOfDevice {
  ParticleSystem system;           // particles in the order of their ids; the lists hold what acts alone
  std::vector<std::int64_t> id;    // of each particle
  std::vector<std::int32_t> rows;  // where each stands on the device
};

/// The engine of a system of spheres, or of bodies of any shape, on a device. In full precision it gives the same bits
/// as the CPU's: the physics is the same text, and sums go in the order of ids.
class DeviceParticles {
 public:
  /// Compiles the kernels for the laws of the system, checks them against the host's numbers and sends the system's
  /// particles and contacts to the device. The motion of `bodies` is prescribed. `max_overlap` stops the run. Of
  /// several ranks each has a device; copies of others' particles must be there, and all ranks call all members alike.
  /// Throws ResourceError.
  DeviceParticles(const opencl::Device& device, Precision precision, const ParticleSystem& system,
                  const ContactLists& lists, const Fields& fields, const std::vector<sc_body_group>& bodies,
                  double max_overlap);

  /// Counts who passes these planes from now on.
  void watch(const std::vector<sc_counting_plane>& planes);

  /// What has passed each plane on this rank since this was asked last. All steps must be settled.
  std::vector<PlaneCount> take_counts();

  /// Gives a step to the device; it is done later.
  void step(DeviceStep step);

  /// True if so many steps are waiting that settle() is due.
  bool is_full() const { return given_.size() >= most_given; }

  /// Waits for the steps given.
  DeviceFindings settle();

  /// Brings particles, in the order of their ids, copies of others' particles after them, and contacts that act back to
  /// the system. All steps must be settled.
  void bring_back(ParticleSystem& system);

  /// Who is in one of the regions, or reaches into it with his effect surface, with the partners of their contacts.
  /// All steps must be settled.
  PartOfDevice part_in(const std::vector<sc_region>& regions, const ParticleSystem& system);

  /// Puts a part back as it has become: who is missing is gone, who was not there has come. The memory of contacts is
  /// that of before. The system's walls are where they are now.
  void put_back(const PartOfDevice& before, const ParticleSystem& after);

  /// Brings the columns of these names back, of those that `to` has, into rows as own particles stand on the device
  /// now; or puts them there. All steps must be settled.
  void read_columns(std::span<const std::string_view> names, Particles& to);
  void write_columns(std::span<const std::string_view> names, const Particles& from);

  /// What acts at each particle in the step that was not done because of it, in the order of ids.
  Buffer<sc_field> bring_back_fields() const;

  /// Own particles.
  std::size_t count() const { return n_ - (borders_ ? borders_->ghosts.size() : 0); }

  /// Listed partners of a particle, on average.
  double candidates() const;

  /// Memory of the device in use [bytes].
  std::size_t bytes() const;

 private:
  static constexpr std::size_t most_given = SC_MOST_GIVEN;
  static constexpr std::size_t group = 128;  // items of a group

  /// What the contacts on a list remember: those of shapes with partners do so by pairs, with walls more than spheres.
  enum class Remembers { nothing, laws, laws_in_single, laws_and_places };
  struct Lists {
    std::size_t particles = 0;
    int room = 0;  // for contacts of each
    Remembers remembers = Remembers::laws;
    opencl::DeviceBuffer counts, entries, slides, rolls, shapes;

    std::size_t bytes() const {
      return counts.bytes() + entries.bytes() + slides.bytes() + rolls.bytes() + shapes.bytes();
    }
  };
  /// One side of a contact that acts.
  struct Side {
    std::size_t particle;
    std::uint32_t entry;
    const double *slide, *roll, *shape;
    double sign;  // of directions
  };
  /// A contact that acts, as it is brought back.
  struct Acting {
    std::size_t particle;
    std::uint32_t other, code;           // the partner or the face; contact_code()
    const double *slide, *roll, *shape;  // null where nothing of the kind is remembered
    double overlap;                      // of a shape with a wall in the last step [m]
  };
  /// A pair of bodies of any shape that acts.
  struct ActingPair {
    std::size_t number;
    std::uint32_t code;                 // contact_code()
    std::array<std::uint32_t, 2> rows;  // of the owner and the partner
  };
  struct Done {
    std::ptrdiff_t steps;
    bool halted;      // lists hold no more, or something has gone wrong
    bool field_lost;  // what acts somewhere in the step that follows is no number
  };
  /// Contacts of some particles, and who else takes part in them.
  struct ContactsOfSome {
    Luggage contacts;
    std::vector<std::int32_t> partners;  // rows, some of them several times
  };
  static constexpr std::string_view ghost_column = "ghost";  // 1 of copies of others' particles

  void check_kernels();
  void check_sizes(const char* kernel, const std::vector<int>& expected);
  void check_sums();
  void check_law();
  void check_single_law();
  std::vector<std::array<double, 16>> single_results(const sc_contact_time& time, const std::vector<float>& touches,
                                                     const std::vector<float>& states);
  void check_shapes(const Forms& forms);
  [[noreturn]] void refuse(const std::string& what) const;
  void send_particles(const Particles& particles);
  void send_contacts(const ParticleSystem& system);
  void send_walls(const ParticleSystem& system);
  void send_poses();
  void send_shapes(const ParticleSystem& system);
  void send_pairs(const ParticleSystem& system);
  void send_sides(const ParticleSystem& system);
  Lists sent_sides(const std::vector<Side>& sides, Remembers remembers) const;
  std::optional<MemoryUnits> slide_units(Remembers remembers) const;
  std::optional<MemoryUnits> roll_units(Remembers remembers) const;
  Remembers pairs_remember() const { return mixed_ ? Remembers::laws_in_single : Remembers::laws; }
  template <class Visit>
  void for_each_acting(const Lists& lists, Visit&& visit) const;
  std::vector<ActingPair> acting_pairs() const;
  std::vector<ActingPair> pairs_of_some(const std::vector<std::int32_t>& asked) const;
  template <class IdOf>
  KeyedContacts remembered_by(const std::vector<ActingPair>& acting, IdOf&& id_of);
  template <class IdOf>
  Luggage remembered(const Lists& pairs, const Lists& faces, const std::vector<std::int64_t>& id, IdOf&& id_of) const;
  Lists make_room(std::size_t particles, int room, Remembers remembers) const;
  void reserve(std::size_t rows);
  void make_scratch(std::size_t row_bytes);
  opencl::DeviceBuffer& column(std::string_view name);
  const opencl::DeviceBuffer& column(std::string_view name) const;
  Lists taken(const Lists& lists, const std::vector<std::int32_t>& rows);
  ContactsOfSome contacts_of(const std::vector<std::int32_t>& rows, const std::vector<std::int64_t>& id);
  Particles particles_at(const std::vector<std::int32_t>& rows);
  std::vector<std::int64_t> ids_at(const std::vector<std::int32_t>& rows);
  std::vector<std::int32_t> found_rows();
  std::vector<std::int32_t> rows_in(const std::vector<sc_region>& regions);
  void put_rows(const std::vector<std::int32_t>& rows, const Particles& values);
  void append(const Particles& fresh);
  void widen_state(std::size_t count);
  double farthest() const;
  void fit_space(const ParticleSystem& system);
  void reach_as_far_as(const ParticleSystem& system, const Sizes& sizes);
  void dismiss(const std::vector<std::int32_t>& rows);
  void put_words(const std::vector<std::int32_t>& rows, std::int32_t word, opencl::DeviceBuffer& to);
  const opencl::DeviceBuffer& ghost_flags() const;
  std::vector<std::int32_t> ghosts() const;
  std::vector<std::int32_t> own_rows() const;
  void join(const ParticleSystem& system, const ContactLists& lists);
  void share_evenly();
  void cover_block(double range);
  std::vector<std::int32_t> rows_at_borders(double range);
  Luggage luggage_of(const Particles& border, const std::vector<std::int32_t>& rows);
  void meet_others();
  void take_places(const Particles& around, std::unordered_map<std::int64_t, std::int32_t>& row_of,
                   std::vector<std::int32_t>& standing);
  void follow(std::vector<std::int32_t>& rows);
  void follow_others();
  void unpack_luggage();
  void put_memory(const KeyedContacts& contacts, const std::unordered_map<std::int64_t, std::int32_t>& row_of,
                  Lists& lists, bool of_faces);
  template <class Visit>
  void for_each_travelling(int to, Visit&& visit);
  void renew_copies(int to);
  bool some_rank_halts(int step);
  void share_lost(int step);
  Done do_ahead();
  Done do_in_turn();
  std::size_t pair_row() const;
  DevicePairs make_pairs(std::size_t room) const;
  void make_room_for_pairs(std::size_t count);
  void list_pairs();
  void put_pairs(const KeyedContacts& contacts, const std::unordered_map<std::int64_t, std::int32_t>& row_of);
  void make_lists();
  void sort_particles();
  void take(const opencl::DeviceBuffer& rows, std::size_t count, std::size_t row_bytes,
            const opencl::DeviceBuffer& from, opencl::DeviceBuffer& packed);
  void put(const opencl::DeviceBuffer& rows, std::size_t count, std::size_t row_bytes,
           const opencl::DeviceBuffer& packed, opencl::DeviceBuffer& to);
  void permute(opencl::DeviceBuffer& rows, std::size_t row_bytes, std::size_t count);
  void permute_state(std::size_t count);
  void note_places();
  void scan(opencl::DeviceBuffer& values, int count);
  template <class Search>
  void search_into(Lists& lists, Search&& search);
  void carry_over(Lists& from, Lists& to, bool of_faces);
  void demand_none_lost() const;
  void find_partners(Lists& to);
  void find_faces();
  void list_faces();
  void fit_cells();
  void adapt_skin();
  void launch(const DeviceStep& given, int number);
  void meet_fields(int number, int from);
  void send_bodies(const std::vector<sc_body_group>& groups);
  void find_bodies();
  void send_prescribed();
  void accelerate_bodies(int number, int from);
  void carry_bodies(int number, int to);
  void count_passings(int number, int from, int to);
  void take_passings();
  const opencl::DeviceBuffer& column_or_none(std::string_view name) const;
  template <class... State>
  void pass(const char* kernel, int number, const State&... state);
  void launch_spheres(int number, int from, int to);
  void launch_mixed(int number, int from, int to);
  void launch_shapes(int number, int from, int to);
  const MixedState* mixed() const { return mixed_ ? &*mixed_ : nullptr; }
  void add_findings(DeviceFindings& to);
  sc_counts counts() const;
  std::size_t groups() const;  // of all particles that there is memory for
  std::size_t finding_groups() const;

  const opencl::Device& device_;
  opencl::Program program_;
  DeviceFields fields_;
  sc_laws laws_of_run_;
  sc_pair_law first_law_;  // of the first material with itself
  bool rolls_;
  std::size_t n_;
  std::size_t come_ = 0, gone_count_ = 0;  // since the lists were made: they stand after the others, or are marked
  std::size_t rows_ = 0;                   // of particles that there is memory for
  int materials_;
  std::size_t faces_, walls_;
  sc_device_step constants_{};
  std::array<double, 3> least_{}, greatest_{};  // corners of what the cells cover [m]
  std::array<bool, 3> wraps_{};                 // that is a whole period
  sc_cells cells_{};
  Sizes sizes_;        // of all that have been there
  double range_ = 0;   // two bodies whose centres are further apart are not listed, skin left out [m]
  double beyond_ = 0;  // how far bodies act beyond their effect surfaces [m]
  double skin_, shortest_skin_, longest_skin_;  // [m]
  bool adapts_;
  std::map<std::string_view, opencl::DeviceBuffer> columns_;  // of Particles, by name, motion and spin left out
  std::map<std::string_view, std::size_t> row_bytes_;
  // The present state, and the next. In mixed precision only the first of each, for lists and hosts.
  opencl::DeviceBuffer motion_[2], spin_[2];
  std::optional<MixedState> mixed_;
  int now_ = 0;  // which of them is the present one
  opencl::DeviceBuffer listed_, laws_;
  opencl::DeviceBuffer wall_faces_, wall_poses_;  // poses: of all walls, step by step
  opencl::DeviceBuffer gaps_, corners_;           // of the listed faces, in the present step
  opencl::DeviceBuffer cell_of_, cell_first_, cursor_, order_, place_, gone_, scratch_, found_, stale_, counters_;
  Lists lists_, fresh_, face_lists_, fresh_face_lists_;
  std::optional<DeviceShapes> shapes_;  // where some particles are no spheres
  std::optional<DeviceBodies> bodies_;  // where some move as prescribed
  std::optional<DevicePlanes> planes_;  // where some are counted
  std::vector<DeviceStep> given_;
  Particles alike_;                       // none, with the fields that there are
  std::optional<DeviceBorders> borders_;  // where there are several ranks
  std::int64_t steps_listed_ = 0;         // since the lists were made
  double walls_travelled_ = 0;            // no wall goes further from then to the end of the step launched last [m]
  bool listed_already_ = false;
};

}  // namespace scree
