// One HDF5 file: datasets, groups and attributes, with every failure of the library turned into an exception.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scree/output/element.h"

namespace scree {

/// How a dataset is stored: as it is, or in chunks with byte shuffle and deflate, quick or thorough.
enum class Storage { plain, compressed, compressed_hard };

/// What a dataset in a file holds; columns is 1 for a one-dimensional one.
struct Shape {
  Element element = Element::float64;
  std::uint64_t rows = 0, columns = 1;
};

/// Rows of a chunk where a dataset is stored in chunks.
std::uint64_t rows_in_chunk(const Shape& shape);

/// A chunk as the file holds it: byte shuffle and deflate. `size` bytes at `data` are rows_in_chunk() rows.
std::vector<std::byte> squeeze(const void* data, std::size_t size, Element element, Storage storage);

/// A file open for writing (create) or reading (open). Names are paths inside the file ("/group/name").
/// Failures throw ResourceError when writing and InputError when reading, with path, name and reason.
class Hdf5File {
 public:
  /// An empty file, replacing what is there. The first `user_block` bytes (0, or a power of two from 512) stay free for
  /// the caller.
  static Hdf5File create(const std::filesystem::path& path, std::uint64_t user_block = 0);
  static Hdf5File open(const std::filesystem::path& path);

  Hdf5File(Hdf5File&& other) noexcept;
  Hdf5File& operator=(Hdf5File&&) = delete;
  ~Hdf5File();

  /// Brings everything to the file; a writer must call it, since the destructor cannot report a full disk.
  void close();

  void create_group(const std::string& name);

  /// One-dimensional when the array has one column, else two-dimensional.
  void write(const std::string& name, const ArrayView& array, Storage storage = Storage::plain);
  void write_text(const std::string& name, std::string_view text);

  /// A dataset stored as it is whose values somebody else writes into the closed file: rows one after the other, least
  /// byte first, from the place that is returned.
  std::uint64_t reserve(const std::string& name, const Shape& shape);

  /// A dataset in chunks, which come from squeeze(): each with its first row.
  void write_chunks(const std::string& name, const Shape& shape, Storage storage,
                    std::span<const std::pair<std::uint64_t, std::span<const std::byte>>> chunks);

  /// Attributes of the dataset or group `object` ("/" for the file itself).
  void set_attribute(const std::string& object, const std::string& name, std::string_view text);
  void set_attribute(const std::string& object, const std::string& name, const ArrayView& row);

  bool contains(const std::string& name) const;
  bool contains_attribute(const std::string& object, const std::string& name) const;
  /// Names in a group, in the order in which they were written.
  std::vector<std::string> names(const std::string& group) const;
  bool is_text(const std::string& name) const;
  Shape shape(const std::string& name) const;

  /// Reads a whole dataset into memory of element_size * rows * columns bytes, which shape() told.
  void read(const std::string& name, const Shape& shape, void* destination) const;

  /// Reads `rows` rows from `first` on.
  void read_rows(const std::string& name, const Shape& shape, std::uint64_t first, std::uint64_t rows,
                 void* destination) const;
  std::string read_text(const std::string& name) const;

  std::string text_attribute(const std::string& object, const std::string& name) const;
  /// Reads an attribute of exactly `count` elements.
  void read_attribute(const std::string& object, const std::string& name, Element element, std::uint64_t count,
                      void* destination) const;

 private:
  Hdf5File(std::filesystem::path path, std::int64_t handle, bool writing);
  std::int64_t create_dataset(const std::string& name, const Shape& shape, std::int64_t creation);
  [[noreturn]] void fail(const std::string& name) const;
  std::int64_t check(std::int64_t result, const std::string& name) const;

  std::filesystem::path path_;
  std::int64_t handle_;
  bool writing_;
};

}  // namespace scree
