# Inside another project (add_subdirectory, FetchContent): the cuda device is built when that project has enabled the
# language CUDA itself, with nvcc. Nothing is enabled here: a language counts for the folder that enables it, and the
# kernels that gw_add_kernels() compiles are in folders of that project. Sets GW_HAVE_CUDA.
get_property(gw_languages GLOBAL PROPERTY ENABLED_LANGUAGES)
set(GW_HAVE_CUDA OFF)
set(GW_CUDA_MISSING "the project around it had not enabled CUDA with nvcc when it was configured")
if("CUDA" IN_LIST gw_languages AND CMAKE_CUDA_COMPILER_ID STREQUAL "NVIDIA")
  if(GW_CUDA OR NOT DEFINED GW_CUDA)
    find_package(CUDAToolkit REQUIRED)
    set(GW_HAVE_CUDA ON)
    set(GW_CUDA_MISSING "")
  endif()
elseif(GW_CUDA)
  message(FATAL_ERROR "GW_CUDA is on, and the project that contains gpuwars has not enabled CUDA with nvcc before: "
    "write project(NAME LANGUAGES CXX CUDA), or leave GW_CUDA off for the cpu device alone.")
endif()
set(GW_HAVE_CUDA ${GW_HAVE_CUDA} PARENT_SCOPE) # as find_package(gpuwars) leaves it
