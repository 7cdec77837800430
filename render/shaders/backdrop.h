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
float fifth(float a) { return a * square(square(a)); }

float lit(sampler2D cover, vec2 place) { return smoothstep(.1, 1.0, 1.0 - texture(cover, place).r); }

float keyLit(vec2 place) {
    float near = lit(keyNarrow, place), wide = lit(keyWide, place);
#ifdef SPOT
    // A lamp that is seen under .1: a caster's penumbra is as much wider as it is higher.
    vec2 all = texture(keyFar, place).rg;
    float sigma = .1 * all.y / max(all.x, 1e-3) / keyTexel;
    return mix(mix(near, wide, smoothstep(2.5, 7.0, sigma)), lit(keyFar, place), smoothstep(7.0, 24.0, sigma));
#else
    return mix(wide, near, square(near));  // narrow near the caster, wide far from it
#endif
}

float skyLit(vec2 place) {
    float open = min(lit(skyNarrow, place), lit(skyWide, place));
#ifdef SPOT
    vec2 all = texture(skyFar, place).rg;
    float height = all.y / max(all.x, 1e-3) / keyTexel;
    open = mix(open, 1.0 - .7 * all.x, smoothstep(5.0, 60.0, height));
#endif
    return open;
}

vec3 groundAt(vec3 p) {
    vec2 place = (keyMatrix * vec4(p, 1)).xy, above = (skyMatrix * vec4(p, 1)).xy;
    float key = keyLit(place);
    float open = skyLit(above);
    vec3 light = keyColor * keyDirection.y * key * spotlight(p) + bright * fillColor * fillDirection.y +
                 bright * .25 * rimColor * rimDirection.y + bright * skyColor * mix(.45, 1.0, open);
    return groundColor * light * mix(.8, 1.0, open);
}

#ifdef MIRROR
uniform sampler2D mirrorNear, mirrorFar;
uniform vec2 mirror;   // its strength where it is grazed, height at which it has faded to 1 / e
uniform vec2 subject;  // x, z of what stands there

// What the floor mirrors is as high as if it stood upright at the subject's distance; the higher, the
// more of it is scattered.
vec3 mirrored(vec3 color, vec3 p, vec3 direction) {
    float level = length(direction.xz), way = dot(subject - p.xz, direction.xz / level);
    float height = max(way, 0.0) * -direction.y / level / mirror.y;
    vec4 image = mix(texture(mirrorNear, screen), texture(mirrorFar, screen), smoothstep(0.0, .7, height));
    float part = mirror.x * exp(-height) * (.2 + .8 * fifth(1.0 + direction.y));
    return color * (1.0 - part * image.a) + part * image.rgb;
}
#else
vec3 mirrored(vec3 color, vec3 p, vec3 direction) { return color; }
#endif

vec3 onGround(vec3 color, vec3 direction) {
    if (direction.y > -1e-4 || eye.y < ground.x) return color;
    vec3 p = eye + (ground.x - eye.y) / direction.y * direction;
    float alpha = 1.0 - smoothstep(ground.y, ground.z, length(p.xz - groundCenter));
    return mix(color, mirrored(groundAt(p), p, direction), alpha);
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
