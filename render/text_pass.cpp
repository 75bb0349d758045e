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

TextPass::TextPass(const std::filesystem::path& assets)
    : font_(loadTextFont(assets)),
      program_(makeGlProgram(assets, "shaders/text.vert", "shaders/text.frag")),
      atlas_(makeGlTexture(font_.atlasSize, GL_R8, GL_RED, font_.atlas.data())),
      vertexArray_(makeGlVertexArray()) {
  const GLuint array = vertexArray_.get();
  const auto attribute = [&](GLuint index, GLint count, GLenum type, GLboolean normalised, size_t offset) {
    glEnableVertexArrayAttrib(array, index);
    glVertexArrayAttribFormat(array, index, count, type, normalised, GLuint(offset));
    glVertexArrayAttribBinding(array, index, 0);
  };
  attribute(0, 4, GL_FLOAT, GL_FALSE, offsetof(Instance, left_px));
  attribute(1, 4, GL_FLOAT, GL_FALSE, offsetof(Instance, u0));
  attribute(2, 3, GL_FLOAT, GL_FALSE, offsetof(Instance, unit_px));
  attribute(3, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(Instance, rgba));
  glVertexArrayBindingDivisor(array, 0, 1);
  glProgramUniform1f(program_.get(), glGetUniformLocation(program_.get(), "range"), font_.range);
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
  if (instances_.size() > bufferCapacity_) {
    bufferCapacity_ = std::max<size_t>(1024, instances_.size() * 2);
    buffer_ = makeGlBuffer(bufferCapacity_ * sizeof(Instance), nullptr, GL_DYNAMIC_STORAGE_BIT);
    glVertexArrayVertexBuffer(vertexArray_.get(), 0, buffer_.get(), 0, sizeof(Instance));
  }
  glNamedBufferSubData(buffer_.get(), 0, GLsizeiptr(instances_.size() * sizeof(Instance)), instances_.data());

  const GLuint program = program_.get();
  glProgramUniform2f(program, glGetUniformLocation(program, "target"), float(target.width), float(target.height));
  glUseProgram(program);
  glBindTextureUnit(0, atlas_.get());
  glBindVertexArray(vertexArray_.get());
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);  // the strokes cover, their glow adds
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, GLsizei(instances_.size()));
  glDisable(GL_BLEND);
  glBindVertexArray(0);
  instances_.clear();
  checkGl("drawing text");
}

}  // namespace gw
