// A field of acceleration, sampled at every vertex once a frame and applied in every substep (M
// 3.1.2) [IN29]. It knows no surfaces and heeds no space scale (M 6); see air.h for wind.
#pragma once

#include "../force.h"
#include "../world.h"
#include "body.h"

#include <functional>

namespace plait {

struct FieldOptions {
    // m/s^2 at x (m) and time t (s), called on one thread, vertex by vertex.
    std::function<Vec<double>(const Vec<double>& x, double t)> acceleration = {};
    std::string name = "field";
    std::vector<Range> objects = {};  // that it moves; empty: everything
};

template <class Real>
class Field : public Force<Real> {
public:
    // Throws std::invalid_argument for a missing function and for objects that the world has not.
    Field(const World& world, const FieldOptions& options)
        : options_(options), acceleration_(world.start.size()) {
        const int count = static_cast<int>(world.start.size());
        const std::vector<Range> everything{{0, count}};
        if (!options.acceleration) throw std::invalid_argument(options.name + ": no acceleration");
        moved_ = markObjects(count, options.objects.empty() ? everything : options.objects,
                             options.name);
    }

    std::string name() const override { return options_.name; }

    void beginFrame(const State<Real>& state, double t0, double /*t1*/, Workers&) override {
        for (std::size_t i = 0; i < acceleration_.size(); ++i)
            if (moved_[i])
                acceleration_[i] = options_.acceleration(state.position(static_cast<int>(i)), t0);
    }

    void apply(State<Real>& state, double /*t*/, double h, Workers& workers) override {
        workers.forBlocks(state.count(), 1024, [&](int begin, int end) {
            for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
                const Vec<double> dv = h * acceleration_[i];
                if (!moved_[i]) continue;
                accelerate(
                    state, i,
                    {static_cast<Real>(dv.x), static_cast<Real>(dv.y), static_cast<Real>(dv.z)});
            }
        });
    }

private:
    FieldOptions options_;
    std::vector<Vec<double>> acceleration_;
    std::vector<std::uint8_t> moved_;
};

}  // namespace plait
