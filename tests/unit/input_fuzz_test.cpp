// Mutated cases never crash the parser: they load, or fail with InputError; what loads can be written and loaded again.
// SCREE_FUZZ_COUNT in the environment sets the number of mutations of each test, SCREE_FUZZ_SEED where they begin.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "scree/base/error.h"
#include "scree/base/expression.h"
#include "scree/base/units.h"
#include "scree/input/load.h"
#include "scree/input/write.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

/// The good cases of the tests, then the bad ones, each kind by name.
std::vector<std::string> seeds() {
  std::vector<std::string> texts;
  for (const char* directory : {"tests/good", "tests/bad"}) {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(fs::path(SCREE_SOURCE_DIR) / directory))
      if (entry.path().extension() == ".toml") paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    for (const fs::path& path : paths) {
      std::ifstream file(path, std::ios::binary);
      texts.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
  }
  return texts;
}

const std::vector<std::string> values = {"0",
                                         "-1",
                                         "1",
                                         "3",
                                         "1e-3",
                                         "1e300",
                                         "0.5",
                                         "true",
                                         "false",
                                         "\"1 mm\"",
                                         "\"2 m/s\"",
                                         "\"random\"",
                                         "\"x\"",
                                         "[0, 0, 0]",
                                         "[1, 1, 1]",
                                         "[0, 0, 1]",
                                         "[1e-3, 1e-3, 1e-3]",
                                         "[\"x\", \"t\", 0]",
                                         "[]",
                                         "[\"drag\"]",
                                         "[[0.5, 0.5, 0.5]]",
                                         "{}",
                                         "{ value = 1e-3 }",
                                         "{ type = \"fluid\" }",
                                         "\"none\"",
                                         "\"spring\"",
                                         "\"history\"",
                                         "\"rotating\"",
                                         "\"still\"",
                                         "\"file\""};

/// Random edits of a text: bytes, spans, words that mean something, pieces of other texts.
struct Mutator {
  std::mt19937_64 random;
  std::vector<std::string> words;

  std::size_t below(std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(random() % n); }

  void edit(std::string& text, const std::string& other) {
    const std::size_t at = below(text.size() + 1);
    const std::size_t span = std::min(below(30), text.size() - at);
    switch (below(7)) {
      case 0:
        text.erase(at, span);
        break;
      case 1:
        text.insert(at, text.substr(below(text.size()), below(60)));
        break;
      case 2:
        text.insert(at, words[below(words.size())]);
        break;
      case 3:
        text.replace(at, span, words[below(words.size())]);
        break;
      case 4:
        if (!text.empty()) text[below(text.size())] = static_cast<char>(random() & 0xFF);
        break;
      case 5:
        text.replace(at, span, other.substr(below(other.size() + 1), below(200)));
        break;
      default:
        text.insert(at, 1, "=[]{}\"'\n.,#-+0e \\"[below(17)]);
        break;
    }
  }

  std::string mutate(const std::string& seed, const std::string& other) {
    std::string text = seed;
    for (std::size_t i = 0, n = 1 + below(4); i < n; ++i) edit(text, other);
    return text;
  }

  /// Edits of whole lines and whole values, which leave the syntax alone.
  std::string mutate_lines(const std::string& seed, const std::string& other) {
    std::vector<std::string> lines = split(seed), others = split(other);
    for (std::size_t i = 0, n = 1 + below(3); i < n; ++i) {
      std::string& line = lines[below(lines.size())];
      const std::size_t equals = line.find('=');
      switch (below(4)) {
        case 0:
          line.clear();
          break;
        case 1:
          line = others[below(others.size())];
          break;
        case 2:
          std::swap(line, lines[below(lines.size())]);
          break;
        default:
          if (equals != std::string::npos) line = line.substr(0, equals + 1) + " " + values[below(values.size())];
      }
    }
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
  }

  static std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> lines(1);
    for (char c : text) {
      if (c == '\n')
        lines.emplace_back();
      else
        lines.back() += c;
    }
    return lines;
  }
};

