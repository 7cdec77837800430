// The sources, as pages with numbered lines.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace plait {

class Sources {
public:
    // Throws FileError that names what is not there: `root` has core, scenes and tests.
    explicit Sources(std::filesystem::path root);

    const std::filesystem::path& root() const { return root_; }
    // Of a file from the root, by line; read once. Throws FileError.
    const std::vector<std::string>& lines(const std::string& file) const;
    // From 1 on, of the first line that has `words` in it; 0: none has.
    int lineOf(const std::string& file, const std::string& words) const;
    // The comment with which a file begins, without its slashes, paragraph by paragraph; one that
    // is indented keeps its lines.
    std::vector<std::string> opening(const std::string& file) const;

    // "source/core/solver.h.html#L12", from the root of the site; the file gets a page.
    std::string link(const std::string& file, int line = 0);
    const std::set<std::string>& linked() const { return linked_; }
    // The lines of a file as HTML.
    std::string listing(const std::string& file) const;

    // Where the function of this name, which builds a scene, is.
    struct Place {
        std::string file;
        int line = 0;
    };
    Place sceneBuilder(const std::string& scene) const;

private:
    std::filesystem::path root_;
    mutable std::map<std::string, std::vector<std::string>> lines_;
    std::set<std::string> linked_;
    std::vector<std::string> sceneFiles_;
};

}  // namespace plait
