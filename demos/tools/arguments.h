// The command line: a table of commands, each with a table of options, which may come in any order.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace plait {

struct Option {
    std::string name;      // without the two dashes
    std::string argument;  // as the help shows it: "N", "a|b"; "" for a flag
    std::string meaning;
    char letter = 0;          // its short name, 0 for none
    bool repeatable = false;  // may be given more than once
};

// What was typed after the command.
struct Arguments {
    std::vector<std::string> operands;
    std::map<std::string, std::vector<std::string>> options;  // by name; a flag's value is ""
    std::string line;  // "build/plait run flag": all of it, for a shell

    bool has(const std::string& name) const { return options.contains(name); }
    // The last value given, or `otherwise`.
    std::string value(const std::string& name, const std::string& otherwise = "") const;
    std::vector<std::string> values(const std::string& name) const;
};

struct Command {
    std::string name;
    std::vector<std::string> operands;  // as the help shows them; "[X]" may be left out
    std::string meaning;
    std::vector<Option> options;
    std::vector<std::string> examples;
    int (*run)(const Arguments&);  // returns an exit status; throws what errors.h says
};

// `words` follow the command's name. Throws UsageError, one line: an unknown option with the
// nearest one, a value that lacks, an option twice, too few or too many operands.
Arguments parseArguments(const Command& command, const std::vector<std::string>& words);

std::string helpOf(const Command& command);
std::string helpOf(const std::vector<Command>& commands);

}  // namespace plait
