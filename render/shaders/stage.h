// The stage: backdrop, lights and shadows, shared by everything that is drawn. Radiance is linear;
// a light of ratio r gives a white surface that faces it the radiance r unit.
#pragma once

namespace plait {

// Comes after the version.
inline constexpr const char* stageShader = R"glsl(
const float pi = 3.14159265;
const vec3 ink = vec3(.008, .014, .025), slate = vec3(.098, .144, .195);
#ifdef SPOT  // indoors
const vec3 haze = vec3(.240, .174, .130);
#else
const vec3 haze = vec3(.687, .497, .352);
#endif
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
uniform float bright;       // part of the light of backdrop and fill that is on
uniform vec4 spot;          // its middle and radius, m
uniform vec3 keyDirection, fillDirection, rimDirection;  // towards the light
uniform mat4 keyMatrix, skyMatrix;                       // world to map, all in 0 .. 1
uniform sampler2DShadow keyDepth;
uniform float keyTexel;  // m
uniform sampler2D keyNarrow, keyWide, keyFar, skyNarrow, skyWide, skyFar;  // what hides the ground
uniform sampler2D skyMoments;

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
    return bright * color + glowColor * glow.x * pow(c, glow.y);
}

// By direction, for reflections; `blur` (radians) stretches the horizon as a rough mirror does.
vec3 backdrop(vec3 direction, float blur) {
    float rise = asin(clamp(direction.y, -1.0, 1.0)) - lens.x;
    return backdropAt(.5 + rise / (lens.y + blur), direction);
}

float atMost(vec2 moments, float depth) {
    float variance = max(moments.y - square(moments.x), 1e-4 * square(moments.x));
    return variance / (variance + square(max(depth - moments.x, 0.0)));
}

// Part of the sky's light that arrives, from moments: blurred before they are looked up, so that a
// wide penumbra costs one fetch. One warp leaks behind two casters that are far from each other, the
// other before the ground that lies far behind one.
float skyVisible(vec3 p) {
    vec3 place = (skyMatrix * vec4(p, 1)).xyz;
    vec4 moments = texture(skyMoments, place.xy);
    float far = exp(40.0 * (clamp(place.z, 0.0, 1.0) - .02) - 20.0);
    return smoothstep(.1, 1.0, min(atMost(moments.xy, -1.0 / far), atMost(moments.zw, far)));
}

// Part of the key light that its lamp sends there.
float spotlight(vec3 p) {
#ifdef SPOT
    vec3 d = p - spot.xyz;
    return 1.0 - smoothstep(.45, 1.0, length(d - dot(d, keyDirection) * keyDirection) / spot.w);
#else
    return 1.0;
#endif
}

// Part of the key light that arrives among folds, where moments would leak.
float keyVisible(vec3 p, vec3 n) {
    float nl = dot(n, keyDirection);
    vec3 off = 3.0 * sign(nl) * sqrt(max(1.0 - nl * nl, 0.0)) * n + 2.0 * keyDirection;
    vec3 place = min((keyMatrix * vec4(p + keyTexel * off, 1)).xyz, vec3(1));
    vec2 spacing = 1.6 / vec2(textureSize(keyDepth, 0));
    float sum = 0.0;
    for (int i = 0; i < 16; ++i)
        sum += texture(keyDepth, place + vec3(spacing * (vec2(i % 4, i / 4) - 1.5), 0));
    return sum / 16.0 * spotlight(p);
}
)glsl";

}  // namespace plait
