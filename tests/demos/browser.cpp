#include "browser.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace plait::test {
namespace {

namespace fs = std::filesystem;

bool inPath(const std::string& program) {
    std::istringstream folders(std::getenv("PATH") ? std::getenv("PATH") : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (access((fs::path(folder) / program).c_str(), X_OK) == 0) return true;
    return false;
}

std::string quoted(const std::string& text) {
    std::string json = "\"";
    for (const char c : text)
        if (c == '"' || c == '\\')
            json += std::string("\\") + c;
        else if (static_cast<unsigned char>(c) < ' ') {
            char code[8];
            std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned char>(c));
            json += code;
        } else
            json += c;
    return json + "\"";
}

void addUtf8(std::string& text, unsigned code) {
    if (code < 0x80) {
        text += static_cast<char>(code);
    } else if (code < 0x800) {
        text += static_cast<char>(0xC0 | code >> 6);
        text += static_cast<char>(0x80 | (code & 63));
    } else {
        text += static_cast<char>(0xE0 | code >> 12);
        text += static_cast<char>(0x80 | (code >> 6 & 63));
        text += static_cast<char>(0x80 | (code & 63));
    }
}

// The string of JSON that begins at `at`, a quote; leaves `at` behind it.
std::string readString(const std::string& json, std::size_t& at) {
    std::string text;
    for (++at; at < json.size() && json[at] != '"'; ++at) {
        if (json[at] != '\\') {
            text += json[at];
            continue;
        }
        const char c = json[++at];
        if (c == 'u') {
            addUtf8(text, static_cast<unsigned>(std::stoul(json.substr(at + 1, 4), nullptr, 16)));
            at += 4;
        } else {
            text += c == 'n' ? '\n' : c == 't' ? '\t' : c;
        }
    }
    ++at;
    return text;
}

// The strings that are the values of a key, wherever it stands.
std::vector<std::string> valuesOf(const std::string& json, const std::string& key) {
    std::vector<std::string> values;
    const std::string mark = "\"" + key + "\":\"";
    for (std::size_t at = 0; (at = json.find(mark, at)) != std::string::npos;) {
        at += mark.size() - 1;
        values.push_back(readString(json, at));
    }
    return values;
}

// "was started successfully on port 12345."
int portIn(const fs::path& file) {
    using namespace std::chrono;
    for (const auto end = steady_clock::now() + seconds(20); steady_clock::now() < end;) {
        std::ifstream in(file);
        const std::string said{std::istreambuf_iterator<char>(in), {}};
        const std::size_t at = said.find("successfully on port ");
        if (at != std::string::npos && said.find('\n', at) != std::string::npos)
            return std::stoi(said.substr(at + 21));
        std::this_thread::sleep_for(milliseconds(20));
    }
    throw std::runtime_error("chromedriver does not begin");
}

// A whole answer, as long as it says that it is.
std::string received(int wire) {
    const timeval patience{.tv_sec = 60, .tv_usec = 0};
    setsockopt(wire, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    std::string answer;
    char part[65536];
    std::size_t whole = std::string::npos;
    while (answer.size() < whole) {
        const ssize_t n = recv(wire, part, sizeof part, 0);
        if (n <= 0) break;
        answer.append(part, static_cast<std::size_t>(n));
        const std::size_t head = answer.find("\r\n\r\n");
        if (whole != std::string::npos || head == std::string::npos) continue;
        for (const char* name : {"Content-Length:", "content-length:"})
            if (const std::size_t at = answer.find(name); at < head)
                whole = head + 4 + std::stoul(answer.substr(at + 15));
    }
    return answer;
}

}  // namespace

bool Browser::isHere() { return inPath("chromium") && inPath("chromedriver"); }

Browser::Browser(const fs::path& folder) {
    const fs::path said = folder / "chromedriver";
    driver_ = fork();
    if (driver_ == 0) {
        setpgid(0, 0);
        prctl(PR_SET_PDEATHSIG, SIGTERM);  // and it ends what it began
        const int file = ::open(said.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
        dup2(file, STDOUT_FILENO);
        dup2(file, STDERR_FILENO);
        setenv("HOME", folder.c_str(), 1);
        execlp("chromedriver", "chromedriver", "--port=0", nullptr);
        _exit(127);
    }
    port_ = portIn(said);
    const std::string answer = ask(
        "POST", "/session",
        R"({"capabilities":{"alwaysMatch":{"browserName":"chrome","goog:loggingPrefs":{"browser":"ALL"},)"
        R"("goog:chromeOptions":{"args":["--headless=new","--no-sandbox","--disable-gpu",)"
        R"("--disable-dev-shm-usage","--hide-scrollbars","--no-first-run","--mute-audio",)"
        R"("--disable-background-networking","--user-data-dir=)" +
            (folder / "profile").string() + R"("]}}}})");
    const std::vector<std::string> id = valuesOf(answer, "sessionId");
    if (id.empty()) throw std::runtime_error("no browser: " + answer);
    session_ = "/session/" + id[0];
}

