#version 450 core
// One glyph per instance, as a rectangle in pixels.
layout(location = 0) in vec4 box;      // left, top, width, height in pixels
layout(location = 1) in vec4 tile;     // u0, v0, u1, v1
layout(location = 2) in vec3 stroke;   // pixels per unit, half a stroke in units, glow
layout(location = 3) in vec4 colour;

uniform vec2 target;  // pixels

out vec2 uv;
flat out vec3 strokeOut;
flat out vec4 colourOut;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  uv = mix(tile.xy, tile.zw, corner);
  strokeOut = stroke;
  colourOut = colour;
  vec2 place = (box.xy + corner * box.zw) / target * 2.0 - 1.0;
  gl_Position = vec4(place.x, -place.y, 0.0, 1.0);
}
