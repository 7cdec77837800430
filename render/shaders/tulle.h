// Tulle: a net, finer than a pixel.
#pragma once

namespace plait {

// Follows reflectionShader. Threads run along and across and are round: lit from either side,
// bright against a light, with a glint wherever one of them lies across the light's half vector.
inline constexpr const char* tulleLightShader = R"glsl(
uniform vec4 finish;  // part that its threads cover, exponent and strength of their glints

float glint(vec3 t, vec3 h) { return pow(max(1.0 - square(dot(t, h)), 1e-5), finish.y); }

void tulleLight(vec3 v, vec3 n, vec3 tangent, float key, out vec3 diffuse, out vec3 shine) {
    vec3 t = normalize(tangent), b = cross(n, t), keyLight = keyColor * key;
    float nk = abs(dot(n, keyDirection)), nr = abs(dot(n, rimDirection));
    float against = square(max(dot(v, -rimDirection), 0.0));
    diffuse = .5 * (hemisphere(n) + hemisphere(-n)) + keyLight * (.3 + .5 * nk) +
              rimColor * (.12 + .25 * nr + .5 * against) + .4 * bright * fillColor;
    vec3 hk = normalize(keyDirection + v), hr = normalize(rimDirection + v);
    shine = finish.z * (keyLight * (glint(t, hk) + glint(b, hk)) + .5 * rimColor * (glint(t, hr) + glint(b, hr)));
}
)glsl";

// Follows surfaceShader; its result is to be blended. Seen at a grazing angle threads close ranks.
inline constexpr const char* tulleShader = R"glsl(
uniform vec4 finish;
centroid in vec3 frontDiffuse, frontShine;
void main() {
    vec3 v = normalize(eye - P), n = normalize(N);
    float alpha = 1.0 - pow(1.0 - finish.x, 1.0 / max(abs(dot(n, v)), .12));
    result = vec4(alpha * blend(surfaceColor(), frontDiffuse, frontShine), alpha);
}
)glsl";

}  // namespace plait
