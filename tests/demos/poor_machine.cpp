// Loaded ahead of a program by LD_PRELOAD: a machine that runs no more than POOR_THREADS threads,
// and whose files cannot be locked, for the reason POOR_LOCKS (errno).
#include <dlfcn.h>
#include <pthread.h>
#include <sys/file.h>
#include <atomic>
#include <cerrno>
#include <cstdlib>

namespace {

template <class Function>
Function* systems(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

std::atomic<int> running{0};

struct Start {
    void* (*routine)(void*);
    void* argument;
};

void* runCounted(void* start) {
    const Start own = *static_cast<Start*>(start);
    delete static_cast<Start*>(start);
    void* const result = own.routine(own.argument);
    --running;
    return result;
}

}  // namespace

extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes,
                              void* (*routine)(void*), void* argument) noexcept {
    static const char* const most = std::getenv("POOR_THREADS");
    if (most && running >= std::atoi(most)) return EAGAIN;
    ++running;
    return systems<decltype(pthread_create)>("pthread_create")(thread, attributes, runCounted,
                                                               new Start{routine, argument});
}

extern "C" int flock(int file, int operation) noexcept {
    const char* const reason = std::getenv("POOR_LOCKS");
    if (!reason) return systems<decltype(flock)>("flock")(file, operation);
    errno = std::atoi(reason);
    return -1;
}
