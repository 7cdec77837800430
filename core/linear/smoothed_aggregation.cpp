#include "smoothed_aggregation.h"

#include "multigrid/levels.h"

#include <stdexcept>

namespace plait {

// The finest level, and the coarser ones below it.
struct SmoothedAggregation::Levels {
    using R = Record<3>;

    struct Incidence {
        int edge;
        bool alone;  // its other end is pinned
    };

    struct Arc {
        int other, edge;
        auto operator<=>(const Arc&) const = default;
    };
    using Arcs = std::vector<std::vector<Arc>>;  // by vertex

    Levels(std::span<const int> ends, std::span<const unsigned char> pinned) {
        const Arcs arcs = arcsOf(ends, pinned);
        join(arcs, number(arcs, pinned));
        a.layOut();
        a.own.resize(static_cast<std::size_t>(a.count()));
        for (std::vector<R>* vector : {&x, &r, &z, &q, &p}) vector->resize(a.own.size());
        partial.resize((a.own.size() + sumBlock - 1) / sumBlock);
        places.resize(a.own.size());
        const Aggregates aggregates = mergeNeighbours(a.columns);
        coarse = std::make_unique<CoarseLevels>(quotient(a.columns, aggregates));
        passage = std::make_unique<Prolongator<3>>(a, aggregates, coarse->finest());
        coarse->layOut();
    }

    Arcs arcsOf(std::span<const int> ends, std::span<const unsigned char> pinned);
    std::vector<int> number(const Arcs& arcs, std::span<const unsigned char> pinned);
    void join(const Arcs& arcs, std::span<const int> node);
    void fill(std::span<const Symmetric<float>> vertexBlocks,
              std::span<const Symmetric<float>> edgeBlocks, Workers& workers);

    // z = an approximation of A^-1 r
    void cycle(Workers& workers) {
        a.forward(r, z, q, workers);
        passage->restrict(q, coarse->right(), workers);
        passage->prolong(coarse->cycle(workers), z, workers);
        a.backward(r, z, workers);
    }

    double dot(const std::vector<R>& u, const std::vector<R>& v, Workers& workers) {
        workers.forBlocks(static_cast<int>(partial.size()), 1, [&](int begin, int end) {
            for (int block = begin; block < end; ++block) {
                const std::size_t first = static_cast<std::size_t>(block) * sumBlock;
                double sum = 0;
                for (std::size_t i = first; i < std::min(first + sumBlock, u.size()); ++i)
                    for (int k = 0; k < 3; ++k) sum += double(u[i][k]) * double(v[i][k]);
                partial[block] = sum;
            }
        });
        double sum = 0;
        for (const double part : partial) sum += part;
        return sum;
    }

    static constexpr std::size_t sumBlock = 4096;

    std::size_t vertices = 0, edges = 0;
    std::vector<int> vertexOf;           // by node
    std::vector<int> firstIncidence{0};  // by node, and the end
    std::vector<Incidence> incidences;   // ascending edges at each node
    Csr edgesOf;                         // by entry of a
    BlockRows<3> a;
    std::unique_ptr<Prolongator<3>> passage;
    std::unique_ptr<CoarseLevels> coarse;
    std::vector<Vec<double>> places;  // m, by node
    std::vector<R> x, r, z, q, p;
    std::vector<double> partial;
};

SmoothedAggregation::Levels::Arcs SmoothedAggregation::Levels::arcsOf(
    std::span<const int> ends, std::span<const unsigned char> pinned) {
    vertices = pinned.size();
    edges = ends.size() / 2;
    Arcs arcs(vertices);
    for (std::size_t e = 0; e < edges; ++e)
        for (const int end : {0, 1}) {
            const int v = ends[2 * e + end], other = ends[2 * e + 1 - end];
            if (v < 0 || static_cast<std::size_t>(v) >= vertices)
                throw std::invalid_argument("an edge names a vertex that is not there");
            if (v != other && !pinned[v]) arcs[v].push_back({other, static_cast<int>(e)});
        }
    return arcs;
}

// Numbers the vertices that are not pinned, in `vertexOf`. Returns nodes by vertex, -1 for none.
std::vector<int> SmoothedAggregation::Levels::number(const Arcs& arcs,
                                                     std::span<const unsigned char> pinned) {
    Csr among;
    std::vector<int> list;
    for (const std::vector<Arc>& around : arcs) {
        list.clear();
        for (const Arc& arc : around)
            if (!pinned[arc.other]) list.push_back(arc.other);
        appendSorted(among, list);
    }
    std::vector<int> node(vertices, -1);
    for (const int v : breadthFirst(among))
        if (!pinned[v]) {
            node[v] = static_cast<int>(vertexOf.size());
            vertexOf.push_back(v);
        }
    return node;
}

// Puts the neighbours of each node into the rows of `a`, and notes the edges between them.
void SmoothedAggregation::Levels::join(const Arcs& arcs, std::span<const int> node) {
    std::vector<Arc> to;
    std::vector<int> list;
    for (const int v : vertexOf) {
        to.clear();
        for (const Arc& arc : arcs[v]) {
            incidences.push_back({arc.edge, node[arc.other] < 0});
            if (node[arc.other] >= 0) to.push_back({node[arc.other], arc.edge});
        }
        firstIncidence.push_back(static_cast<int>(incidences.size()));
        std::sort(to.begin(), to.end());
        list.clear();
        for (std::size_t i = 0; i < to.size(); ++i) {
            edgesOf.item.push_back(to[i].edge);
            list.push_back(to[i].other);
            if (i + 1 == to.size() || to[i + 1].other != to[i].other)
                edgesOf.start.push_back(static_cast<int>(edgesOf.item.size()));
        }
        appendSorted(a.columns, list);
    }
}

namespace {

Block<3> blockOf(const Symmetric<float>& h, float sign) {
    Block<3> b{};
    const float columns[3][3] = {{h.xx, h.xy, h.xz}, {h.xy, h.yy, h.yz}, {h.xz, h.yz, h.zz}};
    for (int c = 0; c < 3; ++c)
        for (int k = 0; k < 3; ++k) b.column[c].set(k, sign * columns[c][k]);
    return b;
}

}  // namespace

void SmoothedAggregation::Levels::fill(std::span<const Symmetric<float>> vertexBlocks,
                                       std::span<const Symmetric<float>> edgeBlocks,
                                       Workers& workers) {
    workers.forBlocks(a.count(), 256, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            Symmetric<float> own = vertexBlocks[vertexOf[i]], all = own;
            for (int n = firstIncidence[i]; n < firstIncidence[i + 1]; ++n) {
                const auto [edge, alone] = incidences[n];
                all += edgeBlocks[edge];
                if (alone) own += edgeBlocks[edge];
            }
            a.own[i] = blockOf(own, 1);
            a.diagonal[i] = blockOf(all, 1);
            for (int k = a.columns.start[i]; k < a.columns.start[i + 1]; ++k) {
                Symmetric<float> sum{};
                for (const int edge : edgesOf[k]) sum += edgeBlocks[edge];
                a.off[k] = blockOf(sum, -1);
            }
        }
    });
    a.invert(workers);
}

