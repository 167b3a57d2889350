#include "scree/output/wall_surface.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "scree/base/atomic_file.h"
#include "scree/base/error.h"
#include "scree/output/hdf5_file.h"
#include "scree/output/numbered_file.h"
#include "scree/output/xdmf.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view grid_begin = "   <Grid Name=\"walls\"", grid_end = "   </Grid>\n";
constexpr std::string_view points_end = ":/points", triangles_end = ":/triangles";

template <class T>
std::vector<T> read_rows(const Hdf5File& file, const std::string& name) {
  const Shape shape = file.shape(name);
  std::vector<T> values(shape.rows * shape.columns);
  file.read(name, shape, values.data());
  return values;
}

WallSurface read_surface(const fs::path& points, const fs::path& triangles) {
  const Hdf5File places = Hdf5File::open(points), topology = Hdf5File::open(triangles);
  return {read_rows<double>(places, "/points"), read_rows<std::int32_t>(topology, "/triangles"),
          read_rows<std::int32_t>(topology, "/wall")};
}

void write_dataset(Hdf5File& file, const std::string& name, const ArrayView& values, Storage storage,
                   std::string_view unit, std::string_view meaning) {
  file.write(name, values, storage);
  file.set_attribute(name, "units", unit);
  file.set_attribute(name, "meaning", meaning);
}

/// Without `topology`, the name of another file that holds them, triangles and their walls are written as well.
void write_surface(const fs::path& path, double time, const WallSurface& surface, const std::string& topology) {
  write_atomically(path, [&](const fs::path& temporary) {
    Hdf5File file = Hdf5File::create(temporary);
    const std::size_t count = surface.wall.size();
    file.set_attribute("/", "format", "scree walls");
    file.set_attribute("/", "time", array_view(&time, 1));
    file.set_attribute("/", "time_units", "s");
    write_dataset(file, "/points", array_view(surface.points.data(), surface.points.size() / 3, 3), Storage::plain, "m",
                  "corners of the triangles");
    if (!topology.empty()) {
      file.set_attribute("/", "triangles_in", topology);
      return file.close();
    }
    write_dataset(file, "/triangles", array_view(surface.triangles.data(), count, 3), Storage::compressed, "1",
                  "three corners each, as rows of /points");
    write_dataset(file, "/wall", array_view(surface.wall.data(), count), Storage::compressed, "1",
                  "wall of each triangle, an index into the walls of the case");
    file.close();
  });
}

/// The time that the text of a grid names [s].
double time_of(std::string_view grid) {
  constexpr std::string_view label = "<Time Value=\"";
  const std::size_t at = grid.find(label);
  return at == std::string_view::npos ? 0 : std::stod(std::string(grid.substr(at + label.size())));
}

/// The file that the text of a grid names for a dataset.
std::string file_of(std::string_view grid, std::string_view dataset) {
  const std::size_t end = grid.find(dataset);
  if (end == std::string_view::npos) return {};
  const std::size_t begin = grid.rfind('>', end) + 1;
  return std::string(grid.substr(begin, end - begin));
}

}  // namespace

SurfaceWriter SurfaceWriter::create(const fs::path& directory) { return SurfaceWriter(directory); }

SurfaceWriter SurfaceWriter::resume(const fs::path& directory, double last_time) {
  SurfaceWriter writer(directory);
  const std::string text =
      fs::exists(directory / "walls.xdmf") ? read_text_file(directory / "walls.xdmf") : std::string();
  std::size_t end = 0;
  for (std::size_t begin = text.find(grid_begin); begin != std::string::npos; begin = text.find(grid_begin, end)) {
    end = text.find(grid_end, begin) + grid_end.size();
    const std::string grid = text.substr(begin, end - begin);
    if (time_of(grid) > last_time) break;
    writer.grids_ += grid;
    writer.file_ = file_of(grid, points_end);
    writer.topology_file_ = file_of(grid, triangles_end);
  }
  if (!writer.file_.empty()) writer.last_ = read_surface(directory / writer.file_, directory / writer.topology_file_);
  // First the list, then the files: at no moment does it name a file that is gone.
  if (!text.empty()) writer.write_list();
  for (const auto& [number, path] : list_numbered(wall_files, directory / "walls"))
    if (writer.file_.empty() || path.filename() > fs::path(writer.file_).filename()) fs::remove(path);
  return writer;
}

void SurfaceWriter::write(double time, std::uint64_t frame, const WallSurface& surface) {
  if (file_.empty() || surface != last_) {
    file_ = "walls/" + numbered_name(wall_files, frame);
    std::error_code error;
    fs::create_directories(directory_ / "walls", error);
    if (error)
      throw ResourceError(fmt::format("cannot create '{}': {}", (directory_ / "walls").string(), error.message()));
    const bool same = !topology_file_.empty() && surface.triangles == last_.triangles && surface.wall == last_.wall;
    if (!same) topology_file_ = file_;
    write_surface(directory_ / file_, time, surface, same ? fs::path(topology_file_).filename().string() : "");
    last_ = surface;
  }
  grids_ += xdmf_surface({file_, topology_file_, time, surface.points.size() / 3, surface.wall.size()});
  write_list();
}

void SurfaceWriter::write_list() const { write_text_file(directory_ / "walls.xdmf", xdmf_document(grids_)); }

}  // namespace scree
