// plait COMMAND ...: finds the command, and turns what it throws into one line and an exit status.
#include "demos/commands/commands.h"
#include "demos/tools/errors.h"
#include "demos/tools/interrupt.h"
#include "demos/tools/words.h"

#include <plait/solver_options.h>

#include <fcntl.h>
#include <unistd.h>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>

namespace {

using namespace plait;

int runCommandLine(const std::vector<std::string>& words) {
    const std::vector<Command> commands{listCommand(),   describeCommand(),  runCommand(),
                                        renderCommand(), checkCommand(),     compareCommand(),
                                        benchCommand(),  stabilityCommand(), studyCommand(),
                                        ablateCommand(), tuneCommand(),      catalogueCommand()};
    const auto isHelp = [](const std::string& word) { return word == "--help" || word == "-h"; };
    if (words.empty() || isHelp(words[0]) || (words[0] == "help" && words.size() == 1)) {
        std::printf("%s", helpOf(commands).c_str());
        return words.empty() ? exitUsage : exitOk;
    }
    if (words[0] == "--version") {
        std::printf("%s", versionText().c_str());
        return exitOk;
    }
    std::vector<std::string> names;
    for (const Command& command : commands) names.push_back(command.name);
    const auto find = [&](const std::string& word) -> const Command& {
        return commands[static_cast<std::size_t>(parseChoice("command", word, names))];
    };
    if (words[0] == "help") {
        std::printf("%s", helpOf(find(words[1])).c_str());
        return exitOk;
    }
    const Command& command = find(words[0]);
    const std::vector<std::string> rest(words.begin() + 1, words.end());
    for (const std::string& word : rest)
        if (isHelp(word)) {
            std::printf("%s", helpOf(command).c_str());
            return exitOk;
        }
    return command.run(parseArguments(command, rest));
}

// A file that is opened where a standard stream was closed would take what is printed for its own.
void holdStandardStreams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) < 0)
            open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);  // for neither use
}

// Throws FileError if anything that was printed is lost.
void finishOutput() {
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
    throw FileError(std::string("standard output: cannot be written: ") + std::strerror(errno));
}

int complain(Exit status, const char* message) {
    std::fprintf(stderr, "plait: %s\n", message);
    return status;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        holdStandardStreams();
        catchInterrupts();
        const int status = runCommandLine({argv + 1, argv + argc});
        finishOutput();
        return status;
    } catch (const UsageError& error) {
        return complain(exitUsage, error.what());
    } catch (const SceneError& error) {
        return complain(exitScene, error.what());
    } catch (const Diverged& error) {
        return complain(exitDiverged, error.what());
    } catch (const FileError& error) {
        return complain(exitFiles, error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        return complain(exitFiles, error.what());
    } catch (const Interrupted& error) {
        return complain(exitInterrupted, error.what());
    } catch (const std::exception& error) {
        return complain(exitFailed, error.what());
    }
}
