#!/usr/bin/env bash
# GLM and GLSL: findMSB() and bitfieldExtract() of signed numbers and usubBorrow() give other results in GLM than in a
# shader. GLM 1.0.1 and Mesa 26.1.6 differ in the same way.
#
# One would guess that a function of GLM with the name of one of GLSL computes the same: that is what GLM is for. But GLSL's
# findMSB() of a negative int is the highest bit that is 0, GLM's is always 31; GLSL extends the sign of an extracted signed
# field, GLM does not; and glm::usubBorrow(x, y) returns y - x. Packed particles, cell numbers or fixed-point times that the
# processor unpacks with the shader's own lines are then not the ones that the shader saw.
#
# Exit status: 0 as described, 1 it behaves otherwise now, 2 the packages cannot be had.
set -u
readonly version=0.9.9.8+ds-6 mesa=22.3.6-1+deb12u2
for package in libgl1-mesa-dri libegl-mesa0; do
  [[ "$(dpkg-query -W -f '${Version}' "$package" 2>/dev/null)" == "$mesa" ]] || {
    echo "$package $mesa is not installed." >&2
    exit 2
  }
done
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
chmod 755 "$folder"
cd "$folder" || exit 2

{ apt-get download -q "libglm-dev=$version" >/dev/null 2>&1 && dpkg-deb -x libglm-dev_*.deb .; } || {
  echo "libglm-dev $version cannot be had here." >&2
  exit 2
}
cat >bits.cpp <<'CPP'
#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <cstdio>
#include <glm/glm.hpp>
#include <glm/integer.hpp>
using glm::uint;
#define CALCULATE                     \
  a[0] = findMSB(a[0]);               \
  a[1] = findMSB(a[1]);               \
  a[2] = bitfieldExtract(a[2], 4, 4); \
  b[0] = usubBorrow(b[0], b[1], c);
#define TEXT_OF(code) #code
#define TEXT(code) TEXT_OF(code)
struct Numbers {
  int a[3];
  uint b[2], c;
};
static void show(const char* who, const Numbers& n) {
  std::printf("%s: %d, %d, %d, %d with borrow %u\n", who, n.a[0], n.a[1], n.a[2], int(n.b[0]), n.c);
}
int main() {
  const Numbers given{{-1, -256, 0xf0}, {5, 2}, 0};
  Numbers byGlm = given;
  {
    using namespace glm;
    auto& [a, b, c] = byGlm;
    CALCULATE
  }
  show("GLM ", byGlm);

  const auto platformDisplay = (PFNEGLGETPLATFORMDISPLAYEXTPROC)eglGetProcAddress("eglGetPlatformDisplayEXT");
  const EGLDisplay display = platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (!eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API)) return 2;
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5, EGL_NONE};
  const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) return 2;
  const char* const source =
      "#version 450\n"
      "layout(local_size_x = 1) in;\n"
      "layout(std430, binding = 0) buffer Numbers { int a[3]; uint b[2], c; };\n"
      "void main() { " TEXT(CALCULATE) " }\n";
  const GLuint program = glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &source);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (!linked) return 2;
  GLuint buffer;
  glCreateBuffers(1, &buffer);
  glNamedBufferData(buffer, sizeof given, &given, GL_DYNAMIC_READ);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer);
  glUseProgram(program);
  glDispatchCompute(1, 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  Numbers byGlsl{};
  glGetNamedBufferSubData(buffer, 0, sizeof byGlsl, &byGlsl);
  show("GLSL", byGlsl);
}
CPP
g++ -std=c++17 -isystem usr/include bits.cpp -lEGL -lOpenGL -o bits || exit 2
seen="$(LIBGL_ALWAYS_SOFTWARE=1 ./bits)" || exit 2
expected='GLM : 31, 31, 15, -3 with borrow 0
GLSL: -1, 7, -1, 3 with borrow 0'
echo "GLM $version and Mesa's llvmpipe $mesa, findMSB(-1), findMSB(-256), bitfieldExtract(0xf0, 4, 4), usubBorrow(5, 2):"
echo "$seen"
[[ "$seen" == "$expected" ]]
