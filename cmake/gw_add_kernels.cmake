# One-line .cpp files that each include a .cu: sources for the C++ compiler.
function(gw_write_stubs stubs folder) # a.cu ...
  set(written)
  foreach(cu IN LISTS ARGN)
    get_filename_component(file ${cu} ABSOLUTE)
    file(RELATIVE_PATH place ${CMAKE_CURRENT_SOURCE_DIR} ${file})
    string(REPLACE "../" "up/" place ${place})
    set(stub ${CMAKE_CURRENT_BINARY_DIR}/${folder}/${place}.cpp)
    file(GENERATE OUTPUT ${stub} CONTENT "#include \"${file}\"\n")
    list(APPEND written ${stub})
  endforeach()
  set(${stubs} ${written} PARENT_SCOPE)
endfunction()

# CMake 3.25 does not know CUDA20; what a folder sets when it ends is what its targets go by.
function(gw_know_cuda20)
  if(NOT DEFINED CMAKE_CUDA20_STANDARD_COMPILE_OPTION)
    cmake_language(DEFER CALL set CMAKE_CUDA20_STANDARD_COMPILE_OPTION -std=c++20)
    cmake_language(DEFER CALL set CMAKE_CUDA20_EXTENSION_COMPILE_OPTION -std=c++20)
  endif()
endfunction()

# gw_add_kernels(name a.cu b.cu ... [LINK libraries])
#
# Compiles each .cu twice: as C++ into <name>_cpu (namespace gw::cpu) and, when CUDA is on, as CUDA into
# <name>_cuda (namespace gw::cuda). <name> links both, and defines GW_HAVE_CUDA for who links it when there are two.
# The C++ side goes through a generated one-line .cpp, because one file cannot have two LANGUAGEs in one folder: both
# targets silently become C++. In projects of others it links gpuwars::gpu by itself, which says for which devices.
# With GW_CUDA_STAND_IN both are C++.
function(gw_add_kernels name)
  cmake_parse_arguments(A "" "" "LINK" ${ARGN})
  if(DEFINED gw_own_kernels_link)  # of this project
    set(common ${gw_own_kernels_link})
    set(with_cuda ${GW_HAVE_CUDA})
  elseif(TARGET gpuwars::gpu)
    set(common gpuwars::gpu)
    get_target_property(devices gpuwars::gpu GW_DEVICES)
    set(with_cuda OFF)
    if("cuda" IN_LIST devices)
      set(with_cuda ON)
    endif()
    # Who links them into a shared library need not know.
    if(NOT DEFINED CMAKE_POSITION_INDEPENDENT_CODE)
      set(CMAKE_POSITION_INDEPENDENT_CODE ON)
    endif()
  else()
    message(FATAL_ERROR "gw_add_kernels(${name}) finds no target gpuwars::gpu here: call find_package(gpuwars) in this "
      "folder or in one above it.")
  endif()

  gw_write_stubs(stubs ${name}/cpu ${A_UNPARSED_ARGUMENTS})
  add_library(${name}_cpu STATIC ${stubs})
  target_compile_definitions(${name}_cpu PRIVATE GW_DEVICE=cpu)
  target_link_libraries(${name}_cpu PUBLIC ${common} ${A_LINK})

  add_library(${name} INTERFACE)
  target_link_libraries(${name} INTERFACE ${name}_cpu)

  if(with_cuda)
    set(sources ${A_UNPARSED_ARGUMENTS})
    if(GW_CUDA_STAND_IN)
      gw_write_stubs(sources ${name}/cuda ${A_UNPARSED_ARGUMENTS})
    endif()
    add_library(${name}_cuda STATIC ${sources})
    if(GW_CUDA_STAND_IN)
      target_compile_definitions(${name}_cuda PRIVATE GW_STAND_IN_KERNELS=1)
      target_link_libraries(${name}_cuda PRIVATE ${GW_CUDART})
      target_compile_options(${name}_cuda PRIVATE -include cuda_runtime.h) # as nvcc does by itself
    endif()
    gw_know_cuda20()
    if(GW_CUDA_NEEDS_MATH AND NOT GW_CUDA_STAND_IN)
      target_compile_options(${name}_cuda PRIVATE
        "SHELL:-Xcompiler -include -Xcompiler ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/cuda_math.h")
    endif()
    set_target_properties(${name}_cuda PROPERTIES CUDA_STANDARD 20 CUDA_STANDARD_REQUIRED ON CUDA_EXTENSIONS OFF
      CUDA_RUNTIME_LIBRARY Static)
    if(GW_PTX_MACHINE)
      gw_for_ptx_machine(${name}_cuda)
    endif()
    target_compile_definitions(${name}_cuda PRIVATE GW_DEVICE=cuda)
    target_link_libraries(${name}_cuda PUBLIC ${common} ${A_LINK})
    target_link_libraries(${name} INTERFACE ${name}_cuda)
    target_compile_definitions(${name} INTERFACE GW_HAVE_CUDA=1)
  endif()
endfunction()
