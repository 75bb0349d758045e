#version 450 core
// Light that is added: white-hot at the head while it is young, its colour along the streak.

in vec2 at;
flat in vec3 shape;
flat in vec3 tint;

layout(location = 0) out vec4 colour;

void main() {
  float across = clamp(1 - abs(at.y) / (shape.x * max(at.x, .01)), 0.0, 1.0);
  float ahead = clamp((1 - at.x) * shape.y / shape.x, 0.0, 1.0);  // a round head instead of a cut one
  float light = across * (2 - across) * ahead * min(at.x * 1.7, 1.0) * shape.z;
  float hot = .8 * light * light * shape.z;
  colour = vec4((tint + hot * (1 - tint)) * light, 0);
}
