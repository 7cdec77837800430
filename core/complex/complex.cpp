#include "complex.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace plait {

namespace {

constexpr const char* names[] = {"point", "edge", "triangle", "tetrahedron"};

int checkedSize(std::size_t size) {
    if (!std::in_range<int>(size))
        throw std::invalid_argument("SimplicialComplex: too many simplices for an int");
    return static_cast<int>(size);
}

template <std::size_t n>
std::vector<int> flattened(const std::vector<std::array<int, n>>& simplices) {
    std::vector<int> table;
    table.reserve(n * simplices.size());
    for (const auto& simplex : simplices) table.insert(table.end(), simplex.begin(), simplex.end());
    return table;
}

// Sorts and returns the sign of the permutation; 0 if a vertex stands twice.
int sortWithSign(std::span<int> vertices) {
    int sign = 1;
    for (std::size_t i = 1; i < vertices.size(); ++i)
        for (std::size_t j = i; j > 0 && vertices[j - 1] >= vertices[j]; --j) {
            if (vertices[j - 1] == vertices[j]) return 0;
            std::swap(vertices[j - 1], vertices[j]);
            sign = -sign;
        }
    return sign;
}

int checkedSign(int k, int i, std::span<int> vertices, int vertexCount) {
    const auto fail = [&](const std::string& cause) {
        throw std::invalid_argument("SimplicialComplex: " + std::string(names[k]) + " " +
                                    std::to_string(i) + ": " + cause);
    };
    for (int v : vertices)
        if (v < 0 || v >= vertexCount)
            fail("vertex " + std::to_string(v) + " is not one of " + std::to_string(vertexCount));
    const int sign = sortWithSign(vertices);
    if (sign == 0) fail("a vertex stands twice");
    return sign;
}

// Row numbers in the lexicographic order of the rows, equal rows by number: one stable counting
// sort for each column, the last column first.
std::vector<int> lexicographicOrder(std::span<const int> table, std::size_t columns,
                                    std::size_t values) {
    std::vector<int> order(table.size() / columns), sorted(order.size());
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t column = columns; column-- > 0;) {
        const auto value = [&](int row) { return table[row * columns + column]; };
        std::vector<int> next(values + 1);
        for (int row : order) ++next[value(row) + 1];
        std::partial_sum(next.begin(), next.end(), next.begin());
        for (int row : order) sorted[next[value(row)]++] = row;
        order.swap(sorted);
    }
    return order;
}

// Equal rows are one simplex: `simplex` of each row, and `row`, the first of each simplex. The rows
// before `given` are numbered as they come, those behind in lexicographic order.
struct Numbering {
    std::vector<int> simplex, row;
};

Numbering numbered(std::span<const int> table, std::size_t columns, std::size_t values, int given) {
    const std::vector<int> order = lexicographicOrder(table, columns, values);
    std::vector<int> first(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto row = [&](int r) { return table.subspan(r * columns, columns); };
        const bool repeats = i > 0 && std::ranges::equal(row(order[i - 1]), row(order[i]));
        first[order[i]] = repeats ? first[order[i - 1]] : order[i];
    }
    Numbering numbering;
    for (int row = 0; row < given; ++row)
        if (first[row] == row) numbering.row.push_back(row);
    for (int row : order)
        if (first[row] == row && row >= given) numbering.row.push_back(row);

    numbering.simplex.resize(order.size());
    for (std::size_t i = 0; i < numbering.row.size(); ++i)
        numbering.simplex[numbering.row[i]] = static_cast<int>(i);
    for (std::size_t row = 0; row < order.size(); ++row)
        numbering.simplex[row] = numbering.simplex[first[row]];
    return numbering;
}

