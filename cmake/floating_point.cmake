# The flags that keep the bits equal on every device, in one interface target that everything links, users of
# the installed library included. No -ffast-math, no -Ofast, no contraction: see docs/design/determinism.md.
add_library(gw_gpu_flags INTERFACE)
target_include_directories(gw_gpu_flags INTERFACE
  $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include> $<INSTALL_INTERFACE:include>) # <gpuwars/...>, see gpu/CMakeLists.txt
target_link_libraries(gw_gpu_flags INTERFACE Threads::Threads)
target_compile_features(gw_gpu_flags INTERFACE cxx_std_20)

set(gw_exact_flags -ffp-contract=off -fno-math-errno)
list(JOIN gw_exact_flags "," gw_exact_csv)
set(gw_sanitize_flags "")
if(GW_SANITIZE)
  # Who links a sanitised library is sanitised too.
  set(gw_sanitize_flags -fsanitize=${GW_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(gw_gpu_flags INTERFACE "$<$<LINK_LANGUAGE:CXX>:-fsanitize=${GW_SANITIZE}>")
endif()
target_compile_options(gw_gpu_flags INTERFACE
  "$<$<COMPILE_LANGUAGE:CXX>:${gw_exact_flags};${gw_sanitize_flags}>"
  "$<$<COMPILE_LANGUAGE:CUDA>:--fmad=false;--ftz=false;--prec-div=true;--prec-sqrt=true;-Xcompiler=${gw_exact_csv}>")

# What this build adds for itself. A newer compiler may warn about what ours does not: warnings are for builds with
# tests, and errors where continuous integration knows the compiler.
option(GW_WARNINGS_AS_ERRORS "Stop at warnings (.ci/run does)" OFF)
add_library(gw_options INTERFACE)
target_link_libraries(gw_options INTERFACE gw_gpu_flags)
target_include_directories(gw_options INTERFACE ${PROJECT_SOURCE_DIR})
set(gw_own_flags "")
if(GW_TESTS)
  list(APPEND gw_own_flags -Wall -Wextra)
  if(GW_WARNINGS_AS_ERRORS)
    list(APPEND gw_own_flags -Werror)
  endif()
  # gcc 12 and later see overlapping copies in "text" + std::string (gcc bug 105651)...
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    list(APPEND gw_own_flags -Wno-restrict)
    # ...and unset variables in their own AVX-512 headers.
    if(GW_NATIVE)
      list(APPEND gw_own_flags -Wno-uninitialized -Wno-maybe-uninitialized)
    endif()
  endif()
endif()
if(GW_NATIVE)
  list(APPEND gw_own_flags -march=native)
endif()
if(gw_own_flags)
  set(gw_host_flags ${gw_own_flags})
  if(GW_CUDA_HOST MATCHES "clang")
    list(REMOVE_ITEM gw_host_flags -Wno-restrict -Wno-maybe-uninitialized)  # which it does not know
  endif()
  list(JOIN gw_host_flags "," gw_own_csv)
  target_compile_options(gw_options INTERFACE
    "$<$<COMPILE_LANGUAGE:CXX>:${gw_own_flags}>" "$<$<COMPILE_LANGUAGE:CUDA>:-Xcompiler=${gw_own_csv}>")
endif()
if(NOT PROJECT_IS_TOP_LEVEL)
  # The flags of the project around this one may be strict, and these sources are not its own.
  target_compile_options(gw_options INTERFACE -w)
endif()
if(GW_SANITIZE)
  # Sanitised code is instrumented before gcc looks for unset variables, which it then sees everywhere:
  # warnings are for the other builds.
  target_compile_options(gw_options INTERFACE "$<$<COMPILE_LANGUAGE:CXX>:-w>")
endif()

include(static_pack)
