# Where packages put things; before the folders that install. Games and their manual have places of their own, and
# libraries lie below the architecture's name where the system has such folders.
set(CMAKE_INSTALL_BINDIR games CACHE PATH "Programs, below the prefix")
if(CMAKE_LIBRARY_ARCHITECTURE AND EXISTS /etc/debian_version)
  set(CMAKE_INSTALL_LIBDIR lib/${CMAKE_LIBRARY_ARCHITECTURE} CACHE PATH "Libraries, below the prefix")
endif()
