// Vessels that are turned of glass.
#pragma once

namespace plait {

// Follows surfaceShader. Drawn twice like glass: factors of what is behind, then sums. A ray that
// passes a round wall outside of its hollow (impact parameter b, hollow q, of the outer radius) is
// bent away as by a rod, which is why glass before a light has dark edges; one that meets the
// hollow comes through nearly as it came, until near b = q it is turned back inside the wall.
inline constexpr const char* crystalShader = R"glsl(
uniform vec4 finish;  // cover of its shadow, reflectance
uniform int layer;    // 0: what comes through, 1: what is mirrored and bent
uniform int side;     // of water: 1 before it, 0 all else, -1 there is none
uniform sampler2D water;  // m, along the camera's axis
uniform vec3 forward;
in float vertexStretch;  // q; below 0: inside of a hollow

vec3 softBox(vec3 r, vec3 direction, vec3 light) { return light * smoothstep(.955, .985, dot(r, direction)); }

vec3 around(vec3 r) {
    float low = smoothstep(.02, -.12, r.y);
    return mix(backdrop(r, .1), .35 * backdrop(r * vec3(1, -1, 1), .5), low);
}

void main() {
    float first = side < 0 ? 0.0 : texelFetch(water, ivec2(gl_FragCoord.xy), 0).r;
    bool before = first > 0.0 && dot(P - eye, forward) < first;
    vec3 v = normalize(eye - P), n = normalize(N);
    bool outer = vertexStretch >= 0.0 && dot(n, v) > 0.0;
    n = dot(n, v) < 0.0 ? -n : n;
    float nv = max(dot(n, v), .02);
    float fresnel = finish.y + (1.0 - finish.y) * fifth(1.0 - nv);
    vec3 r = reflect(-v, n);
    float b = sqrt(1.0 - nv * nv), q = vertexStretch, soft = fwidth(b) + .015;
    if (side >= 0 && before != (side == 1)) discard;  // after what is known by its neighbours
    vec3 shine = around(r) + softBox(r, keyDirection, 5.0 * keyColor) +
                 softBox(r, fillDirection, 2.5 * bright * fillColor) + softBox(r, rimDirection, 3.0 * rimColor);
    if (!outer) {
        result = layer == 0 ? vec4(vec3(1.0 - fresnel), 1) : vec4(.6 * fresnel * shine, 0);
        return;
    }
    float rod = smoothstep(q - soft, q + soft, b);
    vec3 in1 = refract(-v, n, 1.0 / 1.5), exit = normalize(n - 2.0 * dot(n, in1) * in1);
    vec3 bent = refract(in1, -exit, 1.5);
    bent = dot(bent, bent) > 0.0 ? bent : in1;
    float lost = mix(.04, .16, square(square(min(b / max(q, 1e-3), 1.0))));
    vec3 through = vec3(.985, .995, .99) * (1.0 - fresnel) * (1.0 - lost) * (1.0 - rod);
    vec3 added = fresnel * shine + rod * (1.0 - fresnel) * .8 * around(bent);
    result = layer == 0 ? vec4(through, 1) : vec4(added, 0);
}
)glsl";

}  // namespace plait
