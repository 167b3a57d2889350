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
#include "scree/output/numbered_file.h"
#include "scree/output/shared_file.h"
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
SharedDataset vertices_of(const FrameRows& rows, std::uint64_t mine, Compression compression) {
  const auto vertices = std::make_shared<std::vector<std::int32_t>>(mine);
  std::iota(vertices->begin(), vertices->end(), static_cast<std::int32_t>(rows.first));
  return {"/vertices",
          array_view(vertices->data(), mine),
          rows.first,
          rows.total,
          storage_for(Element::int32, compression),
          {{"units", "1"}, {"meaning", "0, 1, 2, ...: the cells of ParaView, one per point"}},
          vertices};
}

/// The datasets of a frame, of which each rank has its rows.
std::vector<SharedDataset> datasets_of(const FrameRows& rows, Compression compression, std::string_view group) {
  std::vector<SharedDataset> out;
  for (const FrameColumn& column : rows.columns)
    out.push_back({fmt::format("/{}/{}", group, column.name),
                   column.values,
                   rows.first,
                   rows.total,
                   storage_for(column.values.element, compression),
                   {{"units", column.unit}, {"meaning", column.meaning}},
                   column.owner});
  const std::uint64_t mine = rows.columns.empty() ? 0 : rows.columns.front().values.rows;
  out.push_back(vertices_of(rows, mine, compression));
  return out;
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
  const std::uint64_t rows = columns.empty() ? 0 : columns.front().values.rows;
  write(time, step, {{columns.begin(), columns.end()}, 0, rows}, {});
}

void FrameWriter::write(double time, std::uint64_t step, const FrameRows& rows, const Ranks& ranks) {
  XdmfFrame frame{path_in_directory(kind_, count_), time, rows.total, {}, std::string(kind_.group)};
  for (const FrameColumn& column : rows.columns) {
    if (column.values.rows != rows.columns.front().values.rows)
      throw std::logic_error("columns of a frame differ in length");
    frame.fields.push_back({column.name, column.values.element, column.values.columns});
  }
  SharedFile out;
  out.begin = [&](Hdf5File& file) {
    file.set_attribute("/", "format", kind_.format);
    write_header(file, domain_, program_, time, step);
    file.create_group("/" + frame.group);
  };
  out.datasets = datasets_of(rows, compression_, kind_.group);
  write_shared(directory_ / frame.file, out, ranks);
  grids_ += xdmf_grid(frame);
  ++count_;
  write_fields_file();
}

void FrameWriter::write_share(const FrameRows& rows, Compression compression, const FrameKind& kind,
                              const Ranks& ranks) {
  SharedFile out;
  out.datasets = datasets_of(rows, compression, kind.group);
  write_shared({}, out, ranks);
}

FrameRows rows_in_order(std::vector<FrameColumn> columns, std::span<const RowKey> keys, const Ranks& ranks) {
  std::vector<ArrayView> views;
  for (const FrameColumn& column : columns) views.push_back(column.values);
  const Slab slab = slab_of(views, keys, ranks);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    columns[k].values = slab.columns[k];
    if (slab.owner) columns[k].owner = slab.owner;
  }
  return {std::move(columns), slab.first, slab.total};
}

void FrameWriter::write_fields_file() const { write_text_file(directory_ / kind_.document, xdmf_document(grids_)); }

}  // namespace scree
