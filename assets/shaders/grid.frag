#version 450 core
// A line one pixel wide, or a wall: a bright core with light falling off to both sides.

in float across_px;
in float along_m;
in float stir;
flat in vec4 tint;
flat in vec4 data;

layout(location = 1) uniform vec4 world;
layout(location = 3) uniform vec4 mood;
layout(location = 0) out vec4 colour;

const float kStirred = 3;   // a line moved by a metre shines so many times brighter, up to 4
const float kApart_m = 60;  // between two packets on one line

void main() {
  float past_px = max(max(-along_m, along_m - data.w), 0.0) * world.z;  // the end of a wall; other lines stop before theirs
  float away_px = length(vec2(across_px, past_px));
  float reach_px = abs(tint.w);
  float fade = clamp(1 - away_px / reach_px, 0.0, 1.0);
  float line = clamp(tint.w + .5 - away_px, 0.0, 1.0);
  float wall = clamp(1.9 - away_px, 0.0, 1.0) + .30 * fade * fade * fade;
  // A packet has a sharp head and a tail of a third of the way to the next.
  float behind = fract((data.x > 0 ? -1 : 1) * (along_m - data.x * mood.x + data.y) / kApart_m);
  float tail = clamp(1 - 4 * behind, 0.0, 1.0);
  float light = (tint.w < 0 ? wall : line) * (1 + data.z * 2.6 * tail * tail + min(kStirred * stir, 4.0));
  colour = vec4(tint.rgb * light, 0);
}
