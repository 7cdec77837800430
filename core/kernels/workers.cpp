#include "workers.h"

#include <immintrin.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace plait {
namespace {

// Colours take microseconds, so a thread first spins; then it sleeps, because there may be more
// threads than cores.
template <class T>
void await(const std::atomic<T>& value, T old) {
    constexpr int spins = 4000;
    for (int i = 0; i < spins; ++i) {
        if (value.load(std::memory_order_acquire) != old) return;
        _mm_pause();
    }
    value.wait(old, std::memory_order_acquire);
}

}  // namespace

Workers::Workers(int threads) : shares_(static_cast<std::size_t>(std::max(threads, 1))) {
    if (threads < 1) throw std::invalid_argument("threads must be at least 1");
    try {
        for (int t = 1; t < threads; ++t) pool_.emplace_back([this, t] { serve(t); });
    } catch (const std::exception&) {
        return;  // those that wait already do all of it
    }
}

Workers::~Workers() {
    stop_ = true;
    ++round_;
    round_.notify_all();
}

void Workers::run(const Job& job) {
    askInterrupt();
    if (pool_.empty() || job.count < 2 * job.block) {
        if (job.count > 0) job.call(job.context, 0, job.count);
        return;
    }
    job_ = job;
    unsigned round = round_.load(std::memory_order_relaxed) + 1;
    if (round == 0) round = 1;  // 0 is for shares that nobody may begin
    for (Share& share : shares_) share.open.store(round, std::memory_order_release);
    round_.store(round, std::memory_order_release);
    round_.notify_all();
    share(0);
    for (int t = 1; t < threads(); ++t)
        if (claim(t, round)) {
            share(t);
            shares_[static_cast<std::size_t>(t)].done.store(round, std::memory_order_relaxed);
        }
    for (int t = 1; t < threads(); ++t) {
        const std::atomic<unsigned>& done = shares_[static_cast<std::size_t>(t)].done;
        for (unsigned at = done.load(std::memory_order_acquire); at != round;
             at = done.load(std::memory_order_acquire))
            await(done, at);
    }
    rethrow();
}

void Workers::share(int thread) {
    const long part = std::max(job_.block / 16, 1), parts = (job_.count + part - 1) / part;
    const long first = parts * thread / threads(), last = parts * (thread + 1) / threads();
    const int begin = static_cast<int>(first * part);
    const int end = static_cast<int>(std::min<long>(last * part, job_.count));
    try {
        if (begin < end) job_.call(job_.context, begin, end);
    } catch (...) {
        shares_[static_cast<std::size_t>(thread)].thrown = std::current_exception();
    }
}

void Workers::rethrow() {
    std::exception_ptr first;
    for (Share& share : shares_) {
        const std::exception_ptr thrown = std::exchange(share.thrown, nullptr);
        if (!first) first = thrown;
    }
    if (first) std::rethrow_exception(first);
}

// True for one of those who ask in a round; `job_` stays until that one is done.
bool Workers::claim(int thread, unsigned round) {
    return shares_[static_cast<std::size_t>(thread)].open.compare_exchange_strong(
        round, 0, std::memory_order_acq_rel);
}

void Workers::serve(int thread) {
    const FlushDenormals flush;
    std::atomic<unsigned>& done = shares_[static_cast<std::size_t>(thread)].done;
    for (unsigned seen = 0;;) {
        await(round_, seen);
        seen = round_.load(std::memory_order_acquire);
        if (stop_) return;  // asked after the round was read, or the last round could be missed
        if (!claim(thread, seen)) continue;
        share(thread);
        done.store(seen);  // in sequence with who waits: run() must be woken, threads need not be
        done.notify_all();
    }
}

FlushDenormals::FlushDenormals() : saved_(_mm_getcsr()) {
    constexpr unsigned flushToZero = 0x8000, denormalsAreZero = 0x0040;
    _mm_setcsr(saved_ | flushToZero | denormalsAreZero);
}

FlushDenormals::~FlushDenormals() { _mm_setcsr(saved_); }

}  // namespace plait
