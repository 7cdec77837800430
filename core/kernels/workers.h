// Threads that share out loops whose turns do not meet: which thread runs what never shows in a
// result. No locks, no atomics on data, no allocation after construction.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <thread>
#include <vector>

namespace plait {

class Workers {
public:
    // `threads` >= 1, the calling one included. Throws std::invalid_argument otherwise.
    explicit Workers(int threads);
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    int threads() const { return static_cast<int>(pool_.size()) + 1; }  // fewer if no more start

    // Called, where there is one, as every loop below begins, and by what loops long by itself. It
    // may throw.
    std::function<void()> interrupt;
    void askInterrupt() const {
        if (interrupt) interrupt();
    }

    // Calls body(begin, end) for [0, count), cut at multiples of block / 16 (at least 1) into one
    // run of equal length a thread, and returns when all are done. A thread meets the same data
    // every time; what it has not begun when this one is through with its own, this one does too,
    // so that threads without a core to run on hold nothing up. A count of less than two blocks
    // runs here: dealing it out would cost more. What `body` throws is thrown here when all are
    // done; where several do, what one thread alone would have met first.
    template <class Body>
    void forBlocks(int count, int block, const Body& body) {
        const auto call = [](const void* context, int begin, int end) {
            (*static_cast<const Body*>(context))(begin, end);
        };
        run({call, &body, count, block});
    }

private:
    struct Job {
        void (*call)(const void*, int, int);
        const void* context;
        int count, block;
    };

    // The run of one thread in the present round, on a cache line of its own.
    struct alignas(64) Share {
        std::atomic<unsigned> open{0};  // the round, until somebody begins it
        std::atomic<unsigned> done{0};  // the round, when it is through
        std::exception_ptr thrown;
    };

    void run(const Job& job);
    void share(int thread);
    void rethrow();
    bool claim(int thread, unsigned round);
    void serve(int thread);

    Job job_{};
    std::atomic<unsigned> round_{0};
    std::atomic<bool> stop_{false};
    std::vector<Share> shares_;  // by thread
    std::vector<std::jthread> pool_;
};

// Flushes denormal numbers to zero on this thread while it lives: alike in all threads, or a
// decaying motion would end in different bits, and a hundred times slower.
class FlushDenormals {
public:
    FlushDenormals();
    ~FlushDenormals();
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;

private:
    unsigned saved_;
};

}  // namespace plait
