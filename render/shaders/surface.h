// Surfaces: the vertex shader and one fragment shader for each family of materials.
#pragma once

namespace plait {

// Follows stageShader. What changes slowly, shadow and openness, is looked up by vertex: a pixel of
// a fine mesh is shaded several times over, once for each small triangle that touches its block.
inline constexpr const char* surfaceVertexShader = R"glsl(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 tangent;
layout(location = 3) in vec2 uv;
layout(location = 4) in vec3 tint;
layout(location = 5) in float cavity;
uniform mat4 camera;
uniform float thickness;  // each side of a cloth stands off by half of it
centroid out vec3 P, N, T;
out vec3 overlayTint;
out vec2 cloth, vertexShade;
void main() {
    P = position + normal * sign(dot(normal, eye - position)) * thickness;
    N = normal;
    T = tangent;
    cloth = uv;
    overlayTint = tint;
    vertexShade = vec2(1, cavity);
#ifdef FINE
    vertexShade.x = keyVisible(P, normal);
#endif
    gl_Position = camera * vec4(P, 1);
}
)glsl";

// Follows stageShader; in front of a family's own text.
inline constexpr const char* surfaceShader = R"glsl(
uniform vec3 color;
centroid in vec3 P, N, T;
in vec3 overlayTint;
in vec2 cloth, vertexShade;
out vec4 result;

// Widening of a lobe by the spread of normals in a pixel (Kaplanyan et al. 2016): no sparkles.
float spread(vec3 n) {
    vec3 dx = dFdx(n), dy = dFdy(n);
    return min(.5 * (dot(dx, dx) + dot(dy, dy)), .18);
}

vec3 hemisphere(vec3 n) { return mix(floorColor, skyColor, .5 + .5 * n.y); }

float wrapped(float nl, float w) { return square(max(nl + w, 0.0) / (1.0 + w)); }

float fifth(float a) { return a * square(square(a)); }

// The normal of the side that is seen. Smooth normals turn away a little before the surface does.
vec3 seenNormal(vec3 v) {
    vec3 n = normalize(gl_FrontFacing ? N : -N);
    return normalize(n + v * max(.05 - dot(n, v), 0.0));
}

// The mesh of an object is fine, that of a prop may be coarse.
float keyLight(vec3 n) {
#ifdef FINE
    return vertexShade.x;
#else
    return keyVisible(P, n);
#endif
}

// How much of the sky is open.
float openness() { return mix(.55, 1.0, visible(skyWide, (skyMatrix * vec4(P, 1)).xyz, .02)); }

// GGX with half vector h, without masking.
float lobe(vec3 n, vec3 h, float nl, float alpha2) {
    float d = square(dot(n, h)) * (alpha2 - 1.0) + 1.0;
    return alpha2 / (pi * d * d) * max(nl, 0.0);
}

#ifdef OVERLAY
vec3 surfaceColor() { return overlayTint; }
vec3 blend(vec3 base, vec3 diffuse, vec3 shine) { return base * (.45 + .5 * diffuse) + .05 * shine; }
#else
vec3 surfaceColor() { return color; }
vec3 blend(vec3 base, vec3 diffuse, vec3 shine) { return base * diffuse + shine; }
#endif
)glsl";

inline constexpr const char* clothShader = R"glsl(
uniform vec4 finish;  // sheen, roughness along and across the warp, transmission
uniform float wrap, gloss;
uniform vec3 print;   // m: the emblem's period, height and width of the cloth
uniform sampler2D emblem, weave;

// The lobe is stretched across the warp (Ward's, in the form of an anisotropic GGX).
float strand(vec3 n, vec3 t, vec3 b, vec3 h, vec2 perAlpha) {
    float d = square(dot(t, h) * perAlpha.x) + square(dot(b, h) * perAlpha.y) + square(dot(n, h));
    return perAlpha.x * perAlpha.y / (4.0 * pi * d * d);
}

// Estevez and Kulla 2017 with roughness 1/3; the visibility is Neubelt's.
float sheen(float nh, float nl, float nv) {
    float s = max(1.0 - nh * nh, 0.0);
    return 5.0 / (8.0 * pi) * s * sqrt(s) * nl / (nl + nv - nl * nv + 1e-3);
}

