# nvcc lets another compiler do the host's half of CUDA files, and takes none newer than itself: 13.0 takes g++ up to 15
# and clang up to 20, where Debian 14's own g++ is 16. So what it takes is found out by compiling, once for each set of
# compilers; what it takes is used for CUDA alone. Objects of an older g++ link with those of a newer one: one libstdc++.

# gw_find_cuda_host_compiler(nvcc host math why)
#   host: what `nvcc -ccbin` is to be told; empty: its own choice is fine, or nothing is
#   math: whether CUDA files need cuda_math.h before all else, for a C library that is newer than nvcc
#   why: empty when CUDA files compile, else one sentence with a remedy, without semicolons
# If CMAKE_CUDA_HOST_COMPILER or CUDAHOSTCXX is set, that one is used, or a sentence says why not.
function(gw_find_cuda_host_compiler nvcc host math why)
  gw_nvcc_release(${nvcc} release)
  set(found "${CMAKE_CUDA_HOST_COMPILER}")
  if(NOT found)
    set(found "$ENV{CUDAHOSTCXX}")
  endif()
  set(given "${found}")
  set(sentence "")
  gw_nvcc_takes(${nvcc} "${given}" needs_math said)
  if(NOT said STREQUAL "")
    gw_refusal_of_nvcc("${release}" "${given}" "${said}" sentence)
    if(NOT given)
      string(REGEX MATCH "unsupported [A-Za-z]+ version" only_too_new "${said}")
      gw_other_host_compilers(others)
      foreach(other IN LISTS others)
        gw_nvcc_takes(${nvcc} ${other} needs_math said)
        if(said STREQUAL "")
          set(found ${other})
          set(sentence "")
          break()
        elseif(only_too_new AND NOT said MATCHES "unsupported [A-Za-z]+ version")
          set(only_too_new "")  # so another compiler of that age is no remedy
          gw_refusal_of_nvcc("${release}" ${other} "${said}" sentence)
        endif()
      endforeach()
    endif()
  endif()
  set(${host} "${found}" PARENT_SCOPE)
  set(${math} "${needs_math}" PARENT_SCOPE)
  set(${why} "${sentence}" PARENT_SCOPE)
endfunction()

# "13.0" of nvcc's answer; empty: it gave none.
function(gw_nvcc_release nvcc release)
  execute_process(COMMAND ${nvcc} --version OUTPUT_VARIABLE text ERROR_QUIET RESULT_VARIABLE failed)
  string(REGEX MATCH "release ([0-9.]+)" found "${text}")
  set(${release} "${CMAKE_MATCH_1}" PARENT_SCOPE)
endfunction()

# What nvcc says against making a program with that host compiler (empty: its own choice); empty when it does, if need be
# with cuda_math.h.
function(gw_nvcc_takes nvcc host needs_math said)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/cuda_host_compiler)
  # What our kernels include: headers, too, can be newer than nvcc.
  file(WRITE ${folder}/probe.cu "#include <algorithm>\n#include <atomic>\n#include <cmath>\n#include <functional>\n"
    "#include <memory>\n#include <span>\n#include <stdexcept>\n#include <string>\n#include <vector>\n"
    "__global__ void kernel(float* x) { *x = sqrtf(*x); }\n"
    "int main() { for (float* x : std::vector<float*>()) kernel<<<1, 1>>>(x); }\n")
  set(by)
  if(host)
    set(by -ccbin ${host})
  endif()
  set(${needs_math} OFF PARENT_SCOPE)
  foreach(before IN ITEMS "" "-Xcompiler;-include;-Xcompiler;${CMAKE_CURRENT_FUNCTION_LIST_DIR}/cuda_math.h")
    execute_process(COMMAND ${nvcc} -std=c++20 ${by} ${before} probe.cu -o probe WORKING_DIRECTORY ${folder}
      OUTPUT_VARIABLE text ERROR_VARIABLE text RESULT_VARIABLE result)
    if(result STREQUAL "0")
      if(before)
        set(${needs_math} ON PARENT_SCOPE)
      endif()
      set(${said} "" PARENT_SCOPE)
      return()
    elseif(NOT before)
      set(${said} "${result}\n${text}" PARENT_SCOPE)
      if(text MATCHES "unsupported [A-Za-z]+ version" OR NOT text MATCHES "error")
        return()
      endif()
    endif()
  endforeach()
