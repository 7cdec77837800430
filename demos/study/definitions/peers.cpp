#include "peers.h"

#include <cmath>
#include <limits>

namespace plait {
namespace {

constexpr double burst = std::numeric_limits<double>::infinity();
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// By frame of 1/60 s: its time and how often each link was evaluated; strains are of the rest
// length.
struct Row {
    double ms;
    int sweeps;
    double worst, late, end, mean;
};

Peer peer(const std::string& name, int n, const std::vector<Row>& rows) {
    const double links = 3.0 * n * n - 4.0 * n + 1;
    Peer peer{name, {}};
    for (const Row& row : rows)
        peer.points.push_back({.cost = row.ms * 60 / 24,
                               .evaluations = 60 * links * row.sweeps,
                               .errors = {row.worst, row.late, row.end, row.mean}});
    return peer;
}

Row blownUp(double ms, int sweeps) { return {ms, sweeps, burst, burst, burst, burst}; }

}  // namespace

std::vector<Peer> peersOnSheet(int n) {
    if (n == 128)
        return {peer("Bullet", n,
                     {{10.1, 10, 255, 195, 255, 3.10},
                      {17.8, 20, 133, 122, 112, 1.07},
                      {69.4, 40, 7.44, 3.75, 4.86, 0.0475}}),
                peer("Jolt", n,
                     {blownUp(2.58, 5), blownUp(5.1, 10), blownUp(10.1, 20), blownUp(20.1, 40)}),
                peer("Jolt, long-range attachments", n, {{12, 20, 249, 201, 174, 4.38}}),
                peer("PositionBasedDynamics", n,
                     {{22.8, 20, 168, 150, 145, 1.50},
                      {14.7, 10, 39.7, 10.5, 9.69, 0.0846},
                      {28.1, 20, 9.92, 4.74, 5.62, 0.0619},
                      {66.2, 50, 2.64, 0.953, 1.06, 0.00767}}),
                peer("Blender, 0.5 s", n, {{616, 0, 0.001, unknown, 0.0011, unknown}})};
    if (n == 256)
        return {peer("Bullet", n,
                     {{61.2, 10, 697, 437, 697, 5.09},
                      {89.8, 20, 610, 389, 610, 4.27},
                      {340, 40, 55, 45.1, 46.9, 0.23}}),
                peer("Jolt", n,
                     {blownUp(11.4, 5), blownUp(22.6, 10), blownUp(45, 20), blownUp(89.5, 40)}),
                peer("Jolt, long-range attachments", n, {{56.8, 20, 568, 504, 451, 38}}),
                peer("PositionBasedDynamics", n,
                     {{91.7, 20, 793, 510, 793, 4.33},
                      {61.2, 10, 277, 249, 230, 1.13},
                      {117, 20, 79.7, 23.9, 11.1, 0.0609}})};
    return {};
}

std::vector<Peer> peersOnRod() {
    constexpr int segments = 64;
    struct Measured {
        int substeps;  // in 1/60 s
        double drop, stretch, speed;
    };
    Peer jolt{"Jolt, on another EPYC", {}};
    for (const Measured& row : {Measured{10, 0.091, 0.032, 5e-5},
                                {20, 0.023, 0.0078, 3e-4},
                                {50, 0.003, 0.0012, 1e-3},
                                {100, 0.020, 0.0003, 4e-3},
                                {200, 0.044, 0.00007, 1e-2}})
        jolt.points.push_back({.cost = 43e-6 * segments * row.substeps * 60 / 24,
                               .evaluations = 60.0 * (2 * segments - 1) * row.substeps,
                               .errors = {row.drop, row.stretch, row.speed}});
    return {jolt};
}

}  // namespace plait
