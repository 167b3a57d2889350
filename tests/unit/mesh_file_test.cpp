// Surfaces from files: both kinds of STL, OBJ, welding, the report, and everything that is not such a file.
#include "scree/input/mesh_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "scree/base/error.h"
#include "scree/input/mesh_report.h"
#include "scree/input/mesh_weld.h"
#include "scree/input/obj.h"
#include "scree/input/stl.h"
#include "support/mesh_shapes.h"
#include "support/temporary_directory.h"

namespace scree {
namespace {

using test::Triangles;

const sc_vec low = sc_make_vec(-1, 0, 2), high = sc_make_vec(1, 3, 3.5);

Triangles box() { return test::box_triangles(low, high); }

TriangleMesh stl_mesh(const Triangles& triangles) { return weld(parse_stl(test::stl_text(triangles), "a.stl")); }

template <class Read>
std::string message_of(Read&& read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string obj_message(std::string_view text) {
  return message_of([&] { parse_obj(text, "a.obj"); });
}

std::string stl_message(std::string_view text) {
  return message_of([&] { parse_stl(text, "a.stl"); });
}

void expect_box(const TriangleMesh& mesh) {
  const MeshReport report = report_mesh(mesh);
  EXPECT_EQ(report.triangles, 12);
  EXPECT_EQ(report.vertices, 8);
  EXPECT_EQ(report.pieces, 1);
  EXPECT_TRUE(report.closed());
  EXPECT_EQ(report.flipped_edges, 0);
  EXPECT_NEAR(report.area, 2 * (2 * 3 + 3 * 1.5 + 1.5 * 2), 1e-14);
  EXPECT_NEAR(report.volume, 9, 1e-14);
  EXPECT_EQ(sc_norm(sc_sub(report.low, low)), 0);
  EXPECT_EQ(sc_norm(sc_sub(report.high, high)), 0);
}

constexpr std::string_view box_obj =
    "\xEF\xBB\xBF# a box\r\nmtllib box.mtl\r\no box\nv -1 0 2\nv 1 0 2 1.0\nv 1 3 2\nv -1 3 2 0.1 0.2 0.3\n"
    "v -1 0 3.5\nv +1 0 3.5\nv 1 3e0 3.5\nv -1 3 3.5 # the last\nvt 0 0\nvn 0 0 1\ns off\n"
    "f 4 3 2 1\nf 5/1 6/1 7/1 8/1\nf 1//1 2//1 6//1 5//1\nf 2/1/1 3/1/1 7/1/1 6/1/1\nf -6 -5 -1 -2\nf 4 1 5\nf 4 5 8";

TEST(MeshFile, EveryKindOfFileGivesTheBox) {
  const test::TemporaryDirectory directory;
  const auto written = [&](const std::string& name, std::string_view content) {
    std::ofstream(directory / name, std::ios::binary) << content;
    return (directory / name).string();
  };
  expect_box(read_mesh(written("text.stl", test::stl_text(box()))));
  expect_box(read_mesh(written("binary.STL", test::stl_binary(box()))));
  expect_box(read_mesh(written("other.stl", test::stl_binary(box(), "made by something"))));
  expect_box(read_mesh(written("box.obj", box_obj)));
  EXPECT_NE(message_of([&] { read_mesh(written("box.ply", box_obj)); }).find("name ends in .stl or .obj"), -1ul);
  EXPECT_NE(message_of([&] { read_mesh(written("empty.obj", "v 0 0 0\n")); }).find("no triangle in this file"), -1ul);
  EXPECT_NE(message_of([&] {
              read_mesh(written("flat.obj", "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n"));
            }).find("none of the 1 triangles of this file has an area"),
            -1ul);
  EXPECT_NE(message_of([&] { read_mesh((directory / "none.stl").string()); }).find("cannot read '"), -1ul);
  std::filesystem::create_directory(directory / "folder.stl");
  EXPECT_NE(message_of([&] { read_mesh((directory / "folder.stl").string()); }).find("s a directory"), -1ul);
}

TEST(MeshFile, CapitalsSeveralSolidsAndBadNormalsAreRead) {
  const std::string one =
      "FACET NORMAL nan nan nan OUTER LOOP VERTEX 0 0 0 VERTEX 1 0 0 VERTEX 0 1 0 ENDLOOP ENDFACET\n";
  const TriangleMesh mesh = parse_stl("\nSOLID a facet b\n" + one + one + "ENDSOLID a\nsolid\nendsolid\n", "a.stl");
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.vertices.size(), 6u);
}

TEST(MeshFile, MessagesNameLineOrByte) {
  EXPECT_EQ(stl_message("solid\nfacet normal 0 0 1\nouter loop\nvertx 0 0 0"),
            "a.stl:4: expected 'vertex', found 'vertx'");
  EXPECT_EQ(stl_message("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 nan 0"),
            "a.stl:4: expected a finite number, found 'nan'");
  EXPECT_EQ(stl_message("solid\nfacet normal 0 0 1\n outer"),
            "a.stl:3: the file ends where 'loop' was expected: it is cut off");
  EXPECT_EQ(stl_message("solid\n\n"), "a.stl:3: the file ends where 'facet' or 'endsolid' was expected: it is cut off");
  EXPECT_EQ(stl_message("solid\nendsolid\nfacet"), "a.stl:3: expected 'solid' or the end of the file, found 'facet'");
  EXPECT_EQ(stl_message("ply"),
            "a.stl: byte 3: the file ends here: neither an STL text, which begins with 'solid', nor a binary STL file, "
            "which has a header of 84 bytes");
  std::string binary = test::stl_binary(box());
  EXPECT_EQ(
      stl_message(binary + "x"),
      "a.stl: byte 684: a binary STL file of 12 triangles has 684 bytes, this one has 685: something else follows");
  const float infinite = std::numeric_limits<float>::infinity();
  binary.replace(84 + 50 + 24, 4, reinterpret_cast<const char*>(&infinite), 4);
  EXPECT_EQ(stl_message(binary), "a.stl: byte 158: triangle 2 has a corner (inf, 3, 2), expected finite numbers");
  EXPECT_EQ(obj_message("v 0 0 0\nv 1 0"), "a.obj:2: a vertex has three coordinates, found 2");
  EXPECT_EQ(obj_message("v 0 0 1e31"), "a.obj:1: expected a finite number, found '1e31'");
  EXPECT_EQ(obj_message("v 0 0 0\nf 1 1 2"), "a.obj:2: there is no vertex 2; 1 come before this line");
  EXPECT_EQ(obj_message("v 0 0 0\nf 1 1 0"), "a.obj:2: there is no vertex 0; 1 come before this line");
  EXPECT_EQ(obj_message("v 0 0 0\nf 1 1 -2"), "a.obj:2: there is no vertex -2; 1 come before this line");
  EXPECT_EQ(obj_message("v 0 0 0\nf 1 1"), "a.obj:2: a face has at least three corners, found 2");
  EXPECT_EQ(obj_message("v 0 0 0\nf 1 1 x/1"), "a.obj:2: expected the number of a vertex, found 'x/1'");
  EXPECT_EQ(obj_message("v 0 0 0\nv 2 0 0\nv 0.2 0.2 0\nv 0 2 0\nf 1 2 3 4\nf 3 4 1 2"), "no error");
  EXPECT_EQ(obj_message("v 0 0 0\nv 2 0 0\nv 0.2 0.2 0\nv 0 2 0\n\nf 1 2 3 4\nf 2 3 4 1"),
            "a.obj:7: this polygon is not convex; divide it into triangles");
  EXPECT_EQ(obj_message("curv2 1"),
            "a.obj:1: expected 'v', 'f' or another statement of an OBJ file of flat faces, found 'curv2'");
}

TEST(MeshFile, CutOffAnywhereItSaysSoOrIsComplete) {
  const std::string text = test::stl_text(box()), binary = test::stl_binary(box());
  const std::size_t last = text.rfind("endsolid") + 8;
  for (std::size_t n = 0; n < last; ++n) EXPECT_NE(stl_message(text.substr(0, n)), "no error") << n;
  for (std::size_t n = last; n <= text.size(); ++n) EXPECT_EQ(stl_message(text.substr(0, n)), "no error") << n;
  for (std::size_t n = 0; n < binary.size(); ++n) EXPECT_NE(stl_message(binary.substr(0, n)), "no error") << n;
  for (std::size_t n = 0; n < box_obj.size(); ++n) obj_message(box_obj.substr(0, n));
}

TEST(MeshFile, RandomBytesAreRefusedOrRead) {
  std::mt19937 random(5);
  const std::string sources[] = {test::stl_text(box()), test::stl_binary(box()), std::string(box_obj)};
  for (int i = 0; i < 3000; ++i) {
    std::string bytes = sources[i % 3];
    for (int k = 0; k < 1 + i % 5; ++k) bytes[random() % bytes.size()] = static_cast<char>(random());
    for (auto parse : {parse_stl, parse_obj}) message_of([&] { report_mesh(weld(parse(bytes, "a"))); });
  }
}

TEST(MeshWeld, JoinsWhatIsCloserThanTheTolerance) {
  std::mt19937 random(3);
  const Triangles plane = test::plane_triangles(1000, 30, 1);
  Triangles shaken = plane;  // by up to a third of the tolerance, which is 1.4e-6
  for (auto& corners : shaken)
    for (auto& x : corners) x.x += 3e-7 * (static_cast<double>(random()) / 4294967296.0);
  for (const Triangles& triangles : {plane, shaken}) {
    const MeshReport report = report_mesh(stl_mesh(triangles));
    EXPECT_EQ(report.triangles, 1800);
    EXPECT_EQ(report.vertices, 31 * 31);
    EXPECT_EQ(report.open_edges, 120);
    EXPECT_EQ(report.pieces, 1);
    EXPECT_NEAR(report.area, 1e6, 1e-2);
  }
  Triangles torn = box();
  torn[0][1].y += 1e-6;
  EXPECT_EQ(report_mesh(stl_mesh(torn)).vertices, 9);
}

TEST(MeshWeld, JoinsAcrossTheCellsItLooksIn) {
  // The diagonal is 5, so the tolerance is 5e-9 and the cells are 5e-6 wide.
  TriangleMesh loose;
  loose.vertices = {sc_make_vec(0, 0, 0), sc_make_vec(3, 4, 0), sc_make_vec(0, 1, 0), sc_make_vec(0, 2, 0)};
  loose.triangles.push_back({0, 1, 2});
  constexpr int pairs = 100;
  for (int k = 1; k <= pairs; ++k)
    for (int side : {-1, 1}) {
      loose.triangles.push_back({static_cast<int>(loose.vertices.size()), 1, side < 0 ? 2 : 3});
      loose.vertices.push_back(sc_make_vec(5e-3 * k + 1e-9 * side, 0, 0));
    }
  EXPECT_EQ(weld(loose).vertices.size(), 4u + pairs);
}

TEST(MeshWeld, LeavesOutWhatHasNoAreaAndWhatIsThere) {
  Triangles triangles = box();
  triangles.push_back({triangles[3][1], triangles[3][0], triangles[3][2]});
  triangles.push_back({low, low, high});
  triangles.push_back({low, high, sc_scale(0.5, sc_add(low, high))});
  const TriangleMesh mesh = stl_mesh(triangles);
  expect_box(mesh);
  EXPECT_EQ(mesh.duplicate, 1);
  EXPECT_EQ(mesh.degenerate, 2);
}

TEST(MeshReport, CountsWhatIsWrong) {
  Triangles open = box();
  open.pop_back();
  EXPECT_EQ(report_mesh(stl_mesh(open)).open_edges, 3);
  Triangles flipped = box();
  std::swap(flipped[4][0], flipped[4][1]);
  EXPECT_EQ(report_mesh(stl_mesh(flipped)).flipped_edges, 3);
  Triangles fin = box();
  fin.push_back({fin[0][0], fin[0][1], sc_make_vec(-5, 0, 0)});
  EXPECT_EQ(report_mesh(stl_mesh(fin)).crowded_edges, 1);
  EXPECT_EQ(report_mesh(stl_mesh(fin)).open_edges, 2);
  Triangles two = box();
  for (const auto& corners : test::box_triangles(sc_make_vec(5, 5, 5), sc_make_vec(6, 6, 6))) two.push_back(corners);
  EXPECT_EQ(report_mesh(stl_mesh(two)).pieces, 2);
  EXPECT_NEAR(report_mesh(stl_mesh(two)).volume, 10, 1e-12);
  const MeshReport tube = report_mesh(stl_mesh(test::cylinder_triangles(2, 5, 24)));
  EXPECT_EQ(tube.open_edges, 48);
  ASSERT_EQ(tube.rims.size(), 2u);
  EXPECT_EQ(tube.rims[0].edges, 24);
  EXPECT_NEAR(tube.rims[0].low.x, -2, 1e-12);
  EXPECT_NEAR(std::abs(tube.rims[0].low.z - tube.rims[1].low.z), 5, 1e-12);
  EXPECT_EQ(tube.rims[0].low.z, tube.rims[0].high.z);
  EXPECT_NEAR(tube.area, 24 * 2 * 2 * std::sin(std::numbers::pi / 24) * 5, 1e-12);
}

TEST(MeshReport, SaysItInWords) {
  EXPECT_EQ(describe(report_mesh(stl_mesh(box()))),
            "12 triangles, 8 vertices, 1 piece; 2 x 3 x 1.5 m from (-1, 0, 2), area 27 m^2, closed, volume 9 m^3");
  Triangles bad = box();
  bad.pop_back();
  bad.push_back(bad[0]);
  EXPECT_EQ(describe(report_mesh(stl_mesh(bad))),
            "11 triangles, 8 vertices, 1 piece; 2 x 3 x 1.5 m from (-1, 0, 2), area 24.75 m^2, open\n"
            "3 edges have one triangle only: the surface ends there\n"
            "rim of 3 edges, 0 x 3 x 1.5 m about (1, 1.5, 2.75)\n"
            "1 triangle that was there already was left out");
}

}  // namespace
}  // namespace scree
