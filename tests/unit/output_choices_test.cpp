// Which fields the frames hold, how exactly, and how small; and what all of it will cost.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numeric>

#include "engine_cases.h"
#include "run_files.h"
#include "scree/app/contact_fields.h"
#include "scree/app/derived.h"
#include "scree/app/frame_fields.h"
#include "scree/input/keys.h"
#include "scree/output/hdf5_file.h"
#include "support/temporary_directory.h"

namespace scree {
namespace {

using namespace test;
namespace fs = std::filesystem;

const LawChoice plain = {"plain", "normal = \"linear\"\n", "friction = 0.5\n"};

Case crowd(const Overrides& more) {
  Overrides all = {"simulation.end=4e-3"};
  all.insert(all.end(), more.begin(), more.end());
  return case_of(crowd_text(plain, 150), all);
}

struct Frames {
  TemporaryDirectory space;
  explicit Frames(const Overrides& more) { run_case(crowd(more), into(space / "run")); }

  fs::path last() const { return space / "run/frames/frame_000001.h5"; }
  std::vector<std::string> names() const { return Hdf5File::open(last()).names("/particles"); }

  template <class T>
  std::vector<T> read(const std::string& name) const {
    const Hdf5File file = Hdf5File::open(last());
    const Shape shape = file.shape("/particles/" + name);
    EXPECT_EQ(element_name(shape.element), element_name(element_of<T>())) << name;
    if (shape.element != element_of<T>()) return {};
    std::vector<T> out(shape.rows * shape.columns);
    file.read("/particles/" + name, shape, out.data());
    return out;
  }
};

using Names = std::vector<std::string>;

TEST(OutputFields, AreThoseThatTheCaseChooses) {
  const Names usual = {"id", "position", "velocity", "angular_velocity", "diameter", "mass", "material", "group"};
  EXPECT_EQ(Frames({}).names(), usual);
  Names grouped = usual;
  grouped.insert(grouped.end(), {"agglomerate", "agglomerate_size"});
  EXPECT_EQ(Frames({"analysis.agglomerates=true"}).names(), grouped);
  EXPECT_EQ(Frames({"output.fields=[\"contacts\", \"force\"]"}).names(),
            (Names{"id", "position", "force", "contacts"}));
  EXPECT_EQ(Frames({"output.fields=[\"position\"]", "analysis.agglomerates=true"}).names(), (Names{"id", "position"}));
}

TEST(OutputFields, TheKeyNamesWhatThereIs) {
  EXPECT_EQ(find(output_section(), "fields")->choices, frame_field_names());
}

TEST(OutputFields, HoldWhatTheirNamesSay) {
  const Frames f(
      {"output.fields=[\"force\", \"contacts\", \"effect_diameter\", \"unwrapped_position\", \"diameter\", "
       "\"velocity\"]",
       "output.tracks=[7]"});
  // The force of a track is the same number.
  const std::string tracks = read_text_file(f.space / "run/tracks.csv");
  const std::string row = tracks.substr(tracks.rfind('\n', tracks.size() - 2) + 1);
  const auto force = f.read<double>("force");
  std::vector<double> track;
  for (std::size_t at = 0; at < row.size();
       at = row.find(',', at) == std::string::npos ? row.size() : row.find(',', at) + 1)
    track.push_back(std::stod(row.substr(at)));
  ASSERT_EQ(track.size(), 14u);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(force[3 * 7 + k], track[11 + k]);
  const auto contacts = f.read<std::int32_t>("contacts");
  EXPECT_GT(std::accumulate(contacts.begin(), contacts.end(), 0), 20);
  const auto effect = f.read<double>("effect_diameter"), body = f.read<double>("diameter");
  EXPECT_NEAR(effect[3] - body[3], 2e-4, 1e-15);
  EXPECT_EQ(effect[170], body[170]);                                            // a pellet
  EXPECT_EQ(f.read<double>("unwrapped_position"), f.read<double>("position"));  // nothing is periodic
}

TEST(OutputFields, UnwrappedPositionsGoOnAcrossPeriods) {
  const TemporaryDirectory space;
  const std::string text =
      "[simulation]\nend = 1\ntime_step = 0.01\n[domain]\nmin = [0, 0, 0]\nmax = [1, 1, 1]\nperiodic = [true, true, "
      "true]\n[[materials]]\nname = \"glass\"\ndensity = 2500\nstiffness = 1\n[[particles]]\nmaterial = "
      "\"glass\"\ndiameter = 0.01\ninsert = \"positions\"\npositions = [[0.5, 0.5, 0.5]]\nvelocity = [3, -1.2, 0]\n"
      "[output]\nfields = [\"unwrapped_position\"]\n";
  run_case(case_of(text), into(space / "run"));
  const Hdf5File file = Hdf5File::open(space / "run/frames/frame_000001.h5");
  std::array<double, 3> x{};
  file.read("/particles/unwrapped_position", file.shape("/particles/unwrapped_position"), x.data());
  EXPECT_NEAR(x[0], 3.5, 1e-12);
  EXPECT_NEAR(x[1], -0.7, 1e-12);
  EXPECT_NEAR(x[2], 0.5, 1e-12);
}

TEST(OutputPrecision, SingleIsTheRoundedDouble) {
  const Frames full({}), half({"output.precision=single"});
  for (const char* name : {"position", "velocity", "diameter", "mass"}) {
    const auto exact = full.read<double>(name);
    const auto rounded = half.read<float>(name);
    ASSERT_EQ(exact.size(), rounded.size());
    for (std::size_t i = 0; i < exact.size(); ++i) ASSERT_EQ(static_cast<float>(exact[i]), rounded[i]) << name;
  }
  half.read<std::int64_t>("id");  // whole numbers stay what they are
  const std::string film = read_text_file(half.space / "run/fields.xdmf");
  EXPECT_NE(
      film.find("NumberType=\"Float\" Precision=\"4\" Dimensions=\"200 3\">frames/frame_000001.h5:/particles/position"),
      std::string::npos);
  EXPECT_EQ(film.find("NumberType=\"Float\" Precision=\"8\""), std::string::npos);
}

TEST(OutputCompression, TheWordsDoWhatTheySayAndKeepEveryBit) {
  std::vector<std::int64_t> id(20000);
  std::iota(id.begin(), id.end(), 0);
  std::vector<double> mass(id.size());
  for (std::size_t i = 0; i < id.size(); ++i) mass[i] = 1e-6 * static_cast<double>(i * 7919 % 1000);
  const FrameColumn columns[] = {{"id", "1", "Number.", array_view(id.data(), id.size())},
                                 {"mass", "kg", "Mass.", array_view(mass.data(), mass.size())}};
  const TemporaryDirectory space;
  const Domain box = build_domain(crowd({}));
  const auto size = [&](const char* name, Compression compression) {
    FrameWriter::create(space / name, box, "scree", compression).write(0, 0, columns);
    const fs::path path = space / (std::string(name) + "/frames/frame_000000.h5");
    std::vector<double> back(mass.size());
    const Hdf5File file = Hdf5File::open(path);
    file.read("/particles/mass", file.shape("/particles/mass"), back.data());
    EXPECT_EQ(back, mass) << name;
    return fs::file_size(path);
  };
  const auto none = size("none", Compression::none), whole = size("whole", Compression::whole_numbers),
             fast = size("fast", Compression::fast), small = size("small", Compression::small);
  EXPECT_LT(whole, none * 7 / 10);
  EXPECT_LT(fast, whole * 7 / 10);
  EXPECT_LT(small, fast);
}

TEST(OutputCompression, TheCaseChoosesIt) {
  const Frames plain_frames({"output.compression=none"}), squeezed({"output.compression=small"});
  EXPECT_EQ(plain_frames.read<double>("velocity"), squeezed.read<double>("velocity"));
  EXPECT_NE(fs::file_size(plain_frames.last()), fs::file_size(squeezed.last()));
}

TEST(OutputCost, CountsWhatARunWrites) {
  const Overrides often = {"output.frames=1e-3", "output.series=5e-4", "output.checkpoints=2e-3", "output.tracks=[3]",
                           "output.compression=none"};
  const TemporaryDirectory space;
  run_case(crowd(often), into(space / "run"));
  const DerivedCost cost = derive(crowd(often)).cost;
  EXPECT_EQ(cost.frames, 5u);
  EXPECT_EQ(cost.rows, 9u);
  EXPECT_EQ(cost.checkpoints, 2u);
  EXPECT_NEAR(static_cast<double>(fs::file_size(space / "run/frames/frame_000004.h5")), cost.frame_bytes,
              0.2 * cost.frame_bytes);
  EXPECT_GT(cost.checkpoint_bytes, 0.5 * static_cast<double>(fs::file_size(newest(space / "run"))));
  // Half the floats, and none but the position.
  const double n = 200;
  const double single = derive(crowd({"output.precision=single"})).cost.frame_bytes;
  EXPECT_EQ(derive(crowd({})).cost.frame_bytes - single, n * 4 * 11);
  EXPECT_EQ(single - derive(crowd({"output.precision=single", "output.fields=[\"position\"]"})).cost.frame_bytes,
            n * (4 * 8 + 2 * 4));
}

/// Bytes and number of the HDF5 files in a folder.
std::pair<double, std::uint64_t> files_in(const fs::path& folder) {
  double bytes = 0;
  std::uint64_t count = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".h5") continue;
    bytes += static_cast<double>(entry.file_size());
    ++count;
  }
  return {bytes, count};
}