// For each value 0 .. values - 1 the rows of the table that hold it, ascending.
Csr transposed(std::span<const int> table, std::size_t columns, std::size_t values) {
    Csr lists;
    lists.start.assign(values + 1, 0);
    lists.item.resize(table.size());
    for (int value : table) ++lists.start[value + 1];
    std::partial_sum(lists.start.begin(), lists.start.end(), lists.start.begin());
    std::vector<int> next(lists.start.begin(), lists.start.end() - 1);
    for (std::size_t i = 0; i < table.size(); ++i)
        lists.item[next[table[i]]++] = static_cast<int>(i / columns);
    return lists;
}

// Every face of every cell, cell by cell, face j without vertex j.
void appendFaces(std::vector<int>& table, std::span<const int> cells, std::size_t columns) {
    table.reserve(table.size() + cells.size() * (columns - 1));
    for (std::size_t cell = 0; cell < cells.size(); cell += columns)
        for (std::size_t without = 0; without < columns; ++without)
            for (std::size_t j = 0; j < columns; ++j)
                if (j != without) table.push_back(cells[cell + j]);
}

template <std::size_t n>
std::array<int, n> oriented(std::span<const int> vertices, int sign) {
    std::array<int, n> order;
    std::copy(vertices.begin(), vertices.end(), order.begin());
    if (sign < 0) std::swap(order[n - 2], order[n - 1]);
    return order;
}

int orientation(int sign) { return sign < 0 ? -1 : 1; }

}  // namespace

SimplicialComplex::SimplicialComplex(int vertexCount, const Simplices& given) {
    if (vertexCount < 0) throw std::invalid_argument("SimplicialComplex: negative vertex count");
    auto& [points, edges, triangles, tetrahedra] = layers_;
    Layer none;
    tetrahedra = makeLayer(3, vertexCount, flattened(given.tetrahedra), none);
    triangles = makeLayer(2, vertexCount, flattened(given.triangles), tetrahedra);
    edges = makeLayer(1, vertexCount, flattened(given.edges), triangles);

    points.vertices.resize(vertexCount);
    std::iota(points.vertices.begin(), points.vertices.end(), 0);
    points.signs.assign(vertexCount, 1);
    checkedSize(edges.vertices.size());
    edges.faces = edges.vertices;
    for (std::size_t i = 0; i < edges.faces.size(); i += 2)
        std::swap(edges.faces[i], edges.faces[i + 1]);
}

// The layer of dimension k from what was given (as a table) and the faces of the layer above,
// whose `faces` it fills.
SimplicialComplex::Layer SimplicialComplex::makeLayer(int k, int vertexCount,
                                                      std::vector<int> table, Layer& above) {
    const std::size_t columns = k + 1;
    const int given = checkedSize(table.size() / columns);
    checkedSize(table.size() / columns + above.vertices.size());
    std::vector<int> givenSigns(given);
    for (int i = 0; i < given; ++i)
        givenSigns[i] =
            checkedSign(k, i, std::span(table).subspan(i * columns, columns), vertexCount);
    appendFaces(table, above.vertices, columns + 1);

    const auto [simplex, row] = numbered(table, columns, vertexCount, given);
    Layer layer;
    layer.vertices.reserve(row.size() * columns);
    layer.signs.reserve(row.size());
    for (int r : row) {
        for (std::size_t j = 0; j < columns; ++j) layer.vertices.push_back(table[r * columns + j]);
        layer.signs.push_back(r < given ? givenSigns[r] : 1);
    }
    for (int r = 0; r < given; ++r)
        if (int& sign = layer.signs[simplex[r]]; sign != givenSigns[r]) sign = 0;
    above.faces.assign(simplex.begin() + given, simplex.end());
    return layer;
}

const SimplicialComplex::Layer& SimplicialComplex::layer(int k) const {
    if (k < 0 || k > maxDimension)
        throw std::invalid_argument("SimplicialComplex: dimension " + std::to_string(k) +
                                    " is not 0 to 3");
    return layers_[k];
}

int SimplicialComplex::count(int k) const { return static_cast<int>(layer(k).signs.size()); }