endfunction()

# Those on PATH that bear a version in their name, as distributions call them; newest first, g++ before clang.
function(gw_other_host_compilers others)
  set(found)
  foreach(family IN ITEMS g++ clang++)
    foreach(age RANGE 20)
      math(EXPR version "30 - ${age}")
      find_program(GW_HOST_COMPILER_${family}_${version} ${family}-${version} NO_CACHE NO_DEFAULT_PATH PATHS ENV PATH)
      if(GW_HOST_COMPILER_${family}_${version})
        list(APPEND found ${GW_HOST_COMPILER_${family}_${version}})
      endif()
    endforeach()
  endforeach()
  set(${others} "${found}" PARENT_SCOPE)
endfunction()

# Programs are linked by the C++ compiler, and CMake hands it the folders where nvcc's host compiler looks for libraries.
# Where that is another compiler, its C++ library would be found before the one that the C++ files were compiled for.
function(gw_without_cxx_libraries list) # its name
  set(kept)
  foreach(folder IN LISTS ${list})
    file(GLOB found ${folder}/libstdc++.* ${folder}/libc++.*)
    if(NOT found)
      list(APPEND kept ${folder})
    endif()
  endforeach()
  set(${list} "${kept}" PARENT_SCOPE)
endfunction()

# One sentence about what nvcc said against a host compiler (empty: its own choice).
function(gw_refusal_of_nvcc release host said sentence)
  if(release STREQUAL "")
    set(${sentence} "nvcc does not start here: reinstall the CUDA toolkit and build again" PARENT_SCOPE)
    return()
  endif()
  set(command g++)
  if(host)
    set(command ${host})
  endif()
  get_filename_component(compiler ${command} NAME)
  execute_process(COMMAND ${command} -dumpfullversion -dumpversion OUTPUT_VARIABLE version ERROR_QUIET
    OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed)
  string(STRIP "${compiler} ${version}" compiler)

  if(said MATCHES "unsupported [A-Za-z]+ version")
    set(text "nvcc ${release} does not take ${compiler} for the host's part")
    set(remedy "and takes no other that is here: install an older g++ and build again")
    if(said MATCHES "gcc versions later than ([0-9]+) are not supported")
      set(remedy "and takes no other that is here: install g++-${CMAKE_MATCH_1} and build again")
    endif()
  else()
    string(REGEX MATCH "[^\n]*error:[^\n]*" line "${said}\n")
    if(line STREQUAL "")
      string(REGEX REPLACE "^[^\n]*\n" "" line "${said}")  # behind its exit status
      string(REGEX MATCH "[^\n]+" line "${line}")
    endif()
    string(REGEX REPLACE "^.*error: *" "" line "${line}")
    string(REPLACE "\"" "'" line "${line}")
    string(REGEX REPLACE "[;\\]" " " line "${line}")
    string(SUBSTRING "${line}" 0 200 line)
    set(text "nvcc ${release} cannot compile with ${compiler} (${line})")
    set(remedy "nor with any other that is here: install a newer CUDA toolkit or an older g++ and build again")
  endif()
  if(CMAKE_CUDA_HOST_COMPILER OR DEFINED ENV{CUDAHOSTCXX})
    set(remedy "which it was told to use: name another by CMAKE_CUDA_HOST_COMPILER or CUDAHOSTCXX")
  endif()
  set(${sentence} "${text}, ${remedy}" PARENT_SCOPE)
endfunction()
