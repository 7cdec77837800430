// Depth seen from a light, what it says of the ground and of all else, and the blur of that.
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

// Of a net part of the texels, in an order by which any 4 by 4 of them have the same part. Another
// odd factor for each layer and side permutes the order, so that they overlap about as chance
// would.
inline constexpr const char* netDepthShader = R"glsl(#version 330 core
uniform float cover;
uniform int layer;
const int order[16] = int[](0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5);
void main() {
    ivec2 p = ivec2(gl_FragCoord.xy) & 3;
    int factor = 4 * layer + 2 * int(gl_FrontFacing) + 1;
    if (float(factor * order[4 * p.y + p.x] & 15) + .5 > 16.0 * cover) discard;
}
)glsl";

inline constexpr const char* blurVertexShader = R"glsl(#version 330 core
out vec2 place;
void main() {
    place = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
    gl_Position = vec4(2.0 * place - 1.0, 0, 1);
}
)glsl";

// What hides the ground, at `height`, from the light: of a plane each texel is hidden or not,
// however many casters lie behind each other, and remains so when blurred. Nothing reaches the
// map's edge, which is what is found beyond it.
inline constexpr const char* coverShader = R"glsl(#version 330 core
uniform sampler2D source;
uniform mat4 toWorld;  // from map and depth
uniform float height;
in vec2 place;
out vec4 result;

// Whether it is, and from how far above.
vec2 hidden(vec2 p) {
    float depth = texture(source, p).r, above = (toWorld * vec4(p, depth, 1)).y - height;
    return depth < 1.0 && above > 0.0 ? .25 * vec2(1, above) : vec2(0);
}

void main() {
    vec2 d = .5 / vec2(textureSize(source, 0)), e = vec2(d.x, -d.y), inside = .5 - abs(place - .5);
    vec2 all = hidden(place + d) + hidden(place - d) + hidden(place + e) + hidden(place - e);
    result = vec4(all * step(.04, min(inside.x, inside.y)), 0, 0);
}
)glsl";

// Moments of two warps of the depth, -exp(-w) and exp(w) with w = 40 depth - 20 (Lauritzen and
// McCool 2008). Without the 20 the least variance is subnormal; flushed to 0, as some threads do,
// it makes 0/0.
inline constexpr const char* momentsShader = R"glsl(#version 330 core
uniform sampler2D source;
in vec2 place;
out vec4 result;

vec4 moments(vec2 p) {
    vec2 inside = .5 - abs(p - .5);
    float depth = min(inside.x, inside.y) > .04 ? texture(source, p).r : 1.0;
    float far = exp(40.0 * depth - 20.0), near = -1.0 / far;
    return .25 * vec4(near, near * near, far, far * far);
}

void main() {
    vec2 d = .5 / vec2(textureSize(source, 0)), e = vec2(d.x, -d.y);
    result = moments(place + d) + moments(place - d) + moments(place + e) + moments(place - e);
}
)glsl";

// Gauss over 9 taps, which are `step` apart; sigma is two of them.
inline constexpr const char* blurShader = R"glsl(#version 330 core
uniform sampler2D source;
uniform vec2 step;
in vec2 place;
out vec4 result;

vec4 tap(float i) { return texture(source, place + i * step); }

void main() {
    result = .2042 * tap(0.0) + .1802 * (tap(1.0) + tap(-1.0)) + .1238 * (tap(2.0) + tap(-2.0)) +
             .0663 * (tap(3.0) + tap(-3.0)) + .0276 * (tap(4.0) + tap(-4.0));
}
)glsl";

}  // namespace plait