SmoothedAggregation::SmoothedAggregation(std::span<const int> edges,
                                         std::span<const unsigned char> pinned)
    : levels_(std::make_unique<Levels>(edges, pinned)) {}

SmoothedAggregation::~SmoothedAggregation() = default;

void SmoothedAggregation::setUp(std::span<const Symmetric<float>> vertexBlocks,
                                std::span<const Symmetric<float>> edgeBlocks,
                                std::span<const Vec<double>> positions, Workers& workers) {
    Levels& on = *levels_;
    if (vertexBlocks.size() != on.vertices || positions.size() != on.vertices ||
        edgeBlocks.size() != on.edges)
        throw std::invalid_argument("a block for each vertex and edge is wanted");
    const FlushDenormals flush;
    on.fill(vertexBlocks, edgeBlocks, workers);
    for (std::size_t i = 0; i < on.places.size(); ++i) on.places[i] = positions[on.vertexOf[i]];
    on.coarse->place(*on.passage, on.places);
    on.passage->smooth(on.a, workers);
    on.passage->project(on.a, on.coarse->finest(), workers);
    on.coarse->setUp(workers);
}

double SmoothedAggregation::solve(std::span<Vec<float>> x, int iterations, Workers& workers) {
    Levels& on = *levels_;
    if (x.size() != on.vertices) throw std::invalid_argument("a number for each vertex is wanted");
    const FlushDenormals flush;
    const int nodes = on.a.count();
    for (int i = 0; i < nodes; ++i) {
        const Vec<float>& from = x[on.vertexOf[i]];
        on.r[i].pack[0] = Pack<4>(Pack<4>::V{from.x, from.y, from.z, 0});
        on.x[i] = on.p[i] = Record<3>(0);
    }
    double rz = 0, first = 0;
    for (int n = 0; n < iterations; ++n) {
        on.cycle(workers);
        const double before = rz;
        rz = on.dot(on.r, on.z, workers);
        if (n == 0) first = rz;
        if (!(rz > 0)) break;
        const float beta = n > 0 ? static_cast<float>(rz / before) : 0;
        workers.forBlocks(nodes, 256, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) on.p[i] = on.z[i] + beta * on.p[i];
        });
        workers.forBlocks(nodes, 256, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) on.q[i] = on.a.row(i, on.p);
        });
        const double pq = on.dot(on.p, on.q, workers);
        if (!(pq > 0)) break;
        const float alpha = static_cast<float>(rz / pq);
        workers.forBlocks(nodes, 256, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) {
                on.x[i] = on.x[i] + alpha * on.p[i];
                on.r[i] = on.r[i] - alpha * on.q[i];
            }
        });
    }
    std::fill(x.begin(), x.end(), Vec<float>{0, 0, 0});
    for (int i = 0; i < nodes; ++i) x[on.vertexOf[i]] = {on.x[i][0], on.x[i][1], on.x[i][2]};
    if (rz == 0) return 0;
    return rz > 0 && first > 0 ? std::sqrt(rz / first) : 1;
}

double SmoothedAggregation::multiplications(int iterations) const {
    const Levels& on = *levels_;
    const double cycle = 3 * on.a.multiplications() + on.passage->multiplications();
    return on.passage->setUpMultiplications(on.a) + on.coarse->setUpMultiplications() +
           iterations * (cycle + on.coarse->multiplications());
}

}  // namespace plait
