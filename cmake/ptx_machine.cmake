# GW_PTX_MACHINE: nvcc's own objects, linked with the runtime of tests/ptx_machine in place of NVIDIA's.
if(NOT GW_HAVE_CUDA)
  message(FATAL_ERROR "GW_PTX_MACHINE runs what nvcc compiled, and there is no cuda device here: ${GW_CUDA_MISSING}. "
    "Install the CUDA toolkit, or use the preset stand-in, which needs no nvcc.")
endif()
if(NOT CMAKE_CUDA_ARCHITECTURES MATCHES "^[0-9]+-virtual$")
  message(FATAL_ERROR "GW_PTX_MACHINE runs PTX of one architecture, and CMAKE_CUDA_ARCHITECTURES is "
    "'${CMAKE_CUDA_ARCHITECTURES}': set it to 75-virtual or 90-virtual.")
endif()
set(GW_CUDART gw_ptx_runtime)
set(CMAKE_CUDA_RUNTIME_LIBRARY None) # programs link none of NVIDIA's

# What a library of kernels adds: PTX as text, so that the machine can read it, and with it the source's lines.
function(gw_for_ptx_machine target)
  set_target_properties(${target} PROPERTIES CUDA_RUNTIME_LIBRARY None)
  target_compile_options(${target} PRIVATE --no-compress -lineinfo -Xcompiler=-g1) # -g1: who allocated what
endfunction()
