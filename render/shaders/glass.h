// Glass.
#pragma once

namespace plait {

// Follows surfaceShader. Drawn twice, and the order of its faces does not matter: first what is
// behind is multiplied by what comes through each face, then what each mirrors is added. Through a
// pane light goes a few millimetres, along it and out of a broken edge centimetres.
inline constexpr const char* glassShader = R"glsl(
uniform vec4 finish;  // cover of its shadow, reflectance, and centimetres through an edge
uniform int layer;    // 0: what comes through, 1: what is mirrored
in float vertexStretch;  // -1: the outside; from 0, closed, to 1: an edge

vec3 softBox(vec3 r, vec3 direction, vec3 light) { return light * smoothstep(.93, .97, dot(r, direction)); }

void main() {
    vec3 v = normalize(eye - P), n = normalize(N);
    n = dot(n, v) < 0.0 ? -n : n;
    bool edge = vertexStretch > -.5;
    float nv = max(dot(n, v), .02), shown = edge ? clamp(vertexStretch, 0.0, 1.0) : 1.0;
    float fresnel = shown * (finish.y + (1.0 - finish.y) * fifth(1.0 - nv));
    vec3 depth = vec3(.16, .028, .06) * (edge ? finish.z * shown : .25 / sqrt(1.0 - (1.0 - nv * nv) / 2.31));
    vec3 through = exp(-depth) * (1.0 - fresnel) * (edge ? 1.0 - .25 * shown : 1.0);
    vec3 r = reflect(-v, n);
    vec3 around = backdrop(r, .1) + softBox(r, keyDirection, 3.0 * keyColor) +
                  softBox(r, fillDirection, 1.5 * bright * fillColor) + softBox(r, rimDirection, 2.0 * rimColor);
    // Along a broken edge light comes out that went in at the others.
    vec3 glow = edge ? shown * .14 * exp(-1.5 * depth) * (hemisphere(n) + .3 * backdrop(-v, .5)) : vec3(0);
    result = layer == 0 ? vec4(through, 1) : vec4(fresnel * around + glow, 0);
}
)glsl";

}  // namespace plait
