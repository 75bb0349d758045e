#version 450 core
// A band of triangles round a circle, from the inner to the outer end of its light. Even vertices lie inside.

layout(location = 0) uniform vec4 camera;  // centre in metres; 1 / half extents
layout(location = 1) uniform vec4 ring;    // centre in metres, radius, steps round the circle
layout(location = 2) uniform vec4 reach;   // metres of light inside and outside the circle; pixels per metre

out vec2 from_m;  // from the centre

void main() {
  bool outside = (gl_VertexID & 1) == 1;
  float angle = float(gl_VertexID >> 1) / ring.w * 6.2831853;
  // The straight sides of the band cut corners; this much further out they stay clear of the light's end.
  float radius = outside ? (ring.z + reach.y) / cos(3.1415927 / ring.w) : max(ring.z - reach.x, 0.0);
  from_m = radius * vec2(cos(angle), sin(angle));
  gl_Position = vec4((ring.xy + from_m - camera.xy) * camera.zw, 0, 1);
}
