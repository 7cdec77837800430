#include "markdown.h"

#include "page.h"

#include <regex>
#include <stdexcept>

namespace plait {
namespace {

using LinkOf = std::function<std::string(const std::string&)>;

class MarkdownReader {
public:
    MarkdownReader(const std::vector<std::string>& lines, const LinkOf& linkOf)
        : lines_(lines), linkOf_(linkOf) {}

    MarkdownText read() {
        if (lines_.empty() || !lines_[0].starts_with("# ")) refuse("no \"# title\"");
        text_.title = lines_[0].substr(2);
        for (at_ = 1; at_ < lines_.size();) block();
        return std::move(text_);
    }

private:
    [[noreturn]] void refuse(const std::string& what) const {
        throw std::invalid_argument("line " + std::to_string(begin_ + 1) + ": " + what);
    }

    const std::string& line() const { return lines_[at_]; }
    bool more() const { return at_ < lines_.size(); }
    void add(const std::string& html) {
        (text_.sections.empty() ? text_.lead : text_.sections.back().html) += html;
    }

    void block() {
        begin_ = at_;
        if (line().empty())
            ++at_;
        else if (line().starts_with("## "))
            heading();
        else if (line().starts_with("    "))
            code();
        else if (line().starts_with("- "))
            list();
        else if (line().starts_with("|"))
            table();
        else
            add("<p>" + inlined(paragraph("")) + "</p>\n");
    }

    void heading() {
        tables_ = 0;
        text_.sections.push_back({.heading = line().substr(3), .html = {}});
        ++at_;
    }

    void code() {
        std::string all;
        for (; more() && line().starts_with("    "); ++at_)
            all += (all.empty() ? "" : "\n") + line().substr(4);
        add(commandLine(all));
    }

    // Lines from here to one that is empty or begins something else.
    std::string paragraph(const std::string& indent) {
        static const std::regex other(
            R"(#.*|>.*|!\[.*|[0-9]+\. .*|[-+*] .*|```.*|---.*|===.*|\|.*)");
        std::string all;
        const std::size_t first = at_;
        for (; more() && !line().empty(); ++at_) {
            if (at_ > first && (line().starts_with("- ") || !line().starts_with(indent))) break;
            const std::string words =
                at_ > first || indent.empty() ? line().substr(indent.size()) : line().substr(2);
            if (std::regex_match(words, other) || words.starts_with(' '))
                refuse("\"" + words.substr(0, 12) + "\" is not known here");
            all += (all.empty() ? "" : " ") + words;
        }
        return all;
    }

    void list() {
        std::vector<std::string> items;
        while (more() && line().starts_with("- ")) {
            begin_ = at_;
            items.push_back(inlined(paragraph("  ")));
        }
        add(listOf(items));
    }

    std::vector<std::string> cells() const {
        if (!line().ends_with("|")) refuse("a row of a table does not end in |");
        std::vector<std::string> all;
        for (std::size_t from = 1, to; from < line().size(); from = to + 1) {
            to = line().find('|', from);
            const std::string cell = line().substr(from, to - from);
            const std::size_t first = cell.find_first_not_of(' ');
            all.push_back(first == std::string::npos
                              ? ""
                              : cell.substr(first, cell.find_last_not_of(' ') - first + 1));
        }
        return all;
    }

    void table() {
        const std::vector<std::string> header = cells();
        for (const std::string& word : header)
            if (word.empty()) refuse("a column without a heading");
        ++at_;
        if (!more() || !std::regex_match(line(), std::regex(R"((\|-+)+\|)")))
            refuse("a table without |---| below its headings");
        ++at_;
        std::vector<std::vector<std::string>> rows;
        for (; more() && line().starts_with("|"); ++at_) {
            begin_ = at_;
            rows.emplace_back();
            for (const std::string& cell : cells()) rows.back().push_back(inlined(cell));
            if (rows.back().size() != header.size())
                refuse(std::to_string(rows.back().size()) + " cells under " +
                       std::to_string(header.size()) + " headings");
        }
        const std::string section =
            text_.sections.empty() ? text_.title : text_.sections.back().heading;
        add(tableOf(section + ", table " + std::to_string(++tables_), header, rows));
    }

    std::string inlined(const std::string& words) const {
        std::string html;
        for (std::size_t i = 0; i < words.size();) {
            const std::string mark = words.compare(i, 2, "**") == 0 ? "**" : words.substr(i, 1);
            if (mark == "[") refuse("links are not known here");
            if (mark != "`" && mark != "*" && mark != "**") {
                html += escaped(mark);
                ++i;
                continue;
            }
            const std::size_t from = i + mark.size(), to = words.find(mark, from);
            if (to == std::string::npos) refuse("a " + mark + " that does not close");
            const std::string inner = words.substr(from, to - from);
            html += mark == "`" ? codeOf(inner) : tagged(mark == "*" ? "em" : "strong", inner);
            i = to + mark.size();
        }
        return html;
    }

    std::string tagged(const std::string& tag, const std::string& words) const {
        return "<" + tag + ">" + inlined(words) + "</" + tag + ">";
    }

    std::string codeOf(const std::string& words) const {
        const std::string code = "<code>" + escaped(words) + "</code>", link = linkOf_(words);
        return link.empty() ? code : "<a href=\"" + escaped(link) + "\">" + code + "</a>";
    }

    const std::vector<std::string>& lines_;
    const LinkOf& linkOf_;
    MarkdownText text_;
    std::size_t at_ = 0, begin_ = 0;  // the line to read next; where what is being read begins
    int tables_ = 0;
};

}  // namespace

MarkdownText readMarkdown(const std::vector<std::string>& lines, const LinkOf& linkOf) {
    return MarkdownReader(lines, linkOf).read();
}

}  // namespace plait
