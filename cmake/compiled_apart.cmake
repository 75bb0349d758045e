# The sanitised builds compile a library's files together (CMAKE_UNITY_BUILD); so does the stand-in for CUDA with
# its kernels. Files that use a name which another file of their library uses too, each for itself, or that define macros
# for a library's header, are compiled apart there. Every other build compiles each file by itself.
function(gw_compiled_apart target) # file.cpp...
  if(TARGET ${target})
    get_target_property(folder ${target} SOURCE_DIR)
    get_target_property(binaries ${target} BINARY_DIR)
    string(REGEX REPLACE "_(cpu|cuda)$" "" kernels ${target})  # where gw_add_kernels() writes what includes a .cu
    foreach(file IN LISTS ARGN)
      set_source_files_properties(
        ${folder}/${file} ${binaries}/${kernels}/cpu/${file}.cpp ${binaries}/${kernels}/cuda/${file}.cpp
        TARGET_DIRECTORY ${target} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endforeach()
  endif()
endfunction()

foreach(device IN ITEMS cpu cuda)
  gw_compiled_apart(gw_gpu_${device} neighbours/uniform_grid.cu)
  gw_compiled_apart(gw_sim_${device} draw/particle_list.cu)
endforeach()
gw_compiled_apart(gw_render egl_session.cpp gl_context.cpp particle_pass.cpp quad_pass.cpp ring_pass.cpp sprite_pass.cpp)
gw_compiled_apart(gw_replay replay_parts.cpp replay_writer.cpp)
gw_compiled_apart(gw_profile_report chart.cpp report_reader.cpp)
gw_compiled_apart(gw_profile runner.cpp session.cpp)

if(GW_CUDA_STAND_IN AND GW_GAME)
  set_target_properties(gw_gpu_cuda gw_sim_cuda PROPERTIES UNITY_BUILD ON)
endif()
