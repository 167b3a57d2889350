// The state of a run as named arrays and values in one checked file: a checkpoint.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <ranges>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "scree/output/slab.h"

namespace scree {

/// One named array. `owner` keeps the memory alive where the archive owns it and is empty where it is borrowed. Of a
/// shared one every rank has some rows, from `first` on of `total`; the others the root has alone.
struct ArchivedArray {
  std::string name;
  ArrayView values;
  std::shared_ptr<const void> owner;
  bool shared = false;
  std::uint64_t first = 0, total = 0;
};

using ArchivedValue = std::variant<double, std::int64_t, std::string>;

/// Named arrays and named single values, in the order in which they were put. Names are unique and hold no '/'.
/// Everything comes back from a file bit for bit.
class Archive {
 public:
  /// Adds rows * columns elements that stay the caller's: they must live until the archive is written.
  template <class T>
  void put(std::string name, const T* data, std::uint64_t rows, std::uint64_t columns = 1) {
    add({std::move(name), array_view(data, rows, columns), nullptr});
  }

  /// Adds a container of rows * columns elements: an lvalue is borrowed as above, a temporary is moved into the
  /// archive.
  template <std::ranges::contiguous_range R>
  void put(std::string name, R&& range, std::uint64_t columns = 1) {
    if constexpr (std::is_lvalue_reference_v<R> || std::ranges::borrowed_range<R>) {
      put(std::move(name), std::ranges::data(range), std::ranges::size(range) / columns, columns);
    } else {
      auto kept = std::make_shared<const std::remove_cvref_t<R>>(std::forward<R>(range));
      const std::uint64_t rows = std::ranges::size(*kept) / columns;
      add({std::move(name), array_view(std::ranges::data(*kept), rows, columns), kept});
    }
  }

  /// Adds what this rank has of arrays that all ranks share: the columns of a slab, by their names.
  void put_shared(std::span<const std::string> names, const Slab& slab);

  void set(std::string name, ArchivedValue value);

  /// Adds all that another archive holds.
  void add_all(const Archive& other);

  bool contains(const std::string& name) const;

  /// All elements of an array, row by row; valid as long as the archive and what it borrows.
  /// Throws InputError when there is no such array or it holds another type or number of columns.
  template <class T>
  std::span<const T> get(const std::string& name, std::uint64_t columns = 1) const {
    const ArrayView& found = find(name, element_of<T>(), columns);
    return {static_cast<const T*>(found.data), found.rows * found.columns};
  }

  /// The rows of an array that this rank takes: those that it has of a shared one, an equal part of another. Throws as
  /// get().
  template <class T>
  std::span<const T> part(const std::string& name, std::uint64_t columns, const Ranks& ranks) const {
    const std::span<const T> all = get<T>(name, columns);
    if (is_cut(name)) return all;
    const auto [first, rows] = equal_part(all.size() / columns, ranks);
    return all.subspan(first * columns, rows * columns);
  }

  /// Single values. Throw InputError when there is none of this name and type.
  double number(const std::string& name) const;
  std::int64_t integer(const std::string& name) const;
  const std::string& text(const std::string& name) const;

  const std::vector<ArchivedArray>& arrays() const { return arrays_; }
  const std::vector<std::pair<std::string, ArchivedValue>>& values() const { return values_; }

  /// For messages: the file that the archive came from.
  std::string origin = "the checkpoint";

  /// Adds an array as it is; read_archive() uses it.
  void add(ArchivedArray array);

 private:
  /// Whether other ranks have the rest of an array.
  bool is_cut(const std::string& name) const;
  const ArrayView& find(const std::string& name, Element element, std::uint64_t columns) const;
  template <class T>
  const T& value(const std::string& name, const char* type) const;

  std::vector<ArchivedArray> arrays_;
  std::vector<std::pair<std::string, ArchivedValue>> values_;
};

/// Writes the archive atomically with a SHA-256 over the whole file. Of several ranks all call it, with the same shared
/// arrays; the root adds everything else. Throws ResourceError, at the root; an older file of that name is then still
/// there.
void write_archive(const std::filesystem::path& path, const Archive& archive, const Ranks& ranks = {});

/// Reads what write_archive() wrote. Throws InputError with the reason when the file is missing, foreign, of another
/// version, incomplete or damaged in any bit; the message says that one cannot `purpose` the file.
/// Of several ranks all call it, and each reads an equal part of every shared array.
Archive read_archive(const std::filesystem::path& path, std::string_view purpose = "restart from",
                     const Ranks& ranks = {});

/// The checks of read_archive() without loading: returns if the file is whole, else throws InputError.
void verify_archive(const std::filesystem::path& path, std::string_view purpose = "restart from");

}  // namespace scree
