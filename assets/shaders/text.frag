#version 450 core
// A tube of light: white-hot in the middle, coloured at its edge, glowing around.
in vec2 uv;
flat in vec3 strokeOut;
flat in vec4 colourOut;

layout(binding = 0) uniform sampler2D atlas;
uniform float range;  // units of distance that the atlas spans

out vec4 picture;

void main() {
  float unit = strokeOut.x;
  float away = (1.0 - texture(atlas, uv).r) * range;  // from the middle of the stroke, units
  // Small text keeps strokes of at least a pixel.
  float half_ = max(strokeOut.y, 0.55 / unit);
  float core = clamp((half_ - away) * unit + 0.5, 0.0, 1.0);
  float heat = (0.35 + 0.5 * strokeOut.z) * clamp(1.0 - away / half_, 0.0, 1.0);
  float outside = max(away - half_, 0.0) / max(range - half_, 0.01);
  float glow = strokeOut.z * (1.0 - core) * exp(-3.2 * outside) * clamp(1.0 - outside, 0.0, 1.0);
  vec3 light = mix(colourOut.rgb, vec3(1.0), heat) * core + colourOut.rgb * glow;
  picture = vec4(light * colourOut.a, core * colourOut.a);
}
