// A liquid of particles: their depths as balls, smoothed to a surface; how much of it lies behind;
// and what that mirrors, bends and swallows.
#pragma once

namespace plait {

// A square around each particle, as large as its ball is seen.
inline constexpr const char* dropVertexShader = R"glsl(#version 330 core
layout(location = 0) in vec3 position;
uniform mat4 camera;
uniform vec3 eye, forward;
uniform float radius, pixels;  // m; pixels that a metre is seen as, a metre away
out vec3 center;
void main() {
    center = position;
    gl_Position = camera * vec4(position, 1);
    gl_PointSize = 2.0 * radius * pixels / max(dot(position - eye, forward), radius) + 2.0;
}
)glsl";

// What both passes over balls know: the ray of a pixel and where it meets one, cut off by panes.
inline constexpr const char* dropShader = R"glsl(#version 330 core
uniform mat4 unproject;  // clip to world
uniform vec2 size;       // of the target, pixels
uniform vec3 eye, forward;
uniform float radius;
uniform vec4 panes[6];   // dot(xyz, p) > w is behind one
uniform int paneCount;
in vec3 center;

// Along direction, from and to where it is in the ball; nothing unless x < y.
vec2 within(vec3 direction) {
    vec3 away = eye - center;
    float b = dot(direction, away), c = dot(away, away) - radius * radius, d = b * b - c;
    if (d <= 0.0) return vec2(1, 0);
    vec2 span = vec2(-b - sqrt(d), -b + sqrt(d));
    for (int i = 0; i < paneCount; ++i) {
        float toward = dot(panes[i].xyz, direction), left = panes[i].w - dot(panes[i].xyz, eye);
        if (toward < 0.0) span.x = max(span.x, left / toward);
        else if (toward > 0.0) span.y = min(span.y, left / toward);
        else if (left < 0.0) span.y = span.x;
    }
    return span;
}

vec3 ray() {
    vec4 far = unproject * vec4(2.0 * gl_FragCoord.xy / size - 1.0, 1, 1);
    return normalize(far.xyz / far.w - eye);
}
)glsl";

// How far away the nearest ball is, along the camera's axis (m).
inline constexpr const char* dropDepthShader = R"glsl(
uniform float farthest;  // m
out vec4 result;
void main() {
    vec3 direction = ray();
    vec2 span = within(direction);
    if (span.x >= span.y || span.x <= 0.0) discard;
    float depth = span.x * dot(direction, forward);
    result = vec4(depth, 0, 0, 1);
    gl_FragDepth = depth / farthest;
}
)glsl";

// How much of balls lies along the ray (m).
inline constexpr const char* dropThicknessShader = R"glsl(
uniform float share;  // of a ball's volume that is its particle's
out vec4 result;
void main() {
    vec2 span = within(ray());
    if (span.x >= span.y) discard;
    result = vec4(share * (span.y - max(span.x, 0.0)), 0, 0, 1);
}
)glsl";

// Of the balls' shadow part of the texels: water lets light through.
inline constexpr const char* dropShadowShader = R"glsl(#version 330 core
const int order[16] = int[](0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5);
uniform float cover;
void main() {
    ivec2 p = ivec2(gl_FragCoord.xy) & 3;
    vec2 off = 2.0 * gl_PointCoord - 1.0;
    if (dot(off, off) > 1.0 || float(order[4 * p.y + p.x]) + .5 > 16.0 * cover) discard;
}
)glsl";
inline constexpr const char* dropShadowVertexShader = R"glsl(#version 330 core
layout(location = 0) in vec3 position;
uniform mat4 matrix;
uniform float pixels;
void main() {
    gl_Position = matrix * vec4(position, 1);
    gl_PointSize = max(pixels, 1.0);
}
)glsl";

// Narrow-range filter (Truong, Yuksel, A narrow-range filter for screen-space fluid rendering,
// 2018), along one direction: what is much nearer is another surface, and with it what lies
// opposite is left out, so that the rest is not tilted; what is much farther counts as not far.
inline constexpr const char* narrowShader = R"glsl(#version 330 core
uniform sampler2D source;
uniform vec2 step;      // of a pixel
uniform float reach;    // m, sigma
uniform float pixels;   // that a metre is seen as, a metre away
uniform float range;    // m, that a surface is thick
in vec2 place;
out vec4 result;

// Never between two: beside an outline there is nothing.
float at(vec2 p) {
    ivec2 size = textureSize(source, 0);
    return texelFetch(source, clamp(ivec2(p * vec2(size)), ivec2(0), size - 1), 0).r;
}

void main() {
    float depth = at(place);
    result = vec4(depth, 0, 0, 1);
    if (depth <= 0.0) return;
    float sigma = min(reach * pixels / depth, 16.0);
    int taps = int(ceil(2.0 * sigma));
    float low = depth - range, high = depth + range, sum = depth, weight = 1.0;
    for (int i = 1; i <= taps; ++i) {
        float a = at(place + float(i) * step), b = at(place - float(i) * step);
        float w = exp(-float(i * i) / (2.0 * sigma * sigma));
        if (a <= 0.0 || b <= 0.0) continue;
        if (a < low || b < low) continue;
        a = min(a, high + .5 * range) > high ? depth + range : a;
        b = min(b, high + .5 * range) > high ? depth + range : b;
        low = min(low, min(a, b) - range);
        high = max(high, max(a, b) + range);
        sum += w * (a + b);
        weight += 2.0 * w;
    }
    result.r = sum / weight;
}
)glsl";

