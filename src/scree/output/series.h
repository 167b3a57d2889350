// Tables of numbers that grow while the program runs: CSV, one line per row.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace scree {

/// Drops the rows of a table that are later than `last_time` [s] (the first column), and a torn last line; a file
/// without a whole first line is removed. Throws InputError at a line that is no row of numbers, ResourceError.
void drop_rows_after(const std::filesystem::path& path, double last_time);

/// A CSV file open at its end. The first column is the time [s]; numbers are written with the fewest digits that give
/// the same double back. Rows reach the operating system at once, so a killed run loses none of them.
class SeriesWriter {
 public:
  /// A new table with only the line of names, replacing what is there. Throws ResourceError.
  static SeriesWriter create(const std::filesystem::path& path, std::vector<std::string> names);

  /// Goes on with an existing table after dropping the rows later than `last_time` and a torn last line; makes a new
  /// one if there is none. Throws InputError when the file has other columns or a line that is no row of numbers.
  static SeriesWriter resume(const std::filesystem::path& path, std::vector<std::string> names, double last_time);

  SeriesWriter(SeriesWriter&& other) noexcept;
  SeriesWriter& operator=(SeriesWriter&&) = delete;
  ~SeriesWriter();

  /// Appends values.size() / columns rows in one piece. Throws ResourceError; the table then ends with a whole row.
  void append(std::span<const double> values);

 private:
  SeriesWriter(std::filesystem::path path, std::size_t columns);

  std::filesystem::path path_;
  std::size_t columns_;
  int descriptor_;
};

}  // namespace scree
