// The layout of a frame file, and the XDMF file that follows the frames.
#include "scree/output/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

#include "scree/base/atomic_file.h"
#include "scree/base/error.h"
#include "scree/output/hdf5_file.h"
#include "scree/output/numbered_file.h"
#include "scree/output/xdmf.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t format_version = 1;

std::string path_in_directory(const FrameKind& kind, std::uint64_t number) {
  return fmt::format("{}/{}", kind.folder, numbered_name(kind.files, number));
}

void write_header(Hdf5File& file, const Domain& domain, const std::string& program, double time, std::uint64_t step) {
  const std::array<std::uint8_t, 3> periodic = {domain.periodic[0], domain.periodic[1], domain.periodic[2]};
  file.set_attribute("/", "format_version", array_view(&format_version, 1));
  file.set_attribute("/", "program", program);
  file.set_attribute("/", "time", array_view(&time, 1));
  file.set_attribute("/", "time_units", "s");
  file.set_attribute("/", "step", array_view(&step, 1));
  file.set_attribute("/", "domain_min", array_view(domain.min.data(), 3));
  file.set_attribute("/", "domain_max", array_view(domain.max.data(), 3));
  file.set_attribute("/", "domain_units", "m");
  file.set_attribute("/", "domain_periodic", array_view(periodic.data(), 3));
}

Storage storage_for(Element element, Compression compression) {
  switch (compression) {
    case Compression::none:
      return Storage::plain;
    case Compression::fast:
      return Storage::compressed;
    case Compression::small:
      return Storage::compressed_hard;
    case Compression::whole_numbers:
      break;
  }
  return is_floating(element) ? Storage::plain : Storage::compressed;
}

/// One vertex cell per point. ParaView's XDMF 3 reader makes no cells without such a list, and a cloud without cells
/// is invisible until glyphs are chosen and cannot be filtered.
void write_vertices(Hdf5File& file, std::uint64_t points, Compression compression) {
  std::vector<std::int32_t> vertices(points);
  std::iota(vertices.begin(), vertices.end(), 0);
  file.write("/vertices", array_view(vertices.data(), points), storage_for(Element::int32, compression));
  file.set_attribute("/vertices", "units", "1");
  file.set_attribute("/vertices", "meaning", "0, 1, 2, ...: the cells of ParaView, one per point");
}

/// The XDMF view of a frame on disk.
XdmfFrame describe(const FrameKind& kind, const fs::path& path, std::uint64_t number) {
  const Hdf5File file = Hdf5File::open(path);
  if (file.text_attribute("/", "format") != kind.format)
    throw InputError(
        fmt::format("'{}' is not a frame of Scree; remove it or restart into a new directory (-o DIR)", path.string()));
  XdmfFrame frame;
  frame.file = path_in_directory(kind, number);
  frame.group = kind.group;
  const std::string group = fmt::format("/{}", kind.group);
  file.read_attribute("/", "time", Element::float64, 1, &frame.time);
  for (const std::string& name : file.names(group)) {
    const Shape shape = file.shape(group + "/" + name);
    frame.points = shape.rows;
    frame.fields.push_back({name, shape.element, shape.columns});
  }
  return frame;
}

}  // namespace

FrameWriter::FrameWriter(fs::path directory, const Domain& domain, std::string program, Compression compression,
                         const FrameKind& kind)
    : kind_(kind),
      directory_(std::move(directory)),
      domain_(domain),
      program_(std::move(program)),
      compression_(compression) {
  std::error_code error;
  const fs::path folder = directory_ / kind_.folder;
  fs::create_directories(folder, error);
  if (error) throw ResourceError(fmt::format("cannot create '{}': {}", folder.string(), error.message()));
}

FrameWriter FrameWriter::create(const fs::path& directory, const Domain& domain, std::string program,
                                Compression compression, const FrameKind& kind) {
  FrameWriter writer(directory, domain, std::move(program), compression, kind);
  writer.write_fields_file();
  return writer;
}

FrameWriter FrameWriter::resume(const fs::path& directory, const Domain& domain, std::string program, double last_time,
                                Compression compression, const FrameKind& kind) {
  FrameWriter writer(directory, domain, std::move(program), compression, kind);
  std::vector<fs::path> dropped;
  for (const auto& [number, path] : list_numbered(kind.files, directory / kind.folder)) {
    const XdmfFrame frame = describe(kind, path, number);
    if (frame.time > last_time) {
      dropped.push_back(path);
      continue;
    }
    writer.grids_ += xdmf_grid(frame);
    writer.count_ = number + 1;
  }
  // First the list, then the files: at no moment does it name a frame that is gone.
  writer.write_fields_file();
  for (const fs::path& path : dropped) fs::remove(path);
  return writer;
}

void FrameWriter::write(double time, std::uint64_t step, std::span<const FrameColumn> columns) {
  XdmfFrame frame{path_in_directory(kind_, count_),
                  time,
                  columns.empty() ? 0 : columns.front().values.rows,
                  {},
                  std::string(kind_.group)};
  const std::string group = "/" + frame.group;
  for (const FrameColumn& column : columns) {
    if (column.values.rows != frame.points) throw std::logic_error("columns of a frame differ in length");
    frame.fields.push_back({column.name, column.values.element, column.values.columns});
  }
  write_atomically(directory_ / frame.file, [&](const fs::path& temporary) {
    Hdf5File file = Hdf5File::create(temporary);
    file.set_attribute("/", "format", kind_.format);
    write_header(file, domain_, program_, time, step);
    file.create_group(group);
    for (const FrameColumn& column : columns) {
      const std::string place = group + "/" + column.name;
      file.write(place, column.values, storage_for(column.values.element, compression_));
      file.set_attribute(place, "units", column.unit);
      file.set_attribute(place, "meaning", column.meaning);
    }
    write_vertices(file, frame.points, compression_);
    file.close();
  });
  grids_ += xdmf_grid(frame);
  ++count_;
  write_fields_file();
}

void FrameWriter::write_fields_file() const { write_text_file(directory_ / kind_.document, xdmf_document(grids_)); }

}  // namespace scree
