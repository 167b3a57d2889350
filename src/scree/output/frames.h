// Pictures of all particles at chosen times: one HDF5 file per frame and an XDMF file over all of them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scree/data/domain.h"
#include "scree/output/element.h"
#include "scree/output/numbered_file.h"
#include "scree/output/slab.h"

namespace scree {

/// One field of a frame: a row per particle, in the order of the ids.
struct FrameColumn {
  std::string name;     // of the dataset; one column is "position" with three components
  std::string unit;     // "m/s"; "1" if it has none
  std::string meaning;  // one sentence
  ArrayView values;
  std::shared_ptr<const void> owner = nullptr;  // of the values, where they are not the caller's
};

/// Columns whose rows are `first` and following of `total`, where several ranks write a frame.
struct FrameRows {
  std::vector<FrameColumn> columns;
  std::uint64_t first = 0, total = 0;
};

/// The rows of all ranks in the order of their keys, and what of them this rank writes. To be called by all ranks.
FrameRows rows_in_order(std::vector<FrameColumn> columns, std::span<const RowKey> keys, const Ranks& ranks);

/// What is squeezed: whole numbers only, nothing, or everything, quickly or as small as it gets. Whole numbers repeat
/// and shrink to a few percent; the lower digits of floating-point results are noise, and squeezing them costs ten
/// times the writing for a tenth of the size.
enum class Compression { whole_numbers, none, fast, small };

/// What frames are of, and how their files are called.
struct FrameKind {
  std::string_view folder;
  NumberedFiles files;
  std::string_view group;     // of the datasets in a file
  std::string_view document;  // the XDMF file over all of them
  std::string_view format;    // written into each file
};

inline constexpr FrameKind particle_frames{"frames", frame_files, "particles", "fields.xdmf", "scree frame"};
inline constexpr FrameKind contact_frames{"contacts", contact_files, "contacts", "contacts.xdmf", "scree contacts"};

/// Writes DIR/frames/frame_NNNNNN.h5 and DIR/fields.xdmf, or what its kind says. Both are replaced atomically: whatever
/// happens to the run, every frame that exists is whole and the XDMF names only frames that exist.
class FrameWriter {
 public:
  /// A new series of frames in an existing run directory. `program` names the writer, as in "scree 0.1.0".
  static FrameWriter create(const std::filesystem::path& directory, const Domain& domain, std::string program,
                            Compression compression = Compression::whole_numbers,
                            const FrameKind& kind = particle_frames);

  /// Goes on after the frames that are there; those later than `last_time` [s] are deleted.
  /// Throws InputError when a frame cannot be read.
  static FrameWriter resume(const std::filesystem::path& directory, const Domain& domain, std::string program,
                            double last_time, Compression compression = Compression::whole_numbers,
                            const FrameKind& kind = particle_frames);

  /// Writes the next frame. All columns have the same number of rows, which may differ from frame to frame.
  /// Throws ResourceError.
  void write(double time, std::uint64_t step, std::span<const FrameColumn> columns);

  /// The same, where other ranks write_share() of their rows.
  void write(double time, std::uint64_t step, const FrameRows& rows, const Ranks& ranks);

  /// What ranks other than the root do while that writes a frame.
  static void write_share(const FrameRows& rows, Compression compression, const FrameKind& kind, const Ranks& ranks);

  /// Frames written so far, those before a restart included: the number of the next frame.
  std::uint64_t count() const { return count_; }

 private:
  FrameWriter(std::filesystem::path directory, const Domain& domain, std::string program, Compression compression,
              const FrameKind& kind);
  void write_fields_file() const;

  FrameKind kind_;
  std::filesystem::path directory_;
  Domain domain_;
  std::string program_;
  Compression compression_;
  std::uint64_t count_ = 0;
  std::string grids_;  // the XDMF text of the frames so far
};

}  // namespace scree
