// A machine that starts no thread.
#pragma once

#include <pthread.h>
#include <cstddef>

namespace plait::test {

// While it lives, a new thread asks for a stack that no address space has room for.
class NoThreads {
public:
    NoThreads() {
        pthread_getattr_default_np(&before_);
        pthread_attr_t none;
        pthread_getattr_default_np(&none);
        pthread_attr_setstacksize(&none, std::size_t{1} << 60);
        pthread_setattr_default_np(&none);
        pthread_attr_destroy(&none);
    }
    ~NoThreads() {
        pthread_setattr_default_np(&before_);
        pthread_attr_destroy(&before_);
    }
    NoThreads(const NoThreads&) = delete;
    NoThreads& operator=(const NoThreads&) = delete;

private:
    pthread_attr_t before_;
};

}  // namespace plait::test
