# What desktops and shells read: man pages and completion (made from the table of options), menu entry, metainfo, icons.
set(gw_documents ${PROJECT_BINARY_DIR}/documents)

# Version and date stand in the changelog, whose date is also that of everything in the packages.
set(changelog ${PROJECT_SOURCE_DIR}/cmake/packages/debian/changelog.in)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${changelog})
file(STRINGS ${changelog} first LIMIT_COUNT 1)
if(NOT first MATCHES "^gpuwars \\(${PROJECT_VERSION}\\) ")
  message(FATAL_ERROR "cmake/packages/debian/changelog.in begins with '${first}': add an entry for ${PROJECT_VERSION}, the project's version.")
endif()
file(STRINGS ${changelog} signed REGEX "^ -- " LIMIT_COUNT 1)
string(REGEX REPLACE "^.*[>@]  " "" signed "${signed}")
execute_process(COMMAND date --utc --date=${signed} "+%s;%Y-%m-%d" OUTPUT_VARIABLE dates
  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
list(GET dates 0 GW_PACKAGE_EPOCH)
list(GET dates 1 GW_PACKAGE_DATE)

add_custom_command(OUTPUT ${gw_documents}/stamp
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${gw_documents}
  COMMAND gw_write_manual ${gw_documents} ${PROJECT_VERSION} ${GW_PACKAGE_DATE}
  COMMAND ${CMAKE_COMMAND} -E touch ${gw_documents}/stamp
  DEPENDS gw_write_manual ${changelog} VERBATIM)
add_custom_target(gw_documents ALL DEPENDS ${gw_documents}/stamp)
install(DIRECTORY ${gw_documents}/man6 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT game)
install(FILES ${gw_documents}/completions/gpuwars DESTINATION share/bash-completion/completions COMPONENT game)

set(desktop ${CMAKE_CURRENT_LIST_DIR}/desktop)
configure_file(${desktop}/org.gpuwars.gpuwars.metainfo.xml.in ${PROJECT_BINARY_DIR}/package/org.gpuwars.gpuwars.metainfo.xml @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/package/org.gpuwars.gpuwars.metainfo.xml DESTINATION share/metainfo COMPONENT game)
install(FILES ${desktop}/gpuwars.desktop DESTINATION share/applications COMPONENT game)
install(DIRECTORY ${desktop}/icons/hicolor DESTINATION share/icons COMPONENT game)
