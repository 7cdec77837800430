// PLY, ascii and binary: what the header declares, element by element.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "mesh_reader.h"
#include "ply_header.h"

namespace plait {

namespace {

using Type = PlyHeader::Type;

// Values as words, on as many lines as they like.
class AsciiBody {
public:
    AsciiBody(MeshBuilder& mesh, std::string_view rest) : mesh_(mesh), rest_(rest) {}

    void begin() {
        if (next_ < words_.size()) noteLine();
        within_ = false;
    }

    std::string_view skip(Type) {
        if (next_ == words_.size()) {
            if (within_) noteLine();
            if (!nextLine()) mesh_.fail("the file ends too early");
        }
        within_ = true;
        return words_[next_++];
    }

    double value(Type type) {
        const std::string_view word = skip(type);
        return type.kind == Type::Kind::Float ? mesh_.number(word)
                                              : static_cast<double>(mesh_.integer(word));
    }

    bool atEnd() { return next_ == words_.size() && !nextLine(); }

private:
    // Most files have a line for each instance of an element. Where that ends is where a value is
    // missing or too many, if the file is refused later on.
    void noteLine() {
        if (mesh_.note.empty())
            mesh_.note =
                " (elements and lines part at line " + std::to_string(mesh_.position) + ")";
    }

    bool nextLine() {
        words_.clear();
        next_ = 0;
        while (words_.empty() && !rest_.empty()) {
            ++mesh_.position;
            splitWords(takeLine(rest_), words_);
        }
        return !words_.empty();
    }

    MeshBuilder& mesh_;
    std::string_view rest_;
    std::vector<std::string_view> words_;
    std::size_t next_ = 0;
    bool within_ = false;  // an element
};

// Values as bytes, end to end.
class BinaryBody {
public:
    BinaryBody(MeshBuilder& mesh, std::string_view content, std::size_t start, bool bigEndian)
        : mesh_(mesh), content_(content), next_(start), bigEndian_(bigEndian) {
        mesh_.unit = "byte ";
        mesh_.position = start;
    }

    void begin() {}

    std::string_view skip(Type type) {
        mesh_.position = next_;
        if (content_.size() - next_ < type.size) mesh_.fail("the file ends too early");
        next_ += type.size;
        return content_.substr(mesh_.position, type.size);
    }

    double value(Type type) {
        const std::string_view bytes = skip(type);
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < type.size; ++i) {
            const char byte = bytes[bigEndian_ ? i : type.size - 1 - i];
            bits = bits << 8 | static_cast<unsigned char>(byte);
        }
        if (type.kind == Type::Kind::Unsigned) return static_cast<double>(bits);
        if (type.kind == Type::Kind::Float)
            return type.size == 8 ? std::bit_cast<double>(bits)
                                  : std::bit_cast<float>(static_cast<std::uint32_t>(bits));
        const auto unused = 64 - 8 * type.size;  // shifted out and back in, as copies of the sign
        return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
    }

    bool atEnd() {
        mesh_.position = next_;
        return next_ == content_.size();
    }

private:
    MeshBuilder& mesh_;
    std::string_view content_;
    std::size_t next_;
    bool bigEndian_;
};

template <class Body>
class ElementReader {
public:
    ElementReader(MeshBuilder& mesh, const PlyHeader& header, Body body)
        : mesh_(mesh), header_(header), body_(std::move(body)) {
        for (const auto& element : header.elements)
            if (element.name == "vertex") vertexCount_ = static_cast<double>(element.count);
    }

    void read() {
        for (const auto& element : header_.elements) {
            if (element.properties.empty()) continue;
            for (long long i = 0; i < element.count; ++i) {
                body_.begin();
                readOne(element);
            }
        }
        if (!body_.atEnd()) mesh_.fail("more behind the last element");
    }

private:
    void readOne(const PlyHeader::Element& element) {
        std::array<double, 3> slots{};
        corners_.clear();
        for (const auto& property : element.properties) {
            const double length = property.length ? body_.value(*property.length) : 1;
            if (length < 0) mesh_.fail("a list of negative length");
            for (double i = 0; i < length; ++i) {
                if (property.slot == PlyHeader::nowhere) {
                    body_.skip(property.type);
                    continue;
                }
                const double value = body_.value(property.type);
                check(element, value);
                if (property.slot == PlyHeader::corners)
                    corners_.push_back(static_cast<int>(value));
                else
                    slots[property.slot] = value;
            }
        }
        if (element.name == "vertex") mesh_.positions.push_back({slots[0], slots[1], slots[2]});
        if (element.name == "face") mesh_.addFace(corners_);
        if (element.name == "tristrips") mesh_.addStrips(corners_);
        if (element.name == "edge")
            mesh_.addEdge(static_cast<int>(slots[0]), static_cast<int>(slots[1]));
    }

    void check(const PlyHeader::Element& element, double value) const {
        const bool partsStrips = element.name == "tristrips" && value == -1;
        if (element.name == "vertex" && !std::isfinite(value))
            mesh_.fail("a coordinate that is not finite");
        if (element.name != "vertex" && !(value >= 0 && value < vertexCount_) && !partsStrips)
            mesh_.fail("a vertex index out of range");
    }

    MeshBuilder& mesh_;
    const PlyHeader& header_;
    Body body_;
    double vertexCount_ = 0;
    std::vector<int> corners_;
};

}  // namespace

void readPly(MeshBuilder& mesh, std::string_view content) {
    std::string_view rest = textOf(content, mesh);
    mesh.position = 0;
    const PlyHeader header = readPlyHeader(mesh, rest);
    if (header.format == PlyHeader::Format::Ascii) {
        ElementReader(mesh, header, AsciiBody(mesh, rest)).read();
    } else {
        const bool bigEndian = header.format == PlyHeader::Format::BigEndian;
        BinaryBody body(mesh, content, content.size() - rest.size(), bigEndian);
        ElementReader(mesh, header, body).read();
    }
    mesh.note.clear();
}

}  // namespace plait
