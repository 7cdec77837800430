// The stage: backdrop, lights and shadows, shared by everything that is drawn. Radiance is linear;
// a light of ratio r gives a white surface that faces it the radiance r unit.
#pragma once

namespace plait {

// Comes after the version.
inline constexpr const char* stageShader = R"glsl(
const float pi = 3.14159265;
const vec3 ink = vec3(.008, .014, .025), slate = vec3(.098, .144, .195), haze = vec3(.687, .497, .352);
const vec3 glowColor = vec3(.811, .571, .371);
const float unit = .85 / pi;
const vec3 keyColor = 4.0 * unit * vec3(1, .80, .58);
const vec3 fillColor = unit * vec3(.62, .80, 1);
const vec3 rimColor = 5.0 * unit * vec3(1, .90, .78);
const vec3 skyColor = vec3(.30, .38, .50), floorColor = vec3(.16, .13, .11);

uniform vec3 eye;
uniform vec2 lens;          // of the camera, radians: pitch, vertical field of view
uniform vec3 glowDirection;
uniform vec2 glow;          // strength, power
uniform vec3 keyDirection, fillDirection, rimDirection;  // towards the light
uniform mat4 keyMatrix, skyMatrix;                       // world to map, all in 0 .. 1
uniform sampler2DShadow keyDepth;
uniform float keyTexel;  // m
uniform sampler2D keyNarrow, keyWide, skyNarrow, skyWide;

float square(float a) { return a * a; }

// A quadratic B-spline through the heights of the three colours; s: height on the screen, 0 at the
// bottom.
vec3 backdropAt(float s, vec3 direction) {
    float q = clamp(s < .55 ? (s - .08) / .47 : 1.0 + (s - .55) / .62, -.5, 2.5);
    float low = .5 * square(max(1.5 - q, 0.0)), high = .5 * square(max(q - .5, 0.0));
    if (q < .5) low = 1.0 - .5 * square(q + .5);
    if (q > 1.5) high = 1.0 - .5 * square(2.5 - q);
    vec3 color = low * haze + high * ink + (1.0 - low - high) * slate;
    float c = max(dot(direction, glowDirection), 0.0);
    return color + glowColor * glow.x * pow(c, glow.y);
}

// By direction, for reflections; `blur` (radians) stretches the horizon as a rough mirror does.
vec3 backdrop(vec3 direction, float blur) {
    float rise = asin(clamp(direction.y, -1.0, 1.0)) - lens.x;
    return backdropAt(.5 + rise / (lens.y + blur), direction);
}

// Part of the light that arrives behind one caster, from moments of -exp(20 - 40 depth) (Lauritzen
// and McCool 2008): blurred before it is looked up, so that a wide penumbra costs one fetch. Without
// the 20 the least variance is subnormal; flushed to 0, as some threads do, it makes 0/0.
float visible(sampler2D map, vec3 place, float bias) {
    vec2 moments = texture(map, place.xy).rg;
    float depth = -exp(20.0 - 40.0 * (clamp(place.z, 0.0, 1.0) - bias));
    float beyond = max(depth - moments.x, 0.0);
    float variance = max(moments.y - square(moments.x), 1e-4 * square(moments.x));
    return smoothstep(.1, 1.0, variance / (variance + square(beyond)));
}

// The same among folds, where several layers lie behind each other and moments leak.
float keyVisible(vec3 p, vec3 n) {
    float nl = dot(n, keyDirection);
    vec3 off = 3.0 * sign(nl) * sqrt(max(1.0 - nl * nl, 0.0)) * n + 2.0 * keyDirection;
    vec3 place = (keyMatrix * vec4(p + keyTexel * off, 1)).xyz;
    vec2 spacing = 1.6 / vec2(textureSize(keyDepth, 0));
    float sum = 0.0;
    for (int i = 0; i < 16; ++i)
        sum += texture(keyDepth, place + vec3(spacing * (vec2(i % 4, i / 4) - 1.5), 0));
    return sum / 16.0;
}
)glsl";

}  // namespace plait
