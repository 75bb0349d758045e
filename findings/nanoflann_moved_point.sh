#!/usr/bin/env bash
# nanoflann's dynamic index: a point that is removed, moved and added again is found twice, then three times, and so on;
# one point that moves takes all places of a search for the k nearest. 1.7.1 does the same, 1.12.1 does not.
#
# One would guess that removePoint(i) and addPoints(i, i) are the way to move a point, as removePoint() takes it out of all
# results. But the old entry stays in its tree and comes back to life with the new one. In a game the target that moves most
# hides all other targets from its hunters, sums over neighbours count it many times, and each step makes the index larger.
# Building the index of a step from nothing helps.
#
# Exit status: 0 as described, 1 it behaves otherwise now, 2 the packages cannot be had.
set -u
readonly version=1.4.3+ds-2
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
chmod 755 "$folder"
cd "$folder" || exit 2

{ apt-get download -q "libnanoflann-dev=$version" >/dev/null 2>&1 && dpkg-deb -x libnanoflann-dev_*.deb .; } || {
  echo "libnanoflann-dev $version cannot be had here." >&2
  exit 2
}
cat >move.cpp <<'CPP'
#include <nanoflann.hpp>
#include <cstdio>
#include <vector>
struct Points {
  std::vector<float> x;
  std::size_t kdtree_get_point_count() const { return x.size(); }
  float kdtree_get_pt(std::size_t i, std::size_t) const { return x[i]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const { return false; }
};
using Metric = nanoflann::L2_Simple_Adaptor<float, Points>;
using Index = nanoflann::KDTreeSingleIndexDynamicAdaptor<Metric, Points, 1>;
static void show(const Index& index, const char* when) {
  const float origin = 0;
  std::size_t found[3];
  float distance2[3];
  nanoflann::KNNResultSet<float> nearest(3);
  nearest.init(found, distance2);
  index.findNeighbors(nearest, &origin, {});
  std::printf("%s:", when);
  for (std::size_t i = 0; i < nearest.size(); ++i) std::printf(" %zu", found[i]);
  std::printf("\n");
}
int main() {
  Points points{{1, 2, 3, 4}};
  Index index(1, points);
  show(index, "at the start");
  index.removePoint(0);
  show(index, "point 0 removed");
  const char* const moved[] = {"moved and added", "moved once more"};
  for (const char* when : moved) {
    index.removePoint(0);
    points.x[0] -= 0.25f;
    index.addPoints(0, 0);
    show(index, when);
  }
}
CPP
g++ -std=c++17 -isystem usr/include move.cpp -o move || exit 2

seen="$(./move)" || exit 2
expected='at the start: 0 1 2
point 0 removed: 1 2 3
moved and added: 0 0 1
moved once more: 0 0 0'
echo "nanoflann $version, four points, the three nearest:"
echo "$seen"
[[ "$seen" == "$expected" ]]
