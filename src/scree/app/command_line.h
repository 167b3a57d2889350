// The words of a command line, and what is wrong with them in the form of all other errors.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace scree {

/// The words after the program's name; `help`, and a command after it, ask for --help.
std::vector<std::string> words_of(int argc, char** argv);

/// The message for a first word that is no command; empty if it is one, or none is there.
std::string unknown_command(const CLI::App& app, const std::vector<std::string>& words);

/// The message for words that the parser refused.
std::string refused_words(const CLI::App& app, const CLI::ParseError& error);

}  // namespace scree
