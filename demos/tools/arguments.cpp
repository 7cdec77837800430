#include "arguments.h"

#include "errors.h"
#include "words.h"

#include <algorithm>
#include <cstdio>

namespace plait {
namespace {

std::vector<std::string> optionNames(const Command& command) {
    std::vector<std::string> names;
    for (const Option& option : command.options) names.push_back("--" + option.name);
    return names;
}

const Option& findOption(const Command& command, const std::string& word) {
    for (const Option& option : command.options)
        if (word == "--" + option.name ||
            (option.letter && word == std::string{'-', option.letter}))
            return option;
    const std::vector<std::string> names = optionNames(command);
    throw UsageError("unknown option " + word +
                     (names.empty() ? "; it has none" : "; nearest: " + nearest(word, names)) +
                     "; see plait " + command.name + " --help");
}

bool isOption(const std::string& word) {
    return word.size() > 1 && word[0] == '-' && !(word[1] >= '0' && word[1] <= '9');
}

void checkOperands(const Command& command, const Arguments& arguments) {
    const std::size_t given = arguments.operands.size(), most = command.operands.size();
    if (given > most)
        throw UsageError("'" + arguments.operands[most] + "' is one word too many; usage: plait " +
                         command.name + " " + joined(command.operands) + " [OPTION]...");
    if (given < most && command.operands[given][0] != '[')
        throw UsageError(command.operands[given] + " is missing; usage: plait " + command.name +
                         " " + joined(command.operands) + " [OPTION]...");
}

}  // namespace

std::string Arguments::value(const std::string& name, const std::string& otherwise) const {
    const auto found = options.find(name);
    return found == options.end() ? otherwise : found->second.back();
}

std::vector<std::string> Arguments::values(const std::string& name) const {
    const auto found = options.find(name);
    return found == options.end() ? std::vector<std::string>{} : found->second;
}

Arguments parseArguments(const Command& command, const std::vector<std::string>& words) {
    Arguments arguments;
    arguments.line = "build/plait " + command.name;
    for (const std::string& word : words) arguments.line += " " + shellWord(word);
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (!isOption(words[i])) {
            arguments.operands.push_back(words[i]);
            continue;
        }
        const std::size_t equals = words[i].find('=');
        const Option& option = findOption(command, words[i].substr(0, equals));
        const std::string name = "--" + option.name;
        std::string value;
        if (option.argument.empty()) {
            if (equals != std::string::npos) throw UsageError(name + " takes no value");
        } else if (equals != std::string::npos) {
            value = words[i].substr(equals + 1);
        } else {
            ++i;
            if (i == words.size() || words[i].starts_with("--"))
                throw UsageError(name + " needs a value: " + option.argument);
            value = words[i];
        }
        if (arguments.has(option.name) && !option.repeatable)
            throw UsageError(name + " is given twice");
        arguments.options[option.name].push_back(value);
    }
    checkOperands(command, arguments);
    return arguments;
}

std::string helpOf(const Command& command) {
    std::string help = "plait " + command.name;
    for (const std::string& operand : command.operands) help += " " + operand;
    help += (command.options.empty() ? "" : " [OPTION]...") + ("\n\n" + command.meaning) + "\n";
    if (!command.options.empty()) help += "\n";
    for (const Option& option : command.options) {
        std::string left = option.letter ? std::string{'-', option.letter} + ", " : "    ";
        left += "--" + option.name + (option.argument.empty() ? "" : " " + option.argument);
        left.resize(std::max<std::size_t>(left.size() + 2, 34), ' ');
        help += "  " + left + option.meaning + "\n";
    }
    if (!command.examples.empty()) help += "\n";
    for (const std::string& example : command.examples) help += "    plait " + example + "\n";
    return help;
}

std::string helpOf(const std::vector<Command>& commands) {
    std::string help = "plait COMMAND [OPTION]...\n\n";
    for (const Command& command : commands) {
        std::string left = "  " + command.name;
        for (const std::string& operand : command.operands) left += " " + operand;
        left.resize(std::max<std::size_t>(left.size() + 2, 28), ' ');
        help += left + command.meaning + "\n";
    }
    return help +
           "\nplait help COMMAND shows its options, which come in any order; plait --version, "
           "what\n"
           "this program is made of.\n";
}

}  // namespace plait
