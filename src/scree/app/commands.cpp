#include "scree/app/commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "scree/app/bench.h"
#include "scree/app/data_files.h"
#include "scree/app/derived.h"
#include "scree/app/device_run.h"
#include "scree/app/fluid_report.h"
#include "scree/app/info.h"
#include "scree/app/memory_need.h"
#include "scree/app/plot.h"
#include "scree/app/restart.h"
#include "scree/app/run.h"
#include "scree/app/simulation.h"
#include "scree/app/verify.h"
#include "scree/base/memory.h"
#include "scree/input/explain.h"
#include "scree/input/load.h"
#include "scree/input/option.h"

namespace scree {
namespace {

void print(const std::string& text) {
  std::fputs(text.c_str(), stdout);
  if (text.empty() || text.back() != '\n') std::fputc('\n', stdout);
}

/// "DIR/silo.toml" -> "runs/silo"; "silo/case.toml" -> "runs/silo".
std::string default_directory(const std::string& case_file) {
  const std::filesystem::path path = std::filesystem::absolute(case_file);
  const std::string stem = path.stem() == "case" ? path.parent_path().filename().string() : path.stem().string();
  return (std::filesystem::path("runs") / stem).string();
}

struct CaseArguments {
  std::string file;
  std::vector<std::string> set;

