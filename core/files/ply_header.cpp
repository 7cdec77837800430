#include "ply_header.h"

#include <algorithm>
#include <array>
#include <utility>

namespace plait {

namespace {

using Type = PlyHeader::Type;
using Property = PlyHeader::Property;
using Element = PlyHeader::Element;

struct Wanted {
    std::string_view element, property;
    int slot;
    bool integer;
};

constexpr Wanted wanted[] = {
    {"vertex", "x", 0, false},
    {"vertex", "y", 1, false},
    {"vertex", "z", 2, false},
    {"face", "vertex_indices", PlyHeader::corners, true},
    {"face", "vertex_index", PlyHeader::corners, true},
    {"tristrips", "vertex_indices", PlyHeader::corners, true},
    {"tristrips", "vertex_index", PlyHeader::corners, true},
    {"edge", "vertex1", 0, true},
    {"edge", "vertex2", 1, true},
};

std::optional<Type> typeNamed(std::string_view name) {
    using enum Type::Kind;
    struct Named {
        std::string_view name, other;
        Type type;
    };
    static constexpr Named types[] = {
        {"char", "int8", {Signed, 1}},    {"uchar", "uint8", {Unsigned, 1}},
        {"short", "int16", {Signed, 2}},  {"ushort", "uint16", {Unsigned, 2}},
        {"int", "int32", {Signed, 4}},    {"uint", "uint32", {Unsigned, 4}},
        {"float", "float32", {Float, 4}}, {"double", "float64", {Float, 8}}};
    for (const Named& type : types)
        if (name == type.name || name == type.other) return type.type;
    return {};
}

class HeaderReader {
public:
    HeaderReader(MeshBuilder& mesh, std::string_view& rest) : mesh_(mesh), rest_(rest) {
        const std::size_t behind = rest.find_first_not_of('\r', rest.find_first_of("\r\n"));
        lineEnd_ = behind < rest.size() && rest[behind] == '\n' ? '\n' : '\r';
    }

    PlyHeader read() {
        if (!nextLine() || words_ != Words{"ply"})
            mesh_.fail("not a PLY file: it does not start with 'ply'");
        while (nextLine()) {
            if (words_.empty() || words_[0] == "comment" || words_[0] == "obj_info") continue;
            if (words_[0] == "end_header") return finished();
            if (words_[0] == "format")
                readFormat();
            else if (words_[0] == "element")
                readElement();
            else if (words_[0] == "property")
                readProperty();
            else
                mesh_.fail("unknown header line " + quoted(words_[0]));
        }
        mesh_.fail("the header does not end");
    }

private:
    using Words = std::vector<std::string_view>;

    bool nextLine() {
        ++mesh_.position;
        words_.clear();
        if (rest_.empty()) return false;
        const std::size_t length = std::min(rest_.find(lineEnd_), rest_.size() - 1) + 1;
        splitWords(rest_.substr(0, length), words_);
        rest_.remove_prefix(length);
        return true;
    }

    void readFormat() {
        constexpr std::array<std::string_view, 3> formats{"ascii", "binary_little_endian",
                                                          "binary_big_endian"};
        const auto format = std::ranges::find(formats, words_.size() == 3 ? words_[1] : "");
        if (format == formats.end() || words_[2] != "1.0") mesh_.fail("unknown format");
        header_.format = PlyHeader::Format(format - formats.begin());
    }

    void readElement() {
        if (words_.size() != 3) mesh_.fail("an element has a name and a count");
        const long long count = mesh_.integer(words_[2]);
        if (count < 0) mesh_.fail("a negative count");
        for (const Element& element : header_.elements)
            if (element.name == words_[1])
                mesh_.fail("element " + quoted(words_[1]) + " stands twice");
        header_.elements.push_back({words_[1], count, mesh_.position, {}});
    }

    void readProperty() {
        if (header_.elements.empty()) mesh_.fail("a property before the first element");
        Element& element = header_.elements.back();
        const bool isList = words_.size() == 5 && words_[1] == "list";
        if (words_.size() != 3 && !isList) mesh_.fail("a property has a type and a name");
        Property property{
            .name = words_.back(), .type = type(words_[words_.size() - 2]), .length = {}};
        if (isList) property.length = type(words_[2]);
        if (isList && property.length->kind == Type::Kind::Float)
            mesh_.fail("a list's length is an integer");
        for (const Wanted& want : wanted)
            if (want.element == element.name && want.property == property.name)
                accept(element, property, want);
        const bool joins = property.name == "vertex_indices" || property.name == "vertex_index";
        if (joins && property.slot == PlyHeader::nowhere && element.count > 0)
            mesh_.fail("element " + quoted(element.name) + " is not read, but joins vertices");
        element.properties.push_back(property);
    }

    void accept(const Element& element, Property& property, const Wanted& want) const {
        for (const Property& other : element.properties)
            if (other.slot == want.slot)
                mesh_.fail("property " + quoted(property.name) + " stands twice");
        if (property.length.has_value() != (want.slot == PlyHeader::corners) ||
            (want.integer && property.type.kind == Type::Kind::Float))
            mesh_.fail("property " + quoted(property.name) + " has the wrong type");
        property.slot = want.slot;
    }

    Type type(std::string_view name) const {
        const auto type = typeNamed(name);
        if (!type) mesh_.fail("unknown type " + quoted(name));
        return *type;
    }

    PlyHeader finished() {
        if (!header_.format) mesh_.fail("no format");
        const std::size_t lastLine = mesh_.position;
        std::size_t left = rest_.size() + 1;  // an ascii file may end without a line end
        for (const Element& element : header_.elements) {
            mesh_.position = element.line;
            std::size_t least = 0;
            for (const Property& property : element.properties)
                least += header_.format == PlyHeader::Format::Ascii
                             ? 2
                             : property.length.value_or(property.type).size;
            if (least > 0 && static_cast<std::size_t>(element.count) > left / least)
                mesh_.fail("more elements than the file can hold");
            left -= static_cast<std::size_t>(element.count) * least;
            requireAllWanted(element);
        }
        mesh_.position = lastLine;
        return std::move(header_);
    }

    void requireAllWanted(const Element& element) const {
        for (const Wanted& want : wanted)
            if (want.element == element.name &&
                std::ranges::find(element.properties, want.slot, &Property::slot) ==
                    element.properties.end())
                mesh_.fail("element " + quoted(element.name) + " lacks " + quoted(want.property));
    }

    MeshBuilder& mesh_;
    std::string_view& rest_;
    char lineEnd_;  // of every line as of the first: behind a "\r", a "\n" may be a binary value
    Words words_;
    PlyHeader header_;
};

}  // namespace

PlyHeader readPlyHeader(MeshBuilder& mesh, std::string_view& rest) {
    return HeaderReader(mesh, rest).read();
}

}  // namespace plait
