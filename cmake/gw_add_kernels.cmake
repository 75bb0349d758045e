# gw_add_kernels(name a.cu b.cu ... [LINK libraries])
#
# Compiles each .cu twice: as C++ into <name>_cpu (namespace gw::cpu) and, when CUDA is on, as CUDA into
# <name>_cuda (namespace gw::cuda). <name> links both. The C++ side goes through a generated one-line
# .cpp, because one file cannot have two LANGUAGEs in one folder: both targets silently become C++.
function(gw_add_kernels name)
  cmake_parse_arguments(A "" "" "LINK" ${ARGN})
  set(stubs)
  foreach(cu IN LISTS A_UNPARSED_ARGUMENTS)
    set(stub ${CMAKE_CURRENT_BINARY_DIR}/cpu/${cu}.cpp)
    if(NOT EXISTS ${stub})
      file(WRITE ${stub} "#include \"${CMAKE_CURRENT_SOURCE_DIR}/${cu}\"\n")
    endif()
    list(APPEND stubs ${stub})
  endforeach()

  add_library(${name}_cpu STATIC ${stubs})
  target_compile_definitions(${name}_cpu PRIVATE GW_DEVICE=cpu)
  target_link_libraries(${name}_cpu PUBLIC gw_options ${A_LINK})

  add_library(${name} INTERFACE)
  target_link_libraries(${name} INTERFACE ${name}_cpu)

  if(GW_HAVE_CUDA)
    add_library(${name}_cuda STATIC ${A_UNPARSED_ARGUMENTS})
    target_compile_definitions(${name}_cuda PRIVATE GW_DEVICE=cuda)
    target_link_libraries(${name}_cuda PUBLIC gw_options ${A_LINK} CUDA::cudart_static)
    target_link_libraries(${name} INTERFACE ${name}_cuda)
    target_compile_definitions(${name} INTERFACE GW_HAVE_CUDA=1)
  endif()
endfunction()
