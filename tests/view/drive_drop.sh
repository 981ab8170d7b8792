#!/bin/bash
# Files and folders dropped on the window, as a file manager drops them; folders on the command line. The third
# argument is the program that drops.
. "$(dirname "$0")/window_driver.sh"
drop=$3
[ -x "$drop" ] || { echo "skipped: $drop is not built"; exit 77; }
start_server 1280x800

# A model in one triangle.
model() {  # FILE
  mkdir -p "$(dirname "$1")"
  cat >"$1" <<'END'
{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3,"min":[0,0,0],"max":[1,1,0]}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}
END
}
model "$folder/a chair.gltf"
model "$folder/one/stool.gltf"
model "$folder/two/table.gltf"
model "$folder/two/bench.gltf"
model "$folder/given/shelf.gltf"
mkdir "$folder/empty"
printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n\200\200\200\201\200\200\200\201' >"$folder/grey.hdr"
drops() { "$drop" "$window" 640 400 "$@" || fail "the drop of $* is not taken"; }

start builtin:spheres --size 1280x800 --samples 1 --visibility none
await "frame drawn: builtin:spheres, builtin:studio$" 1
find_window
sleep 0.5
drops "$folder/a chair.gltf" # its name is not plain
await "frame drawn: .*a chair.gltf" 1
drops "$folder/grey.hdr"
await "environment: .*grey.hdr" 1
# A folder: its only model, whatever is being searched for; of several none.
xdotool key slash
xdotool type --delay 30 "sky"
sleep 0.3
drops "$folder/one"
await "frame drawn: .*stool.gltf" 1
drops "$folder/two"
await "/two: 2 models, 0 environments, 0 measured BRDFs" 1
drops "$folder/empty"
await "error: .*/empty: holds nothing that can be shown" 1
sleep 0.5
[ "$(count "frame drawn: .*\(table\|bench\).gltf")" = 0 ] || fail "a model of a folder of two is opened"
# Several at once: each is taken.
drops "$folder/a chair.gltf" "$folder/grey.hdr"
await "frame drawn: .*a chair.gltf, .*grey.hdr" 1
quit

# The same of a folder on the command line.
start "$folder/given" --size 640x480 --samples 1 --visibility none
await "frame drawn: .*shelf.gltf" 1
find_window
quit
start "$folder/two" --size 640x480 --samples 1 --visibility none
await "/two: 2 models" 1
await "frame drawn: builtin:poster" 1
find_window
quit
# Not beside a model that is named.
start "$folder/given" builtin:spheres --size 640x480 --samples 1 --visibility none
await "listed: given, 1" 1
await "frame drawn: builtin:spheres" 1
find_window
sleep 1
[ "$(count "frame drawn: .*shelf.gltf")" = 0 ] || fail "a folder's model is opened in the place of the one that is named"
quit
echo "passed"
