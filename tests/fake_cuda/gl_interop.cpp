// OpenGL interop: a registered buffer has memory of the device beside it, which mapping fills and unmapping copies
// back. Who writes after unmapping, or lets OpenGL draw before it, is found out: what is drawn is then the old picture.
#include <GL/glew.h>

#include <cstring>

#include "cuda_gl_interop.h"
#include "driver.h"

using namespace gw::stand_in;

struct cudaGraphicsResource {
  GLuint buffer;
  size_t bytes;
  unsigned flags;
  void* beside;
  bool mapped = false;
};

namespace {

// Through a buffer of its own: what is registered need not allow to be mapped or written by the host.
void copyIntoBuffer(const cudaGraphicsResource& resource) {
  GLuint staging = 0;
  glCreateBuffers(1, &staging);
  glNamedBufferData(staging, GLsizeiptr(resource.bytes), resource.beside, GL_STREAM_COPY);
  glCopyNamedBufferSubData(staging, resource.buffer, 0, 0, GLsizeiptr(resource.bytes));
  glDeleteBuffers(1, &staging);
}

}  // namespace

uint64_t gw::stand_in::resourcesLeftMapped() {
  if (driver().sticky != cudaSuccess) return 0;  // a dead context holds nothing
  uint64_t mapped = 0;
  for (const cudaGraphicsResource* resource : driver().resources) mapped += resource->mapped;
  return mapped;
}

cudaError_t cudaGLGetDevices(unsigned* count, int* devices, unsigned room, cudaGLDeviceList) {
  GW_ENTER("cudaGLGetDevices");
  if (driver().options.apart) {
    *count = 0;
    return failed(cudaErrorNoDevice);
  }
  *count = 1;
  if (room > 0) devices[0] = 0;
  return cudaSuccess;
}

cudaError_t cudaGraphicsGLRegisterBuffer(cudaGraphicsResource_t* resource, GLuint buffer, unsigned flags) {
  GW_ENTER_OUTSIDE_CAPTURE("cudaGraphicsGLRegisterBuffer");
  GLint64 bytes = 0;
  glGetNamedBufferParameteri64v(buffer, GL_BUFFER_SIZE, &bytes);
  if (bytes <= 0) return failed(cudaErrorInvalidValue);
  *resource = new cudaGraphicsResource{buffer, size_t(bytes), flags, allocateDevice(size_t(bytes))};
  driver().resources.insert(*resource);
  return cudaSuccess;
}

cudaError_t cudaGraphicsUnregisterResource(cudaGraphicsResource_t resource) {
  GW_ENTER_OUTSIDE_CAPTURE("cudaGraphicsUnregisterResource");
  if (driver().resources.erase(resource) == 0) return failed(cudaErrorInvalidResourceHandle);
  finishAll();
  releaseDevice(resource->beside);
  delete resource;
  return cudaSuccess;
}

cudaError_t cudaGraphicsMapResources(int count, cudaGraphicsResource_t* wanted, cudaStream_t stream) {
  GW_ENTER_OUTSIDE_CAPTURE("cudaGraphicsMapResources");
  if (!streamOf(stream)) return failed(cudaErrorInvalidResourceHandle);
  for (int i = 0; i < count; ++i) {
    if (!driver().resources.count(wanted[i]) || wanted[i]->mapped) return failed(cudaErrorInvalidResourceHandle);
  }
  for (int i = 0; i < count; ++i) {
    cudaGraphicsResource& resource = *wanted[i];
    resource.mapped = true;
    if (resource.flags & cudaGraphicsRegisterFlagsWriteDiscard) {
      deviceForgotten(resource.beside, resource.bytes);
    } else {
      glGetNamedBufferSubData(resource.buffer, 0, GLsizeiptr(resource.bytes), resource.beside);
      deviceWritten(resource.beside, resource.bytes);
    }
  }
  return cudaSuccess;
}

cudaError_t cudaGraphicsUnmapResources(int count, cudaGraphicsResource_t* wanted, cudaStream_t stream) {
  GW_ENTER_OUTSIDE_CAPTURE("cudaGraphicsUnmapResources");
  CUstream_st* on = streamOf(stream);
  if (!on) return failed(cudaErrorInvalidResourceHandle);
  finish(*on);  // OpenGL's commands that follow see what this stream wrote, and no other
  for (int i = 0; i < count; ++i) {
    if (!driver().resources.count(wanted[i]) || !wanted[i]->mapped) return failed(cudaErrorInvalidResourceHandle);
    copyIntoBuffer(*wanted[i]);
    wanted[i]->mapped = false;
  }
  return cudaSuccess;
}

cudaError_t cudaGraphicsResourceGetMappedPointer(void** pointer, size_t* bytes, cudaGraphicsResource_t resource) {
  GW_ENTER("cudaGraphicsResourceGetMappedPointer");
  if (!driver().resources.count(resource) || !resource->mapped) return failed(cudaErrorInvalidResourceHandle);
  *pointer = resource->beside;
  *bytes = resource->bytes;
  return cudaSuccess;
}
