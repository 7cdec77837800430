#include "machine.h"

#include <plait/kernels/kernels.h>

#include <sched.h>
#include <sys/resource.h>
#include <sys/utsname.h>
#include <unistd.h>
#include <fstream>

namespace plait {
namespace {

std::string processorName() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown";
}

}  // namespace

int usableCores() {
    cpu_set_t set;
    return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}

Machine thisMachine() {
    utsname system{};
    uname(&system);
    const KernelChoice kernels = bestKernels();
    return {.processor = processorName(),
            .cores = usableCores(),
            .memory = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE)),
            .system = std::string(system.sysname) + " " + system.release + " " + system.machine,
            .kernels = "x86-64-v" + std::to_string(static_cast<int>(kernels.isa) + 2),
            .lanes = kernels.lanes};
}

long peakMemory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss * 1024;
}

}  // namespace plait
