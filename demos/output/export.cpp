#include "export.h"

#include "demos/tools/words.h"

#include <cstdint>

namespace plait {
namespace {

template <class T>
void put(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void putPoints(std::string& bytes, std::span<const Vec<double>> positions) {
    for (const Vec<double>& x : positions)
        for (const double a : {x.x, x.y, x.z}) put(bytes, static_cast<float>(a));
}

// The edges that no triangle has.
std::vector<int> looseEdges(const SimplicialComplex& complex) {
    std::vector<int> loose;
    const std::vector<int> parents = complex.valences(1);
    for (int i = 0; i < complex.count(1); ++i)
        if (parents[static_cast<std::size_t>(i)] == 0) loose.push_back(i);
    return loose;
}

std::string titleOf(const Run& run, const RunFrame& frame) {
    return "plait " + run.entry->name + ", frame " + std::to_string(frame.number) + " at " +
           text(frame.time) + " s, " + text(run.frameRate()) + " frames/s, metres, y up";
}

// As it hangs together in a frame.
SimplicialComplex complexIn(const Run& run, const RunFrame& frame) {
    const World& world = run.scene.world;
    return frame.cuts.empty() ? world.complex : world.tornBy(frame.cuts).complex;
}

void exportPc2(const RunFolder& folder, const Run& run, int last) {
    WholeFile points(folder.exportPath("points.pc2")), mesh(folder.exportPath("points.obj"));
    std::string bytes = pc2Header(run.scene.world.complex.count(0), last + 1);
    for (int i = 0; i <= last; ++i) {
        putPoints(bytes, folder.frame(i).positions);
        points.write(std::as_bytes(std::span(bytes)));
        bytes.clear();
    }
    const RunFrame start = folder.frame(0);
    bytes = objOf(complexIn(run, start), start.positions, titleOf(run, start));
    mesh.write(std::as_bytes(std::span(bytes)));
    points.commit();
    mesh.commit();
}

}  // namespace

const std::vector<std::string>& exportFormats() {
    static const std::vector<std::string> formats{"obj", "ply", "pc2"};
    return formats;
}

void exportRun(const RunFolder& folder, const Run& run, int last, const std::string& format) {
    makeFolder(folder.exportPath(""));
    if (format == "pc2") return exportPc2(folder, run, last);
    const auto write = format == "obj" ? objOf : plyOf;
    for (int i = 0; i <= last; ++i) {
        const RunFrame frame = folder.frame(i);
        writeWhole(folder.exportPath(numbered(i, "." + format)),
                   write(complexIn(run, frame), frame.positions, titleOf(run, frame)));
    }
}

std::string objOf(const SimplicialComplex& complex, std::span<const Vec<double>> positions,
                  const std::string& title) {
    std::string file = "# " + title + "\n";
    for (const Vec<double>& x : positions)
        file += "v " + text(static_cast<float>(x.x)) + " " + text(static_cast<float>(x.y)) + " " +
                text(static_cast<float>(x.z)) + "\n";
    const auto simplex = [&](const char* letter, const auto& vertices) {
        file += letter;
        for (const int v : vertices) file += " " + std::to_string(v + 1);
        file += "\n";
    };
    for (int i = 0; i < complex.count(2); ++i) simplex("f", complex.triangle(i));
    for (const int i : looseEdges(complex)) simplex("l", complex.edge(i));
    return file;
}

std::string plyOf(const SimplicialComplex& complex, std::span<const Vec<double>> positions,
                  const std::string& title) {
    const std::vector<int> loose = looseEdges(complex);
    std::string file = "ply\nformat binary_little_endian 1.0\ncomment " + title +
                       "\nelement vertex " + std::to_string(positions.size()) +
                       "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                       std::to_string(complex.count(2)) +
                       "\nproperty list uchar int vertex_indices\nelement edge " +
                       std::to_string(loose.size()) +
                       "\nproperty int vertex1\nproperty int vertex2\nend_header\n";
    putPoints(file, positions);
    for (int i = 0; i < complex.count(2); ++i) {
        put(file, std::uint8_t{3});
        for (const int v : complex.triangle(i)) put(file, std::int32_t{v});
    }
    for (const int i : loose)
        for (const int v : complex.edge(i)) put(file, std::int32_t{v});
    return file;
}

std::string pc2Header(int points, int samples) {
    std::string header("POINTCACHE2\0", 12);
    put(header, std::int32_t{1});
    put(header, std::int32_t{points});
    put(header, 0.0F);
    put(header, 1.0F);
    put(header, std::int32_t{samples});
    return header;
}

}  // namespace plait