int SimplicialComplex::incidence(int k, int i, int j) const {
    const int alternating = j % 2 == 0 ? 1 : -1;
    return orientation(sign(k, i)) * alternating * orientation(sign(k - 1, faces(k, i)[j]));
}

std::array<int, 2> SimplicialComplex::edge(int i) const {
    return oriented<2>(vertices(1, i), sign(1, i));
}

std::array<int, 3> SimplicialComplex::triangle(int i) const {
    return oriented<3>(vertices(2, i), sign(2, i));
}

std::array<int, 4> SimplicialComplex::tetrahedron(int i) const {
    return oriented<4>(vertices(3, i), sign(3, i));
}

Csr SimplicialComplex::parents(int k) const {
    const int rows = count(k);
    if (k == maxDimension) return transposed({}, 1, rows);
    return transposed(layer(k + 1).faces, k + 2, rows);
}

std::vector<int> SimplicialComplex::valences(int k) const {
    std::vector<int> valences(count(k));
    if (k < maxDimension)
        for (int face : layer(k + 1).faces) ++valences[face];
    return valences;
}

std::vector<int> SimplicialComplex::boundary(int k) const {
    const std::vector<int> parents = valences(k);
    std::vector<int> boundary;
    for (int i = 0; i < count(k); ++i)
        if (parents[i] == 1) boundary.push_back(i);
    return boundary;
}

std::vector<Hinge> SimplicialComplex::hinges() const {
    const Csr triangles = parents(1);
    std::vector<Hinge> hinges;
    for (int e = 0; e < count(1); ++e) {
        const auto around = triangles[e];
        const auto place = [&](int t) {
            return std::ranges::find(faces(2, t), e) - faces(2, t).begin();
        };
        const auto opposite = [&](int t) { return vertices(2, t)[place(t)]; };
        for (std::size_t a = 0; a < around.size(); ++a)
            for (std::size_t b = a + 1; b < around.size(); ++b) {
                const int t = around[a];
                const bool along = orientation(sign(2, t)) == (place(t) % 2 == 0 ? 1 : -1);
                const auto ends = oriented<2>(vertices(1, e), along ? 1 : -1);
                hinges.push_back({{ends[0], ends[1], opposite(t), opposite(around[b])}, e});
            }
    }
    return hinges;
}

Csr SimplicialComplex::oneRing() const {
    Csr ring = parents(0);
    for (int v = 0; v < ring.size(); ++v) {
        const auto row = std::span(ring.item).subspan(ring.start[v], ring[v].size());
        for (int& item : row) item = vertices(1, item)[vertices(1, item)[0] == v ? 1 : 0];
        std::ranges::sort(row);
    }
    return ring;
}

int SimplicialComplex::eulerCharacteristic() const {
    return count(0) - count(1) + count(2) - count(3);
}

Range SimplicialComplex::append(const SimplicialComplex& other) {
    std::array<int, maxDimension + 1> before;
    for (int k = 0; k <= maxDimension; ++k) {
        before[k] = count(k);
        checkedSize((layer(k).signs.size() + other.layer(k).signs.size()) * (k + 1));
    }
    // Sizes are read before they grow: `other` may be this complex itself.
    const auto join = [](std::vector<int>& mine, const std::vector<int>& others, int shift) {
        const std::size_t old = mine.size(), added = others.size();
        mine.resize(old + added);
        for (std::size_t i = 0; i < added; ++i) mine[old + i] = others[i] + shift;
    };
    for (std::size_t k = 0; k < layers_.size(); ++k) {
        join(layers_[k].vertices, other.layers_[k].vertices, before[0]);
        join(layers_[k].faces, other.layers_[k].faces, k > 0 ? before[k - 1] : 0);
        join(layers_[k].signs, other.layers_[k].signs, 0);
    }
    return {before[0], count(0)};
}

}  // namespace plait
