#include "scree/output/shared_file.h"

#include <algorithm>
#include <optional>

#include "scree/base/atomic_file.h"
#include "scree/base/copy_bytes.h"
#include "scree/base/error.h"
#include "scree/mpi/together.h"
#include "scree/output/slab.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

Shape shape_of(const SharedDataset& d) { return {d.mine.element, d.total, d.mine.columns}; }

bool in_chunks(const SharedDataset& d) { return d.storage != Storage::plain && d.total * d.mine.columns > 0; }

/// A chunk on its way: its first row, its size, and what squeeze() made of it.
void append_chunk(Bytes& to, std::uint64_t row, const std::vector<std::byte>& squeezed) {
  const std::uint64_t head[2] = {row, squeezed.size()};
  const std::size_t at = to.size();
  to.resize(at + sizeof head + squeezed.size());
  copy_bytes(to.data() + at, head, sizeof head);
  copy_bytes(to.data() + at + sizeof head, squeezed.data(), squeezed.size());
}

/// This rank's chunks of a dataset.
Bytes squeeze_share(const SharedDataset& d, const Ranks& ranks) {
  const std::uint64_t rows = rows_in_chunk(shape_of(d));
  const Slab slab = cut_into_chunks(d.mine, d.first, d.total, rows, ranks);
  const ArrayView& mine = slab.columns.front();
  const std::size_t width = mine.columns * element_size(mine.element);
  Bytes out;
  for (std::uint64_t row = 0; row < mine.rows; row += rows) {
    const std::uint64_t count = std::min(rows, mine.rows - row);
    const auto* from = static_cast<const std::byte*>(mine.data) + width * row;
    // The file holds whole chunks only.
    std::vector<std::byte> chunk(from, from + width * count);
    chunk.resize(width * rows);
    append_chunk(out, slab.first + row, squeeze(chunk.data(), chunk.size(), mine.element, d.storage));
  }
  return out;
}

using Chunks = std::vector<std::pair<std::uint64_t, std::span<const std::byte>>>;

Chunks chunks_in(const std::vector<Bytes>& all) {
  Chunks out;
  for (const Bytes& of_rank : all)
    for (std::size_t at = 0; at < of_rank.size();) {
      std::uint64_t head[2];
      copy_bytes(head, of_rank.data() + at, sizeof head);
      out.emplace_back(head[0], std::span(of_rank).subspan(at + sizeof head, head[1]));
      at += sizeof head + head[1];
    }
  return out;
}

/// A file on its way. What goes wrong is kept until all ranks have come to the same place.
class Writing {
 public:
  Writing(const fs::path& path, const SharedFile& file, const Ranks& ranks) : path_(path), file_(file), ranks_(ranks) {}

  void write() {
    lay_out();
    if (ranks_.all(trouble_.empty())) attempt([&] { write_into(path_, pieces()); });
    agree();
  }

 private:
  template <class Do>
  void attempt(Do&& act) {
    if (!trouble_.empty()) return;
    try {
      act();
    } catch (const ResourceError& error) {
      trouble_ = error.what();
    }
  }

  template <class Do>
  void at_root(Do&& act) {
    if (ranks_.root()) attempt(act);
  }

  void lay_out() {
    std::optional<Hdf5File> layout;
    at_root([&] {
      layout.emplace(Hdf5File::create(path_, file_.user_block));
      file_.begin(*layout);
    });
    places_.assign(file_.datasets.size(), 0);
    for (std::size_t k = 0; k < file_.datasets.size(); ++k) {
      const SharedDataset& d = file_.datasets[k];
      if (in_chunks(d)) {
        const std::vector<Bytes> all = ranks_.gather(squeeze_share(d, ranks_));
        at_root([&] { layout->write_chunks(d.place, shape_of(d), d.storage, chunks_in(all)); });
      } else {
        at_root([&] { places_[k] = static_cast<std::int64_t>(layout->reserve(d.place, shape_of(d))); });
      }
      at_root([&] {
        for (const auto& [name, text] : d.attributes) layout->set_attribute(d.place, name, text);
      });
    }
    at_root([&] { layout->close(); });
    ranks_.add_up(places_);
  }

  std::vector<FilePiece> pieces() const {
    std::vector<FilePiece> out;
    for (std::size_t k = 0; k < file_.datasets.size(); ++k) {
      const SharedDataset& d = file_.datasets[k];
      if (in_chunks(d) || d.mine.bytes() == 0) continue;
      const std::uint64_t before = d.first * d.mine.columns * element_size(d.mine.element);
      out.push_back({static_cast<std::uint64_t>(places_[k]) + before,
                     {static_cast<const char*>(d.mine.data), static_cast<std::size_t>(d.mine.bytes())}});
    }
    return out;
  }

  /// The root throws what the first rank in trouble says.
  void agree() const {
    Bytes said(trouble_.size());
    copy_bytes(said.data(), trouble_.data(), trouble_.size());
    for (const Bytes& one : ranks_.gather(said))
      if (!one.empty()) throw ResourceError(std::string(reinterpret_cast<const char*>(one.data()), one.size()));
  }

  const fs::path& path_;
  const SharedFile& file_;
  const Ranks& ranks_;
  std::vector<std::int64_t> places_;  // of the datasets in the file
  std::string trouble_;
};

}  // namespace

void write_shared(const fs::path& path, const SharedFile& file, const Ranks& ranks) {
  const fs::path place = text_of_root(path.string(), ranks);
  if (!ranks.root()) return Writing(place.string() + std::string(temporary_ending), file, ranks).write();
  write_atomically(path, [&](const fs::path& temporary) {
    Writing(temporary, file, ranks).write();
    if (file.seal) file.seal(temporary);
  });
}

}  // namespace scree
