// The C interface of HDF5 behind Hdf5File. Every call's result goes through check(), every handle closes itself.
#include "scree/output/hdf5_file.h"

#include <fmt/format.h>
#include <hdf5.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "scree/base/error.h"

namespace scree {
namespace {

static_assert(sizeof(hid_t) == sizeof(std::int64_t));

using Closer = herr_t (*)(hid_t);

/// An HDF5 object that closes itself.
class Handle {
 public:
  Handle(hid_t id, Closer closer) : id_(id), closer_(closer) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (id_ >= 0) closer_(id_);
  }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  Closer closer_;
};

constexpr hsize_t chunk_bytes = hsize_t{512} << 10;
constexpr unsigned quick_level = 1, hard_level = 9;  // of deflate

constexpr std::array elements = {Element::float64, Element::float32, Element::int32, Element::int64,
                                 Element::uint8,   Element::uint32,  Element::uint64};

/// The type in the file: little-endian on every machine.
hid_t file_type(Element element) {
  switch (element) {
    case Element::float64:
      return H5T_IEEE_F64LE;
    case Element::float32:
      return H5T_IEEE_F32LE;
    case Element::int32:
      return H5T_STD_I32LE;
    case Element::int64:
      return H5T_STD_I64LE;
    case Element::uint8:
      return H5T_STD_U8LE;
    case Element::uint32:
      return H5T_STD_U32LE;
    case Element::uint64:
      return H5T_STD_U64LE;
  }
  return H5I_INVALID_HID;
}

hid_t memory_type(Element element) {
  switch (element) {
    case Element::float64:
      return H5T_NATIVE_DOUBLE;
    case Element::float32:
      return H5T_NATIVE_FLOAT;
    case Element::int32:
      return H5T_NATIVE_INT32;
    case Element::int64:
      return H5T_NATIVE_INT64;
    case Element::uint8:
      return H5T_NATIVE_UINT8;
    case Element::uint32:
      return H5T_NATIVE_UINT32;
    case Element::uint64:
      return H5T_NATIVE_UINT64;
  }
  return H5I_INVALID_HID;
}

/// Two habits of the library that a program with its own error handling must switch off before the first use: it prints
/// every error, and at the program's exit it closes files again whose closing failed (full disk), which crashes
/// (1.10.8).
void prepare_library() {
  static const bool prepared = [] {
    H5dont_atexit();
    return H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr) >= 0;
  }();
  static_cast<void>(prepared);
}

/// The innermost reason of the library's last failure; where the system refused, the system's own words.
std::string reason() {
  std::string text;
  const auto visit = [](unsigned, const H5E_error2_t* error, void* into) -> herr_t {
    auto& found = *static_cast<std::string*>(into);
    if (found.empty() && error->desc) found = error->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, visit, &text);
  constexpr std::string_view mark = "error message = '";
  if (const auto start = text.find(mark); start != std::string::npos) {
    const auto from = start + mark.size();
    text = text.substr(from, text.find('\'', from) - from);
  }
  return text.empty() ? "the HDF5 library gives no reason" : text;
}

hid_t text_type(std::string_view text) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  // Padded with zeros; a size of zero is not allowed, so an empty text is one zero.
  H5Tset_size(type, std::max<std::size_t>(text.size(), 1));
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

int dimensions(const Shape& shape) { return shape.columns == 1 ? 1 : 2; }

Handle how_to_create() {
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_obj_track_times(creation, false);          // the same data give the same bytes at any time of day
  H5Pset_fill_time(creation, H5D_FILL_TIME_NEVER);  // every element will be written
  return {creation, H5Pclose};
}

unsigned level_of(Storage storage) { return storage == Storage::compressed ? quick_level : hard_level; }

void store_in_chunks(hid_t creation, const Shape& shape, Storage storage) {
  const std::array<hsize_t, 2> chunk = {rows_in_chunk(shape), shape.columns};
  H5Pset_chunk(creation, dimensions(shape), chunk.data());
  H5Pset_shuffle(creation);
  H5Pset_deflate(creation, level_of(storage));
}

}  // namespace

std::uint64_t rows_in_chunk(const Shape& shape) {
  return std::clamp<std::uint64_t>(chunk_bytes / (shape.columns * element_size(shape.element)), 1, shape.rows);
}

std::vector<std::byte> squeeze(const void* data, std::size_t size, Element element, Storage storage) {
  const auto* from = static_cast<const std::byte*>(data);
  const std::size_t width = element_size(element), count = size / width;
  std::vector<std::byte> shuffled(size);
  for (std::size_t b = 0; b < width; ++b)
    for (std::size_t i = 0; i < count; ++i) shuffled[b * count + i] = from[i * width + b];
  uLongf room = compressBound(size);
  std::vector<std::byte> out(room);
  if (compress2(reinterpret_cast<Bytef*>(out.data()), &room, reinterpret_cast<const Bytef*>(shuffled.data()), size,
                static_cast<int>(level_of(storage))) != Z_OK)
    throw ResourceError("out of memory while a chunk of a file is squeezed");
  out.resize(room);
  return out;
}

