#include "chain_layout.h"

#include "chain_solve.h"

#include <algorithm>

namespace plait {
namespace {

// Of what is left of a row, and of one of its values.
int numbersOf(const ChainStencils& part) {
    return part.values * (valueNumbers + 3 * part.arity) + (part.links ? linkNumbers : 0);
}
int gradientOf(int a) { return valueNumbers + 3 * a; }

}  // namespace

ChainLayout::ChainLayout(const ChainCurve& plan, std::span<const ChainStencils> stencils,
                         std::span<const int> members, int width, bool along)
    : width_(width),
      along_(along),
      vertices_(static_cast<int>(plan.vertices.size())),
      moving_(plan.moving),
      shape_{static_cast<int>(plan.places.size()), plan.halfWidth, plan.border} {
    placeRows(plan, stencils, members);
    meet(plan);
    join(plan, stencils);
}

void ChainLayout::placeRows(const ChainCurve& plan, std::span<const ChainStencils> stencils,
                            std::span<const int> members) {
    places_.resize(plan.places.size());
    for (int p = 0; p < static_cast<int>(stencils.size()); ++p) {
        const ChainStencils& of = stencils[p];
        std::vector<const ChainPlace*> rows;
        const int numbers = numbersOf(of);
        for (std::size_t i = 0; i < plan.places.size(); ++i) {
            const ChainPlace& place = plan.places[i];
            if (place.part != p) continue;
            if (place.value == 0) rows.push_back(&place);
            const int value = valueNumbers + 3 * of.arity, r = static_cast<int>(rows.size()) - 1;
            places_[i] = out_ + slot(r, numbers) + place.value * value * width_;
        }
        if (rows.empty()) continue;
        const int count = static_cast<int>(rows.size()),
                  blocks = along_ ? (count + width_ - 1) / width_ : count,
                  lanes = along_ ? width_ : 1;
        parts_.push_back({p, count, blocks, static_cast<int>(ids_.size()), parameters_, out_});
        parameters_ += blocks * width_ * members[p];
        out_ += blocks * width_ * numbers;
        // Blocks are filled up with their last row.
        for (int block = 0; block < blocks; ++block)
            for (int a = 0; a < of.arity; ++a)
                for (int lane = 0; lane < lanes; ++lane)
                    ids_.push_back(rows[std::min(block * lanes + lane, count - 1)]->at[a]);
    }
}

void ChainLayout::meet(const ChainCurve& plan) {
    std::vector<std::vector<ChainMeeting>> at(moving_);
    const int rows = shape_.rows, band = bandOf(shape_);
    std::vector<int> last(band, 0);
    for (int i = 0; i < rows; ++i) {
        const ChainPlace& place = plan.places[i];
        for (int a = 0; a < place.arity; ++a) {
            const int v = place.at[a];
            if (v >= moving_) continue;
            at[v].push_back({i, places_[i] + gradientOf(a) * width_});
            if (i < band) last[i] = std::max(last[i], v);
        }
    }
    int done = 0;
    for (int v = 0; v < moving_; ++v) {
        begins_.push_back(static_cast<int>(meetings_.size()));
        const auto edge = std::ranges::find_if(
            at[v], [&](const ChainMeeting& meeting) { return meeting.row >= band; });
        edges_.push_back(begins_.back() + static_cast<int>(edge - at[v].begin()));
        meetings_.insert(meetings_.end(), at[v].begin(), at[v].end());
        while (done < band && last[done] <= v) ++done;
        ready_.push_back(done);
    }
    begins_.push_back(static_cast<int>(meetings_.size()));
}

void ChainLayout::join(const ChainCurve& plan, std::span<const ChainStencils> stencils) {
    std::vector<int> joined(vertices_, -1);
    const auto isLink = [&](const ChainPlace& place) { return stencils[place.part].links; };
    for (const ChainPlace& place : plan.places)
        if (isLink(place))
            for (const int v : {place.at[0], place.at[1]})
                if (v < moving_) joined[v] = 0;
    for (int v = 0; v < moving_; ++v)
        if (joined[v] == 0) {
            joined[v] = static_cast<int>(joinedAt_.size());
            joinedAt_.push_back(v);
        }
    links_.rows = static_cast<int>(joinedAt_.size());
    for (int i = 0; i < shape_.rows; ++i) {
        const ChainPlace& place = plan.places[i];
        if (!isLink(place)) continue;
        const auto moves = [&](int v) { return v < moving_ ? v : -1; };
        const int left = joined[place.at[0]], right = joined[place.at[1]];
        joints_.push_back({i, places_[i] + gradientOf(2) * width_, moves(place.at[0]),
                           moves(place.at[1]), left, right});
        if (left < 0 || right < 0) continue;
        const auto [a, b] = std::minmax(left, right);
        if (2 * (b - a) > std::max(links_.rows, 16))
            links_.border = std::max(links_.border, links_.rows - b);
        else
            links_.halfWidth = std::max(links_.halfWidth, b - a);
    }
}

int ChainLayout::systemScratch() const {
    return along_ ? chainWork<double>(shape_, links_, moving_)
                  : curves() * chainWork<Pack<4, double>>(shape_, links_, moving_);
}

ChainSystem ChainLayout::system(const int* ids, double* lambda, double* scratch) const {
    return {.ids = ids,
            .vertices = vertices_,
            .moving = moving_,
            .places = places_.data(),
            .begins = begins_.data(),
            .edges = edges_.data(),
            .ready = ready_.data(),
            .meetings = meetings_.data(),
            .joints = joints_.data(),
            .jointCount = static_cast<int>(joints_.size()),
            .joined = links_.rows,
            .joinedAt = joinedAt_.data(),
            .rows = shape_,
            .links = links_,
            .step = width_,
            .vertexNumbers = scratch,
            .out = scratch + vertexScratch(),
            .lambda = lambda,
            .work = scratch + vertexScratch() + out_,
            .keep = 1,
            .redundant = 0,
            .rates = false,
            .fall = {0, 0, 0}};
}

}  // namespace plait