TEST(OutputCost, CountsContactsAndAverages) {
  const std::string grids =
      "[[analysis.averages]]\nname = \"whole\"\ncells = [5, 4, 3]\nevery = 5e-4\n"
      "[[analysis.averages]]\nname = \"parts\"\ncells = [8, 8, 8]\nevery = 5e-4\nwindow = 1.5e-3\nfrom = 5e-4\n"
      "[[analysis.averages]]\nname = \"even\"\ncells = [2, 2, 2]\nevery = 5e-4\nwindow = 2e-3\n"
      "[[analysis.averages]]\nname = \"late\"\ncells = [2, 2, 2]\nevery = 1e-3\nfrom = 5e-3\nwindow = 1e-3\n";
  const Case c = case_of(crowd_text(plain, 150) + grids, {"simulation.end=4e-3", "output.frames=1e-3",
                                                          "output.contacts=true", "output.compression=none"});
  const Case without = crowd({"output.frames=1e-3", "output.compression=none"});
  const TemporaryDirectory space;
  run_case(c, into(space / "run"));
  const DerivedCost cost = derive(c).cost, less = derive(without).cost;
  const auto [average_bytes, average_files] = files_in(space / "run/averages");
  EXPECT_EQ(cost.average_files, average_files);
  EXPECT_NEAR(cost.average_bytes, average_bytes, 0.2 * average_bytes);
  const auto [contact_bytes, contact_files] = files_in(space / "run/contacts");
  EXPECT_EQ(cost.frames, contact_files);
  EXPECT_GE(static_cast<double>(contact_files) * cost.contact_bytes, contact_bytes);
  EXPECT_EQ(less.contact_bytes, 0);
  EXPECT_EQ(less.average_files, 0u);
  EXPECT_NEAR(cost.disk - less.disk, 5 * cost.contact_bytes + cost.average_bytes, 1e-9 * cost.disk);
  const std::string report = check_report(c, derive(c), "", {});
  EXPECT_NE(report.find("contacts of every frame, up to "), std::string::npos) << report;
  EXPECT_NE(report.find(" files of averages, "), std::string::npos) << report;
}