Hdf5File::Hdf5File(std::filesystem::path path, std::int64_t handle, bool writing)
    : path_(std::move(path)), handle_(handle), writing_(writing) {}

Hdf5File::Hdf5File(Hdf5File&& other) noexcept
    : path_(std::move(other.path_)), handle_(std::exchange(other.handle_, -1)), writing_(other.writing_) {}

Hdf5File::~Hdf5File() {
  if (handle_ >= 0) H5Fclose(handle_);
}

void Hdf5File::fail(const std::string& name) const {
  const std::string where = name.empty() ? "" : fmt::format(" ('{}')", name);
  if (writing_)
    throw ResourceError(fmt::format("cannot write '{}'{}: {}; check the path, the permissions and the free space",
                                    path_.string(), where, reason()));
  throw InputError(fmt::format("cannot read '{}'{}: {}", path_.string(), where, reason()));
}

std::int64_t Hdf5File::check(std::int64_t result, const std::string& name) const {
  if (result < 0) fail(name);
  return result;
}

Hdf5File Hdf5File::create(const std::filesystem::path& path, std::uint64_t user_block) {
  prepare_library();
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_link_creation_order(creation, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  if (user_block > 0) H5Pset_userblock(creation, user_block);
  Hdf5File file(path, H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, H5P_DEFAULT), true);
  file.check(file.handle_, "");
  return file;
}

Hdf5File Hdf5File::open(const std::filesystem::path& path) {
  prepare_library();
  Hdf5File file(path, H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), false);
  file.check(file.handle_, "");
  return file;
}

void Hdf5File::close() { check(H5Fclose(std::exchange(handle_, -1)), ""); }

