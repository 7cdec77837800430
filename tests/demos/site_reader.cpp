#include "site_reader.h"

#include <algorithm>
#include <cctype>

namespace plait::test {
namespace {

namespace fs = std::filesystem;

const std::set<std::string> voids{"meta", "link", "img", "br", "input"};

class PageReader {
public:
    explicit PageReader(const std::string& html) : html_(html) {}

    ReadPage read() {
        if (!html_.starts_with("<!DOCTYPE html>")) fault("no doctype");
        for (at_ = html_.find('<', 1); at_ != std::string::npos; at_ = html_.find('<', at_)) tag();
        for (const std::string& name : open_) fault("<" + name + "> does not close");
        checkText();
        return std::move(page_);
    }

private:
    void fault(const std::string& what) { page_.faults.push_back(what); }

    void tag() {
        const std::size_t end = endOfTag();
        const std::string text = html_.substr(at_ + 1, end - at_ - 1);
        at_ = end;
        if (text.starts_with('/')) {
            if (open_.empty() || open_.back() != text.substr(1))
                fault("</" + text.substr(1) + "> closes nothing");
            else
                open_.pop_back();
            return;
        }
        Element element{.name = text.substr(0, text.find(' ')), .attributes = {}};
        readAttributes(text, element);
        if (!voids.contains(element.name)) open_.push_back(element.name);
        page_.elements.push_back(std::move(element));
    }

    // A > within quotes ends nothing.
    std::size_t endOfTag() {
        bool quoted = false;
        for (std::size_t i = at_; i < html_.size(); ++i)
            if (html_[i] == '"')
                quoted = !quoted;
            else if (html_[i] == '>' && !quoted)
                return i;
        fault("a tag does not end");
        return html_.size();
    }

    void readAttributes(const std::string& text, Element& element) {
        std::size_t i = element.name.size();
        while (i < text.size()) {
            if (text[i] != ' ') return fault("attributes of " + text);
            const std::size_t end = std::min(text.find_first_of("= ", ++i), text.size());
            const std::string name = text.substr(i, end - i);
            std::string value;
            i = end;
            if (i < text.size() && text[i] == '=') {
                const std::size_t close = text.find('"', i + 2);
                if (text[i + 1] != '"' || close == std::string::npos)
                    return fault("quotes of " + text);
                value = text.substr(i + 2, close - i - 2);
                i = close + 1;
            }
            if (!element.attributes.emplace(name, value).second) fault(name + " twice in " + text);
            if (name == "id" && !page_.ids.insert(value).second) fault("two of id " + value);
        }
    }

    // An & that begins no entity.
    void checkText() {
        for (std::size_t i = 0; (i = html_.find('&', i)) != std::string::npos; ++i) {
            const std::size_t end = html_.find(';', i);
            if (end == std::string::npos || end - i > 10)
                fault("a lone & at " + html_.substr(i, 20));
        }
    }

    const std::string& html_;
    std::size_t at_ = 0;
    std::vector<std::string> open_;
    ReadPage page_;
};

std::string unescaped(std::string text) {
    for (const auto& [entity, letter] : {std::pair{"&amp;", "&"}, {"&quot;", "\""}, {"&#39;", "'"}})
        for (std::size_t at = 0; (at = text.find(entity, at)) != std::string::npos; ++at)
            text.replace(at, std::string(entity).size(), letter);
    return text;
}

}  // namespace

ReadPage readPage(const std::string& html) { return PageReader(html).read(); }

std::map<std::string, ReadPage> readSite(const fs::path& root) {
    std::map<std::string, ReadPage> pages;
    for (const auto& entry : fs::recursive_directory_iterator(root))
        if (entry.path().extension() == ".html")
            pages.emplace(fs::relative(entry.path(), root).generic_string(),
                          readPage(contents(entry.path())));
    return pages;
}

std::vector<std::string> brokenLinks(const fs::path& root,
                                     const std::map<std::string, ReadPage>& pages) {
    std::vector<std::string> broken;
    const auto check = [&](const std::string& from, const std::string& link) {
        const auto bad = [&](const char* what) {
            broken.push_back(from + ": " + link + ": " + what);
        };
        if (link == "data:,") return;  // an icon that is not fetched
        if (link.find(':') != std::string::npos) return bad("leads elsewhere");
        const std::size_t hash = link.find('#');
        const std::string file = link.substr(0, hash);
        const fs::path to = file.empty() ? fs::path(from)
                                         : (fs::path(from).parent_path() / file).lexically_normal();
        if (to.generic_string().starts_with("..")) return bad("leaves the site");
        if (!fs::is_regular_file(root / to)) return bad("is not there");
        if (hash == std::string::npos || link.find('=', hash) != std::string::npos) return;
        const auto page = pages.find(to.generic_string());
        if (page == pages.end() || !page->second.ids.contains(link.substr(hash + 1)))
            bad("no such place");
    };
    for (const auto& [path, page] : pages)
        for (const Element& element : page.elements)
            for (const char* name :
                 {"href", "src", "poster", "data-next", "data-previous", "srcset", "action"})
                if (const auto found = element.attributes.find(name);
                    found != element.attributes.end())
                    check(path, unescaped(found->second));
    return broken;
}

}  // namespace plait::test
