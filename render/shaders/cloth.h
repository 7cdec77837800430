// Cloth: silk, cotton.
#pragma once

namespace plait {

// Follows reflectionShader.
inline constexpr const char* clothLightShader = R"glsl(
uniform vec4 finish;  // sheen, roughness along and across the warp, transmission
uniform float wrap, gloss;

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

// What the colour of the side with normal n, turned as the mesh has it, multiplies, and what it does
// not. `key`: part of the key light that arrives; `hollow`, 1/m; `turn`: spread of normals.
void clothLight(vec3 v, vec3 n, vec3 tangent, float key, float hollow, float turn,
                out vec3 diffuse, out vec3 shine) {
    n = turned(n, v);
    vec2 perAlpha = inversesqrt(finish.yz * finish.yz + 2.0 * min(turn, .18));
    vec3 t = normalize(tangent), b = cross(n, t), keyLight = keyColor * key;
    float nk = dot(n, keyDirection), nr = dot(n, rimDirection), nf = dot(n, fillDirection);
    // What hides the key light stands in the way of the others too; where it grazes, its map cannot tell.
    float hidden = (1.0 - key) * smoothstep(.05, .4, abs(nk)), nv = max(dot(n, v), .06);
    float open = (1.0 - .35 * hidden) / (1.0 + .06 * max(hollow, 0.0)), partly = .5 + .5 * open;
    vec3 hk = normalize(keyDirection + v), hr = normalize(rimDirection + v);
    diffuse = hemisphere(n) * open +
              (keyLight * wrapped(nk, wrap) + .6 * rimColor * wrapped(nr, wrap) +
               bright * fillColor * wrapped(nf, .5)) * partly +
              finish.w * (keyLight * max(-nk, 0.0) + rimColor * max(-nr, 0.0)) +
              pi * finish.x * (keyLight * sheen(dot(n, hk), max(nk, 0.0), nv) +
                               rimColor * sheen(dot(n, hr), max(nr, 0.0), nv));
    float fk = .05 + .95 * fifth(max(1.0 - dot(hk, v), 0.0)), fr = .05 + .95 * fifth(max(1.0 - dot(hr, v), 0.0));
    shine = pi * (keyLight * (fk * strand(n, t, b, hk, perAlpha) * smoothstep(-.1, .5, nk)) +
                  .5 * rimColor * (fr * strand(n, t, b, hr, perAlpha) * smoothstep(-.1, .5, nr)));
    // The stage mirrored in the threads along the rim of a fold.
    shine += .25 * square(square(1.0 - nv)) * open * mix(slate, haze, .5 - .5 * n.y);
    shine *= gloss;
}
)glsl";

// Follows surfaceShader and, unless light comes by vertex (SMALL), clothLightShader.
inline constexpr const char* clothShader = R"glsl(
uniform vec3 print;   // m: the emblem's period, height and width of the cloth
uniform sampler2D emblem, weave;

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

// Threads: each a little lighter or darker, and lit as it leans.
float woven() {
#ifdef WEAVE
    return .5 + dot(texture(weave, cloth / .04).rgb, vec3(.5, -.5, 1));
#else
    return 1.0;
#endif
}

#ifdef SMALL
centroid in vec3 frontDiffuse, frontShine, backDiffuse, backShine;
void main() {
    vec3 base = surfaceColor();
#ifdef PRINT
    base = printed(base);
#endif
    vec3 light = gl_FrontFacing ? blend(base, frontDiffuse, frontShine) : blend(base, backDiffuse, backShine);
    result = vec4(woven() * light, 1);
}
#else
void main() {
    vec3 v = normalize(eye - P), n = normalize(gl_FrontFacing ? N : -N), base = surfaceColor();
    float turn = spread(n);
#ifdef PRINT
    base = printed(base);
#endif
    vec3 diffuse, shine;
    clothLight(v, n, T, keyLight(n), gl_FrontFacing ? vertexShade.y : -vertexShade.y, turn, diffuse, shine);
    result = vec4(woven() * blend(base, diffuse, shine), 1);
}
#endif
)glsl";

}  // namespace plait
