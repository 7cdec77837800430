// Text as other programs, systems and people write it: encodings, line ends, layouts.
#include "mesh_text.h"
#include "tests/catch.h"

#include <bit>
#include <cstdint>
#include <utility>

using namespace plait;
using namespace plait::test;

namespace {

const std::string kite = "v 0 0 0\nv 2 -1 0\nv 3 0 0\nv 2 1 0\nf 1 2 3 4\n";
const Triangles kitesTriangles{{0, 1, 2}, {0, 2, 3}};
const std::string mark = "\xef\xbb\xbf";

std::string withEnds(const std::string& text, const std::string& end) {
    std::string changed;
    for (const char c : text) changed += c == '\n' ? end : std::string(1, c);
    return changed;
}

std::string utf16(const std::string& text, bool bigEndian) {
    std::string wide;
    for (const char c : text) wide += bigEndian ? std::string{'\0', c} : std::string{c, '\0'};
    return wide;
}

const std::string points =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string faceList = "element face 1\nproperty list uchar int vertex_indices\n";

std::string ascii(const std::string& elements, const std::string& values) {
    return "ply\nformat ascii 1.0\n" + elements + "end_header\n" + values;
}

void put(std::string& bytes, std::uint32_t value) {
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> 8 * i & 255);
}

// The kite with the lines of its header ending in `end`. Its first value begins with the byte 10.
std::string binaryKite(const std::string& end) {
    std::string text = withEnds(
        "ply\nformat binary_little_endian 1.0\n" + points + faceList + "end_header\n", end);
    put(text, 0x3f80000a);
    for (const float x : {0.F, 0.F, 2.F, -1.F, 0.F, 3.F, 0.F, 0.F, 2.F, 1.F, 0.F})
        put(text, std::bit_cast<std::uint32_t>(x));
    text += '\4';
    for (const std::uint32_t corner : {0U, 1U, 2U, 3U}) put(text, corner);
    return text;
}

}  // namespace

TEST_CASE("text: a byte order mark is no part of the first line", "[files][strangers]") {
    for (const std::string& before : {std::string(), std::string("# made elsewhere\n")})
        CHECK(triangles(shapeOf("a.obj", mark + before + kite)) == kitesTriangles);
    const std::string values = "0 0 0\n2 -1 0\n3 0 0\n2 1 0\n4 0 1 2 3\n";
    CHECK(triangles(shapeOf("a.ply", mark + ascii(points + faceList, values))) == kitesTriangles);
    CHECK(triangles(shapeOf("b.ply", mark + binaryKite("\n"))) == kitesTriangles);
    const std::string cut = mark + binaryKite("\n").substr(0, binaryKite("\n").size() - 1);
    CHECK(refusal("b.ply", cut) ==
          "b.ply:byte " + std::to_string(cut.size() - 3) + ": the file ends too early");
    CHECK(refusal("a.obj", mark) == "a.obj:0: no vertices");
    CHECK(refusal("a.obj", mark + "v 1 2\n") == "a.obj:1: a vertex with fewer than 3 coordinates");
}

TEST_CASE("text: UTF-16, with its mark or without, is told as such", "[files][strangers]") {
    for (const bool bigEndian : {false, true}) {
        const std::string sign = bigEndian ? "\xfe\xff" : "\xff\xfe";
        for (const char* name : {"a.obj", "a.ply"})
            CHECK(refusal(name, sign + utf16(kite, bigEndian)) ==
                  std::string(name) + ":1: UTF-16 text: save it as UTF-8");
        CHECK(refusal("a.obj", utf16(kite, bigEndian)) ==
              "a.obj:1: a zero byte: binary or UTF-16, not plain text");
    }
}

