#include "scree/input/fluid_region.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace scree {
namespace {

constexpr const char* axes = "xyz";
constexpr double most_cells = 4e9;

/// Builds the region from the keys, one part after the other; a part that fails ends it.
class Builder {
 public:
  Builder(const Case& c, const Complain& complain) : case_(c), keys_(c.fluid), complain_(complain) {}

  FluidRegion build() {
    region_.grid.periodic = case_.domain.periodic;
    for (int a = 0; a < 3; ++a) make_axis(a);
    if (sound_ && region_.grid.all().cells() <= 0) sound_ = false;
    if (!sound_) return region_;
    place_boxes(keys_.blocks, "blocks", "block", region_.blocks);
    if (keys_.blocks.empty()) region_.blocks.push_back(region_.grid.all());
    place_boxes(keys_.obstacles, "obstacles", "obstacle", region_.obstacles);
    if (!sound_) return region_;
    expect_no_overlap();
    expect_no_gap();
    if (sound_ && !region_.obstacles.empty()) expect_one_piece();
    if (!sound_) return region_;
    for (std::size_t i = 0; i < keys_.patches.size(); ++i) place_patch(i);
    return region_;
  }

 private:
  void fail(const char* code, const std::string& path, const std::string& message, const std::string& note,
            const std::string& help) {
    sound_ = false;
    complain_(code, "fluid." + path, message, note, help);
  }

  void make_axis(int a) {
    const std::vector<FluidSegmentKeys>& segments = a == 0 ? keys_.x : a == 1 ? keys_.y : keys_.z;
    const double from = case_.domain.min[a], to = case_.domain.max[a];
    std::vector<GridSegment> list;
    if (segments.empty()) {
      if (keys_.cells.size() != 3) {
        // Told once.
        if (sound_ && keys_.cells.empty())
          fail("E163", "cells", fmt::format("the grid has no cells along {}", axes[a]), "no cells, no segments",
               fmt::format("give cells = [nx, ny, nz], or segments of the axis   (scree explain fluid.{})", axes[a]));
        else if (sound_)
          fail("E105", "cells", fmt::format("the grid needs three numbers of cells, not {}", keys_.cells.size()),
               "expected [nx, ny, nz]", "a flow in a plane has one cell across it");
        return;
      }
      if (keys_.cells[a] < 1 || static_cast<double>(keys_.cells[a]) > most_cells) {
        fail("E130", "cells", fmt::format("{} cells along {} cannot be", keys_.cells[a], axes[a]), "at least 1", "");
        return;
      }
      list.push_back({to, static_cast<std::int64_t>(keys_.cells[a]), 1});
    }
    double last = from;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const FluidSegmentKeys& s = segments[i];
      const std::string path = fmt::format("{}.{}.to", axes[a], i);
      if (!(s.to > last))
        return fail("E165", path, fmt::format("the segment of the grid along {} has no length", axes[a]),
                    fmt::format("it begins at {} m", last), "segments are listed in rising order");
      list.push_back({s.to, static_cast<std::int64_t>(s.cells), s.ratio});
      last = s.to;
    }
    if (!segments.empty() && std::abs(last - to) > 1e-9 * (to - from))
      return fail("E165", fmt::format("{}.{}.to", axes[a], segments.size() - 1),
                  fmt::format("the grid along {} ends at {} m, the domain at {} m", axes[a], last, to),
                  "not the end of the domain", "set it to domain.max, or domain.max to it");
    region_.grid.faces[a] = graded_faces(from, list);
    region_.grid.faces[a].back() = to;
  }

  /// The cells between two corners; nothing if they are no faces of the grid.
  std::optional<CellBox> cells_between(const std::string& path, const std::string& what, const FluidBoxKeys& box) {
    CellBox out;
    for (int a = 0; a < 3; ++a)
      for (const bool upper : {false, true}) {
        const double place = upper ? box.max[a] : box.min[a];
        const int face = region_.grid.face_at(a, place);
        (upper ? out.high : out.low)[a] = face;
        if (face >= 0) continue;
        fail("E165", path + (upper ? ".max" : ".min"),
             fmt::format("{} '{}' does not end on a face of the grid along {}", what, box.name, axes[a]),
             fmt::format("{} m; {}", place, near_faces(a, place)),
             "end a segment of the grid there   (scree explain fluid.x)");
        return {};
      }
    if (!out.empty()) return out;
    fail("E165", path + ".max", fmt::format("{} '{}' holds no cell", what, box.name), "max must be above min", "");
    return {};
  }

  std::string near_faces(int a, double place) const {
    const std::vector<double>& f = region_.grid.faces[a];
    const auto above = std::upper_bound(f.begin(), f.end(), place);
    if (above == f.begin()) return fmt::format("the first face is at {:.9g} m", f.front());
    if (above == f.end()) return fmt::format("the last face is at {:.9g} m", f.back());
    return fmt::format("there are faces at {:.9g} and {:.9g} m", *(above - 1), *above);
  }

