#version 450 core
// One instance = one ParticleVertex (render/sprite_vertex.h): a single triangle, since on llvmpipe it is triangles
// that sparks cost.
//
//   tail  .....-----=====|
//   apex       .....-----=====|  head: the base, half a width further on

layout(location = 0) in vec4 places;     // head; tail
layout(location = 1) in vec2 sizeLight;  // half width in metres; 1 full .. 0 gone
layout(location = 2) in uint look;       // colour 0xRRGGBB

layout(location = 0) uniform vec4 camera;  // centre in metres; 1 / half extents
layout(location = 1) uniform vec2 view;    // pixels per metre; brightness

out vec2 at;          // share of the way from tail to head; pixels beside the middle
flat out vec3 shape;  // half width and length in pixels; light
flat out vec3 tint;

const float kLeastHalf_px = .9;  // thinner ones would flicker

void main() {
  float half_px = max(sizeLight.x * view.x, kLeastHalf_px);
  vec2 way = places.xy - places.zw;
  float way_px = length(way) * view.x;
  vec2 along = way_px > .01 ? normalize(way) : vec2(1, 0);
  float length_px = max(way_px, 2 * half_px) + 2 * half_px;
  float beside_px = gl_VertexID == 0 ? 0 : (gl_VertexID * 2 - 3) * (half_px + 1);
  at = vec2(gl_VertexID == 0 ? 0 : 1, beside_px);
  shape = vec3(half_px + 1, length_px, sizeLight.y * view.y);
  tint = unpackUnorm4x8(look).zyx;

  vec2 tip = places.xy + along * (half_px / view.x);
  vec2 place = tip - along * ((1 - at.x) * length_px / view.x) + vec2(-along.y, along.x) * (beside_px / view.x);
  gl_Position = vec4((place - camera.xy) * camera.zw, 0, 1);
}
