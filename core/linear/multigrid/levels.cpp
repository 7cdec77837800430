#include "levels.h"

#include <cmath>

namespace plait {

void CoarseLevels::layOut() {
    for (;;) {
        Level& level = *levels_.back();
        const auto bodies = static_cast<std::size_t>(level.a.count());
        level.bodies.resize(bodies);
        for (auto* vector : {&level.b, &level.x, &level.r}) vector->resize(bodies);
        if (neighbours_.item.empty()) break;
        const Aggregates aggregates = mergeNeighbours(neighbours_);
        auto next = std::make_unique<Level>();
        level.passage = std::make_unique<Prolongator<6>>(level.a, aggregates, next->a);
        neighbours_ = quotient(neighbours_, aggregates);
        levels_.push_back(std::move(next));
    }
}

void CoarseLevels::gather(std::span<const int> aggregates, std::span<const Body> parts,
                          std::vector<Body>& bodies) {
    for (Body& body : bodies) body = {{0, 0, 0}, 0, 0};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        bodies[aggregates[i]].centre += parts[i].centre;
        ++bodies[aggregates[i]].count;
    }
    for (Body& body : bodies) body.centre = (1.0 / body.count) * body.centre;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        Body& body = bodies[aggregates[i]];
        const Vec<double> d = parts[i].centre - body.centre;
        body.radius += (dot(d, d) + parts[i].radius * parts[i].radius) / body.count;
    }
    for (Body& body : bodies) body.radius = std::sqrt(body.radius);
}

// A part at d from the centre moves by t + w x d, and turns as the body does.
template <int size>
void CoarseLevels::move(Prolongator<size>& passage, std::span<const Body> parts,
                        std::span<const Body> bodies) {
    const std::span<const int> aggregates = passage.aggregates();
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Body& body = bodies[aggregates[i]];
        const double unit = divide(1.0, body.radius);
        const Vec<double> by = unit * (parts[i].centre - body.centre);
        const Vec<float> d{static_cast<float>(by.x), static_cast<float>(by.y),
                           static_cast<float>(by.z)};
        Passage<size>& rows = passage.bodies[i];
        const float turn[3][3] = {{0, d.z, -d.y}, {-d.z, 0, d.x}, {d.y, -d.x, 0}};
        for (int k = 0; k < size; ++k) {
            rows.row[k] = Record<6>(0);
            rows.row[k].set(k, k < 3 ? 1 : static_cast<float>(unit * parts[i].radius));
            for (int c = 0; c < 3 && k < 3; ++c) rows.row[k].set(3 + c, turn[k][c]);
        }
    }
}

void CoarseLevels::place(Prolongator<3>& fromVertices, std::span<const Vec<double>> vertices) {
    points_.resize(vertices.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) points_[v] = {vertices[v], 0, 1};
    gather(fromVertices.aggregates(), points_, levels_[0]->bodies);
    move(fromVertices, points_, levels_[0]->bodies);
    for (std::size_t n = 0; n + 1 < levels_.size(); ++n) {
        Level &fine = *levels_[n], &coarse = *levels_[n + 1];
        gather(fine.passage->aggregates(), fine.bodies, coarse.bodies);
        move(*fine.passage, fine.bodies, coarse.bodies);
    }
}

void CoarseLevels::setUp(Workers& workers) {
    for (std::size_t n = 0; n < levels_.size(); ++n) {
        Level& level = *levels_[n];
        level.a.invert(workers);
        if (!level.passage) continue;
        level.passage->smooth(level.a, workers);
        level.passage->project(level.a, levels_[n + 1]->a, workers);
    }
}

const std::vector<Record<6>>& CoarseLevels::cycle(std::size_t number, Workers& workers) {
    Level& level = *levels_[number];
    level.a.forward(level.b, level.x, level.r, workers);
    if (!level.passage) return level.x;  // no body has a neighbour: that was exact
    level.passage->restrict(level.r, levels_[number + 1]->b, workers);
    level.passage->prolong(cycle(number + 1, workers), level.x, workers);
    level.a.backward(level.b, level.x, workers);
    return level.x;
}

double CoarseLevels::multiplications() const {
    double sum = 0;
    for (const auto& level : levels_)
        sum += 2 * level->a.multiplications() +
               (level->passage ? level->passage->multiplications() : 0);
    return sum;
}

double CoarseLevels::setUpMultiplications() const {
    double sum = 0;
    for (const auto& level : levels_)
        if (level->passage) sum += level->passage->setUpMultiplications(level->a);
    return sum;
}

}  // namespace plait
