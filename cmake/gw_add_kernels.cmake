# One-line .cpp files that each include a .cu: sources for the C++ compiler.
function(gw_write_stubs stubs device) # a.cu ...
  set(written)
  foreach(cu IN LISTS ARGN)
    set(stub ${CMAKE_CURRENT_BINARY_DIR}/${device}/${cu}.cpp)
    if(NOT EXISTS ${stub})
      file(WRITE ${stub} "#include \"${CMAKE_CURRENT_SOURCE_DIR}/${cu}\"\n")
    endif()
    list(APPEND written ${stub})
  endforeach()
  set(${stubs} ${written} PARENT_SCOPE)
endfunction()

# gw_add_kernels(name a.cu b.cu ... [LINK libraries])
#
# Compiles each .cu twice: as C++ into <name>_cpu (namespace gw::cpu) and, when CUDA is on, as CUDA into
# <name>_cuda (namespace gw::cuda). <name> links both, and defines GW_HAVE_CUDA for who links it when there are two.
# The C++ side goes through a generated one-line .cpp, because one file cannot have two LANGUAGEs in one folder: both
# targets silently become C++. Installed with the library: there it links gpuwars::gpu by itself.
# With GW_CUDA_STAND_IN both are C++.
function(gw_add_kernels name)
  cmake_parse_arguments(A "" "" "LINK" ${ARGN})
  gw_write_stubs(stubs cpu ${A_UNPARSED_ARGUMENTS})
  if(TARGET gpuwars::gpu)
    set(common gpuwars::gpu)
  else()
    set(common gw_gpu_flags $<BUILD_INTERFACE:gw_options>)
  endif()

  add_library(${name}_cpu STATIC ${stubs})
  target_compile_definitions(${name}_cpu PRIVATE GW_DEVICE=cpu)
  target_link_libraries(${name}_cpu PUBLIC ${common} ${A_LINK})

  add_library(${name} INTERFACE)
  target_link_libraries(${name} INTERFACE ${name}_cpu)

  if(GW_HAVE_CUDA)
    set(sources ${A_UNPARSED_ARGUMENTS})
    if(GW_CUDA_STAND_IN)
      gw_write_stubs(sources cuda ${A_UNPARSED_ARGUMENTS})
    endif()
    add_library(${name}_cuda STATIC ${sources})
    if(GW_CUDA_STAND_IN)
      target_compile_definitions(${name}_cuda PRIVATE GW_STAND_IN_KERNELS=1)
      target_compile_options(${name}_cuda PRIVATE -include cuda_runtime.h) # as nvcc does by itself
    endif()
    set_target_properties(${name}_cuda PROPERTIES CUDA_STANDARD 20 CUDA_STANDARD_REQUIRED ON CUDA_EXTENSIONS OFF
      CUDA_RUNTIME_LIBRARY Static)
    target_compile_definitions(${name}_cuda PRIVATE GW_DEVICE=cuda)
    target_link_libraries(${name}_cuda PUBLIC ${common} ${A_LINK} CUDA::cudart_static)
    target_link_libraries(${name} INTERFACE ${name}_cuda)
    target_compile_definitions(${name} INTERFACE GW_HAVE_CUDA=1)
  endif()
endfunction()
