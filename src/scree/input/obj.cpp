#include "scree/input/obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "scree/base/error.h"
#include "scree/input/mesh_number.h"
#include "scree/physics/touch/triangle.h"

namespace scree {
namespace {

using Line = std::vector<std::string_view>;

/// Statements that say nothing about where the surface is.
constexpr std::string_view ignored[] = {"vt",     "vn",     "g",        "o",        "s",          "usemtl",
                                        "mtllib", "usemap", "maplib",   "mg",       "lod",        "l",
                                        "p",      "bevel",  "c_interp", "d_interp", "shadow_obj", "trace_obj"};

Line words_of(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\f\v";
  Line words;
  text = text.substr(0, text.find('#'));
  for (std::size_t at = text.find_first_not_of(blanks); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(blanks, at), text.size());
    words.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(blanks, end);
  }
  return words;
}

sc_vec vertex_of(const Line& words, const std::string& place) {
  if (words.size() < 4)
    throw InputError(fmt::format("{}: a vertex has three coordinates, found {}", place, words.size() - 1));
  double x[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const auto number = coordinate(words[k + 1]);
    if (!number)
      throw InputError(fmt::format("{}: expected a finite number, found '{}'", place, words[k + 1].substr(0, 40)));
    x[k] = *number;
  }
  return sc_make_vec(x[0], x[1], x[2]);
}

/// Index of a vertex from "i", "i/j", "i//k" or "i/j/k"; it counts from 1, or backwards from -1.
int corner_of(std::string_view word, int vertices, const std::string& place) {
  const std::string_view digits = word.substr(0, word.find('/'));
  long long index = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
  if (error != std::errc{} || end != digits.data() + digits.size())
    throw InputError(fmt::format("{}: expected the number of a vertex, found '{}'", place, word.substr(0, 40)));
  const long long found = index > 0 ? index - 1 : vertices + index;
  if (index == 0 || found < 0 || found >= vertices)
    throw InputError(fmt::format("{}: there is no vertex {}; {} come before this line", place, index, vertices));
  return static_cast<int>(found);
}

/// Adds a polygon as a fan of triangles.
void add_face(TriangleMesh& mesh, const std::vector<int>& corners, const std::string& place) {
  if (corners.size() < 3)
    throw InputError(fmt::format("{}: a face has at least three corners, found {}", place, corners.size()));
  const auto area = [&](std::size_t k) {
    return sc_triangle_area(mesh.vertices[corners[0]], mesh.vertices[corners[k]], mesh.vertices[corners[k + 1]]);
  };
  sc_vec whole = sc_zero_vec();
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) whole = sc_add(whole, area(k));
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    if (sc_dot(area(k), whole) < 0)
      throw InputError(fmt::format("{}: this polygon is not convex; divide it into triangles", place));
    mesh.triangles.push_back({corners[0], corners[k], corners[k + 1]});
  }
}

}  // namespace

TriangleMesh parse_obj(std::string_view text, const std::string& name) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  TriangleMesh mesh;
  int number = 0;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const Line words = words_of(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    const std::string place = fmt::format("{}:{}", name, ++number);
    if (words.empty()) continue;
    if (words[0] == "v") {
      mesh.vertices.push_back(vertex_of(words, place));
    } else if (words[0] == "f") {
      std::vector<int> corners;
      for (std::size_t k = 1; k < words.size(); ++k)
        corners.push_back(corner_of(words[k], static_cast<int>(mesh.vertices.size()), place));
      add_face(mesh, corners, place);
    } else if (std::ranges::find(ignored, words[0]) == std::end(ignored)) {
      throw InputError(
          fmt::format("{}: expected 'v', 'f' or another statement of an OBJ file of flat faces, found '{}'", place,
                      words[0].substr(0, 40)));
    }
  }
  return mesh;
}

}  // namespace scree
