// The set of all contacts of some surfaces (S 7): simplices stay their thicknesses apart, with
// friction, and never pass through each other.
//
// A substep: pairs that may come near become contacts, sorted and coloured (prepare). Every
// evaluation asks anew where the two are nearest, or, where they may have passed each other on the
// way, when and where they met (touch), and parts them as they were before (part). Most contacts
// stay clear throughout: after the first four evaluations every fourth alone asks all of them.
// After the last column all paths are looked at once more (finish): what still crosses is parted in
// up to five passes, and what crosses even then is put back to how it lay when the substep began
// (impact_zones.h), which was free of crossings, so that the next one begins free of them too. Only
// matter that is moved from outside can break that; such vertices are counted as failed. What goes
// back may be crossed by others, which go back as well: where that does not end soon, all stays
// where it is to the end of the base step, and every substep of it is counted as a failure.
//
// Which contacts there are depends on where everything is and is heading, not on when pairs were
// last looked for: a run that is resumed has the same bits.
#pragma once

#include "../../contact_constraint.h"
#include "../../pieces/poses.h"
#include "../search/pair_search.h"
#include "../trouble/failures.h"
#include "impact_zones.h"
#include "impacts.h"
#include "sections.h"

#include <atomic>
#include <memory>

namespace plait {

struct World;

template <class Real>
class ContactSet : public ContactConstraint<Real> {
public:
    ContactSet(const World& world, const std::vector<Surface>& surfaces,
               const ContactOptions& options);

    void beginFrame(double /*t0*/, double /*t1*/) override { gaveUp_ = false; }
    void begin(const Substep& substep, Workers& workers) override;
    void project(const Sweep<Real>& sweep, Direction direction, Workers& workers) override;
    long finish(const Sweep<Real>& sweep, Workers& workers) override;
    long holdBack(const Sweep<Real>& sweep, Workers& workers) override;
    void furnish(Drawer<Real>& kept) const override;
    double partingTime(const Sweep<Real>& sweep, Workers& workers) override;
    bool needsPast() const override { return bouncy_; }
    void strike(const Sweep<Real>& sweep, const State<Real>& state, const Drawer<Real>& kept,
                Workers& workers) override;
    void conclude(const Sweep<Real>& sweep, Workers& workers) override;
    void rebound(State<Real>& state, Drawer<Real>& kept) const override;
    void markTouched(std::vector<std::uint8_t>& touched) const override;
    long failures() const override { return counts_.failures(); }
    // Contacts looked at in the evaluation last made.
    long size() const override { return looked_; }

    const ContactCounts& counts() const { return counts_; }

private:
    static constexpr int colorLimit = 64;  // contacts beyond run one by one

    // A plane between two. Most contacts never come to be more than this, so it is kept apart from
    // them, and small.
    struct Watch {
        std::array<int, 4> vertices;
        Vec<float> normal;            // to the first, of unit length between what is round
        std::array<float, 4> height;  // m, of each over the last when the substep begins, the
                                      // first one's less the gap
        int first;                    // vertices of the first; 0: look at the contact itself
    };
    struct Contact {
        Pairing pair;
        int color = 0;
        double distance;     // m, where the substep begins, as sections_ makes it round
        double gap;          // m, to be kept
        double push = 0;     // multiplier across, kg m
        Vec<double> grip{};  // multiplier along, kg m
        Watch watch{};
        bool limited = false;  // reached the limit of displacement
    };
    // Where two touch, and the way from the second to the first.
    struct Touch {
        std::array<double, 4> weight;
        Vec<double> normal;
        double value;  // m, C: distance less gap, below 0 also where they passed each other
    };

