#include "scree/particles/insert_table.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string_view>

#include "scree/base/error.h"

namespace scree {
namespace {

enum Column : int { x, y, z, vx, vy, vz, wx, wy, wz, diameter, qw, qx, qy, qz, columns };
constexpr std::array<std::string_view, columns> column_names{"x",  "y",  "z",        "vx", "vy", "vz", "wx",
                                                             "wy", "wz", "diameter", "qw", "qx", "qy", "qz"};

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> fields;
  for (;;) {
    const auto comma = line.find(',');
    fields.push_back(trimmed(line.substr(0, comma)));
    if (comma == line.npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

class Table {
 public:
  explicit Table(const std::string& path) : path_(path), file_(path) {
    if (!file_) throw InputError(fmt::format("{}: cannot be read\n  = help: check the path and the permissions", path));
  }

  std::vector<GivenParticle> read() {
    std::vector<GivenParticle> particles;
    if (!next_line()) fail("the file is empty", "the first line must name the columns, at least x,y,z");
    read_header();
    while (next_line()) particles.push_back(read_row());
    return particles;
  }

 private:
  [[noreturn]] void fail(const std::string& finding, const std::string& remedy) const {
    throw InputError(fmt::format("{}:{}: error: {}\n  = help: {}", path_, line_number_, finding, remedy));
  }

  bool next_line() {
    while (std::getline(file_, line_)) {
      ++line_number_;
      if (line_number_ == 1 && line_.starts_with("\xEF\xBB\xBF")) line_.erase(0, 3);
      const auto text = trimmed(line_);
      if (!text.empty() && text.front() != '#') return true;
    }
    return false;
  }

  void read_header() {
    for (const char separator : {';', '\t'})
      if (line_.find(separator) != line_.npos && line_.find(',') == line_.npos)
        fail(fmt::format("the columns are separated by {}", separator == ';' ? "semicolons" : "tabs"),
             "separate columns by commas, and write decimals with a point: x,y,z and 0.5,1.25,2");
    place_.fill(-1);
    const auto names = split(line_);
    width_ = names.size();
    for (std::size_t f = 0; f < names.size(); ++f) {
      int column = 0;
      while (column < columns && column_names[column] != names[f]) ++column;
      if (column == columns)
        fail(fmt::format("unknown column '{}'", names[f]),
             fmt::format("columns are {}", fmt::join(column_names, ", ")));
      if (place_[column] >= 0) fail(fmt::format("column '{}' occurs twice", names[f]), "remove one of them");
      place_[column] = static_cast<int>(f);
    }
    int turned = 0;
    for (const int q : {qw, qx, qy, qz}) turned += place_[q] >= 0;
    if (turned != 0 && turned != 4)
      fail("columns qw, qx, qy, qz must all be there, or none of them",
           "add what is missing to the first line and to every row");
    for (const int first : {x, vx, wx}) {
      const int present = (place_[first] >= 0) + (place_[first + 1] >= 0) + (place_[first + 2] >= 0);
      if (present != 3 && (present != 0 || first == x))
        fail(fmt::format("columns {}, {}, {} must all be there{}", column_names[first], column_names[first + 1],
                         column_names[first + 2], first == x ? "" : ", or none of them"),
             "add what is missing to the first line and to every row");
    }
  }

  double number(std::string_view text, int column) const {
    double value = 0;
    const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const auto [end, problem] = std::from_chars(begin, text.data() + text.size(), value);
    if (problem != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
      fail(fmt::format("'{}' in column {} is not a number", text, column_names[column]),
           "write plain SI numbers, such as 0.0012 or 1.2e-3");
    return value;
  }

  GivenParticle read_row() const {
    const auto fields = split(line_);
    if (fields.size() != width_)
      fail(fmt::format("{} values, but the first line names {} columns", fields.size(), width_),
           "give one value per column, separated by commas");
    const auto three = [&](int first) {
      std::array<double, 3> v;
      for (int k = 0; k < 3; ++k) v[k] = number(fields[place_[first + k]], first + k);
      return v;
    };
    GivenParticle p;
    p.position = three(x);
    if (place_[vx] >= 0) p.velocity = three(vx);
    if (place_[wx] >= 0) p.angular_velocity = three(wx);
    if (place_[diameter] >= 0) {
      p.diameter = number(fields[place_[diameter]], diameter);
      if (*p.diameter <= 0) fail(fmt::format("diameter {:g} is not positive", *p.diameter), "diameters are in metres");
    }
    if (place_[qw] >= 0) p.orientation = orientation(fields);
    return p;
  }

  sc_quat orientation(const std::vector<std::string_view>& fields) const {
    constexpr double length_tolerance = 1e-6;
    double q[4];
    for (int k = 0; k < 4; ++k) q[k] = number(fields[place_[qw + k]], qw + k);
    const sc_quat out = sc_make_quat(q[0], q[1], q[2], q[3]);
    if (std::abs(sc_quat_square(out) - 1) > length_tolerance)
      fail(fmt::format("the quaternion ({:g}, {:g}, {:g}, {:g}) does not have the length 1", q[0], q[1], q[2], q[3]),
           "divide qw, qx, qy, qz by the root of the sum of their squares");
    return out;
  }

  std::string path_;
  std::ifstream file_;
  std::string line_;
  std::size_t line_number_ = 0, width_ = 0;
  std::array<int, columns> place_{};
};

}  // namespace

std::vector<GivenParticle> read_particle_table(const std::string& path) { return Table(path).read(); }

}  // namespace scree
