// What contacts do not hold: matter that is tangled already, or that they failed to keep apart, is
// taken out of them, named, and taken back when it is free (M 4.4, 4.5.3, V).
#pragma once

#include "../../complex/csr.h"
#include "../counts.h"
#include "../search/nearest.h"
#include "../surface.h"
#include "tangles.h"

#include <cstdint>
#include <span>
#include <vector>

namespace plait {

struct World;

// The flags of a vertex, as V has them, once against its own surface and once against others
// [FH9]. One that is not 0 takes a vertex, and every simplex that it is a corner of, out of
// contacts.
struct Disabled {
    static constexpr int byHand = 1;    // for good
    static constexpr int asFailed = 2;  // until it is free
    static constexpr int ownShift = 2;  // the two bits against its own surface

    static constexpr int fail(int flag) { return flag | asFailed; }
    static constexpr int free(int flag) { return flag & ~asFailed; }
};

// The flags of all vertices, which are a part of the state of a run.
class Failures {
public:
    Failures(const World& world, const std::vector<Surface>& surfaces,
             const ContactOptions& options);

    // Whether anything is ever taken out of contacts.
    static bool needed(const std::vector<Surface>& surfaces, const ContactOptions& options);

    // A substep begins with these positions (m, by vertex) and the flags that the last one left.
    void begin(std::span<const Vec<double>> start, std::span<const std::int32_t> flags,
               ContactCounts& counts, Workers& workers);
    bool leavesOut(const Pairing& pair) const;
    // Still crosses after all passes.
    void fail(const Pairing& pair, ContactCounts& counts);
    // By vertex, for the next substep; at first those by hand.
    const std::vector<std::int32_t>& flags() const { return flags_; }

private:
    void connect(const World& world);
    void set(int vertex, bool own, int flag);
    void disable(int vertex, bool own, ContactCounts& counts);
    void release(bool own, ContactCounts& counts);
    bool own(const Pairing& pair) const {
        return surface_[pair.vertices[0]] == surface_[pair.vertices[3]];
    }
    int flag(int vertex, bool own) const {
        return flags_[vertex] >> (own ? Disabled::ownShift : 0) & 3;
    }

    ContactOptions options_;
    std::vector<int> surface_;  // by vertex, -1 of none
    std::vector<unsigned char> pinned_;
    std::vector<std::int32_t> flags_;
    Csr neighbours_;
    std::vector<int> island_;  // by vertex: what hangs together has one number
    Tangles tangles_;
    Tangles::Marks tangled_;
    std::vector<unsigned char> stuck_;  // by island
    std::vector<int> freed_;            // vertices, of this substep
};

}  // namespace plait
