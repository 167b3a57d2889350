// Formatting and timing of the progress line.
#include "scree/app/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace scree {
namespace {

constexpr double terminal_interval = 0.1, plain_poll = 1.0, plain_interval = 10.0;  // [s]
constexpr double memory_time = 5.0;  // of the smoothed rates [s]: long against jitter, short against a settling run
constexpr int narrowest_bar = 10, widest_bar = 40;

std::string times_text(const ProgressState& s) { return fmt::format("t = {:.4g} / {:.4g} s", s.time, s.end); }

std::string rates_text(const ProgressState& s) {
  std::string text = fmt::format("{:3.0f} %", std::floor(100 * s.fraction));
  if (s.speed > 0) text += fmt::format(" | {:.2e} {}/s", s.speed, s.counted);
  if (s.remaining) text += " | ETA " + clock_text(*s.remaining);
  return text;
}

}  // namespace

std::string clock_text(double seconds) {
  const auto whole = static_cast<long long>(std::clamp(std::ceil(seconds), 0.0, 3.6e9));
  return fmt::format("{:02}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string progress_bar(const ProgressState& state, int width, bool colour) {
  const std::string left = times_text(state), right = rates_text(state);
  const std::string note = state.note.empty() ? "" : " | " + state.note;
  const int room = width - static_cast<int>(left.size() + right.size()) - 4;  // 4: blanks and brackets
  const int bar = std::clamp(room - static_cast<int>(note.size()), narrowest_bar, widest_bar);
  if (room < narrowest_bar) return (left + " " + right).substr(0, static_cast<std::size_t>(std::max(width, 0)));
  const auto filled = static_cast<std::size_t>(bar * std::clamp(state.fraction, 0.0, 1.0));
  const std::string done(filled, '#'), open(static_cast<std::size_t>(bar) - filled, '-');
  const std::string_view start = colour ? "\x1b[32m" : "", stop = colour ? "\x1b[0m" : "";
  const auto space_for_note = static_cast<std::size_t>(room - bar);
  return fmt::format("{} [{}{}{}{}] {}{}", left, start, done, stop, open, right, note.substr(0, space_for_note));
}

std::string progress_line(const ProgressState& state) {
  return times_text(state) + " | " + rates_text(state) + (state.note.empty() ? "" : " | " + state.note);
}

ProgressOptions detect_progress(std::FILE* stream) {
  const char* kind = std::getenv("TERM");
  const char* plain = std::getenv("NO_COLOR");
  ProgressOptions options;
  options.stream = stream;
  const int descriptor = ::fileno(stream);
  options.terminal = ::isatty(descriptor) == 1 && kind && std::string_view(kind) != "dumb";
  options.colour = options.terminal && !(plain && *plain);
  options.width = [descriptor] {
    winsize size{};
    return ::ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? static_cast<int>(size.ws_col) : 80;
  };
  options.now = [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  };
  return options;
}

Progress::Progress(ProgressOptions options, double start, double end)
    : options_(std::move(options)), start_(start), end_(end), last_time_(start) {
  began_ = seen_ = printed_ = options_.now();
}

bool Progress::due() const { return options_.now() - seen_ >= (options_.terminal ? terminal_interval : plain_poll); }

ProgressState Progress::measure(double time, std::uint64_t particle_steps, const std::string& note) {
  const double now = options_.now(), passed = now - seen_;
  if (passed > 0) {
    // Exponential average; the first update has no past to be averaged with.
    const double weight = seen_ == began_ ? 1.0 : 1.0 - std::exp(-passed / memory_time);
    speed_ += weight * (static_cast<double>(particle_steps - last_steps_) / passed - speed_);
    pace_ += weight * ((time - last_time_) / passed - pace_);
    seen_ = now;
    last_time_ = time;
    last_steps_ = particle_steps;
  }
  ProgressState state{time, end_, 1.0, speed_, std::nullopt, note, options_.counted};
  if (end_ > start_) state.fraction = std::clamp((time - start_) / (end_ - start_), 0.0, 1.0);
  if (pace_ > 0) state.remaining = std::max(0.0, (end_ - time) / pace_);
  return state;
}

void Progress::update(double time, std::uint64_t particle_steps, const std::string& note) {
  const ProgressState state = measure(time, particle_steps, note);
  const int tenths = static_cast<int>(10 * state.fraction);
  if (!options_.terminal && seen_ - printed_ < plain_interval && tenths == tenths_) return;
  tenths_ = tenths;
  printed_ = seen_;
  show(state, false);
}

void Progress::finish(double time, std::uint64_t particle_steps, const std::string& note) {
  ProgressState state = measure(time, particle_steps, note);
  const double wall = seen_ - began_;
  // The last line sums the run up: mean speed instead of the latest, and no time left.
  state.speed = wall > 0 ? static_cast<double>(particle_steps) / wall : 0.0;
  state.remaining.reset();
  show(state, true);
}

void Progress::show(const ProgressState& state, bool last) {
  if (options_.terminal) {
    fmt::print(options_.stream, "\r{}\x1b[K{}", progress_bar(state, options_.width(), options_.colour),
               last ? "\n" : "");
  } else {
    fmt::print(options_.stream, "{}\n", progress_line(state));
  }
  std::fflush(options_.stream);
}

}  // namespace scree
