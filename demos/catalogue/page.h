// The frame of every page of the catalogue, and what pages are made of.
#pragma once

#include "render/charts/chart.h"  // escaped

#include <string>
#include <vector>

namespace plait {

struct SitePage {
    std::string path;  // "scenes/flag.html", from the root of the site
    std::string title;
    std::string room;  // which word of the menu it belongs to: "scenes", "dictionary", ...
    std::string body;  // HTML, its links from the page
    std::string next = {}, previous = {};  // paths, for the lecture; "" for none
};

// "", "../", "../../": from a page at `path` to the root of the site.
std::string rootFrom(const std::string& path);

// The whole page.
std::string htmlOf(const SitePage& page);

// A section with a heading, one thing at a time in the lecture; `id` is its place on the page.
std::string sectionOf(const std::string& id, const std::string& heading, const std::string& html);

// <a href>; `words` are text.
std::string linkTo(const std::string& href, const std::string& words);
// Text whose lines stay lines, for <pre>.
std::string escapedLines(const std::string& text);
// A command to copy, in a line of its own, or some below each other; and what makes something that
// is not there yet.
std::string commandLine(const std::string& command);
std::string missing(const std::string& what, const std::string& command);
// Rows of HTML cells beneath a header of text, in a box that scrolls by itself.
std::string tableOf(const std::string& caption, const std::vector<std::string>& header,
                    const std::vector<std::vector<std::string>>& rows);
std::string listOf(const std::vector<std::string>& items);

// As a part of an address: letters, digits and dashes.
std::string slugOf(const std::string& words);

}  // namespace plait
