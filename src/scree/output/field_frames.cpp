#include "scree/output/field_frames.h"

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

constexpr std::string_view field_format = "scree fluid";
constexpr std::int64_t format_version = 1;
constexpr const char* folder = "fluid";

/// The XDMF view of a frame on disk.
XdmfRectilinear describe(const fs::path& path) {
  const Hdf5File file = Hdf5File::open(path);
  if (file.text_attribute("/", "format") != field_format)
    throw InputError(
        fmt::format("'{}' is no frame of a fluid of Scree; remove it or restart into a new directory "
                    "(-o DIR)",
                    path.string()));
  XdmfRectilinear out;
  out.file = fmt::format("{}/{}", folder, path.filename().string());
  file.read_attribute("/", "time", Element::float64, 1, &out.time);
  for (int a = 0; a < 3; ++a)
    out.cells[a] = static_cast<std::int64_t>(file.shape(fmt::format("/faces/{}", "xyz"[a])).rows) - 1;
  for (const std::string& name : file.names("/fields")) {
    const Shape shape = file.shape("/fields/" + name);
    out.fields.push_back({name, shape.element, shape.columns});
  }
  return out;
}

}  // namespace

FieldFrameWriter::FieldFrameWriter(const fs::path& directory, std::array<std::vector<double>, 3> faces,
                                   std::string program, double last_time)
    : directory_(directory), faces_(std::move(faces)), program_(std::move(program)) {
  std::error_code error;
  fs::create_directories(directory_ / folder, error);
  if (error)
    throw ResourceError(fmt::format("cannot create '{}': {}", (directory_ / folder).string(), error.message()));
  std::vector<fs::path> late;
  for (const auto& [number, path] : list_numbered(fluid_files, directory_ / folder)) {
    const XdmfRectilinear frame = describe(path);
    if (frame.time > last_time) {
      late.push_back(path);
      continue;
    }
    grids_ += xdmf_grid(frame);
    count_ = number + 1;
  }
  // First the film, then the files: at no moment does it name one that is gone.
  write_film();
  for (const fs::path& path : late) fs::remove(path);
}

void FieldFrameWriter::write(double time, std::uint64_t step, std::span<const FrameColumn> columns) {
  const fs::path path = directory_ / folder / numbered_name(fluid_files, count_);
  std::uint64_t cells = 1;
  for (const std::vector<double>& f : faces_) cells *= f.size() - 1;
  write_atomically(path, [&](const fs::path& temporary) {
    Hdf5File file = Hdf5File::create(temporary);
    file.set_attribute("/", "format", field_format);
    file.set_attribute("/", "format_version", array_view(&format_version, 1));
    file.set_attribute("/", "program", program_);
    file.set_attribute("/", "time", array_view(&time, 1));
    file.set_attribute("/", "time_units", "s");
    file.set_attribute("/", "step", array_view(&step, 1));
    file.create_group("/faces");
    for (int a = 0; a < 3; ++a) {
      const std::string place = fmt::format("/faces/{}", "xyz"[a]);
      file.write(place, array_view(faces_[a].data(), faces_[a].size()));
      file.set_attribute(place, "units", "m");
    }
    file.create_group("/fields");
    for (const FrameColumn& column : columns) {
      if (column.values.rows != cells) throw std::logic_error("a field of the fluid has a row for every cell");
      const std::string place = "/fields/" + column.name;
      file.write(place, column.values);
      file.set_attribute(place, "units", column.unit);
      file.set_attribute(place, "meaning", column.meaning);
    }
    file.close();
  });
  grids_ += xdmf_grid(describe(path));
  ++count_;
  write_film();
}

void FieldFrameWriter::write_film() const { write_text_file(directory_ / "fluid.xdmf", xdmf_document(grids_)); }

}  // namespace scree
