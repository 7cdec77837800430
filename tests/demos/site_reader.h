// Pages of the catalogue, read as strictly as XML is but for HTML's void elements.
#pragma once

#include "program.h"

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace plait::test {

struct Element {
    std::string name;
    std::map<std::string, std::string> attributes;  // as written
};

struct ReadPage {
    std::vector<Element> elements;  // in their order
    std::set<std::string> ids;
    std::vector<std::string> faults;  // a line each: what does not close, what is written twice

    std::vector<const Element*> named(const std::string& name) const {
        std::vector<const Element*> found;
        for (const Element& element : elements)
            if (element.name == name) found.push_back(&element);
        return found;
    }
};

ReadPage readPage(const std::string& html);

// All pages of a site, by their path from its root.
std::map<std::string, ReadPage> readSite(const std::filesystem::path& root);

// What does not resolve, a line each: links, clips and pictures to files that are not there or to
// places that their page has not, and whatever would be fetched from elsewhere.
std::vector<std::string> brokenLinks(const std::filesystem::path& root,
                                     const std::map<std::string, ReadPage>& pages);

}  // namespace plait::test
