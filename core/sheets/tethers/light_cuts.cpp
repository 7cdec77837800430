// The part of light.h that darkens what a cut takes the light from and lights it again.
#include "light.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plait {

void Geodesics::Light::darken(const Cut& cut) {
    visited_ = 0;
    dark_ = true;
    for (const int e : cut.edges)
        for (const int s : {surface_.stepsOf_[e], surface_.stepsOf_[e] + 1}) {
            const Way& from = ways_[surface_.steps_[s ^ 1].vertex];
            reach(surface_.steps_[s].vertex, from.length + surface_.steps_[s].length, from.source);
        }
    for (const int t : cut.triangles) {
        touch(t);
        for (const int entry : {3 * t, 3 * t + 1, 3 * t + 2}) {
            const Entry& e = surface_.entries_[entry];
            for (int n = firstOf(entry); n >= 0; n = windows_[n].previous)
                shade(n, windows_[n].begin, windows_[n].end);
            parent_ = -1 - e.apex;
            if (surface_.bends_[e.apex] || ways_[e.apex].length == 0)
                send(entry, {0, e.length, e.at, ways_[e.apex].length, ways_[e.apex].source});
        }
    }
    spread();
    dark_ = false;
    forget();
}

// A vertex that is reached just as its way did is dark: whatever leads there is as long.
void Geodesics::Light::loseWay(int vertex, double length) {
    const double known = ways_[vertex].length;
    if (isDark_[vertex] || known == 0 || known == infinity ||
        !(std::fabs(length - known) <= alike * known))
        return;
    isDark_[vertex] = true;
    darkened_.push_back(vertex);
    open_.emplace(known, ++order_, vertex, -1);
}

// The last window of an entry, after forgetting those of which nothing is left.
int Geodesics::Light::firstOf(int entry) {
    for (int* n = &latest_[entry]; *n >= 0;) {
        Window& w = windows_[*n];
        if (w.begin < w.end)
            n = &w.previous;
        else
            *n = w.previous;
    }
    return latest_[entry];
}

// What light went on by from the same parent.
void Geodesics::Light::loseLight(const Window& w) {
    for (int c = childrenOf(parent_); c >= 0; c = children_[c].next)
        for (int n = children_[c].window; n >= 0; n = windows_[n].rest) {
            ++visited_;
            const Window& lit = windows_[n];
            if (lit.entry == w.entry && lit.begin < lit.end)
                shade(n, std::max(w.begin, lit.begin), std::min(w.end, lit.end));
        }
}

// Shadows of a window grow together: what is between them is dark as well. Windows may be as narrow
// as rounding makes them, and darkness must not pass by them.
void Geodesics::Light::shade(int window, double begin, double end) {
    if (begin > end + alike * surface_.entries_[windows_[window].entry].length) return;
    if (begin > end) std::swap(begin, end);
    const auto [at, fresh] = shadows_.try_emplace(window, Shadow{begin, end, true});
    Shadow& shadow = at->second;
    if (!fresh && begin >= shadow.begin && end <= shadow.end) return;
    shadow.begin = std::min(shadow.begin, begin);
    shadow.end = std::max(shadow.end, end);
    if (!shadow.passed) return;
    shadow.passed = false;
    queue(window, shadow.begin, shadow.end);
}

void Geodesics::Light::touch(int triangle) {
    if (isTouched_[triangle]) return;
    isTouched_[triangle] = true;
    touched_.push_back(triangle);
}

// Takes dark vertices their ways and windows their shadows.
void Geodesics::Light::forget() {
    for (const auto& [n, shadow] : shadows_) {
        Window& w = windows_[n];
        touch(w.entry / 3);
        const double begin = w.begin, end = w.end;
        const double near = alike * surface_.entries_[w.entry].length;
        const bool left = shadow.begin<begin + near, right = shadow.end> end - near;
        if (left) w.begin = shadow.end;
        if (!left || right) w.end = shadow.begin;
        if (left && right) w.end = w.begin;
        if (left || right) continue;
        Window rest = w;
        rest.begin = shadow.end, rest.end = end, rest.previous = latest_[w.entry];
        w.rest = latest_[w.entry] = static_cast<int>(windows_.size());
        windows_.push_back(rest);
    }
    shadows_.clear();
    for (const int v : darkened_) {
        ways_[v] = {infinity, -1};
        sent_[v] = -1;
        for (const int entry : surface_.corners_[v]) touch(entry / 3);
    }
}

// Light of the same parent has come by there already.
bool Geodesics::Light::isLit(const Window& w) {
    const double near = alike * surface_.entries_[w.entry].length;
    for (int c = childrenOf(parent_); c >= 0; c = children_[c].next)
        for (int n = children_[c].window; n >= 0; n = windows_[n].rest) {
            const Window& lit = windows_[n];
            if (lit.entry == w.entry && lit.before <= w.before && lit.begin < w.begin + near &&
                lit.end > w.end - near)
                return true;
        }
    return false;
}

// What darkness put out or kept out stands in triangles that it touched: light is put out only
// by ways to the vertices of its side, and around dark ones all is touched.
void Geodesics::Light::relight() {
    std::vector<int> vertices;
    for (const int t : touched_)
        for (const int entry : {3 * t, 3 * t + 1, 3 * t + 2}) {
            vertices.push_back(surface_.entries_[entry].apex);
            for (int n = firstOf(entry); n >= 0; n = windows_[n].previous)
                queue(n, windows_[n].begin, windows_[n].end);
        }
    for (const int v : darkened_)
        for (const int step : surface_.edges_[v]) vertices.push_back(surface_.steps_[step].vertex);
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    for (const int v : vertices)
        if (ways_[v].length < infinity) open_.emplace(ways_[v].length, ++order_, v, -1);
    spread();
    for (const int v : darkened_) isDark_[v] = false;
    for (const int t : touched_) isTouched_[t] = false;
    darkened_.clear();
    touched_.clear();
}

}  // namespace plait
