// Which files a pattern means, and in which order; extensions in capitals.
#include "mesh_text.h"
#include "tests/catch.h"

#include <plait/files/mesh_sequence.h>

#include <cstring>

using namespace plait;
using namespace plait::test;

namespace {

// A triangle at x, to tell meshes apart by.
std::string triangleAt(int x) {
    const std::string place = std::to_string(x);
    return "v " + place + " 0 0\nv " + place + " 1 0\nv " + place + " 0 1\nf 1 2 3\n";
}

using Places = std::vector<int>;

// Where the triangles are, in the sequence's order.
Places placesOf(const std::filesystem::path& pattern) {
    const MeshSequence sequence(pattern, {.frameRate = 1, .smooth = false});
    Places places;
    std::vector<Vec<double>> x = sequence.first().positions;
    for (int i = 0; i < sequence.count(); ++i) {
        sequence(i, x);
        places.push_back(static_cast<int>(x[0].x));
    }
    return places;
}

// The order in which files of these names are taken, by the places of the names.
Places orderOf(const std::vector<std::string>& names, const std::string& pattern) {
    const ScratchFolder folder;
    for (std::size_t i = 0; i < names.size(); ++i)
        write(folder / names[i], triangleAt(static_cast<int>(i)));
    return placesOf(folder / pattern);
}

std::string refusalOf(const std::vector<std::string>& names, const std::string& pattern) {
    const ScratchFolder folder;
    for (const std::string& name : names) write(folder / name, triangleAt(0));
    return refusalIn(folder, [&] { MeshSequence{folder / pattern}; });
}

void writeCache(const std::filesystem::path& path) {
    std::string bytes("POINTCACHE2\0", 12);
    const std::int32_t version = 1, points = 3, samples = 1;
    const float first = 0, spacing = 1, place[9] = {5};
    for (const void* word : {static_cast<const void*>(&version), static_cast<const void*>(&points),
                             static_cast<const void*>(&first), static_cast<const void*>(&spacing),
                             static_cast<const void*>(&samples)})
        bytes.append(static_cast<const char*>(word), 4);
    bytes.append(reinterpret_cast<const char*>(place), sizeof place);
    write(path, bytes);
}

}  // namespace

TEST_CASE("pattern: a star means no hidden file", "[sequence][strangers]") {
    const std::vector<std::string> names{"b1.obj", "b2.obj", "._b1.obj", "._b2.obj", ".b7.obj"};
    CHECK(orderOf(names, "*.obj") == Places{0, 1});
    CHECK(orderOf(names, "b*.obj") == Places{0, 1});
    CHECK(orderOf(names, ".b*.obj") == Places{4});
    CHECK(orderOf(names, "._*.obj") == Places{2, 3});
    CHECK(refusalOf({".x1.obj"}, "*.obj") == "*.obj:0: no file matches");
}

TEST_CASE("pattern: a minus is a sign unless a letter or digit is before it",
          "[sequence][strangers]") {
    CHECK(orderOf({"f.0000.obj", "f.-0001.obj", "f.0001.obj"}, "f.*.obj") == Places{1, 0, 2});
    CHECK(orderOf({"f_1.obj", "f_0.obj", "f_-1.obj", "f_-2.obj"}, "*.obj") == Places{3, 2, 1, 0});
    CHECK(orderOf({"-2.obj", "-1.obj", "0.obj"}, "*.obj") == Places{0, 1, 2});
    CHECK(orderOf({"f-0.obj", "f--1.obj"}, "f-*.obj") == Places{1, 0});
    CHECK(orderOf({"f.-10.obj", "f.-9.obj"}, "f.-*.obj") == Places{0, 1});
    for (const char* pattern : {"f*.obj", "f-*.obj", "*.obj"})
        CHECK(orderOf({"f-0001.obj", "f-0002.obj", "f-0003.obj"}, pattern) == Places{0, 1, 2});
    CHECK(orderOf({"take2-8.obj", "take2-9.obj", "take2-10.obj"}, "take*.obj") == Places{0, 1, 2});
    CHECK(orderOf({"gr\xc3\xbc-1.obj", "gr\xc3\xbc-2.obj"}, "*.obj") == Places{0, 1});

    CHECK(refusalOf({"f-1.obj", "f0.obj", "f2.obj"}, "f*.obj") ==
          "f-1.obj:0: its - may be a dash or a sign: f2.obj has none");
    CHECK(refusalOf({"f.-2.obj", "f.0.obj", "f.1.obj"}, "f.*.obj") ==
          "f.1.obj:0: no file of number 2 before this one");
    CHECK(refusalOf({"f.-0.obj", "f.0.obj"}, "f.*.obj").find("the same number as") !=
          std::string::npos);
}

TEST_CASE("extensions: in capitals as in small letters", "[sequence][strangers]") {
    CHECK(orderOf({"B1.OBJ", "B2.OBJ"}, "B*.OBJ") == Places{0, 1});
    CHECK(orderOf({"B1.Obj", "B2.Obj"}, "*.Obj") == Places{0, 1});
    for (const char* cache : {"body.PC2", "body.pc2", "body.Pc2"})
        for (const char* mesh : {"body.obj", "body.OBJ", "body.Obj"}) {
            const ScratchFolder folder;
            write(folder / mesh, triangleAt(0));
            write(folder / "body2.obj", "");
            writeCache(folder / cache);
            CHECK(placesOf(folder / cache) == Places{5});
        }
    const ScratchFolder folder;
    writeCache(folder / "c.PC2");
    write(folder / "c.OBJ", "v 0 0 0\n");
    CHECK(refusalIn(folder, [&] { MeshSequence{folder / "c.PC2"}; }) ==
          "c.PC2:byte 16: 3 points, but the mesh has 1 vertices");
    write(folder / "c.obj", triangleAt(0));
    CHECK(placesOf(folder / "c.PC2") == Places{5});
    write(folder / "c.PC2", "version https://git-lfs.github.com/spec/v1\n");
    CHECK(refusalIn(folder, [&] { MeshSequence{folder / "c.PC2"}; }) ==
          "c.PC2:0: a pointer of Git LFS in place of the file: get it by git lfs pull");
}
