#include "render/text_pass.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "render/gl_group.h"

namespace gw {

namespace {

uint32_t pack(Rgba colour) {
  const auto byte = [](float share) { return uint32_t(std::lround(std::clamp(share, 0.0f, 1.0f) * 255)); };
  return byte(colour.red) | byte(colour.green) << 8 | byte(colour.blue) << 16 | byte(colour.alpha) << 24;
}

}  // namespace

PassLayout TextPass::layout() {
  return {"text",
          "text",
          {{VertexAttribute::Type::real, 4, offsetof(Instance, left_px)},
           {VertexAttribute::Type::real, 4, offsetof(Instance, u0)},
           {VertexAttribute::Type::real, 3, offsetof(Instance, unit_px)},
           {VertexAttribute::Type::colour, 4, offsetof(Instance, rgba)}}};
}

TextPass::TextPass(const std::filesystem::path& assets)
    : font_(loadTextFont(assets)),
      pass_(assets, layout()),
      atlas_(makeGlTexture(font_.atlasSize, GL_R8, GL_RED, font_.atlas.data())) {
  glProgramUniform1f(pass_.program(), glGetUniformLocation(pass_.program(), "range"), font_.range);
  checkGl("preparing text");
}

void TextPass::add(std::string_view text, float x_px, float baseline_px, const TextStyle& style) {
  const float unit = style.size_px / font_.capHeight;
  float pen = x_px;
  if (style.align != TextAlign::left) {
    pen -= font_.width_px(text, style.size_px) * (style.align == TextAlign::centre ? 0.5f : 1.0f);
  }
  const uint32_t rgba = pack(style.colour);
  for (const char character : text) {
    const Glyph& glyph = font_.glyph(character);
    if (glyph.width > 0) {
      const float scale = unit / font_.pixelsPerUnit;
      instances_.push_back(
          {pen + glyph.left * unit, baseline_px - glyph.top * unit, glyph.width * scale, glyph.height * scale,
           glyph.x / float(font_.atlasSize.width), glyph.y / float(font_.atlasSize.height),
           (glyph.x + glyph.width) / float(font_.atlasSize.width),
           (glyph.y + glyph.height) / float(font_.atlasSize.height), unit, style.weight, style.glow, rgba});
    }
    pen += glyph.advance * unit;
  }
}

void TextPass::flush(PixelSize target) {
  if (instances_.empty()) return;
  const GlGroup group("text");
  const GLuint program = pass_.program();
  glProgramUniform2f(program, glGetUniformLocation(program, "target"), float(target.width), float(target.height));
  glUseProgram(program);
  glBindTextureUnit(0, atlas_.get());
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);  // the strokes cover, their glow adds
  pass_.draw(GL_TRIANGLE_STRIP, 4, instances_);
  glDisable(GL_BLEND);
  glBindVertexArray(0);
  instances_.clear();
}

}  // namespace gw
