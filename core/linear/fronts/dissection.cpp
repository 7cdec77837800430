#include "dissection.h"

#include <algorithm>
#include <limits>

namespace plait {
namespace {

class Dissector {
public:
    Dissector(std::span<const Vec<double>> rest, const Csr& neighbours, int leaf)
        : rest_(rest), neighbours_(neighbours), leaf_(leaf), left_(rest.size(), 0) {}

    void dissect(std::vector<int> vertices) {
        const auto first = out.parts.size();
        if (static_cast<int>(vertices.size()) > leaf_) {
            Halves halves = cut(vertices);
            dissect(std::move(halves.left));
            dissect(std::move(halves.right));
            vertices = std::move(halves.separator);
        }
        if (!vertices.empty()) append(vertices, first);
    }

    Dissection out;

private:
    struct Halves {
        std::vector<int> left, right, separator;
    };
    using Axis = double Vec<double>::*;

    // The parts since `first` that have no parent yet are its children.
    void append(const std::vector<int>& vertices, std::size_t first) {
        const int index = static_cast<int>(out.parts.size());
        for (std::size_t p = first; p < out.parts.size(); ++p)
            if (out.parts[p].parent < 0) out.parts[p].parent = index;
        const int begin = static_cast<int>(out.order.size());
        out.order.insert(out.order.end(), vertices.begin(), vertices.end());
        out.parts.push_back({begin, static_cast<int>(out.order.size()), -1});
    }

    Axis longestAxis(const std::vector<int>& vertices) const {
        Axis longest = nullptr;
        double most = -1;
        for (const Axis axis : {&Vec<double>::x, &Vec<double>::y, &Vec<double>::z}) {
            double low = std::numeric_limits<double>::infinity(), high = -low;
            for (const int v : vertices) {
                low = std::min(low, rest_[v].*axis);
                high = std::max(high, rest_[v].*axis);
            }
            if (high - low > most) longest = axis, most = high - low;
        }
        return longest;
    }

    // Halves by the median along the longest axis. Vertices level with it go to one half, which
    // leaves a regular mesh a straight cut, unless that half gets more than three quarters.
    void markLeft(const std::vector<int>& vertices) {
        const Axis axis = longestAxis(vertices);
        std::vector<double> along;
        for (const int v : vertices) along.push_back(rest_[v].*axis);
        const auto middle = along.begin() + static_cast<std::ptrdiff_t>(along.size() / 2);
        std::nth_element(along.begin(), middle, along.end());
        const double median = *middle;
        const auto count = [&](auto holds) {
            return std::count_if(along.begin(), along.end(), holds);
        };
        const auto n = static_cast<std::ptrdiff_t>(vertices.size());
        const std::ptrdiff_t below = count([&](double s) { return s < median; });
        const std::ptrdiff_t level = count([&](double s) { return s == median; });
        std::ptrdiff_t toLeft = n / 2 - below;
        if (4 * below >= n)
            toLeft = 0;
        else if (4 * (below + level) <= 3 * n)
            toLeft = level;
        for (const int v : vertices) {
            const double s = rest_[v].*axis;
            left_[v] = s < median || (s == median && toLeft-- > 0);
        }
    }

    // The vertices on the right that touch the left lie between.
    Halves cut(const std::vector<int>& vertices) {
        markLeft(vertices);
        const auto isLeft = [&](int v) { return left_[v] != 0; };
        Halves halves;
        for (const int v : vertices) {
            const std::span<const int> around = neighbours_[v];
            if (isLeft(v))
                halves.left.push_back(v);
            else if (std::any_of(around.begin(), around.end(), isLeft))
                halves.separator.push_back(v);
            else
                halves.right.push_back(v);
        }
        for (const int v : vertices) left_[v] = 0;
        return halves;
    }

    std::span<const Vec<double>> rest_;
    const Csr& neighbours_;
    int leaf_;
    std::vector<unsigned char> left_;  // 1: in the left half of the part that is being cut
};

}  // namespace

Dissection dissect(std::span<const Vec<double>> rest, const Csr& neighbours,
                   std::vector<int> vertices, int leaf) {
    Dissector dissector(rest, neighbours, leaf);
    dissector.dissect(std::move(vertices));
    return std::move(dissector.out);
}

}  // namespace plait
