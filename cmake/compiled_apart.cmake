# The sanitised builds compile a library's files together (CMAKE_UNITY_BUILD), in a third of the time. Files that use a name
# which another file of their library uses too, each for itself, or that define macros for a library's header, are compiled
# apart there. Every other build compiles each file by itself.
function(gw_compiled_apart target) # file.cpp...
  if(TARGET ${target})
    get_target_property(folder ${target} SOURCE_DIR)
    get_target_property(binaries ${target} BINARY_DIR)
    string(REGEX REPLACE "_cpu$" "" kernels ${target})  # where gw_add_kernels() writes what includes a .cu
    foreach(file IN LISTS ARGN)
      set_source_files_properties(${folder}/${file} ${binaries}/${kernels}/cpu/${file}.cpp TARGET_DIRECTORY ${target}
        PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endforeach()
  endif()
endfunction()

gw_compiled_apart(gw_gpu_cpu uniform_grid.cu)
gw_compiled_apart(gw_render egl_session.cpp gl_context.cpp particle_pass.cpp quad_pass.cpp ring_pass.cpp sprite_pass.cpp)
gw_compiled_apart(gw_sim_cpu particle_list.cu)
gw_compiled_apart(gw_replay replay_parts.cpp replay_writer.cpp)
gw_compiled_apart(gw_profile_report chart.cpp report_reader.cpp)
gw_compiled_apart(gw_profile runner.cpp session.cpp)
