// What is drawn of matter that comes apart.
#include "renderer.h"

#include <algorithm>

namespace plait {
namespace {

bool mayTear(const World& world, Range object) {
    return std::ranges::any_of(world.tearable, [&](const Tearable& tearable) {
        return object.first <= tearable.matter.first && tearable.spare.last <= object.last;
    });
}

// Copies look as their vertices do.
Look tornLook(Look look, const World& world) {
    if (!world.torn) return look;
    const auto copy = [&](auto& values) {
        if (values.empty()) return;
        for (const VertexSplit& split : world.torn->splits())
            if (look.object.first <= split.copy && split.copy < look.object.last)
                values[split.copy - look.object.first] =
                    values[world.torn->original(split.copy) - look.object.first];
    };
    copy(look.uv);
    copy(look.colors);
    copy(look.satin);
    return look;
}

}  // namespace

// Of its world what tornBy asks for.
void Renderer::prepareTears(const Scene& scene) {
    if (scene.world.tearable.empty()) return;
    whole_ = scene.world;
    whole_->sets.clear();
    whole_->forces.clear();
    whole_->pins.clear();
}

void Renderer::tear(std::span<const std::int32_t> cuts) {
    if (!whole_ || std::ranges::equal(cuts, cuts_)) return;
    cuts_.assign(cuts.begin(), cuts.end());
    const World world = whole_->tornBy(cuts_);
    for (std::size_t i = 0; i < view_.looks.size(); ++i) {
        if (!mayTear(world, view_.looks[i].object)) continue;
        skins_[i] = Skin(world, tornLook(view_.looks[i], world), pixel_);
        showTriangles(meshes_[i], skins_[i]);
    }
}

}  // namespace plait
