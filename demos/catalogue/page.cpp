#include "page.h"

#include <algorithm>
#include <cctype>

namespace plait {
namespace {

struct MenuItem {
    const char *room, *path, *words;
};
constexpr MenuItem menu[] = {{"scenes", "index.html", "Scenes"},
                             {"constraints", "constraints/index.html", "Constraints"},
                             {"methods", "methods/index.html", "Methods"},
                             {"forces", "forces/index.html", "Forces"},
                             {"dictionary", "dictionary.html", "Dictionary"},
                             {"validated", "validated.html", "Validated"},
                             {"limits", "limits.html", "Limits"}};

std::string navigation(const SitePage& page, const std::string& root) {
    std::string items;
    for (const MenuItem& item : menu)
        items += "<li><a href=\"" + root + item.path + "\"" +
                 (page.room == item.room ? " aria-current=\"true\"" : "") + ">" + item.words +
                 "</a></li>";
    return R"(<header class="top"><a class="name" href=")" + root +
           R"(index.html">Plait</a><nav aria-label="Catalogue"><ul>)" + items +
           "</ul></nav></header>\n";
}

}  // namespace

std::string rootFrom(const std::string& path) {
    std::string root;
    for (long n = std::ranges::count(path, '/'); n > 0; --n) root += "../";
    return root;
}

std::string htmlOf(const SitePage& page) {
    const std::string root = rootFrom(page.path);
    const auto neighbour = [&](const char* name, const std::string& path) {
        return path.empty() ? std::string()
                            : " data-" + std::string(name) + "=\"" + root + escaped(path) + "\"";
    };
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<meta name=\"color-scheme\" content=\"light dark\">\n<title>" +
           escaped(page.title) +
           " · Plait</title>\n<link rel=\"icon\" href=\"data:,\">\n"
           "<link rel=\"stylesheet\" href=\"" +
           root + "style.css\">\n<script src=\"" + root +
           "script.js\" defer></script>\n</head>\n<body" + neighbour("next", page.next) +
           neighbour("previous", page.previous) +
           ">\n<a class=\"skip\" href=\"#content\">Skip to the content</a>\n" +
           navigation(page, root) + "<main id=\"content\" tabindex=\"-1\">\n" + page.body +
           "</main>\n<footer><p>Made by <code>build/plait catalogue</code>. Keys: "
           "<kbd>/</kbd> search, <kbd>l</kbd> lecture, <kbd>?</kbd> help.</p></footer>\n"
           "</body>\n</html>\n";
}

std::string sectionOf(const std::string& id, const std::string& heading, const std::string& html) {
    return "<section id=\"" + id + R"(" class="slide" aria-labelledby=")" + id +
           "-heading\">\n<h2 id=\"" + id + "-heading\">" + escaped(heading) + "</h2>\n" + html +
           "</section>\n";
}

std::string linkTo(const std::string& href, const std::string& words) {
    return "<a href=\"" + escaped(href) + "\">" + escaped(words) + "</a>";
}

std::string escapedLines(const std::string& text) {
    std::string html;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        html += (from == 0 ? "" : "\n") + escaped(text.substr(from, end - from));
        from = end + 1;
    }
    return html;
}

std::string commandLine(const std::string& command) {
    return R"(<pre class="command" tabindex="0" aria-label="command"><code>)" +
           escapedLines(command) + "</code></pre>\n";
}

std::string missing(const std::string& what, const std::string& command) {
    return "<div class=\"missing\"><p>" + escaped(what) + " This makes it:</p>" +
           commandLine(command) + "</div>\n";
}

std::string tableOf(const std::string& caption, const std::vector<std::string>& header,
                    const std::vector<std::vector<std::string>>& rows) {
    std::string html = R"(<div class="wide" tabindex="0" role="region" aria-label=")" +
                       escaped(caption) + "\"><table><caption>" + escaped(caption) +
                       "</caption><thead><tr>";
    for (const std::string& word : header) html += "<th scope=\"col\">" + escaped(word) + "</th>";
    html += "</tr></thead><tbody>\n";
    for (const std::vector<std::string>& row : rows) {
        html += "<tr>";
        for (std::size_t c = 0; c < row.size(); ++c)
            html += c == 0 ? "<th scope=\"row\">" + row[c] + "</th>" : "<td>" + row[c] + "</td>";
        html += "</tr>\n";
    }
    return html + "</tbody></table></div>\n";
}

std::string listOf(const std::vector<std::string>& items) {
    std::string html = "<ul>\n";
    for (const std::string& item : items) html += "<li>" + item + "</li>\n";
    return html + "</ul>\n";
}

std::string slugOf(const std::string& words) {
    std::string slug;
    for (const char c : words)
        if (std::isalnum(static_cast<unsigned char>(c)))
            slug += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (!slug.empty() && slug.back() != '-')
            slug += '-';
    while (slug.ends_with('-')) slug.pop_back();
    return slug;
}

}  // namespace plait
