#include "progress.h"

#include "interrupt.h"

#include <unistd.h>
#include <algorithm>
#include <cstdio>
#include <utility>

namespace plait {
namespace {

constexpr int barWidth = 28;
constexpr double barPeriod = 0.1, linePeriod = 5;  // s

thread_local Progress* followed = nullptr;
thread_local int solved = 0;

}  // namespace

Progress::Progress(std::string name, int begun, int total, bool quiet, std::string unit)
    : name_(std::move(name)),
      unit_(std::move(unit)),
      begun_(begun),
      total_(total),
      form_(quiet                   ? Form::none
            : isatty(STDERR_FILENO) ? Form::bar
                                    : Form::lines) {}

Progress::~Progress() {
    if (followed == this) followed = nullptr;
    if (drawn_) std::fputc('\n', stderr);
}

void Progress::follow() {
    followed = this;
    solved = begun_;
}

void frameSolved() {
    if (!followed) return;
    followed->show(++solved);
    stopIfInterrupted();
}

void Progress::show(int done) {
    if (form_ == Form::none) return;
    const Clock::time_point now = Clock::now();
    const auto since = [&](Clock::time_point then) {
        return std::chrono::duration<double>(now - then).count();
    };
    const bool last = done >= total_;
    const double period = form_ == Form::bar ? barPeriod : linePeriod;
    if (since(shown_) < period && !last) return;
    shown_ = now;
    const double rate = (done - begun_) / std::max(since(start_), 1e-9);
    char numbers[96];
    const int length =
        std::snprintf(numbers, sizeof numbers, "%d/%d %s", done, total_, unit_.c_str());
    if (rate > 0)
        std::snprintf(numbers + length, sizeof numbers - length, ", %.1f %s/s, %.0f s left", rate,
                      unit_.c_str(), (total_ - done) / rate);
    if (form_ == Form::lines) {
        std::fprintf(stderr, "%s: %s\n", name_.c_str(), numbers);
    } else {
        const int full = total_ > 0 ? barWidth * std::min(done, total_) / total_ : barWidth;
        const std::string bar = std::string(static_cast<std::size_t>(full), '=') +
                                std::string(static_cast<std::size_t>(barWidth - full), ' ');
        std::fprintf(stderr, "\r%s [%s] %s\x1b[K", name_.c_str(), bar.c_str(), numbers);
        drawn_ = true;
    }
    std::fflush(stderr);
}

}  // namespace plait
