// A browser without a screen, as a person at its keys would have it: Debian's chromium, told what
// to do by its chromedriver (W3C WebDriver over HTTP on this machine).
#pragma once

#include <sys/types.h>
#include <filesystem>
#include <string>
#include <vector>

namespace plait::test {

class Browser {
public:
    // True if both programs are in PATH.
    static bool isHere();

    // `folder`: for what it keeps while it runs. Throws std::runtime_error, with what was answered.
    explicit Browser(const std::filesystem::path& folder);
    ~Browser();
    Browser(const Browser&) = delete;
    Browser& operator=(const Browser&) = delete;

    void open(const std::string& address);
    // Runs an asynchronous function with this body; what it returns, as text.
    std::string run(const std::string& script);
    // "" or the letters of a key; Tab, Enter and the like by their names.
    void press(const std::string& key);
    // What has been written to the console since, a line each.
    std::vector<std::string> console();

    void resize(int width, int height);                                  // px, of the page
    void emulate(const std::string& medium, const std::string& colors);  // "screen", "dark"
    // What is seen of the page, as PNG.
    std::string picture();

private:
    std::string ask(const std::string& method, const std::string& path, const std::string& body);
    std::string command(const std::string& path, const std::string& body) {
        return ask("POST", session_ + path, body);
    }
    std::string developer(const std::string& name, const std::string& parameters);

    pid_t driver_ = -1;
    int port_ = 0;
    std::string session_;
};

}  // namespace plait::test
