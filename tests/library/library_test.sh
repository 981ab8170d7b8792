#!/usr/bin/env bash
# library_test.sh BUILD: what is installed is enough for programs in C and C++ and for Python; their pictures are those
# of the command, what is wrong is a sentence, and the library shows nothing but facet_*.
set -euo pipefail
build=$1
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
sources=$here/../../src/library
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
fail() { echo "$*" >&2; exit 1; }
cmake --install "$build" --prefix "$folder/installed" >install.log 2>&1 || fail "$(cat install.log)"
facet=$folder/installed/bin/facet
export PKG_CONFIG_PATH=$(dirname "$(find installed -name facet.pc)") LD_LIBRARY_PATH=$(dirname "$(find "$folder/installed" -name libfacet.so)")
library=$LD_LIBRARY_PATH/libfacet.so

[[ $(nm -D --defined-only "$library" | awk '{print $3}' | sed 's/@.*//' | LC_ALL=C sort | paste -sd' ') == \
  $(grep -o 'facet_[a-z_]*(' "$sources/facet.h" | tr -d '(' | LC_ALL=C sort -u | paste -sd' ') ]] ||
  fail "what it exports is not what facet.h declares: $(nm -D --defined-only "$library")"
! ldd "$library" | grep -E 'not found|glfw|libX11' || fail "it needs more than it should"
[[ $(pkg-config --modversion facet) == "$("$facet" --version | sed 's/facet \([^,]*\),.*/\1/')" ]] || fail "versions differ"

(($(grep -cv '^ *$' "$sources/example.c") <= 32)) || fail "the example has grown"
read -ra flags <<<"$(pkg-config --cflags --libs facet)"
cc -std=c11 -Wall -Wextra -Wpedantic -Werror "$sources/example.c" "${flags[@]}" -o example
c++ -std=c++17 -Wall -Wextra -Wpedantic -Werror "$here/example.cpp" "${flags[@]}" -o example_cpp

options=(--size 64x48 --orbit 30,70 --env builtin:studio --samples 2 --background '#336699')
status=0
"$facet" render builtin:spheres --log-level warning -o picture.png "${options[@]}" || status=$?
((status != 3)) || exit 77
((status == 0)) || fail "the command draws nothing"
"$facet" render builtin:spheres --log-level warning -o picture.exr "${options[@]}"
words=()
for word in "${options[@]}"; do words+=("${word#--}"); done
./example builtin:spheres c.pam "${words[@]}"
./example_cpp builtin:spheres cpp.pam "${words[@]}"
cmp c.pam cpp.pam

# wrong STATUS SENTENCE COMMAND...
wrong() {
  local said code=0
  said=$("${@:3}" 2>&1) || code=$?
  [[ $code == "$1" && $said == *"$2"* ]] || fail "${*:3}: wanted $1 <$2>, found $code <$said>"
}
for program in ./example ./example_cpp; do
  wrong 2 "no.glb: no such file" "$program" no.glb x.pam
  wrong 2 "'sizes': there is no such option; perhaps size is meant." "$program" builtin:spheres x.pam sizes 1x1
  wrong 2 "--samples: 0 is out of range; give" "$program" builtin:spheres x.pam samples 0
  wrong 2 "--time: nothing moves without an animation" "$program" builtin:spheres x.pam time 1
  wrong 3 "no headless context could be made" env __EGL_VENDOR_LIBRARY_FILENAMES=/nothing.json "$program" builtin:spheres x.pam
done
[[ ! -e x.pam ]] || fail "a picture in spite of errors"

python=$(command -v /usr/bin/python3 || command -v python3) || exit 0
export PYTHONPATH=$folder/installed/lib/python3/dist-packages PYTHONDONTWRITEBYTECODE=1
"$python" "$here/library_test.py" c.pam picture.exr
