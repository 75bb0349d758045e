# What this project cannot be built with: a compiler that is too old, a machine or flags with other arithmetic. Each is
# refused by one sentence with a remedy. What arithmetic has to do with it: docs/design/determinism.md.

# The sentence against a compiler; empty: it is fine. Versions are what C++20 as we use it was tried with.
function(gw_refusal_of_compiler id version refusal)
  set(least_GNU 11)
  set(least_Clang 14)
  set(name_GNU g++)
  set(name_Clang clang)
  set(${refusal} "" PARENT_SCOPE)
  if(DEFINED least_${id} AND version VERSION_LESS least_${id})
    set(${refusal} "GpuWars needs g++ ${least_GNU} or clang ${least_Clang} or newer for C++20, and this is ${name_${id}} \
${version}: install a newer package g++ or clang, and name its compiler by -DCMAKE_CXX_COMPILER" PARENT_SCOPE)
  endif()
endfunction()

# The sentence against a target with these macros predefined; empty: it is fine.
function(gw_refusal_of_machine macros refusal)
  set(right "GpuWars computes the same bits on 64-bit x86-64 and AArch64 only, and this compiler's target is")
  set(remedy "use a compiler for a 64-bit target, and leave -m32 and the like out of its flags")
  set(sentence "")
  if(macros MATCHES "__i386__ ")
    set(sentence "${right} 32-bit x86, whose x87 arithmetic rounds otherwise: ${remedy}")
  elseif(NOT macros MATCHES "__(x86_64|aarch64)__ ")
    set(sentence "${right} ${CMAKE_SYSTEM_PROCESSOR}: ${remedy}")
  elseif(NOT macros MATCHES "__SIZEOF_POINTER__ 8")
    set(sentence "${right} one with 32-bit pointers: ${remedy}")
  elseif(macros MATCHES "__FLT_EVAL_METHOD__ [12]")
    set(sentence "GpuWars computes floats as floats, and this compiler takes the x87 unit, which rounds otherwise: \
leave -mfpmath out of its flags")
  endif()
  set(${refusal} "${sentence}" PARENT_SCOPE)
endfunction()

# The sentence against flags, whose variable it names; empty: they are fine. What -ffast-math consists of is refused
# piece by piece, unless our own flags, which stand behind, take it back.
function(gw_refusal_of_flags variable flags refusal)
  set(pieces -Ofast -ffast-math -funsafe-math-optimizations -fassociative-math -freciprocal-math -ffinite-math-only
    -fno-signed-zeros -fsingle-precision-constant -mrecip -mdaz-ftz -use_fast_math)
  set(${refusal} "" PARENT_SCOPE)
  foreach(piece IN LISTS pieces)
    if(" ${flags} " MATCHES "[ ,;=\"'-](${piece})[ ,;=\"']")
      set(${refusal} "GpuWars computes the same bits everywhere, which ${CMAKE_MATCH_1} in ${variable} does not: \
leave it out" PARENT_SCOPE)
      return()
    endif()
  endforeach()
endfunction()

# Everything that flags come from: variables for each configuration, and what a project around this one adds.
function(gw_check_flags)
  foreach(language IN ITEMS C CXX CUDA)
    foreach(configuration IN ITEMS "" DEBUG RELEASE RELWITHDEBINFO MINSIZEREL ${CMAKE_BUILD_TYPE} ${CMAKE_CONFIGURATION_TYPES})
      string(TOUPPER "CMAKE_${language}_FLAGS_${configuration}" variable)
      string(REGEX REPLACE "_$" "" variable "${variable}")
      gw_stop_if_refused_flags(${variable} "${${variable}}")
    endforeach()
  endforeach()
  foreach(kind IN ITEMS EXE SHARED MODULE)  # linked with -ffast-math, a program flushes small numbers to zero
    gw_stop_if_refused_flags(CMAKE_${kind}_LINKER_FLAGS "${CMAKE_${kind}_LINKER_FLAGS}")
  endforeach()
  get_directory_property(options COMPILE_OPTIONS)
  gw_stop_if_refused_flags("compile options" "${options}")
endfunction()

function(gw_stop_if_refused_flags variable flags)
  gw_refusal_of_flags("${variable}" "${flags}" refusal)
  if(refusal)
    message(FATAL_ERROR "${refusal}.")
  endif()
endfunction()

function(gw_check_requirements)
  gw_refusal_of_compiler("${CMAKE_CXX_COMPILER_ID}" "${CMAKE_CXX_COMPILER_VERSION}" refusal)
  if(refusal)
    message(FATAL_ERROR "${refusal}.")
  endif()
  gw_check_flags()
  string(TOUPPER "CMAKE_CXX_FLAGS_${CMAKE_BUILD_TYPE}" of_build)
  separate_arguments(flags UNIX_COMMAND "${CMAKE_CXX_FLAGS} ${${of_build}}")
  if(CMAKE_CXX_COMPILER_TARGET)
    list(APPEND flags ${CMAKE_CXX_COMPILE_OPTIONS_TARGET}${CMAKE_CXX_COMPILER_TARGET})
  endif()
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} ${CMAKE_CXX_COMPILER_ARG1} ${flags} -dM -E -x c++ /dev/null
    OUTPUT_VARIABLE macros RESULT_VARIABLE failed ERROR_VARIABLE said)
  if(NOT failed STREQUAL "0")
    message(FATAL_ERROR "${CMAKE_CXX_COMPILER} does not take its flags (${said}): correct CMAKE_CXX_FLAGS.")
  endif()
  gw_refusal_of_machine("${macros}" refusal)
  if(refusal)
    message(FATAL_ERROR "${refusal}.")
  endif()
endfunction()
