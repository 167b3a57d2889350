#include "scree/output/grids.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "scree/base/atomic_file.h"
#include "scree/base/error.h"
#include "scree/output/hdf5_file.h"
#include "scree/output/xdmf.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view grid_format = "scree averages";
constexpr std::int64_t format_version = 1;

void write_header(Hdf5File& file, const GridSpan& span, const std::string& program) {
  file.set_attribute("/", "format", grid_format);
  file.set_attribute("/", "format_version", array_view(&format_version, 1));
  file.set_attribute("/", "program", program);
  file.set_attribute("/", "time", array_view(&span.end, 1));
  file.set_attribute("/", "begin", array_view(&span.begin, 1));
  file.set_attribute("/", "time_units", "s");
  file.set_attribute("/", "samples", array_view(&span.samples, 1));
  file.set_attribute("/", "grid_min", array_view(span.min.data(), 3));
  file.set_attribute("/", "grid_max", array_view(span.max.data(), 3));
  file.set_attribute("/", "grid_units", "m");
  file.set_attribute("/", "cells", array_view(span.cells.data(), 3));
}

/// The XDMF view of a file.
XdmfCells describe(const fs::path& path) {
  const Hdf5File file = Hdf5File::open(path);
  if (file.text_attribute("/", "format") != grid_format)
    throw InputError(fmt::format("'{}' holds no averages of Scree; remove it or restart into a new directory (-o DIR)",
                                 path.string()));
  XdmfCells out;
  std::array<double, 3> max;
  out.file = path.filename().string();
  file.read_attribute("/", "time", Element::float64, 1, &out.time);
  file.read_attribute("/", "grid_min", Element::float64, 3, out.min.data());
  file.read_attribute("/", "grid_max", Element::float64, 3, max.data());
  file.read_attribute("/", "cells", Element::int64, 3, out.cells.data());
  for (int k = 0; k < 3; ++k) out.spacing[k] = (max[k] - out.min[k]) / static_cast<double>(out.cells[k]);
  for (const std::string& name : file.names("/fields")) {
    const Shape shape = file.shape("/fields/" + name);
    out.fields.push_back({name, shape.element, shape.columns});
  }
  return out;
}

}  // namespace

GridWriter::GridWriter(const fs::path& directory, std::string name, std::string program, std::uint64_t kept)
    : folder_(directory / "averages"), name_(std::move(name)), prefix_(name_ + "_"), program_(std::move(program)) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) throw ResourceError(fmt::format("cannot create '{}': {}", folder_.string(), error.message()));
  const auto found = list_numbered({prefix_, 6}, folder_);
  for (const auto& [number, path] : found)
    if (number < kept) grids_[number] = xdmf_grid(describe(path));
  // First the film, then the files: at no moment does it name one that is gone.
  write_film();
  for (const auto& [number, path] : found)
    if (number >= kept) fs::remove(path);
}

void GridWriter::write(std::uint64_t number, const GridSpan& span, std::span<const FrameColumn> columns) {
  const auto cells = static_cast<std::uint64_t>(span.cells[0] * span.cells[1] * span.cells[2]);
  const fs::path path = folder_ / numbered_name({prefix_, 6}, number);
  write_atomically(path, [&](const fs::path& temporary) {
    Hdf5File file = Hdf5File::create(temporary);
    write_header(file, span, program_);
    file.create_group("/fields");
    for (const FrameColumn& column : columns) {
      if (column.values.rows != cells) throw std::logic_error("a field of averages has a row for every cell");
      const std::string place = "/fields/" + column.name;
      file.write(place, column.values);
      file.set_attribute(place, "units", column.unit);
      file.set_attribute(place, "meaning", column.meaning);
    }
    file.close();
  });
  grids_[number] = xdmf_grid(describe(path));
  write_film();
}

void GridWriter::write_film() const {
  std::string grids;
  for (const auto& [number, grid] : grids_) grids += grid;
  write_text_file(folder_ / (name_ + ".xdmf"), xdmf_document(grids));
}

}  // namespace scree
