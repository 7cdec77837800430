// What materials look like, in numbers for the shaders.
#pragma once

#include "scenes/view.h"

#include <glm/glm.hpp>

namespace plait {

enum class Family { cloth, metal, coat, skin, tulle, brushed, latex, water, glass, crystal, spark };

// `numbers` is what the family's shader calls `finish`.
struct Finish {
    Family family;
    glm::vec4 numbers;
    float wrap = 0.25f;  // of a cloth's diffuse light around its terminator
    float gloss = 0;     // of a cloth's threads
};

inline Finish finishOf(Material material) {
    switch (material) {
        case Material::silk:
            return {Family::cloth, {0.35f, 0.13f, 0.26f, 0.28f}, 0.25f, 1.1f};
        case Material::cotton:
            return {Family::cloth, {0.3f, 0.6f, 0.6f, 0.14f}, 0.3f, 0.15f};
        case Material::brass:
            return {Family::metal, {0, 0.14f, 0, 0}};
        case Material::steel:
            return {Family::metal, {0, 0.35f, 0, 0}};
        case Material::wire:
            return {Family::metal, {0, 0.4f, 0, 0}};
        case Material::matte:
            return {Family::coat, {0.02f, 0.7f, 0.1f, 0}};
        case Material::rubber:
            return {Family::coat, {0.04f, 0.3f, 0.35f, 0.6f}};
        case Material::satin:
            return {Family::cloth, {0.45f, 0.1f, 0.3f, 0.12f}, 0.2f, 2.2f};
        case Material::tulle:
            return {Family::tulle, {0.3f, 24, 0.5f, 0}};
        case Material::skin:
            return {Family::skin, {0.03f, 0.42f, 0.09f, 0.3f}};
        case Material::brushed:
            return {Family::brushed, {0, 0.26f, 0.5f, 0.35f}};
        case Material::latex:
            return {Family::latex, {0.04f, 0.12f, 0.55f, 0.35f}};
        case Material::water:
            return {Family::water, {}};
        case Material::glass:
            return {Family::glass, {0.12f, 0.04f, 4, 0}};
        case Material::crystal:
            return {Family::crystal, {0.15f, 0.04f, 0, 0}};
        case Material::spark:
            return {Family::spark, {}};
    }
    return {Family::coat, {}};
}

// Optical, of a wall at rest, by channel; without light in one it is all but opaque there.
inline glm::vec3 depthOf(const Wall& wall, const glm::vec3& color) {
    return -glm::log(glm::max(color, 1e-6f)) * static_cast<float>(wall.thickness / wall.clear);
}

}  // namespace plait
