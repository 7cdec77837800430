// The backdrop and the ground, wherever nothing stands before them. The ground is met by the ray of
// each pixel rather than drawn as a plane: it dissolves without an edge, and what lies on it never
// fights with it for the nearer depth.
#pragma once

namespace plait {

inline constexpr const char* screenVertexShader = R"glsl(#version 330 core
uniform mat4 unproject;  // clip to world
out vec3 far;
out vec2 screen;
void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(corner, 1, 1);
    screen = .5 + .5 * corner;
    vec4 p = unproject * gl_Position;
    far = p.xyz / p.w;
}
)glsl";

inline constexpr const char* backdropShader = R"glsl(
uniform vec3 ground;        // height, radii where it begins and ends to dissolve
uniform vec3 groundColor;
uniform vec2 groundCenter;  // x, z
in vec3 far;
in vec2 screen;
out vec4 result;

#ifdef GROUND
vec3 groundAt(vec3 p) {
    vec3 place = (keyMatrix * vec4(p, 1)).xyz, above = (skyMatrix * vec4(p, 1)).xyz;
    // Narrow near the caster, wide far from it.
    float near = visible(keyNarrow, place, .004), wide = visible(keyWide, place, .004);
    float key = mix(wide, near, square(near));
    float open = min(visible(skyNarrow, above, .002), visible(skyWide, above, .002));
    vec3 light = keyColor * keyDirection.y * key + fillColor * fillDirection.y +
                 .25 * rimColor * rimDirection.y + skyColor * mix(.45, 1.0, open);
    return groundColor * light * mix(.8, 1.0, open);
}

vec3 onGround(vec3 color, vec3 direction) {
    if (direction.y > -1e-4 || eye.y < ground.x) return color;
    vec3 p = eye + (ground.x - eye.y) / direction.y * direction;
    float alpha = 1.0 - smoothstep(ground.y, ground.z, length(p.xz - groundCenter));
    return mix(color, groundAt(p), alpha);
}
#else
vec3 onGround(vec3 color, vec3 direction) { return color; }
#endif

void main() {
    vec3 direction = normalize(far - eye);
    result = vec4(onGround(backdropAt(screen.y, direction), direction), 1);
}
)glsl";

}  // namespace plait
