// Owners of OpenGL objects: move-only, deleted with the owner, named by get(). They need a current
// context when they are made and when they go. Direct state access throughout: nothing is bound on the
// way to being changed.
#pragma once

#include <GL/glew.h>

#include <filesystem>
#include <string>
#include <utility>

#include "render/gl_context.h"

namespace gw {

// One object whose deletion is the function Delete.
template <void (*Delete)(GLuint)>
class GlObject {
 public:
  GlObject() = default;
  explicit GlObject(GLuint name) : name_(name) {}
  GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~GlObject() {
    if (name_ != 0) Delete(name_);
  }

  GLuint get() const { return name_; }
  explicit operator bool() const { return name_ != 0; }

 private:
  GLuint name_ = 0;
};

void deleteGlBuffer(GLuint name);
void deleteGlVertexArray(GLuint name);
void deleteGlProgram(GLuint name);
void deleteGlTexture(GLuint name);
void deleteGlFramebuffer(GLuint name);
void deleteGlQuery(GLuint name);

using GlBuffer = GlObject<deleteGlBuffer>;
using GlVertexArray = GlObject<deleteGlVertexArray>;
using GlProgram = GlObject<deleteGlProgram>;
using GlTexture = GlObject<deleteGlTexture>;
using GlFramebuffer = GlObject<deleteGlFramebuffer>;
using GlQuery = GlObject<deleteGlQuery>;

// Immutable storage. flags as for glNamedBufferStorage.
GlBuffer makeGlBuffer(size_t size_bytes, const void* data, GLbitfield flags);
GlVertexArray makeGlVertexArray();
GlQuery makeGlQuery(GLenum target);

// One level, clamped to its edges, linearly filtered. data may be null; rows are tightly packed.
GlTexture makeGlTexture(PixelSize size, GLenum internalFormat, GLenum format, const void* data);

// A frame buffer that draws into the texture. Throws std::runtime_error when the driver refuses it.
GlFramebuffer makeGlFramebuffer(const GlTexture& colour);

// Compiles and links two shaders, e.g. "shaders/sprite.vert" and "shaders/sprite.frag" in the folder of
// assets, each with these lines of #define after its first line. Throws std::runtime_error naming the file and the line
// that the driver complains about.
GlProgram makeGlProgram(const std::filesystem::path& assets, const std::string& vertexShader,
                        const std::string& fragmentShader, const std::string& defines = {});

// Throws std::runtime_error when a GL call since the last check failed. doing and what name the operation in the
// message, e.g. "drawing " and "the sprites". Cheap enough for one call per pass.
void checkGl(const char* doing, const char* what = "");

}  // namespace gw
