// Surfaces: the vertex shader and one fragment shader for each family of materials.
#pragma once

namespace plait {

// Follows stageShader and, for cloth, clothLightShader. What changes slowly, shadow and openness,
// is looked up by vertex: a pixel of a fine mesh is shaded several times over, once for each small
// triangle that touches its block. Where all triangles are small, light as a whole is (SMALL), for
// both sides: which one is seen is known by pixel only.
inline constexpr const char* surfaceVertexShader = R"glsl(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 tangent;
layout(location = 3) in vec2 uv;
layout(location = 4) in vec3 tint;
layout(location = 5) in float cavity;
layout(location = 6) in float satin;
uniform mat4 camera;
uniform float lowest;
uniform float thickness;  // each side of a cloth stands off by half of it
out vec3 vertexTint;
out vec2 cloth;
#ifdef SMALL
uniform float facet;  // m, between vertices
centroid out vec3 frontDiffuse, frontShine, backDiffuse, backShine;
#else
centroid out vec3 P, N, T;
#ifdef WIRE
centroid
#endif
out vec2 vertexShade;
#endif
#ifdef TULLE
centroid out vec3 frontDiffuse, frontShine;
#endif
#ifdef BRUSHED
centroid out vec3 vertexMirrored;
#endif
#ifdef SKIN
out float vertexSatin;
#endif
#ifdef LATEX
out float vertexStretch;
#endif
#ifdef WIRE
centroid out float vertexCover;  // of what lies behind
#endif
void main() {
    vec3 p = position + normal * sign(dot(normal, eye - position)) * thickness;
    cloth = uv;
    vertexTint = tint;
#ifdef SMALL
    vec3 v = normalize(eye - p);
    float key = keyVisible(p, normal), turn = .5 * square(cavity * facet);
    clothLight(v, normal, tangent, key, cavity, turn, frontDiffuse, frontShine);
    clothLight(v, -normal, tangent, key, -cavity, turn, backDiffuse, backShine);
#else
    P = p;
    N = normal;
    T = tangent;
    vertexShade = vec2(1, cavity);
#ifdef WIRE
    vertexCover = satin;
#endif
#ifdef SKIN
    vertexSatin = satin;
#endif
#ifdef LATEX
    vertexStretch = satin;
#endif
#ifdef TULLE
    tulleLight(normalize(eye - p), normal, tangent, keyVisible(p, normal), frontDiffuse, frontShine);
#elif defined FINE
    vertexShade.x = keyVisible(P, normal);
#endif
#ifdef BRUSHED
    vertexMirrored = mirroredLight(normalize(eye - p), normal, tangent, vertexShade.x);
#endif
#endif
    gl_Position = camera * vec4(p, 1);
    gl_ClipDistance[0] = p.y - lowest;
}
)glsl";

// Follows stageShader.
inline constexpr const char* reflectionShader = R"glsl(
vec3 hemisphere(vec3 n) { return bright * mix(floorColor, skyColor, .5 + .5 * n.y); }

float wrapped(float nl, float w) { return square(max(nl + w, 0.0) / (1.0 + w)); }

float fifth(float a) { return a * square(square(a)); }

// Smooth normals turn away a little before the surface does.
vec3 turned(vec3 n, vec3 v) { return normalize(n + v * max(.05 - dot(n, v), 0.0)); }
)glsl";

// Follows reflectionShader; in front of a family's own text.
inline constexpr const char* surfaceShader = R"glsl(
uniform vec3 color;
in vec3 vertexTint;
in vec2 cloth;
out vec4 result;

#ifndef SMALL
centroid in vec3 P, N, T;
#ifdef WIRE
centroid
#endif
in vec2 vertexShade;

// Widening of a lobe by the spread of normals in a pixel (Kaplanyan et al. 2016): no sparkles.
float spread(vec3 n) {
    vec3 dx = dFdx(n), dy = dFdy(n);
    return min(.5 * (dot(dx, dx) + dot(dy, dy)), .18);
}

// The normal of the side that is seen.
vec3 seenNormal(vec3 v) { return turned(normalize(gl_FrontFacing ? N : -N), v); }

