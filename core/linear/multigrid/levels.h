// The coarser levels of smoothed aggregation: bodies, six numbers each, down to one for every
// island of the mesh.
#pragma once

#include "../../numbers/math.h"
#include "prolongator.h"

#include <memory>
#include <span>

namespace plait {

class CoarseLevels {
public:
    // `neighbours` of the finest of them.
    explicit CoarseLevels(Csr neighbours) {
        levels_.push_back(std::make_unique<Level>());
        neighbours_ = std::move(neighbours);
    }
    // Once the columns of the finest are known.
    void layOut();

    BlockRows<6>& finest() { return levels_[0]->a; }
    std::vector<Record<6>>& right() { return levels_[0]->b; }

    // Where bodies are, and how what they consist of moves with them, on all levels.
    void place(Prolongator<3>& fromVertices, std::span<const Vec<double>> vertices);
    // Once the numbers of the finest are known.
    void setUp(Workers& workers);
    // From right(); one cycle.
    const std::vector<Record<6>>& cycle(Workers& workers) { return cycle(0, workers); }

    // Of a cycle; of setUp.
    double multiplications() const;
    double setUpMultiplications() const;

private:
    struct Body {
        Vec<double> centre;  // m
        double radius = 0;   // m, of gyration: the unit of its rotations is 1 / radius
        int count = 0;       // of what it consists of
    };
    struct Level {
        BlockRows<6> a;
        std::vector<Body> bodies;
        std::vector<Record<6>> b, x, r;
        std::unique_ptr<Prolongator<6>> passage;  // none on the last
    };

    static void gather(std::span<const int> aggregates, std::span<const Body> parts,
                       std::vector<Body>& bodies);
    template <int size>
    static void move(Prolongator<size>& passage, std::span<const Body> parts,
                     std::span<const Body> bodies);
    const std::vector<Record<6>>& cycle(std::size_t number, Workers& workers);

    std::vector<std::unique_ptr<Level>> levels_;
    Csr neighbours_;
    std::vector<Body> points_;  // the vertices
};

}  // namespace plait
