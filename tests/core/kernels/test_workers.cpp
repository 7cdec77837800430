// Threads that run blocks, more of them than there are cores.
#include "tests/catch.h"
#include "tests/no_threads.h"
#include "tests/random.h"

#include <plait/kernels/workers.h>

#include <chrono>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace plait;
using namespace plait::test;

TEST_CASE("workers: all of it once and done on return, whatever the threads", "[threads][AR14]") {
    for (const int threads : {1, 2, 3, 8}) {
        Workers workers(threads);
        Random random(1);
        std::vector<int> runs(200, 0), expected(200, 0);
        int odd = 0, wrong = 0;
        for (int round = 0; round < 25000; ++round) {
            const int count = random.below(200), block = 1 + random.below(40);
            const int part = block < 32 ? 1 : 2;  // a sixteenth
            workers.forBlocks(count, block, [&](int begin, int end) {
                if (begin % part != 0 || (end % part != 0 && end != count)) wrong = 1;
                for (int i = begin; i < end; ++i) ++runs[i];
            });
            for (int i = 0; i < count; ++i) odd += runs[i] != ++expected[i];
        }
        INFO(threads << " threads");
        CHECK(odd == 0);
        CHECK(wrong == 0);
        CHECK(runs == expected);
    }
}

TEST_CASE("workers: they come and go without a round, and after one", "[threads]") {
    for (int round = 0; round < 200; ++round) {
        Workers workers(4);
        std::vector<int> runs(8, 0);
        if (round % 2)
            workers.forBlocks(8, 1, [&](int begin, int end) {
                for (int i = begin; i < end; ++i) ++runs[i];
            });
        REQUIRE(runs == std::vector<int>(8, round % 2));
    }
}

// A body that lingers meets others, and is waited for.
TEST_CASE("workers: others than the calling thread take part", "[threads]") {
    Workers workers(2);
    const std::thread::id self = std::this_thread::get_id(), nobody;
    int others = 0;
    for (int round = 0; round < 10000 && others < 20; ++round) {
        std::vector<std::thread::id> by(2, nobody);
        workers.forBlocks(2, 1, [&](int begin, int end) {
            std::this_thread::sleep_for(std::chrono::milliseconds(begin + 1));
            for (int i = begin; i < end; ++i) by[i] = std::this_thread::get_id();
        });
        REQUIRE(by[0] == self);
        REQUIRE(by[1] != nobody);
        others += by[1] != self;
    }
    CHECK(others == 20);
}

TEST_CASE("workers: the first of what is thrown arrives, and the rest is done", "[threads]") {
    for (const int threads : {1, 2, 8}) {
        Workers workers(threads);
        for (int round = 0; round < 500; ++round) {
            std::vector<int> runs(64, 0);
            const auto body = [&](int begin, int end) {
                for (int i = begin; i < end; ++i) {
                    if (i == 9 || i == 41) throw std::runtime_error(std::to_string(i));
                    ++runs[i];
                }
            };
            REQUIRE_THROWS_WITH(workers.forBlocks(64, 1, body), "9");
            if (threads == 8) REQUIRE(std::accumulate(runs.begin(), runs.end(), 0) == 64 - 7 - 7);
        }
        int runs = 0;
        workers.forBlocks(1, 1, [&](int begin, int end) { runs += end - begin; });
        CHECK(runs == 1);
    }
}

TEST_CASE("workers: there is at least one", "[threads]") {
    CHECK_THROWS_AS(Workers(0), std::invalid_argument);
}

TEST_CASE("workers: where no thread starts, the calling one does it all", "[threads][strangers]") {
    const NoThreads none;
    Workers workers(4);
    CHECK(workers.threads() == 1);
    std::vector<int> runs(200, 0);
    workers.forBlocks(200, 10, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) ++runs[i];
    });
    CHECK(runs == std::vector<int>(200, 1));
}