TEST_CASE("text: lines end in LF, CR LF, CR, or each as it likes", "[files][strangers]") {
    const std::string obj = "# a kite\n\no kite\n" + kite;
    const std::string ply =
        ascii("comment a kite\n" + points + faceList, "0 0 0\n2 -1 0\n3 0 0\n2 1 0\n4 0 1 2 3\n");
    for (const char* end : {"\n", "\r\n", "\r", "\r\r\n"}) {
        CHECK(triangles(shapeOf("a.obj", withEnds(obj, end))) == kitesTriangles);
        CHECK(refusal("a.obj", withEnds(obj + "\nf 1 2 9", end)) ==
              "a.obj:10: vertex 9 is not one of 4");
        CHECK(triangles(shapeOf("a.ply", withEnds(ply, end))) == kitesTriangles);
    }
    CHECK(triangles(shapeOf("a.obj", withEnds(obj, "\r") + "# two files in one\r\n" + kite +
                                         withEnds(kite, "\r"))) == kitesTriangles);
    // Behind a header that ends in CR, the first byte of the values may look like an LF.
    for (const char* end : {"\n", "\r\n", "\r"}) {
        const Shape shape = shapeOf("b.ply", binaryKite(end));
        CHECK(triangles(shape) == kitesTriangles);
        CHECK(shape.positions[0].x == double{std::bit_cast<float>(0x3f80000aU)});
    }
}

TEST_CASE("obj: blanks behind a backslash", "[files][strangers]") {
    const std::string start = kite.substr(0, kite.find('f'));
    for (const char* faces :
         {"f 1 2 \\ \n 3 4\n", "f 1 2\\\t \t\n3 4\n", "f \\\r\n1 \\ \r\n2 \\\t\r\n3 4\r\n",
          "f 1 \\  # more below\n2 3 4\n", "f 1 2 3 4 \\ "})
        CHECK(triangles(shapeOf("a.obj", start + faces)) == kitesTriangles);
    CHECK(triangles(shapeOf("a.obj", "v 0 \\ \n 0 \\  \n 0\n" + kite.substr(8))) == kitesTriangles);
    CHECK(refusal("a.obj", start + "f 1 \\ \n 2 9\n") == "a.obj:5: vertex 9 is not one of 4");
}

TEST_CASE("obj: words beyond ASCII, colours, weights, tiny numbers", "[files][strangers]") {
    CHECK(triangles(shapeOf("a.obj",
                            "# Gr\xf6\xdf"
                            "e\no dr\xc3\xa9p\xc3\xa9\ng \xe5\xb8\x83\n" +
                                kite)) == kitesTriangles);
    const Shape shape =
        shapeOf("a.obj", "v 1 2 3 0.5\nv 1 2 4 255 0 0\nv 1e-400 -2E-310 -1e-999 1 0 0 1\n");
    CHECK(shape.positions[0] == Vec<double>{1, 2, 3});
    CHECK(shape.positions[1] == Vec<double>{1, 2, 4});
    CHECK(shape.positions[2] == Vec<double>{0, -2e-310, 0});
    CHECK(refusal("a.obj", "v 1,5 0 0\n") == "a.obj:1: '1,5' is not a number");
    CHECK(refusal("a.obj", kite + "v 1 2 \xe2\x88\x92"
                                  "3\n") == "a.obj:6: '???3' is not a number");
}

TEST_CASE("files that are something else are told so in one line", "[files][strangers]") {
    const std::string pointer =
        "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n";
    for (const char* name : {"a.obj", "a.ply"})
        CHECK(refusal(name, pointer) ==
              std::string(name) +
                  ":0: a pointer of Git LFS in place of the file: get it by git lfs pull");
    CHECK(refusal("a.obj", "<!DOCTYPE html>\n<html>\n") ==
          "a.obj:1: unknown statement '<!DOCTYPE'");
    CHECK(refusal("a.obj", kite + std::string(8, '\0')) ==
          "a.obj:6: a zero byte: binary or UTF-16, not plain text");
    CHECK(refusal("a.ply", kite) == "a.ply:1: not a PLY file: it does not start with 'ply'");
}

