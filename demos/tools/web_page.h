// Pages of charts and tables, in the look book's colours.
#pragma once

#include <string>

namespace plait {

// The whole page; `title` is text, `body` is HTML.
std::string webPage(const std::string& title, const std::string& body);

// A chart beside the page, FILE.svg, with the words for those who cannot see it.
std::string pictureLine(const std::string& file, const std::string& words);
// What made the page, and on which machine.
std::string commandLines(const std::string& command);

}  // namespace plait
