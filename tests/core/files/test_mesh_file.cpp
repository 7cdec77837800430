#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <string>
#include <utility>

#include <unistd.h>

#include "tests/catch.h"

#include <plait/files/mesh_file.h>

using namespace plait;

namespace {

namespace fs = std::filesystem;
using Triangles = std::vector<std::array<int, 3>>;
using Edges = std::vector<std::array<int, 2>>;

// A folder of this process alone, removed at the end.
class Folder {
public:
    Folder() : path_(fs::temp_directory_path() / ("plait-mesh-" + std::to_string(getpid()))) {
        fs::create_directories(path_);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() { fs::remove_all(path_); }

    fs::path file(const std::string& name) const { return path_ / name; }

    fs::path write(const std::string& name, const std::string& content) const {
        fs::remove(file(name));  // some file systems flush a file that is overwritten
        std::ofstream(file(name), std::ios::binary) << content;
        return file(name);
    }

private:
    fs::path path_;
};

Shape shapeOf(const std::string& name, const std::string& content) {
    const Folder folder;
    return readMesh(folder.write(name, content));
}

// The refusal's message without the folder.
std::string refusal(const std::string& name, const std::string& content) {
    const Folder folder;
    const fs::path path = folder.write(name, content);
    try {
        readMesh(path);
    } catch (const MeshFileError& error) {
        const std::string message = error.what(), file = path.string();
        REQUIRE(message.starts_with(file));
        REQUIRE(message.find('\n') == std::string::npos);
        return name + message.substr(file.size());
    }
    return "accepted";
}

Triangles triangles(const Shape& shape) {
    Triangles all;
    for (int t = 0; t < shape.complex.count(2); ++t) all.push_back(shape.complex.triangle(t));
    return all;
}

// The edges given: those that the closure adds come behind them.
Edges edges(const Shape& shape, int count) {
    Edges first;
    for (int e = 0; e < count; ++e) first.push_back(shape.complex.edge(e));
    return first;
}

// One corner at the origin, three along the axes; a lone point.
const std::string fivePoints = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 -2e-1 +.25\n";

std::string bytes(std::uint64_t value, std::size_t size, bool bigEndian) {
    std::string text;
    for (std::size_t i = 0; i < size; ++i)
        text += static_cast<char>(value >> 8 * (bigEndian ? size - 1 - i : i) & 255);
    return text;
}

// A square and an edge, with properties and elements that nobody asked for between those wanted.
std::string binaryPly(bool bigEndian, float x = 0.5F, unsigned corner = 2) {
    std::string text = "ply\nformat binary_" + std::string(bigEndian ? "big" : "little") +
                       "_endian 1.0\ncomment made by hand\nelement vertex 4\n"
                       "property float x\nproperty uchar red\nproperty double y\nproperty short z\n"
                       "property list ushort float weights\n"
                       "element junk 2\nproperty list uchar int8 numbers\n"
                       "element face 1\nproperty list uchar uint vertex_indices\n"
                       "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n";
    const auto number = [&](std::uint64_t value, std::size_t size) {
        text += bytes(value, size, bigEndian);
    };
    const double y[] = {0.25, 1e-3, 1e10, -7};
    const std::int16_t z[] = {0, 300, -1, -32768};
    for (int i = 0; i < 4; ++i) {
        number(std::bit_cast<std::uint32_t>(i == 0 ? x : static_cast<float>(-i)), 4);
        number(255, 1);
        number(std::bit_cast<std::uint64_t>(y[i]), 8);
        number(static_cast<std::uint16_t>(z[i]), 2);
        number(static_cast<unsigned>(i), 2);
        for (int j = 0; j < i; ++j) number(0x7fc00000, 4);  // not a number, and not wanted
    }
    number(0, 1);
    number(2, 1);
    number(7, 1);
    number(8, 1);
    number(4, 1);
    for (unsigned v : {0U, 1U, corner, 3U}) number(v, 4);
    number(3, 4);
    number(1, 4);
    return text;
}

const std::string asciiHeader =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n";

}  // namespace

TEST_CASE("obj: vertices, faces in all forms, lines, points") {
    const Shape shape =
        shapeOf("all.obj",
                "# comment\r\nmtllib a.mtl\r\no thing\r\nf 1 2 3  # before them\r\n" + fivePoints +
                    "vt 0 0\nvn 0 0 1\n\n\tf 1/1 3/1\t4/1 \nf 1//1 2//1 5//1\n"
                    "f 2/1/1 3/1/1 5/1/1\nf -1 -5 \\\r\n  -2\nl 1 2 3\np 5\ns off\nf 4 3 -1");
    CHECK(shape.positions.size() == 5);
    CHECK(shape.positions[4] == Vec<double>{0.5, -0.2, 0.25});
    CHECK(triangles(shape) ==
          Triangles{{0, 1, 2}, {0, 2, 3}, {0, 1, 4}, {1, 2, 4}, {0, 3, 4}, {2, 4, 3}});
    CHECK(edges(shape, 2) == Edges{{0, 1}, {1, 2}});
}

TEST_CASE("obj: quads are split to the left", "[SH7]") {
    CHECK(triangles(shapeOf("quad.obj", fivePoints + "f 1 2 3 4")) ==
          Triangles{{0, 1, 2}, {0, 2, 3}});
    CHECK(triangles(shapeOf("quad.obj", fivePoints + "f 2 3 4 1")) ==
          Triangles{{1, 2, 3}, {0, 1, 3}});
    const std::string early = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -3\nv 0 0 1\nf -2 -3 4\n";
    CHECK(triangles(shapeOf("early.obj", early)) == Triangles{{0, 2, 1}, {1, 3, 2}});
}

TEST_CASE("obj: curves may close, clouds have no faces, the extension's case is no matter") {
    CHECK(edges(shapeOf("loop.obj", fivePoints + "l 1 2 3 1\n"), 3) ==
          Edges{{0, 1}, {1, 2}, {2, 0}});
    const Shape cloud = shapeOf("CLOUD.OBJ", fivePoints);
    CHECK(cloud.complex.count(0) == 5);
    CHECK(cloud.complex.count(1) == 0);
}

TEST_CASE("obj: what is wrong is refused with file, line and cause") {
    const auto broken = [](const std::string& end) { return refusal("a.obj", fivePoints + end); };
    CHECK(broken("f 1 2 6\n") == "a.obj:6: vertex 6 is not one of 5");
    CHECK(broken("\n\nf 1 2 -6\n") == "a.obj:8: vertex -6 is not one of 5");
    CHECK(broken("f 1 2 0\n") == "a.obj:6: vertex 0: indices count from 1");
    CHECK(broken("f 1 2 2/5\n") == "a.obj:6: a vertex stands twice in a face");
    CHECK(broken("f 1 2\n") == "a.obj:6: a face with fewer than 3 vertices");
    CHECK(broken("f 1 2 x\n") == "a.obj:6: 'x' is not an integer");
    CHECK(broken("f 1 2 3.5\n") == "a.obj:6: '3.5' is not an integer");
    CHECK(broken("f 1 2 3/a\n") == "a.obj:6: '3/a' is not a vertex");
    CHECK(broken("f 1 2 99999999999999999999\n") ==
          "a.obj:6: '99999999999999999999' is out of range");
    CHECK(broken("f 1 \\\n2 \\\n9\n") == "a.obj:6: vertex 9 is not one of 5");
    CHECK(broken("f 1 \\\n2 \\\n3\nf 1 2 9\n") == "a.obj:9: vertex 9 is not one of 5");
    CHECK(broken("# \\\nf 1 2 9\n") == "a.obj:7: vertex 9 is not one of 5");
    CHECK(broken("l 3\n") == "a.obj:6: a line with fewer than 2 vertices");
    CHECK(broken("l 1 2 2\n") == "a.obj:6: an edge joins a vertex to itself");
    CHECK(broken("p 7\n") == "a.obj:6: vertex 7 is not one of 5");
    CHECK(broken("v 1 2\n") == "a.obj:6: a vertex with fewer than 3 coordinates");
    CHECK(broken("v 1 2 three\n") == "a.obj:6: 'three' is not a number");
    CHECK(broken("v 1 2 +-3\n") == "a.obj:6: '+-3' is not a number");
    CHECK(broken("v 1 2 3m\n") == "a.obj:6: '3m' is not a number");
    CHECK(broken("v 1 nan 3\n") == "a.obj:6: 'nan' is not finite");
    CHECK(broken("v 1 -inf 3\n") == "a.obj:6: '-inf' is not finite");
    CHECK(broken("v 1 1e999 3\n") == "a.obj:6: '1e999' is out of range");
    CHECK(broken("curv 0 1\n") == "a.obj:6: unknown statement 'curv'");
    CHECK(broken(std::string("\x02\x01\xff") + std::string(40, 'y')) ==
          "a.obj:6: unknown statement '???yyyyyyyyyyyyyyyyyyyyy...'");
    CHECK(refusal("a.obj", "v 0 0 0\nf 1 2 -2\nv 1 0 0\nv 0 1 0\n") ==
          "a.obj:2: vertex -2 is not one of 1");
    CHECK(refusal("b.obj", "") == "b.obj:0: no vertices");
    CHECK(refusal("b.obj", "# nothing\n") == "b.obj:0: no vertices");
}

TEST_CASE("no file, no mesh file, no format") {
    const Folder folder;
    CHECK_THROWS_WITH(readMesh(folder.file("none.obj")),
                      folder.file("none.obj").string() + ":0: no such file");
    fs::create_directory(folder.file("folder.ply"));
    CHECK_THROWS_WITH(readMesh(folder.file("folder.ply")),
                      folder.file("folder.ply").string() + ":0: not a file");
    CHECK(refusal("a.stl", "solid") == "a.stl:0: neither .obj nor .ply");
    CHECK(refusal("a", "v 0 0 0") == "a:0: neither .obj nor .ply");
}

TEST_CASE("ply: ascii") {
    const Shape shape =
        shapeOf("a.ply",
                "ply\r\nformat ascii 1.0\r\nobj_info none\r\nelement face 2\r\n"
                "property uchar flags\r\nproperty list uint8 int32 vertex_index\r\n"
                "element vertex 5\r\nproperty double y\r\nproperty float32 x\r\n"
                "property int z\r\nproperty float quality\r\nelement edge 1\r\n"
                "property int vertex1\r\nproperty int vertex2\r\n"
                "element nothing 1000000000000\r\nend_header\r\n"
                "7 4 0 1 2 3\r\n\r\n7 3 4 2 1\r\n"
                "0 0 0 nan\r\n0 1 0 0\r\n1 1 0 0\r\n1 0 0 0\r\n0.125 -3.5 -4 0\r\n4 0");
    CHECK(shape.positions.size() == 5);
    CHECK(shape.positions[4] == Vec<double>{-3.5, 0.125, -4});
    CHECK(triangles(shape) == Triangles{{0, 1, 2}, {0, 2, 3}, {1, 4, 2}});
    CHECK(edges(shape, 1) == Edges{{4, 0}});
}

TEST_CASE("ply: binary of both byte orders gives the same mesh") {
    for (bool bigEndian : {false, true}) {
        const Shape shape = shapeOf("b.ply", binaryPly(bigEndian));
        REQUIRE(shape.positions.size() == 4);
        CHECK(shape.positions[0] == Vec<double>{0.5, 0.25, 0});
        CHECK(shape.positions[1] == Vec<double>{-1, 1e-3, 300});
        CHECK(shape.positions[2] == Vec<double>{-2, 1e10, -1});
        CHECK(shape.positions[3] == Vec<double>{-3, -7, -32768});
        CHECK(triangles(shape) == Triangles{{0, 1, 2}, {0, 2, 3}});
        CHECK(edges(shape, 1) == Edges{{3, 1}});
    }
}

TEST_CASE("ply: what is wrong in the header is refused with file, line and cause") {
    const auto broken = [](const std::string& header) { return refusal("a.ply", header); };
    const std::string start = "ply\nformat ascii 1.0\n";
    CHECK(broken("") == "a.ply:1: not a PLY file: it does not start with 'ply'");
    CHECK(broken("plx\n") == "a.ply:1: not a PLY file: it does not start with 'ply'");
    CHECK(broken("ply\nformat ascii 2.0\n") == "a.ply:2: unknown format");
    CHECK(broken("ply\nformat\n") == "a.ply:2: unknown format");
    CHECK(broken("ply\nformat middle_endian 1.0\n") == "a.ply:2: unknown format");
    CHECK(broken("ply\nend_header\n") == "a.ply:2: no format");
    CHECK(broken(start) == "a.ply:3: the header does not end");
    CHECK(broken(start + "elements vertex 3\n") == "a.ply:3: unknown header line 'elements'");
    CHECK(broken(start + "element vertex\n") == "a.ply:3: an element has a name and a count");
    CHECK(broken(start + "element vertex -1\n") == "a.ply:3: a negative count");
    CHECK(broken(start + "element vertex many\n") == "a.ply:3: 'many' is not an integer");
    CHECK(broken(start + "element a 1\nelement a 1\n") == "a.ply:4: element 'a' stands twice");
    CHECK(broken(start + "property int x\n") == "a.ply:3: a property before the first element");
    CHECK(broken(start + "element a 1\nproperty int\n") ==
          "a.ply:4: a property has a type and a name");
    CHECK(broken(start + "element a 1\nproperty half x\n") == "a.ply:4: unknown type 'half'");
    CHECK(broken(start + "element a 1\nproperty list float int x\n") ==
          "a.ply:4: a list's length is an integer");
    CHECK(broken(start + "element vertex 1\nproperty int x\nproperty int x\n") ==
          "a.ply:5: property 'x' stands twice");
    CHECK(broken(start + "element vertex 1\nproperty list int float x\n") ==
          "a.ply:4: property 'x' has the wrong type");
    CHECK(broken(start + "element face 1\nproperty list uchar float vertex_index\n") ==
          "a.ply:4: property 'vertex_index' has the wrong type");
    CHECK(broken(start + "element vertex 1\nproperty int x\nproperty int z\nend_header\n1 1\n") ==
          "a.ply:3: element 'vertex' lacks 'y'");
    CHECK(broken(start + "element face 1\nproperty int colour\nend_header\n1\n") ==
          "a.ply:3: element 'face' lacks 'vertex_indices'");
    CHECK(broken(start + "end_header\n") == "a.ply:0: no vertices");
}

TEST_CASE("ply: counts that lie are refused before they cost anything") {
    const std::string properties = "property float x\nproperty float y\nproperty float z\n";
    const auto claiming = [&](const std::string& count, const std::string& format) {
        std::string text = "ply\nformat " + format;
        text += " 1.0\nelement vertex " + count;
        text += "\n" + properties + "end_header\n0 0 0\n";
        return refusal("a.ply", text);
    };
    for (const char* count : {"2", "4000000000", "9223372036854775807"})
        for (const char* format : {"ascii", "binary_little_endian"})
            CHECK(claiming(count, format) == "a.ply:3: more elements than the file can hold");
    CHECK(refusal("a.ply", "ply\nformat ascii 1.0\nelement vertex 9223372036854775808\n") ==
          "a.ply:3: '9223372036854775808' is out of range");
    CHECK(refusal("a.ply", asciiHeader + "0 0 0\n1 0 0\n0 1 0\n4000000000000 0 1 2\n") ==
          "a.ply:13: the file ends too early (elements and lines part at line 13)");
}

TEST_CASE("ply: what is wrong in the values is refused with file, line or byte, and cause") {
    const auto broken = [](const std::string& values) {
        return refusal("a.ply", asciiHeader + values);
    };
    const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
    CHECK(broken(points + "3 0 1 3\n") == "a.ply:13: a vertex index out of range");
    CHECK(broken(points + "3 0 1 -1\n") == "a.ply:13: a vertex index out of range");
    CHECK(broken(points + "3 0 1 1\n") == "a.ply:13: a vertex stands twice in a face");
    CHECK(broken(points + "2 0 1\n") == "a.ply:13: a face with fewer than 3 vertices");
    CHECK(broken(points + "-3 0 1 2\n") == "a.ply:13: a list of negative length");
    CHECK(broken(points + "3 0 1\n") ==
          "a.ply:13: the file ends too early (elements and lines part at line 13)");
    CHECK(broken(points + "3 0 1 2 0\n") == "a.ply:13: more behind the last element");
    CHECK(broken(points + "3 0 1 2\n\n7\n") == "a.ply:15: more behind the last element");
    CHECK(broken(points + "3 0 1 2.0\n") == "a.ply:13: '2.0' is not an integer");
    CHECK(broken(points + "\n\n\n") == "a.ply:15: the file ends too early");
    CHECK(broken("0 0 0\n1 O 0\n0 1 0\n3 0 1 2\n") == "a.ply:11: 'O' is not a number");
    CHECK(broken("0 0 0\n1 inf 0\n0 1 0\n3 0 1 2\n") == "a.ply:11: 'inf' is not finite");

    for (bool bigEndian : {false, true}) {
        const std::string good = binaryPly(bigEndian);
        const auto fromEnd = [&](std::size_t bytes) { return std::to_string(good.size() - bytes); };
        const std::string values = std::to_string(good.find("end_header\n") + 11);
        CHECK(refusal("b.ply", good.substr(0, good.size() - 1)) ==
              "b.ply:byte " + fromEnd(4) + ": the file ends too early");
        CHECK(refusal("b.ply", good + "x") ==
              "b.ply:byte " + fromEnd(0) + ": more behind the last element");
        const float far = std::numeric_limits<float>::infinity();
        CHECK(refusal("b.ply", binaryPly(bigEndian, far)) ==
              "b.ply:byte " + values + ": a coordinate that is not finite");
        CHECK(refusal("b.ply", binaryPly(bigEndian, far - far)) ==
              "b.ply:byte " + values + ": a coordinate that is not finite");
        CHECK(refusal("b.ply", binaryPly(bigEndian, 0, 4)) ==
              "b.ply:byte " + fromEnd(16) + ": a vertex index out of range");
    }
}

TEST_CASE("files mutilated at random are read or refused, never worse") {
    const Folder folder;
    const std::string obj = fivePoints + "f 1/1 2//2 -3 4/1/1 \\\n5\nl 1 2\np 3\nvn 0 0 1\n";
    const std::string ascii = asciiHeader + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    constexpr int runs = 1000;
    std::mt19937 bits(2);
    int read = 0, refused = 0;
    for (const auto& [name, content] : {std::pair{"a.obj", obj},
                                        {"a.ply", ascii},
                                        {"b.ply", binaryPly(false)},
                                        {"c.ply", binaryPly(true)}})
        for (int run = 0; run < runs; ++run) {
            std::string mutant = content;
            for (unsigned change = bits() % 4 + 1; change > 0; --change) {
                const std::size_t at = bits() % mutant.size();
                switch (bits() % 5) {
                    case 0:
                        mutant[at] = static_cast<char>(bits());
                        break;
                    case 1:
                        mutant[at] = "0123456789-+./e \n\\#"[bits() % 19];
                        break;
                    case 2:
                        mutant.insert(at, mutant.substr(bits() % mutant.size(), bits() % 20));
                        break;
                    case 3:
                        mutant.erase(at, bits() % 8);
                        break;
                    default:
                        mutant.resize(at + 1);
                }
                if (mutant.empty()) mutant = " ";
            }
            try {
                const Shape shape = readMesh(folder.write(name, mutant));
                REQUIRE(shape.complex.count(0) == static_cast<int>(shape.positions.size()));
                ++read;
            } catch (const MeshFileError& error) {
                REQUIRE(std::string(error.what()).find('\n') == std::string::npos);
                ++refused;
            }
        }
    CHECK(read > runs / 10);
    CHECK(refused > runs);
}