    void locate(const Sweep<Real>& sweep, Workers& workers);
    void prepare(const Sweep<Real>& sweep, Workers& workers);
    void consider(const Pairing& pair, std::vector<Contact>& list) const;
    double wholeGapOf(const Pairing& pair, const Nearest& now) const;
    double gapOf(const Pairing& pair, const Nearest& now) const;
    void bend(const Sweep<Real>& sweep, const State<Real>& state);
    // What takes the push at a vertex: itself, or the first vertex of its piece; -1: nothing does.
    int unitOf(int vertex) const {
        if (pinned_[vertex]) return -1;
        const int piece = pieces_.of(vertex);
        return piece < 0 ? vertex : pieces_.body(piece).vertices.first;
    }
    // Two pieces, or one and what is pinned, by their units: all their contacts are one group,
    // which runs in sequence. Of all others (-1, -1).
    std::array<int, 2> groupOf(const Pairing& pair) const;
    void sortParts(Workers& workers);
    void group();
    void colour(Workers& workers);
    template <class Body>
    void forUnits(const Contact& contact, const Body& body) const;
    double frictionPart(const Surface& a, const Surface& b) const {
        return &a == &b ? options_.selfFriction : options_.otherFriction;
    }
    PairPoints startOf(const Pairing& pair) const;
    PairPoints headingOf(const Pairing& pair) const;
    PairPoints endOf(const Sweep<Real>& sweep, const Pairing& pair) const;
    Touch touch(const Contact& contact, const PairPoints& start, const PairPoints& end) const;
    Watch watchOf(const Contact& contact, const Rounding& rounding, const Vec<double>& normal,
                  const PairPoints& start) const;
    static float room(const Watch& watch, const std::array<float, 4>& height);
    bool clearNow(Contact& contact, const Rounding& rounding, const PairPoints& start,
                  const PairPoints& end) const;
    double leastOf(const Contact& contact) const;
    bool clear(const Sweep<Real>& sweep, const Watch& watch) const;
    void part(const Sweep<Real>& sweep, Contact& contact);
    void findPoses(const Sweep<Real>& sweep, Workers& workers);
    void check(const Pairing& pair, std::vector<Contact>& list) const;
    bool findStrays(Workers& workers);
    bool findMoved(const Sweep<Real>& sweep, Workers& workers);
    bool hasMoved(const std::array<int, 4>& v) const {
        return moved_[v[0]] || moved_[v[1]] || moved_[v[2]] || moved_[v[3]];
    }
    void cross(const Sweep<Real>& sweep, Workers& workers);
    void crossMoved(const Sweep<Real>& sweep, Workers& workers);
    bool crossForeseen(const Sweep<Real>& sweep, Workers& workers);
    int putBack(const Sweep<Real>& sweep, bool hold);
    long putEverythingBack(const Sweep<Real>& sweep) const;
    long putAllBack(const Sweep<Real>& sweep, Workers& workers, bool hold);

    ContactOptions options_;
    PairSearch search_;
    Sections sections_;
    std::vector<Vec<double>> rest_, start_, end_, heading_;  // m, by vertex
    std::vector<Vec<double>> seen_;      // end_ when paths were last looked at; empty: not yet
    std::vector<std::uint8_t> moved_;    // by vertex: 1 if end_ is another since
    std::vector<int> strays_;            // further from where they were heading than contacts reach
    std::vector<std::uint8_t> isStray_;  // by vertex
    bool isElsewhere_ = false;           // search_ was told other ways since than those to heading_
    std::vector<unsigned char> pinned_;  // by vertex: it does not yield; all of a piece alike
    Pieces pieces_;
    std::vector<Pose> poses_;  // of them, in the present evaluation
    std::vector<int> whole_;   // of what goes back: vertices of a contact and of their pieces
    double gravity_;           // m/s^2: what rests approaches by its step
    std::vector<double> inverseMass_;  // 1/kg, in contacts
    ImpactZones zones_;                // of crossing_, and of what crossed before it
    bool bouncy_ = false;              // something has restitution
    std::vector<Bounce> bounces_;
    std::vector<Path> paths_;  // by vertex, of this substep
    std::vector<int> bent_;    // vertices that bounced
    std::vector<Contact> contacts_, crossing_;
    std::vector<Watch> watches_;    // of contacts_
    std::vector<int> near_;         // of each block of a colour those that were not
                                    // clear when all were looked at, then -1
    int evaluation_ = 0;            // of this substep
    int backRounds_ = 0;            // in which what crossed was put back in this substep
    long backPairs_ = 0;            // that crossed in them
    bool gaveUp_ = false;           // in this base step: nothing moves until its end
    std::atomic<long> looked_ = 0;  // in the evaluation last made
    std::array<int, colorLimit + 2> colors_{};  // where each colour begins in groups_
    std::vector<int> groups_;                   // where each group begins in contacts_, and the end
    std::vector<std::vector<Contact>> parts_;   // as they are found
    std::vector<Contact*> ordered_;             // all of them
    std::vector<int> places_;                   // in ordered_, by kind and first vertex
    std::vector<int> members_;                  // where each group begins in ordered_, and the end
    std::vector<int> to_;                       // and where it goes in contacts_
    std::vector<std::uint64_t> taken_;          // colours at each unit
    double slack_;                              // m, that contacts reach beyond their gap
    double widest_;                             // m, the largest thickness, as wide as it counts
    double h_ = 0;                              // s
    double opens_ = 0;                          // m, that what begins too near may part
    bool ready_ = false;                        // contacts_ are those of this substep
    int foreseen_ = 0;                          // contacts as they were found; what crossed follows
    std::unique_ptr<Failures> failures_;        // null: nothing is ever left out
    ContactCounts counts_;
};

extern template class ContactSet<float>;
extern template class ContactSet<double>;

}  // namespace plait
