# The driver that the stand-in and the PTX machine share, compiled by each against its own headers of CUDA: what lies
# below it is device_seam.h's. gw_fake_cuda_driver holds the sources.
foreach(gw_source IN ITEMS driver.cpp gl_interop.cpp runtime.cpp streams.cpp)
  list(APPEND gw_fake_cuda_driver ${CMAKE_CURRENT_LIST_DIR}/${gw_source})
endforeach()
