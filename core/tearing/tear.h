// What decides, once a substep has ended, what comes apart. It is a force that does not push.
#pragma once

#include "../force.h"
#include "stress.h"
#include "tearing.h"

#include <vector>

namespace plait {

struct TornMembrane {
    std::vector<Membrane::Rubber> rubber;
    Tearing tearing;
};

template <class Real>
class Tear : public Force<Real> {
public:
    Tear(const World& world, const TornMembrane& membrane);

    std::string name() const override { return tearing_.name; }
    // By spare vertex the time (s) at which it came apart, and how far it has to open (m) until a
    // tear goes on from there. Of the whole numbers one, the cuts that
    // were refused for want of spare vertices.
    void furnish(Drawer<Real>& kept) const override;
    void beginFrame(const State<Real>&, double t0, double, Workers&) override { from_ = t0; }
    void apply(State<Real>&, double, double, Workers&) override {}
    void settle(State<Real>& state, Drawer<Real>& kept, double t, double h) override;

    // What a tear that ends at this vertex sets free a length, along its way at rest: J/m.
    Vec<double> drive(const State<Real>& state, int vertex) const;
    // The greatest force on an area at rest, in the mean of the triangles around a vertex, and the
    // normal of that area at rest: Pa.
    struct Bearing {
        double force = 0;
        Vec<double> normal{};
    };
    Bearing bearing(const State<Real>& state, int vertex) const {
        return bearing(state, vertex, sites_[static_cast<std::size_t>(vertex)].triangles);
    }

private:
    struct Failing {
        double times;  // of what it bears
        int vertex;
        Vec<double> normal;  // of the section that bears most, at rest
        Vec<double> way;     // of the end of a tear, at rest: where it goes; 0 elsewhere
    };

    // Triangles within `ring` edges of a vertex, and how many each of the vertices there is away.
    struct Disc {
        std::vector<int> vertices, steps, triangles;
    };
    Disc discAt(int vertex) const;
    int ringAt(const Disc& disc) const;
    std::vector<int> trianglesAhead(int vertex) const;
    Bearing bearing(const State<Real>& state, int vertex, std::span<const int> triangles) const;
    std::array<Vec<double>, 3> placesOf(const State<Real>& state, int triangle) const;
    SheetStress::Borne borneAt(const State<Real>& state, int triangle) const {
        return borne_.empty() ? stress_.borne(triangle, placesOf(state, triangle))
                              : borne_[static_cast<std::size_t>(triangle)];
    }
    // Whether the lips behind the end of a tear are apart, and waves have had time to come along.
    bool mayGoOn(const State<Real>& state, const Drawer<Real>& kept, const Site& site, double times,
                 double t) const;
    void note(const State<Real>& state, const Cuts& cuts, const VertexSplit& split, double t,
              Drawer<Real>& kept) const;
    void findFailing(const State<Real>& state, const Drawer<Real>& kept, double t,
                     std::vector<Failing>& failing) const;
    int pierced(const State<Real>& state, const Vec<double>& from, const Vec<double>& to) const;
    const Spoke* edgeFor(const Failing& failing, const Vec<double>& way, double least) const;
    std::vector<int> edgesFor(const Failing& failing) const;
    std::vector<int> branchesFor(const Failing& failing) const;
    void noteParted(State<Real>& state) const;
    bool near(int vertex, const std::vector<int>& others) const;

    Tearing tearing_;
    Range spare_{};
    Cuts cuts_;
    std::vector<Vec<double>> rest_;  // m
    SheetStress stress_;
    std::vector<Site> sites_;
    std::vector<double> parts_, scatter_;  // by vertex of the whole: of strength and toughness, and
                                           // of strength beside
    std::vector<SheetStress::Borne> borne_;  // by triangle, while all vertices are asked
    double waveSpeed_ = 0;                   // m/s, of shear waves at rest
    double from_ = 0;                        // s, of the frame
};

extern template class Tear<float>;
extern template class Tear<double>;

}  // namespace plait
