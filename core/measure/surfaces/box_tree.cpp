#include "box_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace plait {
namespace {

Box join(const Box& a, const Box& b) {
    return {
        {std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y), std::min(a.low.z, b.low.z)},
        {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y), std::max(a.high.z, b.high.z)}};
}

double Vec<double>::* longestAxis(const Box& b) {
    const Vec<double> size = b.high - b.low;
    if (size.x >= size.y && size.x >= size.z) return &Vec<double>::x;
    return size.y >= size.z ? &Vec<double>::y : &Vec<double>::z;
}

}  // namespace

Box boxOf(std::span<const Vec<double>> points) {
    Box box{points[0], points[0]};
    for (const auto& p : points) box = join(box, {p, p});
    return box;
}

BoxTree::BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), items_(boxes_.size()) {
    std::iota(items_.begin(), items_.end(), 0);
    if (!items_.empty()) build(0, static_cast<int>(items_.size()));
}

void BoxTree::build(int first, int last) {
    Box box = boxes_[items_[first]];
    for (int i = first; i < last; ++i) box = join(box, boxes_[items_[i]]);
    const auto node = nodes_.size();
    nodes_.push_back({box, first, last, 0});
    if (last - first <= leafSize) return;
    const auto axis = longestAxis(box);
    const auto begin = items_.begin();
    const int middle = first + (last - first) / 2;
    std::nth_element(begin + first, begin + middle, begin + last, [&](int a, int b) {
        return boxes_[a].low.*axis + boxes_[a].high.*axis <
               boxes_[b].low.*axis + boxes_[b].high.*axis;
    });
    build(first, middle);
    nodes_[node].right = static_cast<int>(nodes_.size());
    build(middle, last);
}

}  // namespace plait
