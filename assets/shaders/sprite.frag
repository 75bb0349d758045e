#version 450 core
// A neon sign: a bright line along the shape's edge, light falling off to both sides, a dim inside that covers
// what lies below. The distance comes from at most three edges of the folded shape (see sprite.vert). There are
// no branches on the shape: llvmpipe would run all of them for every pixel.

in vec2 at;
flat in vec4 edge0, edge1, edge2;
flat in vec4 edges;
flat in vec4 kind;
flat in vec4 rings;
flat in vec4 tint;
flat in vec3 lit;

layout(location = 0) out vec4 colour;  // premultiplied: light is added where alpha is 0

// x: how far outside the edge's line (inside is negative); y: squared distance to the edge itself.
vec2 toEdge(vec2 p, vec4 edge, float length) {
  vec2 from = p - edge.xy;
  float along = dot(from, edge.zw);
  float beside = dot(from, vec2(edge.w, -edge.z));
  float beyond = along - clamp(along, 0.0, length);
  return vec2(beside, beside * beside + beyond * beyond);
}

void main() {
  vec2 p = vec2(mix(at.x, abs(at.x), kind.x), abs(at.y));
  p = mix(p, vec2(max(p.x, p.y), min(p.x, p.y)), kind.y);
  vec2 a = toEdge(p, edge0, edges.x), b = toEdge(p, edge1, edges.y), c = toEdge(p, edge2, edges.z);
  float outside = max(a.x, max(b.x, c.x));
  float near = min(a.y, min(b.y, c.y));
  float d = (outside < 0 ? outside : sqrt(near)) - kind.z;

  // The line lies just within the shape, so that what is seen is what collides.
  float unit_px = edges.w, halfLine_px = rings.z;
  float line_px = abs(d * unit_px + halfLine_px) - halfLine_px;
  // Chequers without a fill have their cross drawn: an announced one would else look like a plain square.
  float cross_px = min(abs(at.x), abs(at.y)) * unit_px - .5;
  line_px = mix(line_px, min(line_px, max(cross_px, d * unit_px)), lit.x > 0 ? 0.0 : kind.w);
  if (rings.x > 0) {
    float radius = length(at);
    d = radius - rings.x;
    line_px = min(abs(d * unit_px + halfLine_px), abs(radius - rings.y) * unit_px) - halfLine_px;
  }

  float line = clamp(.5 - line_px, 0.0, 1.0);
  float fade = clamp(1 - line_px / rings.w, 0.0, 1.0);
  float inside = clamp(.5 - d * unit_px, 0.0, 1.0);
  float squares = clamp(.5 + at.x * at.y * unit_px * 4, 0.0, 1.0);
  float fill = inside * lit.x * mix(1, squares, kind.w);

  vec3 core = tint.rgb + .35 * line * line * (1 - tint.rgb);
  colour = vec4(core * (line * lit.y) + tint.rgb * (fill * (1 - line) + fade * fade * lit.z * (1 - line)),
                max(inside * tint.w, line * min(tint.w, lit.y)));
}
