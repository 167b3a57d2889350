#include "scree/app/verify_results.h"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <fstream>

#include "scree/base/error.h"

namespace scree {
namespace {

struct CsvFile {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;
};

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields;
  std::size_t begin = 0;
  for (std::size_t end; (end = line.find(',', begin)) != std::string::npos; begin = end + 1)
    fields.push_back(line.substr(begin, end - begin));
  fields.push_back(line.substr(begin));
  return fields;
}

double to_number(const std::string& field, const std::string& path, std::size_t line) {
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size())
    throw InputError(fmt::format("{}:{}: '{}' is not a number", path, line, field));
  return value;
}

CsvFile read_csv(const std::string& path) {
  std::ifstream in(path);
  std::string line;
  if (!in || !std::getline(in, line)) throw InputError(fmt::format("{}: missing or empty; run the case again", path));
  CsvFile file;
  file.names = split(line);
  file.columns.resize(file.names.size());
  for (std::size_t number = 2; std::getline(in, line); ++number) {
    const std::vector<std::string> fields = split(line);
    if (fields.size() != file.names.size())
      throw InputError(
          fmt::format("{}:{}: {} fields where the header has {}", path, number, fields.size(), file.names.size()));
    for (std::size_t i = 0; i < fields.size(); ++i) file.columns[i].push_back(to_number(fields[i], path, number));
  }
  return file;
}

// The long format of tracks.csv (time, id, then values) becomes one column per particle and value.
void add_tracks(const std::string& path, ResultTable& table) {
  const CsvFile file = read_csv(path);
  if (file.names.size() < 3 || file.names[0] != "time" || file.names[1] != "id")
    throw InputError(fmt::format("{}:1: the columns must begin with time,id", path));
  const std::size_t rows = table.rows();
  for (std::size_t row = 0; row < file.columns[0].size(); ++row) {
    const std::string prefix = fmt::format("p{}.", static_cast<long long>(file.columns[1][row]));
    for (std::size_t i = 2; i < file.names.size(); ++i)
      table.columns[prefix + file.names[i]].push_back(file.columns[i][row]);
  }
  for (const auto& [name, values] : table.columns)
    if (values.size() != rows)
      throw InputError(fmt::format("{}: {} has {} rows, the series {}; a followed particle must live through the run",
                                   path, name, values.size(), rows));
}

}  // namespace

ResultTable load_results(const std::string& directory) {
  ResultTable table;
  const std::string series = directory + "/series.csv";
  CsvFile file = read_csv(series);
  for (std::size_t i = 0; i < file.names.size(); ++i) table.columns[file.names[i]] = std::move(file.columns[i]);
  if (!table.columns.contains("time") || table.rows() == 0)
    throw InputError(fmt::format("{}: no column 'time' or no rows", series));
  const std::string tracks = directory + "/tracks.csv";
  if (std::filesystem::exists(tracks)) add_tracks(tracks, table);
  return table;
}

}  // namespace scree
