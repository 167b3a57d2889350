// summary.json written with the JSON library, entries in the order of docs/files.md.
#include "scree/output/summary.h"

#include <fmt/chrono.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "scree/base/atomic_file.h"

namespace scree {
namespace {

using Json = nlohmann::ordered_json;

Json table(const std::vector<std::pair<std::string, double>>& entries) {
  Json result = Json::object();
  for (const auto& [name, value] : entries) result[name] = value;
  return result;
}

}  // namespace

std::string summary_text(const Summary& s) {
  const double speed = s.wall_seconds > 0 ? static_cast<double>(s.particle_steps) / s.wall_seconds : 0.0;
  Json json = {{"program", s.program},
               {"version", s.version},
               {"commit", s.commit},
               {"case", s.case_file},
               {"title", s.title},
               {"status", s.status},
               {"reason", s.reason},
               {"started", s.started},
               {"ended", s.ended},
               {"wall_seconds", s.wall_seconds},
               {"stages", table(s.stages)},
               {"first_step", s.first_step},
               {"steps", s.steps},
               {"time", s.time},
               {"end", s.end},
               {"time_step", s.time_step},
               {"particles", s.particles},
               {"particle_steps", s.particle_steps},
               {"particle_steps_per_second", speed},
               {"contacts", s.contacts},
               {"wall_contacts", s.wall_contacts},
               {"ranks", s.ranks},
               {"threads", s.threads},
               {"device", s.device},
               {"precision", s.precision},
               {"sharing", table(s.sharing)},
               {"sweeps", table(s.sweeps)},
               {"ledger", table(s.ledger)},
               {"state_hash", s.state_hash}};
  if (s.cells > 0) {
    json["cells"] = s.cells;
    json["cell_steps_per_second"] =
        s.wall_seconds > 0 ? static_cast<double>(s.cells) * static_cast<double>(s.steps) / s.wall_seconds : 0.0;
    json["fluid_hash"] = s.fluid_hash;
  }
  // A path or a message may hold bytes that are no UTF-8; a summary with a mark in it is better than none.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_summary(const std::filesystem::path& path, const Summary& summary) {
  write_text_file(path, summary_text(summary));
}

std::optional<PastRun> read_past_run(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return {};
  const Json json = Json::parse(read_text_file(path), nullptr, false);
  if (!json.is_object() || !json.contains("status") || !json["status"].is_string()) return {};
  PastRun past;
  past.status = json["status"].get<std::string>();
  if (json.contains("reason") && json["reason"].is_string()) past.reason = json["reason"].get<std::string>();
  if (json.contains("end") && json["end"].is_number()) past.end = json["end"].get<double>();
  return past;
}

std::string timestamp_now() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

}  // namespace scree
