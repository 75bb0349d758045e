# Cross-compiles for AArch64 on Debian, with the libraries of the architecture arm64 beside the machine's own:
#   dpkg --add-architecture arm64 && apt-get install g++-aarch64-linux-gnu libglew-dev:arm64 ...
# tests/distributions aarch64 does all of it, and runs the program under qemu-user.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_FIND_ROOT_PATH /usr/aarch64-linux-gnu /)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER) # programs run here
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64)
