#version 450 core
// Bright on the circle, falling off to either side, a white core where it is brightest.

in vec2 from_m;

layout(location = 1) uniform vec4 ring;
layout(location = 2) uniform vec4 reach;
layout(location = 3) uniform vec4 tint;  // colour; brightness
layout(location = 0) out vec4 colour;

void main() {
  float away_m = length(from_m) - ring.z;
  float fade = clamp(1 - abs(away_m) / (away_m < 0 ? reach.x : reach.y), 0.0, 1.0);
  float line = clamp(1.8 - abs(away_m) * reach.z, 0.0, 1.0);
  colour = vec4((tint.rgb * (.55 * fade * fade + line) + .4 * line * (1 - tint.rgb)) * tint.a, 0);
}
