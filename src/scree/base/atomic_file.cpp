// Temporary file, sync, rename, sync of the directory: the only order that survives a power failure on POSIX systems.
#include "scree/base/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "scree/base/error.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, int error) {
  throw ResourceError(fmt::format("cannot write '{}': {}; check the path, the permissions and the free space",
                                  path.string(), std::strerror(error)));
}

/// An open file descriptor that closes itself.
struct Descriptor {
  int number;
  explicit Descriptor(int n) : number(n) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
};

void sync_to_disk(const fs::path& path, int flags) {
  const Descriptor file(::open(path.c_str(), flags | O_CLOEXEC));
  if (file.number < 0) refuse(path, errno);
  // Some file systems cannot sync a directory and say so with EINVAL; there is nothing more to be done there.
  if (::fsync(file.number) != 0 && errno != EINVAL) refuse(path, errno);
}

}  // namespace

void write_atomically(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  fs::path temporary = path;
  temporary += temporary_ending;
  try {
    write(temporary);
    sync_to_disk(temporary, O_RDONLY);
    if (::rename(temporary.c_str(), path.c_str()) != 0) refuse(path, errno);
  } catch (...) {
    // Emptied first: a library may still hold the file open, and its space may be what the next write needs.
    std::error_code ignored;
    fs::resize_file(temporary, 0, ignored);
    fs::remove(temporary, ignored);
    throw;
  }
  const fs::path directory = path.parent_path();
  sync_to_disk(directory.empty() ? fs::path(".") : directory, O_RDONLY | O_DIRECTORY);
}

void write_text_file(const fs::path& path, std::string_view text) {
  write_atomically(path, [&](const fs::path& temporary) {
    const Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    if (file.number < 0) refuse(path, errno);
    write_all(file.number, text, path);
  });
}

void write_into(const fs::path& path, std::span<const FilePiece> pieces) {
  const Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (file.number < 0) refuse(path, errno);
  for (const FilePiece& piece : pieces) {
    if (::lseek(file.number, static_cast<off_t>(piece.place), SEEK_SET) < 0) refuse(path, errno);
    write_all(file.number, piece.bytes, path);
  }
  if (::fsync(file.number) != 0 && errno != EINVAL) refuse(path, errno);
}

std::string read_text_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  // An empty file makes the stream insertion fail, so look at the file's own state.
  if (file && file.peek() != std::ifstream::traits_type::eof()) text << file.rdbuf();
  if (!file.is_open() || file.bad() || fs::is_directory(path))
    throw InputError(fmt::format("cannot read '{}': {}", path.string(), std::strerror(errno ? errno : EISDIR)));
  return std::move(text).str();
}

void write_all(int descriptor, std::string_view text, const fs::path& path) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) refuse(path, errno);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace scree
