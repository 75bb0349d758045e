# A text file in a program: gw_embed_text(TARGET FILE NAME) makes the header NAME.h, which TARGET includes, with the text
# of FILE as the string gw::NAME. As a script this file writes that header.
if(CMAKE_SCRIPT_MODE_FILE)
  file(READ "${IN}" text)
  file(WRITE "${OUT}" "// Made from a text file by cmake/embed_text.cmake.\n#pragma once\n\n#include <string_view>\n\n\
namespace gw {\n\ninline constexpr std::string_view ${NAME} = R\"gw_text(${text})gw_text\";\n\n}  // namespace gw\n")
  return()
endif()

function(gw_embed_text target file name)
  cmake_path(ABSOLUTE_PATH file)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/embedded)
  add_custom_command(OUTPUT ${folder}/${name}.h
    COMMAND ${CMAKE_COMMAND} -DIN=${file} -DOUT=${folder}/${name}.h -DNAME=${name} -P ${PROJECT_SOURCE_DIR}/cmake/embed_text.cmake
    DEPENDS ${file} ${PROJECT_SOURCE_DIR}/cmake/embed_text.cmake
    VERBATIM)
  target_sources(${target} PRIVATE ${folder}/${name}.h)
  target_include_directories(${target} PRIVATE ${folder})
endfunction()
