#include "sources.h"

#include "demos/tools/errors.h"
#include "render/charts/chart.h"  // escaped

#include <algorithm>
#include <sstream>

namespace plait {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> linesOfText(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::size_t indentOf(const std::string& line) {
    const std::size_t first = line.find_first_not_of(' ');
    return first == std::string::npos ? 0 : first;
}

}  // namespace

Sources::Sources(fs::path root) : root_(std::move(root)) {
    for (const char* part : {"core", "scenes", "tests/catalogue.txt"})
        if (!fs::exists(root_ / part))
            throw FileError((root_ / part).string() +
                            ": not there; --sources says where the sources are");
    for (const auto& entry : fs::recursive_directory_iterator(root_ / "scenes"))
        if (entry.path().extension() == ".cpp")
            sceneFiles_.push_back(fs::relative(entry.path(), root_).generic_string());
    std::ranges::sort(sceneFiles_);
}

const std::vector<std::string>& Sources::lines(const std::string& file) const {
    const auto found = lines_.find(file);
    if (found != lines_.end()) return found->second;
    return lines_[file] = linesOfText(readWhole(root_ / file));
}

int Sources::lineOf(const std::string& file, const std::string& words) const {
    const std::vector<std::string>& all = lines(file);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].find(words) != std::string::npos) return static_cast<int>(i) + 1;
    return 0;
}

std::vector<std::string> Sources::opening(const std::string& file) const {
    std::vector<std::string> paragraphs;
    bool open = false;
    for (const std::string& line : lines(file)) {
        if (!line.starts_with("//")) break;
        const std::string words = line.size() > 3 ? line.substr(3) : "";
        if (words.empty()) {
            open = false;
            continue;
        }
        const bool formula = indentOf(words) > 1;
        if (!open || (formula && paragraphs.back()[0] != ' '))
            paragraphs.push_back(words);
        else
            paragraphs.back() += (paragraphs.back()[0] == ' ' ? "\n" : " ") + words;
        open = true;
    }
    return paragraphs;
}

std::string Sources::link(const std::string& file, int line) {
    linked_.insert(file);
    return "source/" + file + ".html" + (line > 0 ? "#L" + std::to_string(line) : "");
}

std::string Sources::listing(const std::string& file) const {
    std::string html = R"(<pre class="listing" tabindex="0" aria-label=")" + escaped(file) + "\">";
    int number = 0;
    for (const std::string& line : lines(file)) {
        const std::string n = std::to_string(++number);
        const std::size_t comment = line.find("//");
        html += R"(<span class="line" id="L)" + n + "\"><a href=\"#L" + n + "\">" + n + "</a>" +
                (comment == std::string::npos ? escaped(line)
                                              : escaped(line.substr(0, comment)) + "<i>" +
                                                    escaped(line.substr(comment)) + "</i>") +
                "\n</span>";
    }
    return html + "</pre>\n";
}

Sources::Place Sources::sceneBuilder(const std::string& scene) const {
    const std::string table = "scenes/scene.cpp";
    const int from = lineOf(table, ".name = \"" + scene + "\",");
    const std::vector<std::string>& all = lines(table);
    for (std::size_t i = from > 0 ? static_cast<std::size_t>(from) : all.size(); i < all.size();
         ++i) {
        const std::size_t at = all[i].find(".build = ");
        if (at == std::string::npos) continue;
        const std::size_t name = at + 9;
        const std::string function = all[i].substr(name, all[i].find('}', name) - name);
        for (const std::string& file : sceneFiles_)
            if (const int line = lineOf(file, "Scene " + function + "("); line > 0)
                return {file, line};
    }
    return {table, from};
}

}  // namespace plait
