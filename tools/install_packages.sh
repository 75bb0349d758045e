#!/usr/bin/env bash
# Installs what play or check needs on Debian and Ubuntu, and nothing when it is all there.
#   tools/install_packages.sh play|check
set -euo pipefail

# Compilers, the libraries of the game, Mesa for machines whose display or GPU has no driver of its own, and what makes
# PNG of the profile's pictures.
play_packages=(
  g++ cmake ninja-build ccache
  libsdl2-dev libglew-dev libopenal-dev libegl-dev libgl-dev
  libegl1 libegl-mesa0 libgl1-mesa-dri
  libcli11-dev nlohmann-json3-dev libtomlplusplus-dev libxxhash-dev zlib1g-dev libfmt-dev libstb-dev libimgui-dev
  libpugixml-dev libutfcpp-dev
  librsvg2-bin fonts-dejavu-core
)
# The test frameworks, a virtual display with keys and screenshots, the second compiler, the tools of the gates.
check_packages=(
  libgtest-dev librapidcheck-dev libnanoflann-dev libboost-context-dev
  xvfb xauth xdotool imagemagick
  clang libclang-rt-dev binutils python3 python3-jsonschema git util-linux
)
# Programs, and their packages, that show reports and encode films as players' do, that look at packages as Debian does, and
# that look at sources. clang-format and clang-tidy are of one version (tests/gates/llvm_tools.py), which newer systems lack.
# Ubuntu has Chromium only as a snap; what needs them is skipped and counted without them.
declare -A optional_packages=(
  [chromium]=chromium [ffmpeg]=ffmpeg
  [dpkg-shlibdeps]=dpkg-dev [file]=file [lintian]=lintian [desktop-file-validate]=desktop-file-utils
  [appstreamcli]=appstream [mandoc]=mandoc
  [clang-format-14]=clang-format-14 [clang-tidy-14]=clang-tidy-14 [doxygen]=doxygen
)

case "${1:-}" in
  play) wanted=("${play_packages[@]}") ;;
  check) wanted=("${play_packages[@]}" "${check_packages[@]}") ;;
  *)
    echo "usage: tools/install_packages.sh play|check" >&2
    exit 2
    ;;
esac

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "This is neither Debian nor Ubuntu, so nothing is installed. Needed, by their Debian names: ${wanted[*]}"
  exit 0
fi

# One query for all: it lists what is installed and fails for the rest, so its status says nothing.
installed=" $(dpkg-query -W -f '${db:Status-Abbrev}${Package} ' "${wanted[@]}" 2>/dev/null | sed 's/ii \+/ii/g' || true) "
missing=()
for package in "${wanted[@]}"; do
  [[ "$installed" == *" ii$package "* ]] || missing+=("$package")
done
optional=()
if [[ "$1" == check ]]; then
  for program in "${!optional_packages[@]}"; do
    command -v "$program" >/dev/null || optional+=("${optional_packages[$program]}")
  done
fi
if [[ ${#missing[@]} -eq 0 && ${#optional[@]} -eq 0 ]]; then
  exit 0
fi

as_root=()
if [[ "$(id -u)" -ne 0 ]]; then
  if ! command -v sudo >/dev/null; then
    if [[ ${#missing[@]} -eq 0 ]]; then
      exit 0
    fi
    echo "Missing packages and no sudo. As root, run: apt-get install ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300)

echo "Installing with apt${as_root:+ (through sudo)}: ${missing[*]} ${optional[*]}"
# A repository that does not answer need not hold what is missing: the installation below decides.
"${apt[@]}" update -q </dev/null || echo "apt-get update failed; trying with the lists that are there." >&2
for package in "${optional[@]}"; do
  "${apt[@]}" install -y -q --no-install-recommends "$package" </dev/null ||
    echo "apt could not install $package: tests that need it will be skipped." >&2
done
if [[ ${#missing[@]} -eq 0 ]]; then
  exit 0
fi
if ! "${apt[@]}" install -y -q --no-install-recommends "${missing[@]}" </dev/null; then
  echo "apt could not install: ${missing[*]}. Install them by hand and start again." >&2
  exit 1
fi
