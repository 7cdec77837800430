// Metal with a grain along a wire.
#pragma once

namespace plait {

// Follows reflectionShader. Across the grain normals fan out: what is mirrored, the stage and two
// soft boxes where key and fill stand, is drawn out there.
inline constexpr const char* brushedLightShader = R"glsl(
uniform vec4 finish;  // -, roughness along and across the grain, half the fan of mirrors

vec3 mirroredLight(vec3 v, vec3 normal, vec3 t, float key) {
    vec3 n = turned(normal, v), b = cross(n, t), sum = vec3(0);
    for (int i = -2; i <= 2; ++i) {
        vec3 r = reflect(-v, normalize(n + .5 * float(i) * finish.w * b));
        sum += (3.0 - abs(float(i))) / 9.0 *
               (backdrop(r, 2.0 * finish.y) + 2.0 * keyColor * key * smoothstep(.5, 1.0, dot(r, keyDirection)) +
                2.0 * bright * fillColor * smoothstep(.5, 1.0, dot(r, fillDirection)));
    }
    return sum;
}
)glsl";

// Follows surfaceShader. On a thin wire, without relief (cloth.x), a highlight becomes a band where
// the tangent alone decides (Kajiya and Kay 1989).
inline constexpr const char* brushedShader = R"glsl(
uniform vec4 finish;
centroid in vec3 vertexMirrored;

// GGX, stretched across the grain, without masking.
float grain(vec3 n, vec3 t, vec3 b, vec3 h, float nl, vec2 perAlpha) {
    float d = square(dot(t, h) * perAlpha.x) + square(dot(b, h) * perAlpha.y) + square(dot(n, h));
    return perAlpha.x * perAlpha.y / (pi * d * d) * max(nl, 0.0);
}

void main() {
    vec3 v = normalize(eye - P), n = seenNormal(v), t = normalize(T - dot(T, n) * n), b = cross(n, t);
    vec3 base = surfaceColor();
    float key = keyLight(n), open = openness();
    vec2 rough2 = finish.yz * finish.yz, perAlpha = inversesqrt(rough2 * rough2 + vec2(0, 2.0 * spread(n) + .2 * (1.0 - cloth.x)));
    vec3 fresnel = base + (1.0 - base) * fifth(1.0 - max(dot(n, v), 0.0));
    vec3 hk = normalize(keyDirection + v), hr = normalize(rimDirection + v);
    vec3 shine = keyColor * key * grain(n, t, b, hk, dot(n, keyDirection), perAlpha) +
                 rimColor * grain(n, t, b, hr, dot(n, rimDirection), perAlpha);
    vec3 rough = keyColor * key * max(dot(n, keyDirection), 0.0) + hemisphere(n);
    result = shown(blend(base, .12 * rough * open, fresnel * open * (vertexMirrored + shine)));
}
)glsl";

}  // namespace plait
