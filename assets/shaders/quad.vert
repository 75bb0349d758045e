#version 450 core
// Screen pixels, y down, to clip space.

layout(location = 0) in vec2 place_px;
layout(location = 1) in vec4 tint;
layout(location = 0) uniform vec2 perPixel;  // 2 / size of the picture

out vec4 paint;

void main() {
  paint = tint;
  gl_Position = vec4(place_px.x * perPixel.x - 1, 1 - place_px.y * perPixel.y, 0, 1);
}
