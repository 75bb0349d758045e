#!/usr/bin/env bash
# Mesa's llvmpipe: the first GL_TIME_ELAPSED query of a context holds the time since the machine started, hours of it; all
# later ones hold what they should. The same in Mesa 22.3.6, 25.0.7 and 26.1.6.
#
# One would guess that a query that begins and ends around a clear holds how long that took, or 0. A profiler that takes
# the mean of its frames is off by hours for one frame; a limit on the time of a frame trips at once. A query that is
# thrown away before the first real one helps.
#
# Exit status: 0 as described, 1 it behaves otherwise now, 2 the packages cannot be had.
set -u
readonly version=22.3.6-1+deb12u2
for package in libgl1-mesa-dri libegl-mesa0; do
  [[ "$(dpkg-query -W -f '${Version}' "$package" 2>/dev/null)" == "$version" ]] || {
    echo "$package $version is not installed." >&2
    exit 2
  }
done
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 2

cat >elapsed.cpp <<'CPP'
#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <cstdio>
#include <ctime>
int main() {
  const auto platformDisplay = (PFNEGLGETPLATFORMDISPLAYEXTPROC)eglGetProcAddress("eglGetPlatformDisplayEXT");
  const EGLDisplay display = platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (!eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API)) return 2;
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5, EGL_NONE};
  const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) return 2;
  GLuint texture, target;
  glCreateTextures(GL_TEXTURE_2D, 1, &texture);
  glTextureStorage2D(texture, 1, GL_RGBA8, 640, 480);
  glCreateFramebuffers(1, &target);
  glNamedFramebufferTexture(target, GL_COLOR_ATTACHMENT0, texture, 0);
  glBindFramebuffer(GL_FRAMEBUFFER, target);
  for (int i = 1; i <= 3; ++i) {
    GLuint query;
    GLuint64 took_ns = 0;
    glGenQueries(1, &query);
    glBeginQuery(GL_TIME_ELAPSED, query);
    glClear(GL_COLOR_BUFFER_BIT);
    glEndQuery(GL_TIME_ELAPSED);
    glGetQueryObjectui64v(query, GL_QUERY_RESULT, &took_ns);
    timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    const double behind_s = double(now.tv_sec) - double(took_ns) * 1e-9;
    std::printf("query %d: %s\n", i, behind_s < 5 ? "all the time since the machine started" :
                                    took_ns < 1000000000 ? "less than a second" : "something else");
  }
}
CPP
g++ elapsed.cpp -lEGL -lOpenGL -o elapsed || exit 2
seen="$(LIBGL_ALWAYS_SOFTWARE=1 ./elapsed)" || exit 2
expected='query 1: all the time since the machine started
query 2: less than a second
query 3: less than a second'
echo "Mesa $version, llvmpipe, three clears, each timed by itself:"
echo "$seen"
[[ "$seen" == "$expected" ]]
