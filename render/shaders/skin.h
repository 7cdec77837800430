// Skin, and the satin that it wears.
#pragma once

namespace plait {

// Follows surfaceShader. Light that enters skin creeps around the terminator and into shadows, red
// farthest (d'Eon and Luebke 2007); its shine is broad, and down grazes its outline.
inline constexpr const char* skinShader = R"glsl(
uniform vec4 finish;  // reflectance, roughness, and how far light creeps: blue, red
in float vertexSatin;

vec3 crept(float nl, vec3 w) { return pow(max((nl + w) / (1.0 + w), 1e-5), 1.0 + w); }

void main() {
    vec3 v = normalize(eye - P), n = seenNormal(v), base = surfaceColor();
    float satin = clamp(vertexSatin, 0.0, 1.0), open = openness() / (1.0 + .012 * max(vertexShade.y, 0.0));
    float key = keyLight(n), nk = dot(n, keyDirection), nr = dot(n, rimDirection), nv = max(dot(n, v), 0.0);
    key = mix(1.0, key, smoothstep(-.15, .2, nk));  // its own shadow begins where light has crept to
    vec3 creep = mix(vec3(finish.w, mix(finish.z, finish.w, .35), finish.z), vec3(.12), satin);
    vec3 lit = keyColor * pow(vec3(max(key, 1e-5)), mix(vec3(.75, 1, 1.1), vec3(1), satin));
    vec3 diffuse = hemisphere(n) * open + lit * crept(nk, creep) +
                   fillColor * bright * crept(dot(n, fillDirection), creep + .2) * (.5 + .5 * open) +
                   .7 * rimColor * crept(nr, creep) * (.4 + .6 * open);
    float alpha2 = square(square(mix(finish.y, .33, satin))) + spread(n);
    float strength = mix(finish.x, .16, satin);
    vec3 hk = normalize(keyDirection + v), hr = normalize(rimDirection + v);
    vec3 shine = lit * (strength + (1.0 - strength) * fifth(max(1.0 - dot(hk, v), 0.0))) * lobe(n, hk, nk, alpha2) +
                 .5 * rimColor * (strength + (1.0 - strength) * fifth(max(1.0 - dot(hr, v), 0.0))) * lobe(n, hr, nr, alpha2);
    vec3 down = (lit * max(nk, 0.0) + rimColor * max(nr, 0.0) + hemisphere(n)) * base * mix(.25, .8, satin) * square(square(1.0 - nv));
    result = vec4(blend(base, diffuse, .25 * pi * shine + down * open), 1);
}
)glsl";

}  // namespace plait
