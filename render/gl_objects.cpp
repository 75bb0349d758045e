#include "render/gl_objects.h"

#include <regex>
#include <stdexcept>

#include "render/asset_file.h"

namespace gw {
namespace {

// The first line number in a driver's message: Mesa writes "0:12(5): error: ...", NVIDIA "0(12) : error ...",
// others "ERROR: 0:12: ...".
std::string describeShaderLog(const std::string& file, const std::string& log) {
  static const std::regex place(R"((?:\d+:(\d+)\(\d+\)|\d+\((\d+)\)|ERROR: \d+:(\d+))\s*:?\s*([^\n]*))");
  std::smatch match;
  if (!std::regex_search(log, match, place)) return file + ": " + log.substr(0, log.find('\n'));
  const std::string line = match[1].matched ? match[1] : match[2].matched ? match[2] : match[3];
  return file + ", line " + line + ": " + match[4].str();
}

std::runtime_error shaderError(const std::string& what) {
  return std::runtime_error("The shader does not compile in " + what +
                            "; put it back from the GpuWars package, or update the graphics driver.");
}

GLuint compileShader(GLenum stage, const std::filesystem::path& assets, const std::string& file,
                     const std::string& defines) {
  std::string source = readAsset(assets, file);
  const size_t firstLine = source.find('\n');  // #version, which has to come first
  if (!defines.empty() && firstLine != std::string::npos) source.insert(firstLine + 1, defines + "#line 2\n");
  const char* text = source.c_str();
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint ok = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (!ok) {
    char log[4096] = "";
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    glDeleteShader(shader);
    throw shaderError(describeShaderLog((assets / file).string(), log));
  }
  return shader;
}

const char* glErrorName(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "invalid enumerant";
    case GL_INVALID_VALUE:
      return "invalid value";
    case GL_INVALID_OPERATION:
      return "invalid operation";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "invalid frame buffer";
    case GL_OUT_OF_MEMORY:
      return "out of memory";
    default:
      return "unknown error";
  }
}

}  // namespace

void deleteGlBuffer(GLuint name) {
  glDeleteBuffers(1, &name);
}
void deleteGlVertexArray(GLuint name) {
  glDeleteVertexArrays(1, &name);
}
void deleteGlProgram(GLuint name) {
  glDeleteProgram(name);
}
void deleteGlTexture(GLuint name) {
  glDeleteTextures(1, &name);
}
void deleteGlFramebuffer(GLuint name) {
  glDeleteFramebuffers(1, &name);
}
void deleteGlQuery(GLuint name) {
  glDeleteQueries(1, &name);
}

GlBuffer makeGlBuffer(size_t size_bytes, const void* data, GLbitfield flags) {
  GLuint name = 0;
  glCreateBuffers(1, &name);
  GlBuffer buffer(name);
  glNamedBufferStorage(name, GLsizeiptr(size_bytes), data, flags);
  checkGl("making a buffer");
  return buffer;
}

GlVertexArray makeGlVertexArray() {
  GLuint name = 0;
  glCreateVertexArrays(1, &name);
  return GlVertexArray(name);
}

GlQuery makeGlQuery(GLenum target) {
  GLuint name = 0;
  glCreateQueries(target, 1, &name);
  return GlQuery(name);
}

GlTexture makeGlTexture(PixelSize size, GLenum internalFormat, GLenum format, const void* data) {
  GLuint name = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &name);
  GlTexture texture(name);
  glTextureStorage2D(name, 1, internalFormat, size.width, size.height);
  glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTextureParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  if (data != nullptr) {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(name, 0, 0, 0, size.width, size.height, format, GL_UNSIGNED_BYTE, data);
  }
  checkGl("making a texture");
  return texture;
}

GlFramebuffer makeGlFramebuffer(const GlTexture& colour) {
  GLuint name = 0;
  glCreateFramebuffers(1, &name);
  GlFramebuffer framebuffer(name);
  glNamedFramebufferTexture(name, GL_COLOR_ATTACHMENT0, colour.get(), 0);
  if (glCheckNamedFramebufferStatus(name, GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error(
        "The graphics driver refuses a picture of this size: choose a smaller --width and --height.");
  }
  return framebuffer;
}

GlProgram makeGlProgram(const std::filesystem::path& assets, const std::string& vertexShader,
                        const std::string& fragmentShader, const std::string& defines) {
  GlProgram program(glCreateProgram());
  const GLuint vertex = compileShader(GL_VERTEX_SHADER, assets, vertexShader, defines);
  glAttachShader(program.get(), vertex);
  glDeleteShader(vertex);  // lives on as long as the program holds it
  const GLuint fragment = compileShader(GL_FRAGMENT_SHADER, assets, fragmentShader, defines);
  glAttachShader(program.get(), fragment);
  glDeleteShader(fragment);
  glLinkProgram(program.get());
  GLint ok = 0;
  glGetProgramiv(program.get(), GL_LINK_STATUS, &ok);
  if (!ok) {
    char log[4096] = "";
    glGetProgramInfoLog(program.get(), sizeof log, nullptr, log);
    throw shaderError(
        describeShaderLog((assets / vertexShader).string() + " and " + (assets / fragmentShader).string(), log));
  }
  return program;
}

void checkGl(const char* doing, const char* what) {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return;
  while (glGetError() != GL_NO_ERROR) {
  }
  throw std::runtime_error(std::string("OpenGL failed while ") + doing + what + " (" + glErrorName(error) +
                           "): update the graphics driver, or run with --headless.");
}

}  // namespace gw