vec3 printed(vec3 base) {
    // The distances reach .05 heights to either side of .5.
    float width = (length(dFdx(cloth)) + length(dFdy(cloth))) * .5 / (.1 * print.y);
    vec2 cover = clamp((.5 - texture(emblem, cloth / print.xy).rg) / (1.2 * width) + .5, 0.0, 1.0);
    base = mix(base, vec3(.880, .791, .658), cover.x);
    base = mix(base, vec3(.807, .456, .102), cover.y);
    // A hem of two layers along the free edges, and its seam.
    float inset = min(min(cloth.y, print.y - cloth.y), print.z - cloth.x);
    float pixel = .1 * print.y * width;
    float seam = clamp(1.5 - abs(inset - .022) / max(.0015, pixel), 0.0, 1.0) * min(.0015 / pixel, 1.0);
    return base * (1.0 - .08 * smoothstep(pixel, -pixel, inset - .022) - .3 * seam);
}

void main() {
    float side = gl_FrontFacing ? 1.0 : -1.0;
    vec3 v = normalize(eye - P), n = seenNormal(v);
    vec2 perAlpha = inversesqrt(finish.yz * finish.yz + 2.0 * spread(n));
    vec3 t = normalize(T), b = cross(n, t), base = surfaceColor();
#ifdef PRINT
    base = printed(base);
#endif
#ifdef WEAVE
    vec3 fibre = texture(weave, cloth / .04).rgb - .5;
    n = normalize(n + fibre.x * t + fibre.y * b);
    base *= 1.0 + fibre.z;
#endif
    float nv = max(dot(n, v), .06), open = 1.0 / (1.0 + .05 * max(vertexShade.y * side, 0.0));
    vec3 key = keyColor * keyLight(n);
    float nk = dot(n, keyDirection), nr = dot(n, rimDirection), nf = dot(n, fillDirection);

    float partly = .5 + .5 * open;
    vec3 diffuse = hemisphere(n) * open +
                   (key * wrapped(nk, wrap) + .6 * rimColor * wrapped(nr, wrap) +
                    fillColor * wrapped(nf, .5)) * partly +
                   finish.w * (key * max(-nk, 0.0) + rimColor * max(-nr, 0.0));

    vec3 hk = normalize(keyDirection + v), hr = normalize(rimDirection + v);
    float fk = .05 + .95 * fifth(max(1.0 - dot(hk, v), 0.0)), fr = .05 + .95 * fifth(max(1.0 - dot(hr, v), 0.0));
    vec3 shine = pi * gloss * (key * (fk * strand(n, t, b, hk, perAlpha) * smoothstep(-.1, .5, nk)) +
                               .5 * rimColor * (fr * strand(n, t, b, hr, perAlpha) * smoothstep(-.1, .5, nr)));
    shine += pi * finish.x * base * (key * sheen(dot(n, hk), max(nk, 0.0), nv) +
                                     rimColor * sheen(dot(n, hr), max(nr, 0.0), nv));
    // The stage mirrored in the threads along the rim of a fold.
    shine += gloss * .25 * square(square(1.0 - nv)) * open * mix(slate, haze, .5 - .5 * n.y);
    result = vec4(blend(base, diffuse, shine), 1);
}
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
    result = vec4(blend(base, .4 * finish.y * rough, fresnel * (around * open + .4 * shine)), 1);
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
                   fillColor * wrapped(dot(n, fillDirection), .5) * (.5 + .5 * open) +
                   rimColor * max(dot(n, rimDirection), 0.0);
    float fresnel = finish.x * (1.0 + 5.0 * fifth(1.0 - max(dot(n, v), 0.0)));
    vec3 shine = keyColor * key * lobe(n, normalize(keyDirection + v), nk, alpha2) +
                 rimColor * lobe(n, normalize(rimDirection + v), dot(n, rimDirection), alpha2);
    shine = .25 * pi * finish.x * shine + fresnel * backdrop(reflect(-v, n), .5) * open;
    result = vec4(blend(surfaceColor(), diffuse, shine), 1);
}
)glsl";

}  // namespace plait