inline constexpr const char* waterVertexShader = R"glsl(#version 330 core
out vec2 place;
void main() {
    place = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
    gl_Position = vec4(2.0 * place - 1.0, 0, 1);
}
)glsl";

// Follows the stage. One surface: the nearest. What is behind is bent by it as through as much
// water as lies along the ray, and swallowed by channel; what the water scatters comes from the
// sky.
inline constexpr const char* waterShader = R"glsl(
uniform mat4 camera, unproject;
uniform vec3 forward;
uniform sampler2D depths, thicknesses, behind;
uniform vec3 swallow;  // 1/m
uniform float spacing;  // m
uniform float beyond;   // m, to what is seen through it
uniform vec3 color;
in vec2 place;
out vec4 result;

vec3 rayAt(vec2 p) {
    vec4 far = unproject * vec4(2.0 * p - 1.0, 1, 1);
    vec3 d = far.xyz / far.w - eye;
    return d / dot(d, forward);
}

float depthAt(vec2 p) {
    ivec2 size = textureSize(depths, 0);
    return texelFetch(depths, clamp(ivec2(p * vec2(size)), ivec2(0), size - 1), 0).r;
}

vec3 pointAt(vec2 p, float depth) { return eye + depth * rayAt(p); }

// The smaller of the two differences: across an outline the other is that to another surface. Where
// both are, or there is none, it counts as upright to the eye.
vec3 slope(vec3 at, vec2 by) {
    float ahead = depthAt(place + by), back = depthAt(place - by);
    float depth = dot(at - eye, forward), most = .5 * spacing;
    bool noneAhead = ahead <= 0.0 || abs(ahead - depth) > most;
    bool noneBack = back <= 0.0 || abs(back - depth) > most;
    if (noneAhead && noneBack) return pointAt(place + by, depth) - at;
    vec3 a = pointAt(place + by, ahead) - at, b = at - pointAt(place - by, back);
    if (noneAhead) return b;
    if (noneBack) return a;
    return abs(ahead - depth) < abs(back - depth) ? a : b;
}

float fifthOf(float a) { return a * square(square(a)); }

void main() {
    float depth = depthAt(place);
    if (depth <= 0.0) discard;
    vec3 at = pointAt(place, depth);
    vec2 pixel = 1.0 / vec2(textureSize(depths, 0));
    vec3 n = normalize(cross(slope(at, vec2(pixel.x, 0)), slope(at, vec2(0, pixel.y))));
    vec3 v = normalize(eye - at);
    float nv = dot(n, v);
    // At an outline differences say little: there it counts as not quite grazed.
    if (nv < .2) n = normalize(n + (.2 - nv) * v);
    nv = max(dot(n, v), .2);

    float thick = texture(thicknesses, place).r;
    vec3 inside = refract(-v, n, 1.0 / 1.33);
    // Where the bent ray leaves the water the picture behind is looked up.
    // There it is bent again, as if by the far side of a ball.
    vec3 leaving = refract(inside, -normalize(n - 2.0 * dot(n, inside) * inside), 1.33);
    vec4 out4 = camera * vec4(at + min(thick, .6) * inside + beyond * leaving, 1);
    vec2 bent = clamp(.5 + .5 * out4.xy / out4.w, vec2(.001), vec2(.999));
    vec3 through = exp(-swallow * thick);
    // An outline is where hardly any water is left, rather than where the last ball ends.
    float part = smoothstep(.12, .5, thick / spacing), around = 0.0;
    for (int i = 0; i < 9; ++i) around += step(1e-6, depthAt(place + pixel * (vec2(i % 3, i / 3) - 1.0)));
    part *= smoothstep(4.0, 9.0, around);
    vec3 seen = texture(behind, bent).rgb;
    vec3 scattered = color * (bright * skyColor + .5 * keyColor * max(keyDirection.y, 0.0) +
                              .6 * backdrop(-v, 1.0) + .3 * rimColor * max(dot(-v, rimDirection), 0.0));
    vec3 r = reflect(-v, n);
    float fresnel = .02 + .98 * fifthOf(1.0 - nv);
    float glint = 40.0 * pow(max(dot(r, keyDirection), 0.0), 900.0) + 1.5 * pow(max(dot(r, keyDirection), 0.0), 60.0);
    float rim = 12.0 * pow(max(dot(r, rimDirection), 0.0), 300.0);
    vec3 mirrored = backdrop(r, .05) + bright * skyColor * max(r.y, 0.0) + glint * keyColor + rim * rimColor;
    result = vec4(mix(mix(scattered, seen, through), mirrored, fresnel), part);
    vec4 clip = camera * vec4(at, 1);
    gl_FragDepth = .5 + .5 * clip.z / clip.w;
}
)glsl";

}  // namespace plait