  void declare(CLI::App& command) {
    command.add_option("case", file, "the case file, CASE.toml")->required();
    command.add_option("--set", set, "change a key: --set simulation.end=0.5 (may be repeated)");
  }
};

/// An option that is read like a value of a case.
template <class T, class Read>
void add_option(CLI::App& command, const std::string& name, const std::string& what, T& target, Read read) {
  const auto take = [&command, name, &target, read](const std::string& text) {
    target = static_cast<T>(read(OptionText{command.get_name(), name, text}));
  };
  command.add_option_function<std::string>(name, take, what);
}

/// Why a run of the case would end before it begins; empty if it would not. Builds the initial state to find out.
std::string refusal_of(const Case& c) {
  try {
    const Simulation simulation(c, 1);
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

Command declare_run(CLI::App& app, const RanksOfRun& processes) {
  CLI::App* c = app.add_subcommand("run", "Run a case");
  auto arguments = std::make_shared<CaseArguments>();
  auto options = std::make_shared<RunOptions>();
  auto plot = std::make_shared<bool>(false);
  options->ranks = processes.ranks();
  options->processors = processes.processors();
  arguments->declare(*c);
  c->add_option("-o,--output", options->directory, "directory of the results [runs/NAME]");
  c->add_flag("--force", options->force, "replace the results of an earlier run in that directory");
  c->add_option("--restart", options->restart,
                "go on from a checkpoint file, from the latest in a run directory, or from the \"latest\" of this run, "
                "appending to its results");
  add_option(*c, "--until", "end at this time: 0.5, \"20 ms\"", options->until, read_time);
  add_option(*c, "--wall-time",
             "pause with a checkpoint before this much time has passed: \"90 s\", \"1.5 h\", 2:30:00; the same command "
             "line goes on",
             options->wall_time, read_duration);
  add_option(*c, "--threads", "threads of each process [its share of the processors]", options->threads, read_count);
  c->add_option(
      "--device", options->device,
      "where the steps are done: cpu, opencl (the first device that `scree info` lists), opencl:NUMBER [cpu]");
  c->add_option("--precision", options->precision,
                "on a device: double, with the bits of the CPU, or mixed, with contacts in single precision [double]");
  c->add_flag("--quiet", options->quiet, "print nothing but errors");
  c->add_flag("--plot", *plot, "draw series.png and particles.png at the end");
  return {"run", [=] {
            const Case loaded = load_case(arguments->file, arguments->set);
            if (options->directory.empty() && options->restart != "latest")
              options->directory = run_directory_of(options->restart);
            if (options->directory.empty()) options->directory = default_directory(arguments->file);
            const RunResult result = run_case(loaded, *options);
            if (!result.summary.reason.empty()) std::fprintf(stderr, "%s\n", result.summary.reason.c_str());
            if (*plot && options->ranks.root() && result.status == Exit::success) plot_run(options->directory);
            return static_cast<int>(result.status);
          }};
}

Command declare_check(CLI::App& app) {
  CLI::App* c = app.add_subcommand("check", "Check a case and print the numbers that follow from it; nothing is run");
  auto arguments = std::make_shared<CaseArguments>();
  auto directory = std::make_shared<std::string>();
  arguments->declare(*c);
  auto device = std::make_shared<std::string>("cpu");
  c->add_option("-o,--output", *directory, "where the results would go [runs/NAME]");
  c->add_option("--device", *device,
                "where the steps would be done, as in `scree run`; says whether that can do all of the case [cpu]");
  auto precision = std::make_shared<std::string>("double");
  c->add_option("--precision", *precision, "double or mixed, as in `scree run` [double]");
  return {"check", [=] {
            const Case loaded = load_case(arguments->file, arguments->set);
            const Precision asked = find_precision(*precision, *device);
            if (*device != "cpu") {
              refuse_on_device(loaded);
              if (asked == Precision::mixed) refuse_in_mixed(loaded);
              print(fmt::format("{} can do the steps of this case in {} precision\n\n", find_device(*device).name,
                                *precision));
            }
            if (solves_flow(loaded) && !couples(loaded)) {
              print(fluid_report(loaded));
              return static_cast<int>(Exit::success);
            }
            // First what nothing need be made for: a case that does not fit must not fill the memory.
            std::string refusal = memory_refusal(loaded, available_memory());
            const Exit verdict = refusal.empty() ? Exit::input : Exit::resource;
            if (refusal.empty()) refusal = refusal_of(loaded);
            const std::string place = directory->empty() ? default_directory(arguments->file) : *directory;
            print(check_report(loaded, derive(loaded), refusal, output_place(place)));
            return static_cast<int>(refusal.empty() ? Exit::success : verdict);
          }};
}

Command declare_verify(CLI::App& app) {
  CLI::App* c = app.add_subcommand("verify", "Run the verification book: every law against its reference");
  auto options = std::make_shared<VerifyOptions>();
  c->add_option("names", options->names, "cases, by name or number [all]");
  c->add_option("-o,--output", options->directory, "directory of the results")->capture_default_str();
  c->add_flag("--plot", options->plot, "draw each case over its reference");
  auto many_hours = std::make_shared<bool>(false);
  c->add_flag("--long", *many_hours, "the cases that take minutes to hours each instead");
  add_option(*c, "--threads", "threads", options->threads, read_count);
  return {"verify", [=] {
            options->cases = (data_directory("verify") / (*many_hours ? "long" : "")).string();
            return verify(*options);
          }};
}

Command declare_bench(CLI::App& app, const RanksOfRun& processes) {
  CLI::App* c = app.add_subcommand("bench", "Measure speed on the benchmark scenes, and how run time grows");
  auto options = std::make_shared<BenchOptions>();
  options->ranks = processes.ranks();
  c->add_option(
      "names", options->names,
      "dense, dilute, drum, silo, mix, ellipsoids, cylinders, boxes, exponents, shapes, endless, linear, fluid, "
      "gpu-spheres, gpu-shapes, gpu-vortex [dense dilute]");
  add_option(*c, "--threads", "threads [1 and all]", options->threads, read_count);
  add_option(*c, "--rounds", "measurements of which the median counts [5; linear and on devices 3]", options->rounds,
             read_count);
  add_option(*c, "--particles", "linear, gpu-spheres, gpu-shapes, gpu-vortex: the largest size [1000000, 10000000]",
             options->particles, read_count);
  c->add_option("--set", options->set, "change a key of the scenes: --set contact.detection=vertices (may be repeated)")
      ->allow_extra_args(false);
  c->add_option("--device", options->device, "gpu-spheres, gpu-shapes, gpu-vortex: opencl, opencl:NUMBER [opencl]");
  c->add_option("--precision", options->precision, "gpu-spheres, gpu-shapes, gpu-vortex: double, mixed [double]");
  c->add_option("--json", options->json, "also write the figures to this file");
  c->add_option("--packings", options->packings, "directory of the particle tables [the user's cache]");
  c->add_option("--plot", options->plot, "linear: draw run time over particles into this PNG");
  return {"bench", [=] { return bench(*options); }};
}

Command declare_explain(CLI::App& app) {
  CLI::App* c = app.add_subcommand("explain", "Explain a key of the case file or the code of an error");
  auto key = std::make_shared<std::string>();
  auto schema = std::make_shared<bool>(false);
  auto markdown = std::make_shared<bool>(false);
  c->add_option("key", *key, "contact.normal, say, or E102 [an overview]");
  c->add_flag("--schema", *schema, "print the JSON Schema of case files, for editors");
  c->add_flag("--markdown", *markdown, "print the reference of all keys");
  return {"explain", [=] {
            print(*schema ? json_schema() : *markdown ? reference_markdown() : explain(*key));
            return 0;
          }};
}

Command declare_info(CLI::App& app) {
  app.add_subcommand("info", "Show version, build and machine");
  return {"info", [] {
            print(info_text());
            return 0;
          }};
}

Command declare_new(CLI::App& app) {
  CLI::App* c = app.add_subcommand("new", "Copy an example into a new directory");
  auto name = std::make_shared<std::string>();
  auto directory = std::make_shared<std::string>();
  c->add_option("example", *name, "the example; without it, all are listed");
  c->add_option("directory", *directory, "where to put it [its name]");
  return {"new", [=] {
            print(name->empty() ? list_examples() : copy_example(*name, *directory));
            return 0;
          }};
}

Command declare_plot(CLI::App& app) {
  CLI::App* c = app.add_subcommand("plot", "Draw series.png and particles.png of a run");
  auto directory = std::make_shared<std::string>();
  c->add_option("directory", *directory, "the directory of the run")->required();
  return {"plot", [=] {
            plot_run(*directory);
            return 0;
          }};
}

}  // namespace

Commands make_commands(CLI::App& app, const RanksOfRun& processes) {
  return {declare_run(app, processes), declare_check(app), declare_verify(app), declare_bench(app, processes),
          declare_explain(app),        declare_info(app),  declare_new(app),    declare_plot(app)};
}

}  // namespace scree
