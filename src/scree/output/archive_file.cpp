// An archive on disk: an HDF5 file behind a 512-byte block of plain text that names format, size and SHA-256.
//
// The block makes the check independent of the HDF5 library: nothing of a damaged file is handed to its parser, and a
// flipped bit in the library's own bookkeeping is found as surely as one in the data.
#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "scree/base/error.h"
#include "scree/base/hash.h"
#include "scree/output/archive.h"
#include "scree/output/shared_file.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t block_size = 512;
constexpr std::string_view signature = "scree checkpoint\n";
constexpr int format_version = 1;
constexpr const char* shared_mark = "shared";  // an attribute of arrays that ranks have shared

/// The text of the first block, filled up with blanks.
std::string header_block(std::uint64_t size, const std::string& digest) {
  std::string block = fmt::format("{}version {}\nsize {}\nsha256 {}\n", signature, format_version, size, digest);
  block.resize(block_size - 1, ' ');
  return block + '\n';
}

/// SHA-256 of everything behind the first block.
std::string digest_of(std::istream& file) {
  Sha256 hash;
  std::vector<char> piece(std::size_t{1} << 20);
  file.seekg(block_size);
  while (file) {
    file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    hash.update(piece.data(), static_cast<std::size_t>(file.gcount()));
  }
  return hash.hex();
}

/// Why a file cannot serve its purpose.
struct Refusal {
  fs::path path;
  std::string_view purpose;

  [[noreturn]] void operator()(const std::string& finding) const {
    throw InputError(fmt::format("cannot {} '{}': {}", purpose, path.string(), finding));
  }
};

/// What the root has alone.
void write_own(Hdf5File& file, const Archive& archive) {
  file.create_group("/values");
  file.create_group("/arrays");
  for (const auto& [name, value] : archive.values()) {
    const std::string place = "/values/" + name;
    if (const auto* text = std::get_if<std::string>(&value)) file.write_text(place, *text);
    if (const auto* number = std::get_if<double>(&value)) file.write(place, array_view(number, 1));
    if (const auto* integer = std::get_if<std::int64_t>(&value)) file.write(place, array_view(integer, 1));
  }
  for (const ArchivedArray& array : archive.arrays())
    if (!array.shared) file.write("/arrays/" + array.name, array.values);
}

/// Puts the first block before a file of which all else is there.
void seal(const fs::path& temporary) {
  std::fstream file(temporary, std::ios::in | std::ios::out | std::ios::binary);
  const std::string digest = digest_of(file);
  file.clear();
  file.seekp(0);
  file << header_block(fs::file_size(temporary), digest) << std::flush;
  if (!file) throw ResourceError(fmt::format("cannot write '{}': {}", temporary.string(), std::strerror(errno)));
}

ArchivedValue read_value(const Hdf5File& file, const std::string& place) {
  if (file.is_text(place)) return file.read_text(place);
  if (file.shape(place).element == Element::int64) {
    std::int64_t integer = 0;
    file.read(place, {Element::int64, 1, 1}, &integer);
    return integer;
  }
  double number = 0;
  file.read(place, {Element::float64, 1, 1}, &number);
  return number;
}

ArchivedArray read_array(const Hdf5File& file, const std::string& name, const Ranks& ranks) {
  const std::string place = "/arrays/" + name;
  const Shape shape = file.shape(place);
  const bool shared = file.contains_attribute(place, shared_mark);
  const auto [first, rows] = shared ? equal_part(shape.rows, ranks) : std::pair{std::uint64_t{0}, shape.rows};
  ArrayView values{shape.element, rows, shape.columns, nullptr};
  const std::shared_ptr<std::byte[]> memory(new std::byte[values.bytes()]);
  file.read_rows(place, shape, first, rows, memory.get());
  values.data = memory.get();
  return {name, values, memory, shared, first, shape.rows};
}

}  // namespace

void write_archive(const fs::path& path, const Archive& archive, const Ranks& ranks) {
  SharedFile file;
  file.user_block = block_size;
  file.begin = [&](Hdf5File& layout) { write_own(layout, archive); };
  for (const ArchivedArray& array : archive.arrays())
    if (array.shared)
      file.datasets.push_back({"/arrays/" + array.name,
                               array.values,
                               array.first,
                               array.total,
                               Storage::plain,
                               {{shared_mark, "row by row among the processes"}}});
  file.seal = seal;
  write_shared(path, file, ranks);
}

void verify_archive(const fs::path& path, std::string_view purpose) {
  const Refusal refuse{path, purpose};
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse(std::strerror(errno));
  if (fs::is_directory(path)) refuse("it is a directory; name one of its checkpoint files");
  std::string block(block_size, '\0');
  file.read(block.data(), block_size);
  if (!block.starts_with(signature)) refuse("it is not a checkpoint of Scree");
  int version = 0;
  unsigned long long size = 0;
  std::array<char, 65> digest{};
  const int fields = std::sscanf(block.c_str() + signature.size(), "version %d\nsize %llu\nsha256 %64[0-9a-f]\n",
                                 &version, &size, digest.data());
  if (fields < 1) refuse("it is damaged: its first lines cannot be read");
  if (version != format_version)
    refuse(
        fmt::format("it has checkpoint format {}, this program reads format {}; continue with the version of "
                    "Scree that wrote it",
                    version, format_version));
  if (fields < 3) refuse("it is damaged: its first lines cannot be read");
  const std::uintmax_t found = fs::file_size(path);
  if (found != size) refuse(fmt::format("it is incomplete: {} bytes instead of {}", found, size));
  if (digest_of(file) != digest.data() || block != header_block(size, digest.data()))
    refuse("it is damaged: its contents do not match their SHA-256; use an older checkpoint");
}

Archive read_archive(const fs::path& path, std::string_view purpose, const Ranks& ranks) {
  verify_archive(path, purpose);
  const Hdf5File file = Hdf5File::open(path);
  Archive archive;
  archive.origin = fmt::format("'{}'", path.string());
  for (const std::string& name : file.names("/values")) archive.set(name, read_value(file, "/values/" + name));
  for (const std::string& name : file.names("/arrays")) archive.add(read_array(file, name, ranks));
  return archive;
}

}  // namespace scree