// The mesh of an object is fine, that of a prop may be coarse.
float keyLight(vec3 n) {
#ifdef FINE
    return vertexShade.x;
#else
    return keyVisible(P, n);
#endif
}

// How much of the sky is open; of a wire, how much of all around.
#ifdef WIRE
centroid in float vertexCover;
float openness() { return vertexShade.y * mix(.55, 1.0, skyVisible(P)); }
vec4 shown(vec3 light) { return vertexCover * vec4(light, 1); }
#else
float openness() { return mix(.55, 1.0, skyVisible(P)); }
vec4 shown(vec3 light) { return vec4(light, 1); }
#endif

// GGX with half vector h, without masking.
float lobe(vec3 n, vec3 h, float nl, float alpha2) {
    float d = square(dot(n, h)) * (alpha2 - 1.0) + 1.0;
    return alpha2 / (pi * d * d) * max(nl, 0.0);
}
#endif

#ifdef OVERLAY
vec3 surfaceColor() { return vertexTint; }
vec3 blend(vec3 base, vec3 diffuse, vec3 shine) { return base * (.45 + .5 * diffuse) + .05 * shine; }
#else
#ifdef COLORS
vec3 surfaceColor() { return vertexTint; }
#else
vec3 surfaceColor() { return color; }
#endif
vec3 blend(vec3 base, vec3 diffuse, vec3 shine) { return base * diffuse + shine; }
#endif
)glsl";

inline constexpr const char* metalShader = R"glsl(
uniform vec4 finish;  // -, roughness, -, -

void main() {
    vec3 v = normalize(eye - P), n = seenNormal(v);
    vec3 base = surfaceColor();
    float alpha2 = square(square(finish.y)) + spread(n), key = keyLight(n), open = openness();
    vec3 r = reflect(-v, n);
    vec3 fresnel = base + (1.0 - base) * fifth(1.0 - max(dot(n, v), 0.0));
    // Two soft boxes where key and fill stand, so that round metal has something to mirror.
    float low = .95 - 1.6 * finish.y;
    vec3 around = backdrop(r, 2.0 * finish.y) +
                  keyColor * .9 * key * smoothstep(low, 1.0, dot(r, keyDirection)) +
                  fillColor * .8 * smoothstep(low, 1.0, dot(r, fillDirection));
    vec3 shine = keyColor * key * lobe(n, normalize(keyDirection + v), dot(n, keyDirection), alpha2) +
                 rimColor * lobe(n, normalize(rimDirection + v), dot(n, rimDirection), alpha2);
    vec3 rough = keyColor * key * max(dot(n, keyDirection), 0.0) + hemisphere(n);
    result = shown(blend(base, .4 * finish.y * rough, fresnel * (around * open + .4 * shine)));
}
)glsl";

inline constexpr const char* coatShader = R"glsl(
uniform vec4 finish;  // strength and roughness of the coat, wrap, warmth of the terminator

void main() {
    vec3 v = normalize(eye - P), n = seenNormal(v);
    float key = keyLight(n), open = openness(), nk = dot(n, keyDirection);
    float alpha2 = square(square(finish.y)) + spread(n);
    vec3 turn = mix(vec3(1), vec3(1, .55, .4), finish.w * (1.0 - smoothstep(-.1, .45, nk)));
    vec3 diffuse = hemisphere(n) * open + keyColor * key * wrapped(nk, finish.z) * turn +
                   bright * fillColor * wrapped(dot(n, fillDirection), .5) * (.5 + .5 * open) +
                   rimColor * max(dot(n, rimDirection), 0.0);
    float fresnel = finish.x * (1.0 + 5.0 * fifth(1.0 - max(dot(n, v), 0.0)));
    vec3 shine = keyColor * key * lobe(n, normalize(keyDirection + v), nk, alpha2) +
                 rimColor * lobe(n, normalize(rimDirection + v), dot(n, rimDirection), alpha2);
    shine = .25 * pi * finish.x * shine + fresnel * backdrop(reflect(-v, n), .5) * open;
    result = shown(blend(surfaceColor(), diffuse, shine));
}
)glsl";

inline constexpr const char* sparkShader = R"glsl(
void main() { result = shown(surfaceColor()); }
)glsl";

}  // namespace plait
