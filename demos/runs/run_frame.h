// A frame of a run, and how frames and the solver's state stand in the cache.
//
// Both files begin with eight letters, the format's version (uint32: 2 of a frame, 6 of a
// checkpoint) and the bytes of a number (uint32: 4 or 8), and end with a hash (uint64,
// core/measure/hash.h) of all bytes before it. Bytes run from the lowest; a number is a float or a
// double by the precision of the run.
//
//   cache/00012.frame  "plaitfrm", then int32 frame, vertices, metrics, how many have an id and an
//                      age: as many, or 0 where nothing comes or goes, and cuts; float64 time in s;
//                      int64 evaluations so far; float64 seconds that it took; float64 a metric;
//                      then three numbers a vertex: positions in m, then velocities in m/s; then
//                      a byte a vertex: 1 where a contact pushed it; then int32 an id, float64 an
//                      age in s, and int32 a cut, an edge of the world's complex.
//   cache/checkpoint   "plaitchk", then int32 frame; int64 substep, evaluations; int32 past;
//                      then the arrays of core/state.h, in their order, ids, births and cuts
//                      last, each after its length (int64); then the number of drawers (int64), and
//                      of each its numbers and its integers (int32), likewise.
#pragma once

#include <plait/numbers/math.h>
#include <plait/state.h>

#include <cstdint>
#include <string>
#include <vector>

namespace plait {

struct RunFrame {
    int number = 0;                                  // 0 is the start
    double time = 0;                                 // s
    long evaluations = 0;                            // since the start of the run
    double seconds = 0;                              // of wall time that it took
    std::vector<double> metrics;                     // in the order of the scene's
    std::vector<Vec<double>> positions, velocities;  // m, m/s
    std::vector<std::uint8_t> touched;               // 1: a contact pushed it in the last substep
    // Of sources, as Snapshot has them; empty where nothing comes or goes.
    std::vector<std::int32_t> ids = {};
    std::vector<double> ages = {};  // s
    // What has come apart by then, in order (State::cuts).
    std::vector<std::int32_t> cuts = {};
};

// Bytes of a frame file whose numbers have `size` bytes.
std::string encodeFrame(const RunFrame& frame, int size);
// Throws FileError that begins with `name`, as does the next.
RunFrame decodeFrame(const std::string& bytes, const std::string& name);

template <class Real>
struct Checkpoint {
    int frame = 0;
    long evaluations = 0;
    State<Real> state;
};
template <class Real>
std::string encodeCheckpoint(const Checkpoint<Real>& checkpoint);
template <class Real>
Checkpoint<Real> decodeCheckpoint(const std::string& bytes, const std::string& name);

}  // namespace plait
