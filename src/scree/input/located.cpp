#include "scree/input/located.h"

#include <fmt/format.h>

namespace scree {

InputError error_at(const Case& c, const std::string& path, Problem problem) {
  if (c.text) {
    problem.place = c.text->origins.place(path);
    return InputError(render(c.text->sources, {problem}, c.text->colour));
  }
  const std::string help = problem.help.empty() ? "" : "\n  = help: " + problem.help;
  const std::string note = problem.note.empty() ? "" : ": " + problem.note;
  return InputError(fmt::format("{}: {}{}{}", path, problem.message, note, help));
}

}  // namespace scree
