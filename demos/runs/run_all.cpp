#include "run_all.h"

#include "demos/tools/interrupt.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace plait {

void runAll(int count, int jobs, int begun, Progress& progress,
            const std::function<void(int i, int job)>& task) {
    std::atomic<int> next{0};
    std::exception_ptr error;
    std::mutex mutex;
    int done = begun;
    const auto work = [&](int job) {
        try {
            for (int i; (i = next++) < count;) {
                stopIfInterrupted();
                task(i, job);
                const std::lock_guard lock(mutex);
                progress.show(++done);
            }
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!error) error = std::current_exception();
            next = count;
        }
    };
    std::vector<std::jthread> threads;
    try {
        for (int job = 0; job < jobs; ++job) threads.emplace_back(work, job);
    } catch (const std::system_error&) {
        if (threads.empty()) work(0);  // those that there are do all of it
    }
    threads.clear();
    if (error) std::rethrow_exception(error);
}

}  // namespace plait
