#version 450 core
// A neon sign: a bright line along the shape's edge, light falling off to both sides, a dim inside that covers
// what lies below. The distance is that to the furthest side of the folded shape (see sprite.vert): exact within
// the shape, mitred past its corners, which suits neon and costs a fifth less than rounding them. There are
// no branches on the shape: llvmpipe would run all of them for every pixel.

in vec2 at;
flat in vec3 side0, side1, side2;
flat in vec3 kind;
flat in vec4 scale;
flat in vec4 tint;
flat in vec3 lit;

layout(location = 0) out vec4 colour;  // premultiplied: light is added where alpha is 0

void main() {
  vec2 p = vec2(kind.x > 0 ? abs(at.x) : at.x, abs(at.y));
  p = kind.x > 1 ? vec2(max(p.x, p.y), min(p.x, p.y)) : p;
  float radius = length(at);
  float d = max(max(dot(p, side0.xy) - side0.z, dot(p, side1.xy) - side1.z),
                max(dot(p, side2.xy) - side2.z, radius - scale.w));

  // The line lies just within the shape, so that what is seen is what collides.
  float d_px = d * scale.x, halfLine_px = scale.y;
  float line_px = abs(d_px + halfLine_px) - halfLine_px;
  line_px = kind.z > 0 ? min(line_px, abs(radius - kind.z) * scale.x - halfLine_px) : line_px;
  // Chequers without a fill have their cross drawn: an announced one would else look like a plain square.
  float cross_px = max(min(abs(at.x), abs(at.y)) * scale.x - .5, d_px);
  line_px = kind.y > 0 && lit.x <= 0 ? min(line_px, cross_px) : line_px;

  float line = clamp(.5 - line_px, 0.0, 1.0);
  float fade = clamp(1 - line_px / scale.z, 0.0, 1.0);
  float inside = clamp(.5 - d_px, 0.0, 1.0);
  float squares = kind.y > 0 ? clamp(.5 + at.x * at.y * scale.x * 4, 0.0, 1.0) : 1.0;
  float fill = inside * squares * lit.x;

  vec3 core = tint.rgb + .35 * line * line * (1 - tint.rgb);
  colour = vec4(core * (line * lit.y) + tint.rgb * ((fill + fade * fade * lit.z) * (1 - line)),
                max(inside * tint.w, line * min(tint.w, lit.y)));
}
