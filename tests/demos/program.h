// Runs build/plait as a user does.
#pragma once

#include <fcntl.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace plait::test {

inline std::string contents(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

// A folder of its own, gone when the test ends.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "plait-XXXXXX").string();
        path_ = mkdtemp(name.data());
    }
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

private:
    std::filesystem::path path_;
};

struct Outcome {
    int status;  // 128 + signal if one ended it, as a shell says
    std::string out, err;
};

// A plait that is running, its output going to files of `folder`.
class Program {
public:
    Program(const TemporaryFolder& folder, const std::vector<std::string>& words)
        : out_(folder / "stdout"), err_(folder / "stderr") {
        std::vector<const char*> arguments{PLAIT_PROGRAM};
        for (const std::string& word : words) arguments.push_back(word.c_str());
        arguments.push_back(nullptr);
        process_ = fork();
        if (process_ != 0) return;
        redirect(STDOUT_FILENO, out_);
        redirect(STDERR_FILENO, err_);
        execv(PLAIT_PROGRAM, const_cast<char* const*>(arguments.data()));
        _exit(127);
    }

    void signal(int number) const { kill(process_, number); }

    Outcome wait() const {
        int status = 0;
        waitpid(process_, &status, 0);
        return {WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status), contents(out_),
                contents(err_)};
    }

private:
    static void redirect(int to, const std::filesystem::path& path) {
        const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
        dup2(file, to);
        close(file);
    }

    std::filesystem::path out_, err_;
    pid_t process_;
};

inline Outcome plait(const TemporaryFolder& folder, const std::vector<std::string>& words) {
    return Program(folder, words).wait();
}

inline bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace plait::test
