// A sheet of equal springs that hangs from its upper edge and swings: what the map of step and
// stiffness is made of, with its energy and its fastest mode from code of its own.
#pragma once

#include <plait/world.h>

#include <array>
#include <vector>

namespace plait {

class SpringSheet {
public:
    // `side` x `side` vertices, 1 m x 1 m of 0.02 kg/m^2, with one diagonal a cell; springs of
    // `stiffness` N/m. It starts as it is at rest, swinging at 1 m/s at its lower edge, and with
    // a millionth of its energy in the fastest mode, which no explosion has to wait for.
    SpringSheet(int side, double stiffness);

    const World& world() const { return world_; }
    // In rad/s, of the fastest mode of the shape at rest: by power iteration.
    double omegaMax() const { return omegaMax_; }
    // Of the uppermost springs under the weight at rest.
    double staticStrain() const;

    // Of motion and gravity, in J, zero where the lower edge hangs at rest; and with the springs.
    double mechanicalEnergy(const std::vector<Vec<double>>& x,
                            const std::vector<Vec<double>>& v) const;
    double energy(const std::vector<Vec<double>>& x, const std::vector<Vec<double>>& v) const;
    // E + h v.f / 2, f the forces: what symplectic Euler keeps of a linear spring while E swings
    // between its like over 1 + h omega / 2 and over 1 - h omega / 2 (validation A0).
    double modifiedEnergy(const std::vector<Vec<double>>& x, const std::vector<Vec<double>>& v,
                          double h) const;
    // The greatest of |length / rest - 1|.
    double strain(const std::vector<Vec<double>>& x) const;

private:
    using Vectors = std::vector<Vec<double>>;

    // One application of W K, K the stiffness matrix of the shape at rest; pins stay.
    Vectors accelerations(const Vectors& u) const;
    Vectors fastestMode();

    World world_;
    double stiffness_, omegaMax_ = 0;
    std::vector<std::array<int, 2>> edges_;
    std::vector<double> rest_;
};

}  // namespace plait
