// The light that found the shortest ways from some sources (geodesics.h), kept so that after a cut
// only those ways are found again that led through it.
//
// Darkness spreads as light does: from what is cut on through every window that light has come by
// since, and along edges, to the vertices whose length it accounts for. No way through the cut is
// missed, flat or not, because darkness goes by what light did go by, and nothing else stops it.
// Windows lose what is dark of them. Then what still lights the triangles that darkness went
// through (windows, and vertices where ways turn, new corners among them) does so once more: there,
// what was put out because other light was nearer goes on now. No light is needed elsewhere: what
// is not dark kept its way, and a cut makes none shorter.
#pragma once

#include "geodesics.h"

#include <map>
#include <queue>
#include <tuple>

namespace plait {

class Geodesics::Light {
public:
    // Of the surface as it is; it must stay where it is. Throws std::invalid_argument for a source
    // that is not a vertex.
    Light(const Geodesics& surface, std::span<const int> sources);

    const std::vector<Way>& ways() const { return ways_; }  // by vertex of the complex

    // A cut of the surface: `darken` before it takes it, `relight` after.
    void darken(const Cut& cut);
    void relight();

    // Windows and vertices looked at since the beginning, or since the last `darken`.
    long visited() const { return visited_; }

private:
    // What is lit of a side, from `begin` to `end` along it, by a source (x, y), y < 0, that is
    // itself `before` away from where the way began.
    struct Window {
        int entry;
        int source;
        double begin, end;
        Point light;
        double before;
        int previous;       // window of the entry, -1 for none
        int children = -1;  // where its light goes on: the first of a list in children_
        int rest = -1;      // another part of the same light's, beyond a shadow
    };
    struct Beam {
        double begin, end;  // along the side
        Point light;        // in the plane of the triangle that it leaves, the side as x axis
        double before;
        int source;
    };
    struct Child {
        int window, next;
    };
    struct Shadow {
        double begin, end;  // of a window
        bool passed;
    };

    // Of the length of a side: the same place; and more than rounding, around what is dark.
    static constexpr double alike = 1e-9, blurred = 1e-6;

    static double distance(Point a, Point b) {
        return squareRoot((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
    }

    void spread();
    void reach(int vertex, double length, int source);
    void leave(int vertex);
    void send(int out, const Beam& beam);
    void enter(const Window& w);
    bool helps(const Window& w) const;
    void pass(int number);
    void adopt(int window);
    void aim(const Window& w, int out, Point foot, int footVertex, double x0, double x1,
             double middle);

    void loseWay(int vertex, double length);
    void loseLight(const Window& w);
    void shade(int window, double begin, double end);
    void forget();
    void touch(int triangle);
    void queue(int window, double begin, double end);
    bool isLit(const Window& w);
    int& childrenOf(int parent) {
        return parent < 0 ? sent_[-1 - parent] : windows_[parent].children;
    }
    int firstOf(int entry);

    const Geodesics& surface_;
    std::vector<Way> ways_;
    std::vector<Window> windows_;
    std::vector<Child> children_;
    std::vector<int> sent_;     // by vertex: as Window::children
    int parent_ = 0;            // the window that light goes on from, or -1 - the vertex
    std::vector<int> latest_;   // by entry: its last window
    std::vector<int> waiting_;  // by entry: its last window, while it waits
    // Length, order of arrival, then a vertex or a window.
    using Event = std::tuple<double, long, int, int>;
    std::priority_queue<Event, std::vector<Event>, std::greater<>> open_;
    long order_ = 0, visited_ = 0;

    bool dark_ = false;              // darkness spreads, not light
    std::map<int, Shadow> shadows_;  // by window
    std::vector<bool> isDark_;       // by vertex
    std::vector<int> darkened_;      // vertices
    std::vector<bool> isTouched_;    // by triangle: light may come in; none: everywhere
    std::vector<int> touched_;
};

}  // namespace plait