const std::vector<std::string> case_words = {"[[particles]]\n",
                                             "[materials]\n",
                                             "[",
                                             "]]",
                                             "inf",
                                             "nan",
                                             "-",
                                             "1e308",
                                             "1e-320",
                                             "9223372036854775807",
                                             "0x7f",
                                             "1979-05-27T07:32:00Z",
                                             "\"1 mm\"",
                                             "\"5 kg/(m s2)\"",
                                             "\"\"",
                                             "'''",
                                             "\"\"\"",
                                             "true",
                                             "{}",
                                             "[[[]]]",
                                             "= ",
                                             "name = \"a\"\n",
                                             "µ",
                                             "\xff",
                                             "\xEF\xBB\xBF",
                                             "insert = \"random\"\n",
                                             "type = \"expression\"\n",
                                             "\"expression\"",
                                             "\"prescribed\"",
                                             "diameter.max = 3\n",
                                             "# --set ",
                                             "\\u0000",
                                             "a.b.c.d = 1\n",
                                             "\"hertz\"",
                                             "\"jkr\"",
                                             "periodic = [true, true, true]\n"};

TEST(Fuzz, Cases) {
  const std::vector<std::string> texts = seeds();
  Mutator m{std::mt19937_64(from_environment("SCREE_FUZZ_SEED", 1)), case_words};
  const std::uint64_t count = from_environment("SCREE_FUZZ_COUNT", 2000);
  std::uint64_t loaded = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::string& seed = texts[m.below(i % 3 == 0 ? 2 : texts.size())];  // the good cases come first
    const std::string& other = texts[m.below(texts.size())];
    const std::string text = i % 2 == 0 ? m.mutate(seed, other) : m.mutate_lines(seed, other);
    std::string written;
    try {
      written = resolved_case(parse_case(text, "case.toml"));
    } catch (const InputError& error) {
      ASSERT_NE(std::string(error.what()).find("error[E1"), std::string::npos) << text;
      continue;
    }
    ++loaded;
    ASSERT_EQ(resolved_case(parse_case(written, "case.toml")), written) << text;
  }
  EXPECT_GT(loaded, count / 100);
}

TEST(Fuzz, Overrides) {
  const std::vector<std::string> texts = {"simulation.end=0.5",
                                          "materials.glass.friction=0.1",
                                          "particles.0.velocity.value=[1, 0, 0]",
                                          "gravity.acceleration.2=-1.62",
                                          "flow.type=none",
                                          "particles.0.diameter=2 mm",
                                          "contact.normal=hertz"};
  Mutator m{std::mt19937_64(from_environment("SCREE_FUZZ_SEED", 2)),
            {".", "=", "0", "[", "]", "name", "walls", "\n", "\"", "type", "1e99", "{a=1}", "set"}};
  const fs::path path = fs::path(SCREE_SOURCE_DIR) / "tests/good/linear.toml";
  std::ifstream file(path, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  for (std::uint64_t i = 0; i < from_environment("SCREE_FUZZ_COUNT", 500); ++i) {
    const std::string a = m.mutate(texts[m.below(texts.size())], texts[m.below(texts.size())]);
    const std::string b = m.mutate(texts[m.below(texts.size())], a);
    try {
      parse_case(text, "case.toml", {a, b});
    } catch (const InputError&) {
    }
  }
}

TEST(Fuzz, QuantitiesAndFormulas) {
  const std::vector<std::string> texts = {"1.2 mm",
                                          "2.5 g/cm3",
                                          "12 W/(m K)",
                                          "5 1/ms",
                                          "3 kg·m⁻³",
                                          "9.81 * sin(2 * pi * t)",
                                          "x > 0 ? 1e-3 : -(y^2)",
                                          "max(1, x, atan2(y, z))"};
  Mutator m{
      std::mt19937_64(from_environment("SCREE_FUZZ_SEED", 3)),
      {"(", ")", "^", "-", "/", "**", "µ", "⁻", "²", "1", "e", "?", ":", ",", "x", "sin(", "==", "&&", "rpm", "1e400"}};
  for (std::uint64_t i = 0; i < from_environment("SCREE_FUZZ_COUNT", 5000); ++i) {
    const std::string text = m.mutate(texts[m.below(texts.size())], texts[m.below(texts.size())]);
    const QuantityResult result = parse_quantity(text);
    if (result.problem) {
      ASSERT_LE(result.problem->offset + result.problem->length, text.size()) << text;
    }
    expression_problem(text, {"x", "y", "z", "t"});
  }
}

}  // namespace
}  // namespace scree
