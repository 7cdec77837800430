// Rubber that is blown up.
#pragma once

namespace plait {

// Follows surfaceShader. Incompressible, a wall gets thinner as its area grows: of the light from
// behind exp(-depth / stretch) comes through, by channel. What is mirrored are the stage and soft
// boxes where the lights stand, sharp where the wall is taut.
inline constexpr const char* latexShader = R"glsl(
uniform vec4 finish;  // reflectance, roughness where it is taut and limp, wrap
uniform vec3 depth;   // optical, at rest
// The factor by which the wall's area has grown.
in float vertexStretch;

// About the part of a lobe of spread s around x that falls within h to either side of 0. Some tanh
// overflow.
float below(float x) { return .5 + .5 * tanh(clamp(x, -9.0, 9.0)); }
float within(float x, float h, float s) { return below((x + h) / s) - below((x - h) / s); }

// A soft box that faces what it lights and sends it as much light as `light` does, upright as seen
// from below; its sides are half as wide and high as `size`, in radians.
vec3 softBox(vec3 r, vec3 direction, vec3 light, vec2 size, float blur) {
    vec3 side = normalize(cross(direction, vec3(0, 1, 0))), up = cross(side, direction);
    float ahead = dot(r, direction);
    vec2 p = vec2(dot(r, side), dot(r, up)) / max(ahead, .05);
    float part = within(p.x, size.x, blur) * within(p.y, size.y, blur) * smoothstep(0.0, .3, ahead);
    return part * pi / (4.0 * size.x * size.y) * light;
}

void main() {
    vec3 v = normalize(eye - P), n = seenNormal(v), base = surfaceColor(), r = reflect(-v, n);
    float stretch = max(vertexStretch, 1e-3), taut = smoothstep(1.0, 5.0, stretch);
    float key = keyLight(n), open = openness() / (1.0 + .012 * max(vertexShade.y, 0.0));
    float nk = dot(n, keyDirection), nr = dot(n, rimDirection), nf = dot(n, fillDirection), nv = max(dot(n, v), 0.0);
    vec3 warm = mix(vec3(1), vec3(1, .55, .4), .6 * (1.0 - smoothstep(-.1, .45, nk)));
    float crept = mix(1.0, key, smoothstep(-.1, .3, nk));  // its own shadow begins where light has crept to
    vec3 diffuse = hemisphere(n) * open + keyColor * crept * wrapped(nk, finish.w) * warm +
                   bright * fillColor * wrapped(nf, .5) * (.5 + .5 * open) + .7 * rimColor * max(nr, 0.0);
    // Inside, light that came in elsewhere is scattered about.
    vec3 behind = .5 * spotlight(P) * keyColor * wrapped(-nk, .5) + .55 * rimColor * wrapped(-nr, .5) +
                  .5 * bright * fillColor * wrapped(-nf, .5) + .65 * backdrop(-v, 1.0) + .25 * hemisphere(-n);
    vec3 through = exp(-depth / stretch);
    float rough = mix(finish.z, finish.y, taut), blur = .01 + 2.2 * square(rough) + 2.0 * sqrt(spread(n));
    float fresnel = finish.x + (1.0 - finish.x) * fifth(1.0 - nv) * (1.0 - rough);
    vec3 around = backdrop(r, 2.0 * rough) * open + softBox(r, keyDirection, .5 * key * keyColor, vec2(.2), blur) +
                  softBox(r, fillDirection, bright * fillColor, vec2(.17, .22), blur) +
                  softBox(r, rimDirection, .5 * rimColor, vec2(.2, .35), blur) * open;
    result = shown(blend(base, mix(.42, .78, taut) * (1.0 - .6 * through) * diffuse, through * behind + fresnel * around));
}
)glsl";

}  // namespace plait
