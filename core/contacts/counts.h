// What contacts did, for those who ask whether all went well.
#pragma once

namespace plait {

// What contacts did since the solver was made.
struct ContactCounts {
    long searches = 0;  // for pairs
    long pairs = 0;     // in the list, at most
    long contacts = 0;  // in a substep, at most
    long bounces = 0;   // off what has restitution
    long impacts = 0;   // times at which paths were asked for
    long passes = 0;    // over what crossed after the last column
    long heldBack = 0;  // vertices put back to where they were
    long failed = 0;    // pairs that cross all the same
    long tangled = 0;   // vertices where a substep begins, at most, if it is asked
    long disabled = 0;  // vertices taken out of contacts as failed
    long enabled = 0;   // of these, taken back
    long limited = 0;   // times that a contact reached the limit of displacement
    long givenUp = 0;   // substeps in which nothing moved, since what crossed did not end
    long pressed = 0;   // pairs of a particle and another or a curve, within a quarter of their gap
    long cut = 0;       // substeps in which more bounces were left than are followed

    // What was not held, all in all.
    long failures() const { return failed + disabled + givenUp + pressed + cut; }
};

}  // namespace plait
