// Wavefront OBJ. The first pass collects the vertices, the second what joins them, so that faces
// may name vertices that stand further down.
#include <algorithm>
#include <array>

#include "mesh_reader.h"

namespace plait {

namespace {

using Words = std::vector<std::string_view>;

// What the format has beside vertices and faces and a simulation does not need. Free-form curves
// and surfaces are not among them: to skip those would be to lose geometry in silence.
constexpr std::array<std::string_view, 17> skipped{
    "vt",     "vn",     "vp",    "o",        "g",        "s",   "mg",         "usemtl",   "mtllib",
    "usemap", "maplib", "bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj"};

class ObjReader {
public:
    ObjReader(MeshBuilder& mesh, std::string_view text) : mesh_(mesh), text_(text) {}

    void read() {
        forEachStatement([&](const Words& words) { readVertex(words); });
        forEachStatement([&](const Words& words) { readElement(words); });
    }

private:
    // A statement is a line, or several when all but the last end in a backslash and blanks.
    template <class Visit>
    void forEachStatement(const Visit& visit) {
        std::string_view rest = text_;
        std::size_t lines = 0;
        Words words;
        while (!rest.empty()) {
            mesh_.position = lines + 1;
            words.clear();
            bool continues = true;
            while (continues && !rest.empty()) {
                ++lines;
                std::string_view line = takeLine(rest);
                if (line.find('\0') != std::string_view::npos)
                    mesh_.fail("a zero byte: binary or UTF-16, not plain text");
                line = line.substr(0, line.find('#'));
                line = line.substr(0, line.find_last_not_of(blanks) + 1);
                continues = line.ends_with('\\');
                if (continues) line.remove_suffix(1);
                splitWords(line, words);
            }
            if (!words.empty()) visit(words);
        }
    }

    void readVertex(const Words& words) {
        if (words[0] != "v") return;
        if (words.size() < 4) mesh_.fail("a vertex with fewer than 3 coordinates");
        mesh_.positions.push_back(
            {mesh_.number(words[1]), mesh_.number(words[2]), mesh_.number(words[3])});
    }

    void readElement(const Words& words) {
        if (words[0] == "v") {
            ++seen_;
        } else if (words[0] == "f") {
            mesh_.addFace(vertices(words));
        } else if (words[0] == "l") {
            const auto line = vertices(words);
            if (line.size() < 2) mesh_.fail("a line with fewer than 2 vertices");
            for (std::size_t i = 1; i < line.size(); ++i) mesh_.addEdge(line[i - 1], line[i]);
        } else if (words[0] == "p") {
            vertices(words);
        } else if (std::ranges::find(skipped, words[0]) == skipped.end()) {
            mesh_.fail("unknown statement " + quoted(words[0]));
        }
    }

    // Words are v, v/vt, v//vn or v/vt/vn. Indices count from 1, or back from the vertex read last.
    std::vector<int> vertices(const Words& words) const {
        std::vector<int> vertices;
        for (std::size_t i = 1; i < words.size(); ++i) {
            const std::string_view vertex = words[i].substr(0, words[i].find('/'));
            const std::string_view others = words[i].substr(vertex.size());
            const long long index = mesh_.integer(vertex);
            if (others.find_first_not_of("/-0123456789") != std::string_view::npos)
                mesh_.fail(quoted(words[i]) + " is not a vertex");
            if (index == 0) mesh_.fail("vertex 0: indices count from 1");
            const long long total = static_cast<long long>(mesh_.positions.size());
            if (index > total || index < -seen_)
                mesh_.fail("vertex " + std::to_string(index) + " is not one of " +
                           std::to_string(index > 0 ? total : seen_));
            vertices.push_back(static_cast<int>(index > 0 ? index - 1 : seen_ + index));
        }
        return vertices;
    }

    MeshBuilder& mesh_;
    std::string_view text_;
    long long seen_ = 0;  // vertices above the statement
};

}  // namespace

void readObj(MeshBuilder& mesh, std::string_view content) {
    ObjReader(mesh, textOf(content, mesh)).read();
}

}  // namespace plait