TEST_CASE("ply: in ascii, lines end wherever values do", "[files][strangers]") {
    const std::string elements = points + "property float nx\n" + faceList;
    const std::string values = "0 0 0 7 2 -1 0 7 3 0 0 7 2 1 0 7 4 0 1 2 3";
    CHECK(triangles(shapeOf("a.ply", ascii(elements, values))) == kitesTriangles);
    std::string column = values;
    for (char& c : column) c = c == ' ' ? '\n' : c;
    CHECK(triangles(shapeOf("a.ply", ascii(elements, column))) == kitesTriangles);
    CHECK(triangles(shapeOf("a.ply", ascii(elements,
                                           "0 0 0\n7\n2 -1 0\n7\n3 0 0\n\n7\n2 1 0\n7\n"
                                           "4 0 1\n2 3\n\n"))) == kitesTriangles);
    // Where a line lacks a value or has one too many, the message leads there.
    const auto broken = [](const std::string& text) {
        return refusal("a.ply", ascii(points + faceList, text));
    };
    CHECK(broken("0 0 0\n2 -1\n3 0 0\n2 1 0\n4 0 1 2 3\n") ==
          "a.ply:14: a face with fewer than 3 vertices (elements and lines part at line 11)");
    CHECK(broken("0 0 0\n2 -1 0\n3 0 0 5\n2 1 0\n4 0 1 2 3\n") ==
          "a.ply:13: a face with fewer than 3 vertices (elements and lines part at line 12)");
}

TEST_CASE("ply: strips of triangles", "[files][strangers]") {
    const auto strips = [](const std::string& list) {
        return ascii(points + "element tristrips 1\nproperty list int int vertex_indices\n",
                     "0 0 0\n2 -1 0\n3 0 0\n2 1 0\n" + list);
    };
    CHECK(triangles(shapeOf("a.ply", strips("4 0 1 3 2"))) == Triangles{{0, 1, 3}, {1, 2, 3}});
    CHECK(triangles(shapeOf("a.ply", strips("9 0 1 2 -1 2 3 0 -1 -1"))) == kitesTriangles);
    // Repeats lead from a triangle to another, and count as places of the strip.
    CHECK(triangles(shapeOf("a.ply", strips("9 0 1 2 2 0 0 0 2 3"))) == kitesTriangles);
    CHECK(triangles(shapeOf("a.ply", strips("3 -1 -1 -1"))).empty());
    CHECK(refusal("a.ply", strips("3 0 1 -2")) == "a.ply:14: a vertex index out of range");
    CHECK(refusal("a.ply", strips("3 0 1 4")) == "a.ply:14: a vertex index out of range");

    const std::string before =
        ascii("element tristrips 2\nproperty list uchar short vertex_index\n" + points + faceList,
              "3 0 1 2\n0\n0 0 0\n2 -1 0\n3 0 0\n2 1 0\n3 0 2 3\n");
    CHECK(triangles(shapeOf("a.ply", before)) == kitesTriangles);
}

TEST_CASE("ply: what joins vertices and is not read is named", "[files][strangers]") {
    const auto element = [](const std::string& name, const std::string& list) {
        return refusal("a.ply", ascii(points + name + "\nproperty list uchar int " + list + "\n",
                                      "0 0 0 1 0 0 0 1 0 0 0 1 3 0 1 2"));
    };
    CHECK(element("element trifans 1", "vertex_indices") ==
          "a.ply:8: element 'trifans' is not read, but joins vertices");
    CHECK(element("element Face 1", "vertex_index") ==
          "a.ply:8: element 'Face' is not read, but joins vertices");
    CHECK(element("element face 1", "corners") == "a.ply:7: element 'face' lacks 'vertex_indices'");
    CHECK(element("element bones 1", "parents") == "accepted");
    CHECK(element("element tristrips 4000000000", "vertex_indices") ==
          "a.ply:7: more elements than the file can hold");
}
