#include "scree/input/stl.h"

#include <fmt/format.h>

#include <cctype>
#include <cstdint>
#include <cstring>

#include "scree/base/error.h"
#include "scree/input/mesh_number.h"

namespace scree {
namespace {

constexpr std::size_t header_bytes = 84;  // 80 of text, then the count
constexpr std::size_t triangle_bytes = 50;
constexpr std::string_view blanks = " \t\r\n\f\v";

void add_triangle(TriangleMesh& mesh, const sc_vec (&corners)[3]) {
  const int first = static_cast<int>(mesh.vertices.size());
  for (const sc_vec& corner : corners) mesh.vertices.push_back(corner);
  mesh.triangles.push_back({first, first + 1, first + 2});
}

std::uint32_t count_in_header(std::string_view bytes) {
  unsigned char digits[4];
  std::memcpy(digits, bytes.data() + header_bytes - 4, 4);
  return digits[0] | digits[1] << 8 | digits[2] << 16 | static_cast<std::uint32_t>(digits[3]) << 24;
}

float number_at(std::string_view bytes, std::size_t at) {
  float x;
  std::memcpy(&x, bytes.data() + at, sizeof x);
  return x;
}

TriangleMesh parse_binary(std::string_view bytes, const std::string& name) {
  const std::size_t count = count_in_header(bytes);
  const std::size_t needed = header_bytes + triangle_bytes * count;
  if (bytes.size() != needed)
    throw InputError(fmt::format("{}: byte {}: a binary STL file of {} triangles has {} bytes, this one has {}: {}",
                                 name, std::min(bytes.size(), needed), count, needed, bytes.size(),
                                 bytes.size() < needed ? "it is cut off" : "something else follows"));
  TriangleMesh mesh;
  mesh.vertices.reserve(3 * count);
  mesh.triangles.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    sc_vec corners[3];
    const std::size_t start = header_bytes + triangle_bytes * i + 12;  // behind the normal
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t at = start + 12 * k;
      corners[k] = sc_make_vec(number_at(bytes, at), number_at(bytes, at + 4), number_at(bytes, at + 8));
      if (!usable_coordinate(corners[k].x) || !usable_coordinate(corners[k].y) || !usable_coordinate(corners[k].z))
        throw InputError(fmt::format("{}: byte {}: triangle {} has a corner ({}, {}, {}), expected finite numbers",
                                     name, at, i + 1, corners[k].x, corners[k].y, corners[k].z));
    }
    add_triangle(mesh, corners);
  }
  return mesh;
}

/// Words of a text, and the line that the last one is in.
class Words {
 public:
  Words(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  /// The next word, empty at the end.
  std::string_view next() {
    while (at_ < text_.size() && blanks.find(text_[at_]) != std::string_view::npos) line_ += text_[at_++] == '\n';
    const std::size_t start = at_;
    while (at_ < text_.size() && blanks.find(text_[at_]) == std::string_view::npos) ++at_;
    return text_.substr(start, at_ - start);
  }

  void skip_line() { at_ = std::min(text_.find('\n', at_), text_.size()); }

  [[noreturn]] void fail(std::string_view expected, std::string_view found) const {
    throw InputError(
        found.empty() ? fmt::format("{}:{}: the file ends where {} was expected: it is cut off", name_, line_, expected)
                      : fmt::format("{}:{}: expected {}, found '{}'", name_, line_, expected, found.substr(0, 40)));
  }

  void expect(std::string_view keyword) {
    const std::string_view word = next();
    if (!is(word, keyword)) fail(fmt::format("'{}'", keyword), word);
  }

  double number() {
    const std::string_view word = next();
    const auto x = coordinate(word);
    if (!x) fail("a finite number", word);
    return *x;
  }

  /// Keywords are small or capital letters.
  static bool is(std::string_view word, std::string_view keyword) {
    return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
                      [](unsigned char a, unsigned char b) { return std::tolower(a) == b; });
  }

 private:
  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
  int line_ = 1;
};

/// Behind the word 'facet', to the end of 'endfacet'.
void parse_facet(Words& words, TriangleMesh& mesh) {
  words.expect("normal");
  // Some writers print nan for the normal of a triangle without area; nobody reads it.
  for (int k = 0; k < 3; ++k)
    if (words.next().empty()) words.fail("the normal", "");
  words.expect("outer");
  words.expect("loop");
  sc_vec corners[3];
  for (sc_vec& corner : corners) {
    words.expect("vertex");
    corner.x = words.number();
    corner.y = words.number();
    corner.z = words.number();
  }
  words.expect("endloop");
  words.expect("endfacet");
  add_triangle(mesh, corners);
}

TriangleMesh parse_text(std::string_view text, const std::string& name) {
  TriangleMesh mesh;
  Words words(text, name);
  words.expect("solid");
  for (bool another = true; another;) {
    words.skip_line();
    std::string_view word;
    while (Words::is(word = words.next(), "facet")) parse_facet(words, mesh);
    if (!Words::is(word, "endsolid")) words.fail("'facet' or 'endsolid'", word);
    words.skip_line();
    word = words.next();
    another = Words::is(word, "solid");
    if (!another && !word.empty()) words.fail("'solid' or the end of the file", word);
  }
  return mesh;
}

}  // namespace

TriangleMesh parse_stl(std::string_view bytes, const std::string& name) {
  const bool long_enough = bytes.size() >= header_bytes;
  if (long_enough && bytes.size() == header_bytes + triangle_bytes * count_in_header(bytes))
    return parse_binary(bytes, name);
  const std::size_t start = std::min(bytes.find_first_not_of(blanks), bytes.size());
  const bool begins_solid = Words::is(bytes.substr(start, 5), "solid");
  // A header may say 'solid' too, but text has no zero bytes.
  const bool is_text = begins_solid && bytes.find('\0') == std::string_view::npos;
  if (is_text) return parse_text(bytes, name);
  if (!long_enough)
    throw InputError(
        fmt::format("{}: byte {}: the file ends here: neither an STL text, which begins with 'solid', nor a "
                    "binary STL file, which has a header of {} bytes",
                    name, bytes.size(), header_bytes));
  return parse_binary(bytes, name);
}

}  // namespace scree
