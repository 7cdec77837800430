// The rows of all rods of a set, by kind, so that those of one kind are a part each.
#pragma once

#include "bend_vector.h"
#include "chain_set.h"
#include "frame_rows.h"

#include <tuple>

namespace plait {

class RodRows {
public:
    template <class Kind>
    void add(const Rows<Kind>& more) {
        Rows<Kind>& all = std::get<Rows<Kind>>(rows_);
        all.ids.insert(all.ids.end(), more.ids.begin(), more.ids.end());
        all.rows.insert(all.rows.end(), more.rows.begin(), more.rows.end());
    }

    void addTo(Chains& chains) const {
        const auto one = [&](const auto& rows) {
            if (rows.size() > 0) chains.add(rows);
        };
        std::apply([&](const auto&... rows) { (one(rows), ...); }, rows_);
    }

private:
    std::tuple<Rows<Stretch>, Rows<DirectorAcross>, Rows<DirectorLength>, Rows<FrameTurn>,
               Rows<Angle>, Rows<Bend>, Rows<BendVector>>
        rows_;
};

}  // namespace plait
