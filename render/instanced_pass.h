// What the passes that draw from vertex buffers share: program, vertex layout, buffer and draw call. A pass adds its
// uniforms and its blending.
#pragma once

#include <algorithm>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "render/camera.h"
#include "render/gl_objects.h"
#include "render/vertex_stream.h"

namespace gw {

struct VertexAttribute {
  enum class Type { real, integer, colour };  // float; uint; bytes 0..255 that the shader reads as 0..1
  Type type;
  GLint components;
  size_t offset_bytes;  // in the vertex
};

struct PassLayout {
  std::string shader;                       // assets/shaders/NAME.vert and NAME.frag
  const char* what;                         // in messages, e.g. "the sprites"
  std::vector<VertexAttribute> attributes;  // in the order of their locations in the shader
  std::string defines = {};                 // #define lines that both shaders begin with
};

// The program and the vertex array of a pass.
class GeometryPass {
 public:
  enum class Step { vertex, instance };  // what the buffer holds an element of

  GeometryPass(const std::filesystem::path& assets, const PassLayout& layout, Step step);

  GLuint program() const { return program_.get(); }

 protected:
  // Makes the vertices current.
  void bind(GLuint buffer, size_t offset_bytes, size_t stride_bytes);
  void checkDrawn() const { checkGl("drawing ", what_); }

 private:
  GlProgram program_;
  GlVertexArray vertexArray_;
  const char* what_;
};

// A buffer of the pass's own for vertices that the host makes; grows when more come than ever before.
template <class Vertex>
class HostVertices {
 public:
  explicit HostVertices(size_t firstCapacity) : firstCapacity_(firstCapacity) {}

  GLuint upload(std::span<const Vertex> vertices) {
    if (vertices.size() > capacity_) {
      capacity_ = std::max(firstCapacity_, vertices.size() * 2);
      buffer_ = makeGlBuffer(capacity_ * sizeof(Vertex), nullptr, GL_DYNAMIC_STORAGE_BIT);
    }
    // Orphaning first: the driver then need not wait until the previous contents have been drawn.
    glInvalidateBufferData(buffer_.get());
    glNamedBufferSubData(buffer_.get(), 0, GLsizeiptr(vertices.size_bytes()), vertices.data());
    return buffer_.get();
  }

 private:
  size_t firstCapacity_, capacity_ = 0;
  GlBuffer buffer_;
};

// One Vertex per instance.
template <class Vertex>
class InstancedPass : public GeometryPass {
 public:
  InstancedPass(const std::filesystem::path& assets, const PassLayout& layout)
      : GeometryPass(assets, layout, Step::instance) {}

  // Instances that a kernel has written; their number is in the region's command. The region is selected by the offset
  // of the binding, so that baseInstance stays 0 in what the kernel writes.
  void draw(GLenum primitive, const RegionOf<Vertex>& region) {
    bind(region.vertexBuffer, region.vertexOffset_bytes, sizeof(Vertex));
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, region.commandBuffer);
    glDrawArraysIndirect(primitive, reinterpret_cast<const void*>(region.commandOffset_bytes));
    checkDrawn();
  }

  // Instances that the host has made.
  void draw(GLenum primitive, GLsizei verticesEach, std::span<const Vertex> instances) {
    bind(host_.upload(instances), 0, sizeof(Vertex));
    glDrawArraysInstanced(primitive, 0, verticesEach, GLsizei(instances.size()));
    checkDrawn();
  }

 private:
  HostVertices<Vertex> host_{1024};
};

// One Vertex per vertex, from the host.
template <class Vertex>
class TrianglePass : public GeometryPass {
 public:
  TrianglePass(const std::filesystem::path& assets, const PassLayout& layout)
      : GeometryPass(assets, layout, Step::vertex) {}

  void draw(std::span<const Vertex> vertices) {
    bind(host_.upload(vertices), 0, sizeof(Vertex));
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(vertices.size()));
    checkDrawn();
  }

 private:
  HostVertices<Vertex> host_{4096};  // a screen of bars without growing
};

// Location of the uniform `vec4 camera` of every shader that draws the world.
inline constexpr GLint kCameraUniform = 0;

inline void setCamera(const Camera& camera) {
  glUniform4f(kCameraUniform, camera.centre_x, camera.centre_y, 1 / camera.halfWidth_m, 1 / camera.halfHeight_m);
}

inline float pixelsPerMetre(const Camera& camera, PixelSize target) {
  return float(target.height) / (2 * camera.halfHeight_m);
}

}  // namespace gw
