// From linear light to sRGB: bloom, exposure, vignette, tone curve, dither.
#pragma once

namespace plait {

// Of one moment of an exposure.
inline constexpr const char* shareShader = R"glsl(#version 330 core
uniform sampler2D source;
uniform float share;
in vec2 place;
out vec4 result;
void main() { result = share * texelFetch(source, ivec2(gl_FragCoord.xy), 0); }
)glsl";

// A quarter of the size: what is brighter than .9.
inline constexpr const char* brightShader = R"glsl(#version 330 core
uniform sampler2D source;
uniform vec2 texel;  // of the source
in vec2 place;
out vec4 result;

vec3 bright(vec2 p) { return min(max(texture(source, p).rgb - .9, 0.0), 4.0); }

void main() {
    vec2 d = texel;
    result = vec4(.25 * (bright(place + d) + bright(place - d) + bright(place + vec2(d.x, -d.y)) +
                         bright(place + vec2(-d.x, d.y))), 1);
}
)glsl";

inline constexpr const char* bloomShader = R"glsl(#version 330 core
uniform sampler2D source;
uniform vec2 step;
in vec2 place;
out vec4 result;
void main() {
    vec3 sum = .2042 * texture(source, place).rgb;
    sum += .1802 * (texture(source, place + step).rgb + texture(source, place - step).rgb);
    sum += .1238 * (texture(source, place + 2.0 * step).rgb + texture(source, place - 2.0 * step).rgb);
    sum += .0663 * (texture(source, place + 3.0 * step).rgb + texture(source, place - 3.0 * step).rgb);
    sum += .0276 * (texture(source, place + 4.0 * step).rgb + texture(source, place - 4.0 * step).rgb);
    result = vec4(sum, 1);
}
)glsl";

// Rows come out upside down: the first that is read back is the top one.
inline constexpr const char* gradeShader = R"glsl(#version 330 core
uniform sampler2D scene, bloom;
uniform vec2 size;
uniform float exposure, vignette;
out vec4 result;

// Khronos PBR Neutral: colours keep their hue, only what is nearly white is compressed.
vec3 neutral(vec3 c) {
    const float start = .76, desaturation = .15;
    float low = min(c.r, min(c.g, c.b));
    c -= low < .08 ? low - 6.25 * low * low : .04;
    float peak = max(c.r, max(c.g, c.b));
    if (peak < start) return c;
    float d = 1.0 - start, compressed = 1.0 - d * d / (peak + d - start);
    float g = 1.0 / (desaturation * (peak - compressed) + 1.0);
    return mix(vec3(compressed), c * compressed / peak, g);
}

vec3 encode(vec3 c) {
    c = clamp(c, 0.0, 1.0);
    return mix(12.92 * c, 1.055 * pow(max(c, 1e-6), vec3(1.0 / 2.4)) - .055, step(.0031308, c));
}

// The same noise in every frame, from integers: alike on every machine.
float noise(uvec2 p, uint channel) {
    uint h = p.x * 0x9E3779B1u + p.y * 0x85EBCA77u + channel * 0xC2B2AE3Du;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    h = (h ^ (h >> 12)) * 0x297A2D39u;
    return float((h ^ (h >> 15)) >> 8) / 16777216.0 - .5;
}

void main() {
    vec2 pixel = vec2(gl_FragCoord.x, size.y - gl_FragCoord.y);
    vec2 place = pixel / size, edge = 2.0 * place - 1.0;
    vec3 c = texelFetch(scene, ivec2(pixel), 0).rgb + .1 * texture(bloom, place).rgb;
    c = encode(neutral(c * exposure * (1.0 - vignette * dot(edge, edge))));
    uvec2 p = uvec2(gl_FragCoord.xy);
    c += 1.5 / 255.0 * vec3(noise(p, 0u), noise(p, 1u), noise(p, 2u));
    result = vec4(c, 1);
}
)glsl";

}  // namespace plait
