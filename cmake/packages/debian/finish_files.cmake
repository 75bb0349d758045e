# Run by cpack on the files of the packages: manual and changelog are compressed, and what of an object file neither the
# linker nor a debugger needs is taken out, as Debian's own tools do it. Equal input gives equal bytes.
cmake_minimum_required(VERSION 3.22)

function(gw_on_each pattern) # command...
  file(GLOB_RECURSE files LIST_DIRECTORIES OFF ${CPACK_TEMPORARY_DIRECTORY}/*)
  list(FILTER files INCLUDE REGEX "${pattern}")
  foreach(file IN LISTS files)
    execute_process(COMMAND ${ARGN} ${file} COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
endfunction()

gw_on_each("/share/(man/man6/[^/]*\\.6|doc/[^/]*/changelog)$" gzip -9 --no-name --force)
set(needless --remove-section=.comment --remove-section=.note)
gw_on_each("\\.a$" strip --strip-debug --enable-deterministic-archives ${needless})
gw_on_each("(/(games|bin)/[^/]*|\\.so)$" strip ${needless})

# CMake makes folders with the permissions that the umask leaves.
file(CHMOD_RECURSE ${CPACK_TEMPORARY_DIRECTORY} DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
