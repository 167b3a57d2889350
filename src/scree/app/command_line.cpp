#include "scree/app/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "scree/input/suggest.h"

namespace scree {
namespace {

std::string message(const std::string& program, const std::string& what, const std::string& suggestion) {
  const std::string more = program + " --help";
  return fmt::format("{}: error[E190]: {}\n      = help: {}", program, what,
                     suggestion.empty() ? more : suggestion + "   (" + more + ")");
}

std::vector<std::string> long_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

}  // namespace

std::vector<std::string> words_of(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty() || words.front() != "help") return words;
  words.erase(words.begin());
  words.push_back("--help");
  return words;
}

std::string unknown_command(const CLI::App& app, const std::vector<std::string>& words) {
  if (words.empty() || words.front().starts_with("-")) return "";
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  for (const std::string& name : names)
    if (name == words.front()) return "";
  return message("scree", fmt::format("unknown command '{}'", words.front()), did_you_mean(words.front(), names));
}

std::string refused_words(const CLI::App& app, const CLI::ParseError& error) {
  const auto chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  const std::string program = chosen.empty() ? "scree" : "scree " + command.get_name();
  const std::vector<std::string> left = app.remaining(true);
  if (left.empty()) return message(program, error.what(), "");
  const std::string& word = left.front();
  if (!word.starts_with("-")) return message(program, fmt::format("'{}' is one argument too many", word), "");
  const std::string name = word.substr(0, word.find('='));
  return message(program, fmt::format("unknown option '{}'", name), did_you_mean(name, long_names(command)));
}

}  // namespace scree
