#!/usr/bin/env bash
# CMake, CUDA and two versions of g++: when nvcc is given an older g++ for its host part (CUDAHOSTCXX), CMake puts that
# compiler's own library folder on the link line of programs that the newer g++ links, before the linker's own places.
#
# One would guess that a program linked by g++ 12 gets g++ 12's C++ library, since nvcc's host compiler compiles the .cu
# files only. But the older libstdc++ is found first. On Debian 14 (g++ 16, nvcc 13.0 with g++-15, CMake 4.3) programs whose
# C++ files wait on a std::atomic do not link: "undefined reference to std::__detail::__wait_impl". Taking the folders with a
# libstdc++ out of CMAKE_CUDA_IMPLICIT_LINK_DIRECTORIES helps.
#
# Needs nvcc, 12 or newer (CUDACXX, or on PATH, or in /usr/local/cuda).
# Exit status: 0 as described, 1 it behaves otherwise now, 2 the packages cannot be had.
set -u
readonly cmake=3.25.1-1 host=11.3.0-12
nvcc="${CUDACXX:-$(command -v nvcc || echo /usr/local/cuda/bin/nvcc)}"
[[ -x "$nvcc" ]] || { echo "nvcc is not installed." >&2; exit 2; }
[[ "$(dpkg-query -W -f '${Version}' cmake 2>/dev/null)" == "$cmake" ]] || { echo "cmake $cmake is not installed." >&2; exit 2; }
[[ "$(g++ -dumpversion 2>/dev/null)" == 12 ]] || { echo "g++ 12 is not installed." >&2; exit 2; }
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
chmod 755 "$folder"
cd "$folder" || exit 2

for package in g++-11 gcc-11 cpp-11 libstdc++-11-dev libgcc-11-dev; do
  apt-get download -q "$package=$host" >/dev/null 2>&1 && dpkg-deb -x "$package"_*.deb . || {
    echo "$package $host cannot be had here." >&2
    exit 2
  }
done
cat >CMakeLists.txt <<'CMAKE'
cmake_minimum_required(VERSION 3.22)
project(mixed LANGUAGES CXX CUDA)
add_executable(mixed main.cpp kernel.cu)
CMAKE
echo 'int main() {}' >main.cpp
echo '__global__ void kernel() {}' >kernel.cu
CXX=g++ CUDACXX="$nvcc" CUDAHOSTCXX="$folder/usr/bin/g++-11" cmake -G "Unix Makefiles" -S . -B build >log 2>&1 || {
  tail -n 5 log >&2
  exit 2
}
line="$(cat build/CMakeFiles/mixed.dir/link.txt)"
linker="${line%% *}"
older=no
[[ "$line" == *"-L$folder/usr/lib/gcc/x86_64-linux-gnu/11"* ]] && older=yes
echo "CMake $cmake, C++ by g++ 12, nvcc's host part by g++ 11:"
echo "linked by ${linker##*/}, the library folder of g++ 11 is on its line: $older"
[[ "${linker##*/}" == g++ && $older == yes ]]
