#!/usr/bin/env bash
# RapidCheck: of the 100 floats with which it tries a property, the later 50 are all whole numbers, most of them beyond the
# range of an int; NaN and the infinities never come. The same with the RapidCheck of Debian 13 and 14.
#
# One would guess that growing sizes bring a mixture, small and large numbers with fractions to the end, and now and then
# the special ones. But a float is a random 64 bit integer of the case's size plus a fraction that a large sum rounds away.
# A property of positions, angles or speeds is tried on fractions in fewer than 4 of 10 cases, however many there are. It
# helps to draw an integer with rc::gen::inRange() and to scale it, and to name special values with rc::gen::element().
#
# Exit status: 0 as described, 1 it behaves otherwise now, 2 the packages cannot be had.
set -u
readonly version=0~1033-08b5058-3
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
chmod 755 "$folder"
cd "$folder" || exit 2

{ apt-get download -q "librapidcheck-dev=$version" >/dev/null 2>&1 && dpkg-deb -x librapidcheck-dev_*.deb .; } || {
  echo "librapidcheck-dev $version cannot be had here." >&2
  exit 2
}
cat >floats.cpp <<'CPP'
#include <rapidcheck.h>
#include <cmath>
#include <cstdio>
int main() {
  int cases = 0, fraction[2] = {}, beyond[2] = {}, special = 0;
  rc::check("any float", [&](float x) {
    const int half = cases++ / 50;
    fraction[half] += x != std::trunc(x);
    beyond[half] += std::fabs(x) > 2147483648.0f;
    special += !std::isfinite(x);
  });
  for (int half = 0; half < 2; ++half)
    std::printf("cases %d to %d: %d with a fraction, %d beyond an int\n", 50 * half + 1, 50 * half + 50, fraction[half],
                beyond[half]);
  std::printf("NaN or infinite: %d of %d\n", special, cases);
}
CPP
g++ -std=c++17 -isystem usr/include floats.cpp usr/lib/*/librapidcheck.a -o floats || exit 2

seen="$(RC_PARAMS='seed=1' ./floats 2>/dev/null)"
expected='cases 1 to 50: 37 with a fraction, 0 beyond an int
cases 51 to 100: 0 with a fraction, 49 beyond an int
NaN or infinite: 0 of 100'
echo "RapidCheck $version, a property of one float, 100 cases:"
echo "$seen"
[[ "$seen" == "$expected" ]]
