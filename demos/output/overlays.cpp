#include "overlays.h"

#include <plait/measure/strain.h>
#include <plait/sets/coloring.h>

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

constexpr float strainHigh = 4;  // %

// The speed of a fall from the height of the scene, rounded up to 1, 2, 5, 10 ... m/s: one scale
// for a whole clip.
float speedScale(const std::vector<Vec<double>>& x) {
    double low = 0, high = 0;
    for (const Vec<double>& p : x)
        low = std::min({low, p.x, p.y, p.z}), high = std::max({high, p.x, p.y, p.z});
    const double fall = std::sqrt(2 * 9.81 * std::max(high - low, 1e-6));
    const double ten = std::pow(10, std::floor(std::log10(fall)));
    for (const double step : {1.0, 2.0, 5.0})
        if (fall <= step * ten) return static_cast<float>(step * ten);
    return static_cast<float>(10 * ten);
}

}  // namespace

const std::vector<std::string>& overlayNames() {
    static const std::vector<std::string> names{"none", "strain", "velocity", "colours",
                                                "contacts"};
    return names;
}

Overlays::Overlays(const Run& run, const std::string& name)
    : whole_(run.scene.world), name_(name), edges_(edgesOf(whole_)) {
    std::vector<int> ids;
    for (const auto& [a, b] : edges_.ends) ids.insert(ids.end(), {a, b});
    colors_.assign(whole_.rest.size(), 0);
    const std::vector<int> colors = greedyColors(ids, 2, whole_.complex.count(0));
    for (std::size_t i = colors.size(); i-- > 0;)
        colors_[static_cast<std::size_t>(edges_.ends[i][0])] = static_cast<float>(colors[i]);
    high_ = name == "velocity" ? speedScale(whole_.start) : name == "strain" ? strainHigh : 1;
}

Overlays::Edges Overlays::edgesOf(const World& world) {
    Edges edges;
    for (int i = 0; i < world.complex.count(1); ++i) {
        const auto [a, b] = edges.ends.emplace_back(world.complex.edge(i));
        edges.rest.push_back(length(world.rest[static_cast<std::size_t>(b)] -
                                    world.rest[static_cast<std::size_t>(a)]));
    }
    return edges;
}

// The most of the edges at a vertex.
void Overlays::showStrain(const Edges& edges, const RunFrame& frame, std::vector<float>& values) {
    const std::vector<double> strain = strains(frame.positions, edges.ends, edges.rest);
    for (std::size_t i = 0; i < strain.size(); ++i)
        for (const int v : edges.ends[i]) {
            float& most = values[static_cast<std::size_t>(v)];
            most = std::max(most, static_cast<float>(100 * std::fabs(strain[i])));
        }
}

Overlay Overlays::of(const RunFrame& frame) const {
    Overlay overlay{.values = std::vector<float>(whole_.rest.size(), 0),
                    .low = 0,
                    .high = high_,
                    .palette = legend().palette};
    if (name_ == "strain") {
        if (frame.cuts.empty())
            showStrain(edges_, frame, overlay.values);
        else
            showStrain(edgesOf(whole_.tornBy(frame.cuts)), frame, overlay.values);
    } else if (name_ == "velocity") {
        for (std::size_t i = 0; i < overlay.values.size(); ++i)
            overlay.values[i] = static_cast<float>(length(frame.velocities[i]));
    } else if (name_ == "colours") {
        overlay.values = colors_;
        if (frame.cuts.empty()) return overlay;
        const World torn = whole_.tornBy(frame.cuts);
        for (const VertexSplit& split : torn.torn->splits())
            overlay.values[split.copy] = colors_[torn.torn->original(split.copy)];
    } else if (name_ == "contacts") {
        overlay.values.assign(frame.touched.begin(), frame.touched.end());
    }
    return overlay;
}

Legend Overlays::legend() const {
    Legend legend{.name = name_, .unit = "", .low = 0, .high = high_, .palette = Palette::heat};
    if (name_ == "strain") legend.unit = "%";
    if (name_ == "velocity") legend.unit = "m/s";
    if (name_ == "colours" || name_ == "contacts") legend.palette = Palette::categories;
    if (name_ == "colours")
        legend.high = colors_.empty() ? 0 : *std::max_element(colors_.begin(), colors_.end());
    return legend;
}

}  // namespace plait
