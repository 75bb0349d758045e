#!/usr/bin/env bash
# CLI11: a positional argument "[run].txt" arrives as it is, but "[run]" arrives as "run", and "[a,b]" as two arguments.
#
# One would guess that an option of type std::vector<std::string> holds what the shell passed, word for word. CLI11 reads
# brackets as the notation of a list, whatever the option is for, and nothing turns that off: a program that takes files
# opens another file than the one named, without a word. Who takes files must take them past CLI11's own conversion.
#
# Exit status: 0 as described, 1 it behaves otherwise now, 2 the packages cannot be had.
set -u
readonly version=2.1.2+ds-1
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 2

apt-get download -q "libcli11-dev=$version" >/dev/null 2>&1 && dpkg-deb -x libcli11-dev_*.deb . || {
  echo "libcli11-dev $version cannot be had here." >&2
  exit 2
}
cat >files.cpp <<'CPP'
#include <CLI/CLI.hpp>
#include <iostream>
int main(int argc, char** argv) {
  CLI::App app;
  std::vector<std::string> files;
  app.add_option("files", files);
  CLI11_PARSE(app, argc, argv);
  for (const std::string& file : files) std::cout << '<' << file << '>';
  std::cout << '\n';
}
CPP
g++ -std=c++17 -isystem usr/include files.cpp -o files || exit 2

seen="$(./files '[run].txt'; ./files '[run]'; ./files '[a,b]')"
expected='<[run].txt>
<run>
<a><b>'
echo "CLI11 $version, given [run].txt, then [run], then [a,b]:"
echo "$seen"
[[ "$seen" == "$expected" ]]
