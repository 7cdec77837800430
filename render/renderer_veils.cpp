// What lets light through, after all that is opaque: thin wires, cloth, glass, water.
#include "render/matter/back_to_front.h"
#include "renderer.h"

#include <algorithm>
#include <cmath>

namespace plait {

// Wires that are thinner than they are drawn: over all that is opaque, farther turns first.
void Renderer::drawFaint(const Shot& shot) {
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDepthFunc(GL_LESS);
    for (std::size_t i = 0; i < skins_.size(); ++i) {
        if (!skins_[i].faint()) continue;
        useSurface(i, shot);
        glBindVertexArray(meshes_[i].array);
        uploadTriangles(sorted_,
                        backToFront(skins_[i].triangles(), skins_[i].vertices(), shot.pose.eye,
                                    skins_[i].group()),
                        GL_STREAM_DRAW);
        drawMesh(i);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, meshes_[i].triangles);
    }
    glDisable(GL_BLEND);
}

void Renderer::drawVeils(const Shot& shot) {
    const auto veil = std::ranges::find_if(skins_, isVeil);
    if (veil == skins_.end()) return;
    useSurface(static_cast<std::size_t>(veil - skins_.begin()), shot);
    veils_.draw(shot.pose.eye);
}

// Twice: factors of what is behind in any order, then sums.
void Renderer::drawGlass(const Shot& shot, int side) {
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LESS);
    for (const int layer : {0, 1}) {
        if (layer == 0)
            glBlendFunc(GL_ZERO, GL_SRC_COLOR);
        else
            glBlendFunc(GL_ONE, GL_ONE);
        for (std::size_t i = 0; i < skins_.size(); ++i) {
            if (!isGlass(skins_[i])) continue;
            const bool crystal = finishOf(skins_[i].material()).family == Family::crystal;
            if (!crystal && side == 1) continue;
            useSurface(i, shot);
            const Program& program = surfaceProgram(i, shot);
            program.set("layer", layer);
            program.set("side", side);
            if (side >= 0 && water_) program.set("water", 12, water_->depths());
            program.set("forward", shot.pose.forward());
            drawMesh(i);
        }
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

void Renderer::copyCanvas() const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, canvas_.framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.framebuffer);
    glBlitFramebuffer(0, 0, options_.width, options_.height, 0, 0, options_.width, options_.height,
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void Renderer::findWater(const Shot& shot) {
    if (!water_) return;
    water_->find({shot.pose.eye, shot.pose.forward(), shot.camera, shot.pose.fieldOfView}, empty_);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
}

// Over all else, but for glass that it is seen through. What it bends is the picture without any
// glass: as a lens it would show the glass that it is in upside down.
void Renderer::drawWater(const Shot& shot) {
    if (!water_) return;
    const WaterLens lens{shot.pose.eye, shot.pose.forward(), shot.camera, shot.pose.fieldOfView};
    canvas_.bind();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    setStage(water_->use(lens, resolved_.texture), shot.pose);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    drawScreen(empty_);
    glDisable(GL_BLEND);
    drawGlass(shot, 1);
}

}  // namespace plait