Browser::~Browser() {
    try {
        if (!session_.empty()) ask("DELETE", session_, "");
    } catch (const std::runtime_error&) {
        // it is gone already
    }
    kill(-driver_, SIGKILL);  // and what it began
    waitpid(driver_, nullptr, 0);
}

std::string Browser::ask(const std::string& method, const std::string& path,
                         const std::string& body) {
    const int wire = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(static_cast<std::uint16_t>(port_));
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (connect(wire, reinterpret_cast<const sockaddr*>(&to), sizeof to) != 0) {
        close(wire);
        throw std::runtime_error("chromedriver does not answer");
    }
    const std::string request = method + " " + path +
                                " HTTP/1.1\r\nHost: localhost:" + std::to_string(port_) +
                                "\r\nConnection: close\r\nContent-Type: application/json\r\n"
                                "Content-Length: " +
                                std::to_string(body.size()) + "\r\n\r\n" + body;
    for (std::size_t sent = 0; sent < request.size();) {
        const ssize_t n = send(wire, &request[sent], request.size() - sent, MSG_NOSIGNAL);
        if (n <= 0) break;
        sent += static_cast<std::size_t>(n);
    }
    const std::string answer = received(wire);
    close(wire);
    const std::size_t begin = answer.find("\r\n\r\n");
    if (!answer.starts_with("HTTP/1.1 200") || begin == std::string::npos)
        throw std::runtime_error(method + " " + path + ": " + answer.substr(0, 2000));
    return answer.substr(begin + 4);
}

void Browser::open(const std::string& address) {
    command("/url", "{\"url\":" + quoted(address) + "}");
}

std::string Browser::run(const std::string& script) {
    const std::string answer =
        command("/execute/sync",
                "{\"args\":[],\"script\":" +
                    quoted("return (async () => {" + script + "})().then(x => 'x' + x)") + "}");
    const std::vector<std::string> values = valuesOf(answer, "value");
    if (values.empty()) throw std::runtime_error("no answer to " + script + ": " + answer);
    return values[0].substr(1);
}

void Browser::press(const std::string& key) {
    static const std::map<std::string, std::string> codes{{"Tab", "\\uE004"},
                                                          {"Enter", "\\uE007"},
                                                          {"Escape", "\\uE00C"},
                                                          {"ArrowLeft", "\\uE012"},
                                                          {"ArrowRight", "\\uE014"},
                                                          {"ArrowDown", "\\uE015"},
                                                          {"Space", " "}};
    const auto found = codes.find(key);
    const std::string code = found == codes.end() ? key : found->second;
    command("/actions",
            R"({"actions":[{"type":"key","id":"keys","actions":[{"type":"keyDown","value":")" +
                code + R"("},{"type":"keyUp","value":")" + code + R"("}]}]})");
}

std::vector<std::string> Browser::console() {
    return valuesOf(command("/se/log", R"({"type":"browser"})"), "message");
}

std::string Browser::developer(const std::string& name, const std::string& parameters) {
    return command("/goog/cdp/execute", "{\"cmd\":\"" + name + "\",\"params\":" + parameters + "}");
}

void Browser::resize(int width, int height) {
    developer("Emulation.setDeviceMetricsOverride",
              "{\"width\":" + std::to_string(width) + ",\"height\":" + std::to_string(height) +
                  ",\"deviceScaleFactor\":1,\"mobile\":false}");
}

void Browser::emulate(const std::string& medium, const std::string& colors) {
    developer("Emulation.setEmulatedMedia",
              "{\"media\":\"" + medium +
                  "\",\"features\":[{\"name\":\"prefers-color-scheme\",\"value\":\"" + colors +
                  "\"}]}");
}

std::string Browser::picture() {
    const std::vector<std::string> data =
        valuesOf(developer("Page.captureScreenshot", "{\"format\":\"png\"}"), "data");
    const std::string code = data.empty() ? "" : data[0];
    static const std::string letters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0, count = 0;
    for (const char c : code) {
        const std::size_t six = letters.find(c);
        if (six == std::string::npos) break;
        bits = bits << 6 | static_cast<unsigned>(six);
        if ((count += 6) >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 255);
    }
    return bytes;
}

}  // namespace plait::test
