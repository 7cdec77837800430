#include "inset_trail.h"

#include "demos/tools/errors.h"

#include <algorithm>

namespace plait {
namespace {

std::size_t metricOf(const Run& run, const std::string& name) {
    const auto& metrics = run.scene.metrics;
    const auto metric = std::ranges::find(metrics, name, &Metric::name);
    if (metric == metrics.end())
        throw SceneError(run.entry->name + " cannot be filmed: inset: no metric " + name);
    return static_cast<std::size_t>(metric - metrics.begin());
}

std::string labelOf(const Metric& metric) {
    return metric.name + (metric.unit.empty() ? "" : " [" + metric.unit + "]");
}

}  // namespace

InsetTrail::InsetTrail(const Run& run) : inset_(run.scene.view.inset) {
    if (!inset_) return;
    x_ = metricOf(run, inset_->x);
    y_ = metricOf(run, inset_->y);
    chart_.x = labelOf(run.scene.metrics[x_]);
    chart_.y = labelOf(run.scene.metrics[y_]);
    for (const auto& [x, y] : inset_->curve) chart_.curve.push_back({x, y});
    if (chart_.curve.size() < 2)
        throw SceneError(run.entry->name + " cannot be filmed: inset: a curve has two points");
}

void InsetTrail::add(const RunFrame& frame) {
    if (!inset_) return;
    const std::lock_guard lock(mutex_);
    trail_.push_back({frame.metrics[x_], frame.metrics[y_]});
}

std::optional<InsetChart> InsetTrail::at(int frame) const {
    if (!inset_) return {};
    InsetChart chart = chart_;
    const std::lock_guard lock(mutex_);
    chart.trail.assign(trail_.begin(), trail_.begin() + frame + 1);
    return chart;
}

}  // namespace plait