  void place_boxes(const std::vector<FluidBoxKeys>& list, const char* table, const char* what,
                   std::vector<CellBox>& out) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      const auto box = cells_between(fmt::format("{}.{}", table, i), what, list[i]);
      if (box) out.push_back(*box);
    }
  }

  void expect_no_overlap() {
    for (std::size_t i = 0; i < region_.blocks.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (!common(region_.blocks[i], region_.blocks[j]).empty())
          return fail("E165", fmt::format("blocks.{}.min", i),
                      fmt::format("block '{}' overlaps block '{}'", keys_.blocks[i].name, keys_.blocks[j].name),
                      fmt::format("{} cells in both", common(region_.blocks[i], region_.blocks[j]).cells()),
                      "blocks lie side by side: end one where the other begins");
  }

  /// Whether two boxes share a face, over a periodic end too.
  bool touch(const CellBox& a, const CellBox& b) const {
    for (int axis = 0; axis < 3; ++axis)
      for (const int shift : {0, region_.grid.cells(axis), -region_.grid.cells(axis)}) {
        if (shift != 0 && !region_.grid.periodic[axis]) continue;
        CellBox moved = b;
        moved.low[axis] += shift;
        moved.high[axis] += shift;
        if (moved.low[axis] != a.high[axis] && moved.high[axis] != a.low[axis]) continue;
        moved.low[axis] = a.low[axis];
        moved.high[axis] = a.high[axis];
        if (!common(a, moved).empty()) return true;
      }
    return false;
  }

  void expect_no_gap() {
    const std::size_t n = region_.blocks.size();
    std::vector<bool> reached(n, false);
    reached[0] = true;
    for (std::size_t round = 0; round < n; ++round)
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n && !reached[i]; ++j)
          if (reached[j] && touch(region_.blocks[i], region_.blocks[j])) reached[i] = true;
    for (std::size_t i = 0; i < n; ++i)
      if (!reached[i])
        return fail("E165", fmt::format("blocks.{}.min", i),
                    fmt::format("block '{}' shares no face with the others", keys_.blocks[i].name),
                    "a gap lies between", "let its corner be that of its neighbour");
  }

  /// Whether the fluid has been cut into pieces by obstacles: pressures of pieces have nothing to do with each other.
  void expect_one_piece() {
    const std::array<std::int64_t, 3> n = {region_.grid.cells(0), region_.grid.cells(1), region_.grid.cells(2)};
    std::vector<char> open(static_cast<std::size_t>(n[0] * n[1] * n[2]));
    std::int64_t first = -1;
    for (std::int64_t c = 0; c < std::ssize(open); ++c) {
      open[c] = region_.is_fluid(static_cast<int>(c % n[0]), static_cast<int>(c / n[0] % n[1]),
                                 static_cast<int>(c / n[0] / n[1]));
      if (open[c] && first < 0) first = c;
    }
    if (first < 0)
      return fail("E165", "obstacles.0.min", "the obstacles leave no fluid", "every cell of the blocks is in one", "");
    std::vector<std::int64_t> front = {first};
    open[first] = false;
    while (!front.empty()) {
      const std::int64_t c = front.back();
      front.pop_back();
      const std::array<std::int64_t, 3> at = {c % n[0], c / n[0] % n[1], c / n[0] / n[1]};
      for (int a = 0; a < 3; ++a)
        for (const int way : {-1, 1}) {
          std::array<std::int64_t, 3> next = at;
          next[a] += way;
          if (region_.grid.periodic[a]) next[a] = (next[a] + n[a]) % n[a];
          if (next[a] < 0 || next[a] >= n[a]) continue;
          const std::int64_t neighbour = (next[2] * n[1] + next[1]) * n[0] + next[0];
          if (!open[neighbour]) continue;
          open[neighbour] = false;
          front.push_back(neighbour);
        }
    }
    const auto rest = std::ranges::find(open, char{true});
    if (rest != open.end()) tell_of_piece(rest - open.begin(), n);
  }

  void tell_of_piece(std::int64_t c, const std::array<std::int64_t, 3>& n) {
    const std::array<int, 3> at = {static_cast<int>(c % n[0]), static_cast<int>(c / n[0] % n[1]),
                                   static_cast<int>(c / n[0] / n[1])};
    std::string where = "of the domain";
    for (std::size_t b = 0; b < keys_.blocks.size(); ++b)
      if (!common(region_.blocks[b], CellBox{at, {at[0] + 1, at[1] + 1, at[2] + 1}}).empty())
        where = fmt::format("of block '{}'", keys_.blocks[b].name);
    const std::size_t last = keys_.obstacles.size() - 1;
    fail("E165", fmt::format("obstacles.{}.min", last),
         fmt::format("the obstacles up to '{}' cut the fluid in two", keys_.obstacles[last].name),
         fmt::format("no way leads to ({:.4g}, {:.4g}, {:.4g}) m {}", region_.grid.centre(0, at[0]),
                     region_.grid.centre(1, at[1]), region_.grid.centre(2, at[2]), where),
         "leave a way, or make a case of each part");
  }

  /// The cells of fluid beside a face of the domain, a block or an obstacle, before they are known to be fluid.
  std::optional<CellBox> cells_beside(std::size_t number, int axis, bool upper, bool& outward_upper) {
    const FluidPatchKeys& patch = keys_.patches[number];
    CellBox box = region_.grid.all();
    bool of_obstacle = false;
    if (!patch.of.empty()) {
      const auto named = [&](const FluidBoxKeys& k) { return k.name == patch.of; };
      const auto block = std::ranges::find_if(keys_.blocks, named);
      const auto obstacle = std::ranges::find_if(keys_.obstacles, named);
      if (block == keys_.blocks.end() && obstacle == keys_.obstacles.end()) {
        fail("E160", fmt::format("patches.{}.of", number),
             fmt::format("patch '{}': there is no block or obstacle '{}'", patch.name, patch.of), "not a name",
             "names are those of [[fluid.blocks]] and [[fluid.obstacles]]");
        return {};
      }
      of_obstacle = block == keys_.blocks.end();
      box = of_obstacle ? region_.obstacles[obstacle - keys_.obstacles.begin()]
                        : region_.blocks[block - keys_.blocks.begin()];
    }
    // The fluid is inside of blocks and outside of obstacles.
    outward_upper = of_obstacle ? !upper : upper;
    const int face = upper ? box.high[axis] : box.low[axis];
    box.low[axis] = outward_upper ? face - 1 : face;
    box.high[axis] = box.low[axis] + 1;
    for (int a = 0; a < 3; ++a) {
      if (a == axis) continue;
      while (box.low[a] < box.high[a] && region_.grid.centre(a, box.low[a]) < patch.min[a]) ++box.low[a];
      while (box.low[a] < box.high[a] && region_.grid.centre(a, box.high[a] - 1) > patch.max[a]) --box.high[a];
    }
    return box;
  }

  /// Whether the patch has a face of the boundary, and no other patch has it too.
  void expect_own_faces(std::size_t number, const PatchPlace& place) {
    const std::string path = fmt::format("patches.{}.face", number);
    bool found = false;
    for (int k = place.cells.low[2]; k < place.cells.high[2]; ++k)
      for (int j = place.cells.low[1]; j < place.cells.high[1]; ++j)
        for (int i = place.cells.low[0]; i < place.cells.high[0]; ++i) {
          std::array<int, 3> beyond{i, j, k};
          beyond[place.axis] += place.upper ? 1 : -1;
          if (!region_.is_fluid(i, j, k) || region_.is_fluid(beyond[0], beyond[1], beyond[2])) continue;
          found = true;
          const int other = region_.patch_of(i, j, k, place.axis, place.upper);
          if (other >= 0)
            return fail("E161", path,
                        fmt::format("patch '{}' overlaps patch '{}' on the face {}", place.name,
                                    region_.patches[other].name, keys_.patches[number].face),
                        fmt::format("cell ({}, {}, {}) has both", i, j, k), "give each its part by min and max");
        }
    if (!found)
      fail("E165", path, fmt::format("patch '{}' covers no face of the boundary", place.name),
           "no cell of fluid ends there", "look at its face, min and max, and at the blocks");
  }

  void place_patch(std::size_t number) {
    const FluidPatchKeys& k = keys_.patches[number];
    if (k.face.size() != 5) return;
    PatchPlace place;
    place.name = k.name;
    place.axis = k.face[0] - 'x';
    const bool upper = k.face.ends_with("max");
    place.kind = k.type == "inlet"       ? PatchKind::inlet
                 : k.type == "outlet"    ? PatchKind::outlet
                 : k.type == "permeable" ? PatchKind::permeable
                 : k.type == "wall"      ? PatchKind::wall
                                         : PatchKind::slip;
    const std::string path = fmt::format("patches.{}.face", number);
    for (const PatchPlace& other : region_.patches)
      if (other.name == k.name)
        return fail("E161", path, fmt::format("there are two patches '{}'", k.name), "names tell them apart", "");
    if (k.of.empty() && region_.grid.periodic[place.axis])
      return fail("E167", path, fmt::format("patch '{}' lies on a periodic axis", k.name),
                  fmt::format("the domain is periodic along {}", axes[place.axis]),
                  "take the patch away, or set domain.periodic to false along it");
    const auto cells = cells_beside(number, place.axis, upper, place.upper);
    if (!cells) return;
    place.cells = *cells;
    expect_own_faces(number, place);
    if (sound_) region_.patches.push_back(place);
  }

  const Case& case_;
  const FluidKeys& keys_;
  const Complain& complain_;
  FluidRegion region_;
  bool sound_ = true;
};

}  // namespace

FluidRegion make_fluid_region(const Case& c, const Complain& complain) { return Builder(c, complain).build(); }

}  // namespace scree
