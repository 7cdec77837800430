// The little of Markdown that tests/validated.md and tests/limits.md are written in.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace plait {

struct MarkdownSection {
    std::string heading;  // text
    std::string html;
};

struct MarkdownText {
    std::string title;  // text
    std::string lead;   // HTML: what stands between the title and the first heading
    std::vector<MarkdownSection> sections;
};

// One "# title", "## headings", paragraphs, "- " lists of one level, tables whose columns all have
// a heading, code indented by four spaces, `code`, *emphasis* and **strong**. `linkOf` is asked
// where a word in `code` leads; "" is nowhere. A table is named after its section. Throws
// std::invalid_argument, "line N: what is wrong", for whatever else it finds.
MarkdownText readMarkdown(const std::vector<std::string>& lines,
                          const std::function<std::string(const std::string& code)>& linkOf);

}  // namespace plait
