#include "render/instanced_pass.h"

namespace gw {

GeometryPass::GeometryPass(const std::filesystem::path& assets, const PassLayout& layout, Step step)
    : program_(makeGlProgram(assets, "shaders/" + layout.shader + ".vert", "shaders/" + layout.shader + ".frag",
                             layout.defines)),
      vertexArray_(makeGlVertexArray()),
      what_(layout.what) {
  constexpr GLuint kBinding = 0;  // the one that all attributes come from
  const GLuint array = vertexArray_.get();
  for (GLuint location = 0; location < layout.attributes.size(); ++location) {
    const auto& [type, components, offset_bytes] = layout.attributes[location];
    const auto offset = GLuint(offset_bytes);
    switch (type) {
      case VertexAttribute::Type::real:
        glVertexArrayAttribFormat(array, location, components, GL_FLOAT, GL_FALSE, offset);
        break;
      case VertexAttribute::Type::integer:
        glVertexArrayAttribIFormat(array, location, components, GL_UNSIGNED_INT, offset);
        break;
      case VertexAttribute::Type::colour:
        glVertexArrayAttribFormat(array, location, components, GL_UNSIGNED_BYTE, GL_TRUE, offset);
        break;
    }
    glEnableVertexArrayAttrib(array, location);
    glVertexArrayAttribBinding(array, location, kBinding);
  }
  glVertexArrayBindingDivisor(array, kBinding, step == Step::instance ? 1 : 0);
  checkGl("preparing ", what_);
}

void GeometryPass::bind(GLuint buffer, size_t offset_bytes, size_t stride_bytes) {
  glBindVertexArray(vertexArray_.get());
  glVertexArrayVertexBuffer(vertexArray_.get(), 0, buffer, GLintptr(offset_bytes), GLsizei(stride_bytes));
}

}  // namespace gw