TEST(OutputCost, CountsTheFilesOfWalls) {
  // A mesh that moves from the second frame to the fourth, a wall at rest, and one that appears.
  std::string mesh = "[[walls]]\nname = \"mesh\"\nmaterial = \"glass\"\ntype = \"triangles\"\nvertices = [";
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 40; ++j) {
      const auto at = [](int x, int y) { return fmt::format("[{}, {}, -0.1], ", 0.001 * x, 0.001 * y); };
      mesh += at(i, j) + at(i + 1, j) + at(i + 1, j + 1) + at(i, j) + at(i + 1, j + 1) + at(i, j + 1);
    }
  mesh += "]\nmotion = { type = \"velocity\", velocity = [0, 0, -1], start = 1.5e-3, stop = 3.5e-3 }\n";
  const std::string late =
      "[[walls]]\nname = \"late\"\nmaterial = \"glass\"\ntype = \"plane\"\npoint = [0, 0, -0.001]\nnormal = [0, 0, 1]\n"
      "from = 4.5e-3\n";
  const auto costs = [](const std::string& walls) {
    const Case c = case_of(crowd_text(plain, 30) + walls, {"simulation.end=6e-3", "output.frames=1e-3"});
    const TemporaryDirectory space;
    run_case(c, into(space / "run"));
    const auto [bytes, files] = files_in(space / "run/walls");
    const DerivedCost cost = derive(c).cost;
    EXPECT_GE(cost.wall_files, files);
    EXPECT_LE(cost.wall_files, files + 1);
    EXPECT_GE(cost.wall_bytes, bytes);
    EXPECT_LE(cost.wall_bytes, 1.5 * bytes + 2 * 8e3);
    return cost;
  };
  EXPECT_EQ(costs(mesh + late).wall_files, 5u);
  const DerivedCost still = costs(late);
  EXPECT_EQ(still.wall_files, 2u);
  EXPECT_GT(costs(mesh).disk, still.disk + 4 * 41 * 41 * 24.0);
}

TEST(OutputCost, AContactTakesWhatTheFileTakes) {
  const TemporaryDirectory space;
  run_case(crowd({"output.contacts=true"}), into(space / "run"));
  const Hdf5File file = Hdf5File::open(space / "run/contacts/contacts_000001.h5");
  std::size_t bytes = element_size(Element::int32);  // of the vertices
  for (const std::string& name : file.names("/contacts")) {
    const Shape shape = file.shape("/contacts/" + name);
    bytes += shape.columns * element_size(shape.element);
  }
  EXPECT_EQ(file_bytes_per_contact(), bytes);
}

TEST(OutputCost, TheReportWarnsWhenItWillNotFit) {
  const Case c = crowd({"output.frames=1e-3"});
  const Derived d = derive(c);
  const std::string fits = check_report(c, d, "", OutputPlace{"runs/crowd", 1e12});
  EXPECT_NE(fits.find("1 TB are left for 'runs/crowd'"), std::string::npos) << fits;
  EXPECT_NE(fits.find("5 frames of "), std::string::npos) << fits;
  EXPECT_EQ(fits.find("write fewer frames"), std::string::npos);
  const std::string full = check_report(c, d, "", OutputPlace{"runs/crowd", 1e4});
  EXPECT_NE(full.find("warning  disk"), std::string::npos) << full;
  EXPECT_NE(full.find("= help: write fewer frames"), std::string::npos) << full;
  EXPECT_TRUE(output_place("/no/such/place").has_value());
}

}  // namespace
}  // namespace scree
