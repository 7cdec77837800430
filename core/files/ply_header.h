// The header of a PLY file; not for use outside its reader.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "mesh_reader.h"

namespace plait {

// The header's own view of the file: all names point into it.
struct PlyHeader {
    enum class Format { Ascii, LittleEndian, BigEndian };

    struct Type {
        enum class Kind { Signed, Unsigned, Float } kind;
        std::size_t size;
    };

    // Where the mesh wants a value: a coordinate or an end of an edge (0 to 2), the corners of a
    // face, or nowhere.
    static constexpr int corners = 3;
    static constexpr int nowhere = -1;

    struct Property {
        std::string_view name;
        Type type;
        std::optional<Type> length;  // of a list
        int slot = nowhere;
    };

    struct Element {
        std::string_view name;
        long long count;
        std::size_t line;
        std::vector<Property> properties;
    };

    std::optional<Format> format;
    std::vector<Element> elements;
};

// Takes the header, with its last line, off `rest`; leaves the number of that line in the builder.
// Counts are held against what is left of the file: none that lies is believed.
PlyHeader readPlyHeader(MeshBuilder& mesh, std::string_view& rest);

}  // namespace plait
