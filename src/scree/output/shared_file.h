// One HDF5 file that all ranks write at once, and the same to the last byte for any number of them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "scree/mpi/ranks.h"
#include "scree/output/hdf5_file.h"

namespace scree {

/// A dataset of which every rank has some rows: `mine` are rows `first` and following of `total`.
struct SharedDataset {
  std::string place;
  ArrayView mine;
  std::uint64_t first = 0, total = 0;
  Storage storage = Storage::plain;
  std::vector<std::pair<std::string, std::string>> attributes = {};
  std::shared_ptr<const void> owner = nullptr;
};

/// What ranks other than the root have of a file are its datasets alone.
struct SharedFile {
  std::uint64_t user_block = 0;
  std::function<void(Hdf5File&)> begin;                                   // what comes before the datasets
  std::vector<SharedDataset> datasets;                                    // the same on all ranks, but for their rows
  std::function<void(const std::filesystem::path& temporary)> seal = {};  // last, when all values are there
};

/// Writes a file atomically. To be called by all ranks; whichever of them fails, the root throws ResourceError, and
/// what was there before is still there.
///
/// The root lays the file out. Values that are stored as they are every rank then writes itself; chunks that are
/// squeezed every rank squeezes and the root writes.
void write_shared(const std::filesystem::path& path, const SharedFile& file, const Ranks& ranks);

}  // namespace scree
