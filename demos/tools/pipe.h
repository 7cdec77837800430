// A queue between two threads that holds only so much: the faster one waits.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

namespace plait {

template <class T>
class Pipe {
public:
    explicit Pipe(std::size_t capacity) : capacity_(capacity) {}

    // Waits for room, and calls `ask` over and over meanwhile, which may throw. False if the pipe
    // is closed: nobody will take it.
    template <class Ask>
    bool push(T item, const Ask& ask) {
        std::unique_lock lock(mutex_);
        while (!changed_.wait_for(lock, std::chrono::milliseconds(50),
                                  [&] { return closed_ || items_.size() < capacity_; }))
            ask();
        if (closed_) return false;
        items_.push_back(std::move(item));
        changed_.notify_all();
        return true;
    }
    bool push(T item) {
        return push(std::move(item), [] {});
    }

    // Waits for an item; none once the pipe is closed and empty.
    std::optional<T> pop() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return closed_ || !items_.empty(); });
        if (items_.empty()) return std::nullopt;
        T item = std::move(items_.front());
        items_.pop_front();
        changed_.notify_all();
        return item;
    }

    // Nothing more comes; with `discard` what is in it is dropped.
    void close(bool discard = false) {
        const std::lock_guard lock(mutex_);
        closed_ = true;
        if (discard) items_.clear();
        changed_.notify_all();
    }

private:
    std::size_t capacity_;
    std::deque<T> items_;
    bool closed_ = false;
    std::mutex mutex_;
    std::condition_variable changed_;
};

}  // namespace plait