void Hdf5File::create_group(const std::string& name) {
  const Handle creation(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
  H5Pset_link_creation_order(creation, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  const Handle group(H5Gcreate2(handle_, name.c_str(), H5P_DEFAULT, creation, H5P_DEFAULT), H5Gclose);
  check(group, name);
}

std::int64_t Hdf5File::create_dataset(const std::string& name, const Shape& shape, std::int64_t creation) {
  const std::array<hsize_t, 2> extent = {shape.rows, shape.columns};
  const Handle space(H5Screate_simple(dimensions(shape), extent.data(), nullptr), H5Sclose);
  return check(H5Dcreate2(handle_, name.c_str(), file_type(shape.element), space, H5P_DEFAULT, creation, H5P_DEFAULT),
               name);
}

void Hdf5File::write(const std::string& name, const ArrayView& array, Storage storage) {
  const Handle creation = how_to_create();
  if (storage != Storage::plain && array.bytes() > 0)
    store_in_chunks(creation, {array.element, array.rows, array.columns}, storage);
  const Handle dataset(create_dataset(name, {array.element, array.rows, array.columns}, creation), H5Dclose);
  if (array.bytes() > 0)
    check(H5Dwrite(dataset, memory_type(array.element), H5S_ALL, H5S_ALL, H5P_DEFAULT, array.data), name);
}

std::uint64_t Hdf5File::reserve(const std::string& name, const Shape& shape) {
  static_assert(std::endian::native == std::endian::little, "values are written as they lie in memory");
  const Handle creation = how_to_create();
  H5Pset_alloc_time(creation, H5D_ALLOC_TIME_EARLY);
  const Handle dataset(create_dataset(name, shape, creation), H5Dclose);
  if (shape.rows * shape.columns == 0) return 0;
  const haddr_t place = H5Dget_offset(dataset);
  if (place == HADDR_UNDEF) fail(name);
  return place;
}

void Hdf5File::write_chunks(const std::string& name, const Shape& shape, Storage storage,
                            std::span<const std::pair<std::uint64_t, std::span<const std::byte>>> chunks) {
  const Handle creation = how_to_create();
  if (!chunks.empty()) store_in_chunks(creation, shape, storage);
  const Handle dataset(create_dataset(name, shape, creation), H5Dclose);
  for (const auto& [row, bytes] : chunks) {
    const std::array<hsize_t, 2> at = {row, 0};
    check(H5Dwrite_chunk(dataset, H5P_DEFAULT, 0, at.data(), bytes.size(), bytes.data()), name);
  }
}

void Hdf5File::write_text(const std::string& name, std::string_view text) {
  const Handle type(text_type(text), H5Tclose);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation, false);
  const Handle dataset(H5Dcreate2(handle_, name.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT), H5Dclose);
  check(dataset, name);
  check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.empty() ? "" : text.data()), name);
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, std::string_view text) {
  // Of variable length, since h5py hands those out as str and others as bytes.
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(
      H5Acreate_by_name(handle_, object.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  check(attribute, name);
  const std::string terminated(text);
  const char* pointer = terminated.c_str();
  check(H5Awrite(attribute, type, &pointer), name);
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, const ArrayView& row) {
  const hsize_t count = row.rows * row.columns;
  const Handle space(count == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &count, nullptr), H5Sclose);
  const Handle attribute(H5Acreate_by_name(handle_, object.c_str(), name.c_str(), file_type(row.element), space,
                                           H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  check(attribute, name);
  check(H5Awrite(attribute, memory_type(row.element), row.data), name);
}

bool Hdf5File::contains(const std::string& name) const { return H5Lexists(handle_, name.c_str(), H5P_DEFAULT) > 0; }

bool Hdf5File::contains_attribute(const std::string& object, const std::string& name) const {
  return H5Aexists_by_name(handle_, object.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Hdf5File::names(const std::string& group) const {
  std::vector<std::string> found;
  const auto visit = [](hid_t, const char* name, const H5L_info_t*, void* into) -> herr_t {
    static_cast<std::vector<std::string>*>(into)->emplace_back(name);
    return 0;
  };
  hsize_t position = 0;
  check(H5Literate_by_name(handle_, group.c_str(), H5_INDEX_CRT_ORDER, H5_ITER_INC, &position, visit, &found,
                           H5P_DEFAULT),
        group);
  return found;
}

bool Hdf5File::is_text(const std::string& name) const {
  const Handle dataset(H5Dopen2(handle_, name.c_str(), H5P_DEFAULT), H5Dclose);
  check(dataset, name);
  const Handle type(H5Dget_type(dataset), H5Tclose);
  return H5Tget_class(type) == H5T_STRING;
}

Shape Hdf5File::shape(const std::string& name) const {
  const Handle dataset(H5Dopen2(handle_, name.c_str(), H5P_DEFAULT), H5Dclose);
  check(dataset, name);
  const Handle space(H5Dget_space(dataset), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space);
  std::array<hsize_t, 2> extent = {1, 1};
  const Handle type(H5Dget_type(dataset), H5Tclose);
  const auto match = std::find_if(elements.begin(), elements.end(),
                                  [&](Element element) { return H5Tequal(type, file_type(element)) > 0; });
  if (rank > 2 || rank < 0 || match == elements.end())
    throw InputError(fmt::format("'{}' ('{}') holds data of a kind that Scree does not write", path_.string(), name));
  check(H5Sget_simple_extent_dims(space, extent.data(), nullptr), name);
  return {*match, extent[0], extent[1]};
}

void Hdf5File::read(const std::string& name, const Shape& shape, void* destination) const {
  const Handle dataset(H5Dopen2(handle_, name.c_str(), H5P_DEFAULT), H5Dclose);
  check(dataset, name);
  if (shape.rows * shape.columns == 0) return;
  check(H5Dread(dataset, memory_type(shape.element), H5S_ALL, H5S_ALL, H5P_DEFAULT, destination), name);
}

void Hdf5File::read_rows(const std::string& name, const Shape& shape, std::uint64_t first, std::uint64_t rows,
                         void* destination) const {
  const Handle dataset(H5Dopen2(handle_, name.c_str(), H5P_DEFAULT), H5Dclose);
  check(dataset, name);
  if (rows * shape.columns == 0) return;
  const std::array<hsize_t, 2> start = {first, 0}, count = {rows, shape.columns};
  const Handle wanted(H5Dget_space(dataset), H5Sclose);
  const Handle memory(H5Screate_simple(dimensions(shape), count.data(), nullptr), H5Sclose);
  check(H5Sselect_hyperslab(wanted, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr), name);
  check(H5Dread(dataset, memory_type(shape.element), memory, wanted, H5P_DEFAULT, destination), name);
}

std::string Hdf5File::read_text(const std::string& name) const {
  const Handle dataset(H5Dopen2(handle_, name.c_str(), H5P_DEFAULT), H5Dclose);
  check(dataset, name);
  const Handle type(H5Dget_type(dataset), H5Tclose);
  std::string text(H5Tget_size(type), '\0');
  check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), name);
  text.erase(text.find_last_not_of('\0') + 1);
  return text;
}

std::string Hdf5File::text_attribute(const std::string& object, const std::string& name) const {
  const Handle attribute(H5Aopen_by_name(handle_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  check(attribute, name);
  const Handle type(H5Aget_type(attribute), H5Tclose);
  if (H5Tis_variable_str(type) <= 0)
    throw InputError(fmt::format("'{}': attribute '{}' is no text of Scree", path_.string(), name));
  char* pointer = nullptr;
  check(H5Aread(attribute, type, &pointer), name);
  const std::string text(pointer ? pointer : "");
  H5free_memory(pointer);
  return text;
}

void Hdf5File::read_attribute(const std::string& object, const std::string& name, Element element, std::uint64_t count,
                              void* destination) const {
  const Handle attribute(H5Aopen_by_name(handle_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  check(attribute, name);
  const Handle space(H5Aget_space(attribute), H5Sclose);
  const hssize_t found = H5Sget_simple_extent_npoints(space);
  if (found < 0 || static_cast<std::uint64_t>(found) != count)
    throw InputError(
        fmt::format("'{}': attribute '{}' has {} elements, expected {}", path_.string(), name, found, count));
  check(H5Aread(attribute, memory_type(element), destination), name);
}

}  // namespace scree
