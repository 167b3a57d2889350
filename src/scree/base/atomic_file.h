// Files that appear whole or not at all: written under a temporary name, synced to the disk, then renamed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace scree {

/// Ending of the temporary names; a file with it is left over from a killed run and may be deleted.
inline constexpr std::string_view temporary_ending = ".part";

/// Calls write(temporary path), syncs that file, renames it to `path` and syncs the directory. A reader sees the old
/// file or the new one, also after a kill or a power failure. If anything throws, the temporary file is removed and
/// `path` is as it was. Throws ResourceError when the system refuses.
void write_atomically(const std::filesystem::path& path,
                      const std::function<void(const std::filesystem::path&)>& write);

/// Writes a whole text file atomically. Throws ResourceError.
void write_text_file(const std::filesystem::path& path, std::string_view text);

/// Bytes that belong at a place of a file.
struct FilePiece {
  std::uint64_t place = 0;
  std::string_view bytes;
};

/// Writes pieces into a file that is there, and syncs it. Several processes may do so at once where their pieces do not
/// overlap. Throws ResourceError.
void write_into(const std::filesystem::path& path, std::span<const FilePiece> pieces);

/// The contents of a file, byte for byte. Throws InputError when it cannot be read.
std::string read_text_file(const std::filesystem::path& path);

/// Appends the whole of `text` to an open file descriptor; `path` is for the message. Throws ResourceError.
void write_all(int descriptor, std::string_view text, const std::filesystem::path& path);

}  // namespace scree
