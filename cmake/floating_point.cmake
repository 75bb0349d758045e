# The flags that keep the bits equal on every device, in one interface target that everything links.
# No -ffast-math, no -Ofast, no contraction: see docs/determinism.md.
add_library(gw_options INTERFACE)
target_include_directories(gw_options INTERFACE ${PROJECT_SOURCE_DIR})
target_link_libraries(gw_options INTERFACE Threads::Threads)

set(gw_host_flags -ffp-contract=off -fno-math-errno)
# A player's newer compiler may warn about what ours does not: warnings, and stopping at them, are for
# builds with tests.
if(GW_TESTS)
  list(APPEND gw_host_flags -Wall -Wextra -Werror)
  # gcc 12 and later see overlapping copies in "text" + std::string (gcc bug 105651)...
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    list(APPEND gw_host_flags -Wno-restrict)
    # ...and unset variables in their own AVX-512 headers.
    if(GW_NATIVE)
      list(APPEND gw_host_flags -Wno-uninitialized -Wno-maybe-uninitialized)
    endif()
  endif()
endif()
if(GW_NATIVE)
  list(APPEND gw_host_flags -march=native)
endif()
set(gw_sanitize_flags "")
if(GW_SANITIZE)
  # Sanitised code is instrumented before gcc looks for unset variables, which it then sees everywhere:
  # warnings are for the other builds.
  set(gw_sanitize_flags -w -fsanitize=${GW_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(gw_options INTERFACE "$<$<LINK_LANGUAGE:CXX>:-fsanitize=${GW_SANITIZE}>")
endif()
list(JOIN gw_host_flags "," gw_host_csv)
target_compile_options(gw_options INTERFACE
  "$<$<COMPILE_LANGUAGE:CXX>:${gw_host_flags};${gw_sanitize_flags}>"
  "$<$<COMPILE_LANGUAGE:CUDA>:--fmad=false;--ftz=false;--prec-div=true;--prec-sqrt=true;-Xcompiler=${gw_host_csv}>")

include(static_pack)
