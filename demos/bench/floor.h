// A substep written by hand, with AVX2 intrinsics: the layout and the arithmetic of the core, the
// same bits, and nothing of its generality. What the core costs beyond it is the price of writing a
// constraint once.
#pragma once

#include <plait/state.h>

#include <vector>

namespace plait {

// True if this processor can run it.
bool floorAvailable();

// One colour of stretch in blocks of 16, as core/kernels.h lays it out.
struct FloorColor {
    struct alignas(64) Block {
        int ids[2][16];
        float rows[3][16];  // rest length, compliance, compression
        float lambda[16];
    };
    std::vector<Block> blocks;
};

// Projects the constraints of blocks [begin, end).
void floorStretch(Particle<float>* particles, FloorColor::Block* blocks, float inverseH2, int begin,
                  int end);

// v + h g, then x + h v, of vertices [begin, end).
void floorPredict(Particle<float>* particles, Padded<float>* velocity, Padded<float>* before,
                  float h, float gravity, int begin, int end);

// v = (x - before) / h, then d folded into x.
void floorUpdate(Particle<float>* particles, Padded<float>* velocity, const Padded<float>* before,
                 float h, int begin, int end);

}  // namespace plait
