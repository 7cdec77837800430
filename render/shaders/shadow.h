// Depth seen from a light, and the blur of its exponential moments.
#pragma once

namespace plait {

inline constexpr const char* depthVertexShader = R"glsl(#version 330 core
layout(location = 0) in vec3 position;
uniform mat4 matrix;
void main() { gl_Position = matrix * vec4(position, 1); }
)glsl";

inline constexpr const char* depthShader = R"glsl(#version 330 core
void main() {}
)glsl";

inline constexpr const char* blurVertexShader = R"glsl(#version 330 core
out vec2 place;
void main() {
    place = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
    gl_Position = vec4(2.0 * place - 1.0, 0, 1);
}
)glsl";

// Gauss over 9 taps, which are `step` apart; sigma is two of them.
inline constexpr const char* blurShader = R"glsl(#version 330 core
uniform sampler2D source;
uniform vec2 step;
uniform int fromDepth;
in vec2 place;
out vec4 result;

vec2 tap(vec2 p) {
    vec2 v = texture(source, p).rg;
    float w = -exp(20.0 - 40.0 * v.r);
    return fromDepth == 1 ? vec2(w, w * w) : v;
}

void main() {
    vec2 sum = .2042 * tap(place);
    sum += .1802 * (tap(place + step) + tap(place - step));
    sum += .1238 * (tap(place + 2.0 * step) + tap(place - 2.0 * step));
    sum += .0663 * (tap(place + 3.0 * step) + tap(place - 3.0 * step));
    sum += .0276 * (tap(place + 4.0 * step) + tap(place - 4.0 * step));
    result = vec4(sum, 0, 0);
}
)glsl";

}  // namespace plait
