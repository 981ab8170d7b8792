#!/bin/bash
# The viewer for long: models and environments switched again and again, a file that changes again and again, a monitor
# that changes. drive_endurance.sh FACET SHADERS DROP [SWITCHES [CHANGES]]; with a fifth argument memory goes there, a
# line a switch: number, kilobytes.
. "$(dirname "$0")/window_driver.sh"
drop=$3 switches=${4:-30} changes=${5:-20} table=${6:-/dev/null}
[ "$switches" -ge 3 ] && [ "$changes" -ge 1 ] || fail "not counts: $switches switches, $changes changes"
[ -x "$drop" ] || { echo "skipped: $drop is not built"; exit 77; }
start_server 1280x800

model() {  # FILE HEIGHT of a triangle
  cat >"$1.new" <<END
{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"scale":[1,$2,1]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3,"min":[0,0,0],"max":[1,1,0]}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}
END
  mv "$1.new" "$1"
}
memory() { awk '/^RssAnon/ {print $2}' /proc/$viewer/status; }
descriptors() { ls /proc/$viewer/fd | wc -l; }

for i in 0 1 2; do model "$folder/model$i.gltf" "$((i + 1))"; done
for i in 0 1; do printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n\200\200\200\201\200\20%d\200\201' $i >"$folder/grey$i.hdr"; done

start "$folder/model0.gltf" --size 320x240 --samples 1 --visibility none --env builtin:studio
await "frame drawn: .*model0.gltf" 1
find_window
sleep 0.5
first=0 files=0
for i in $(seq "$switches"); do
  name=model$((i % 3)).gltf light=grey$((i % 2)).hdr
  frames=$(count "frame drawn: .*$name, .*$light")
  "$drop" "$window" 160 120 "$folder/$name" "$folder/$light" >/dev/null || fail "the drop of $name is not taken"
  await "frame drawn: .*$name, .*$light" $((frames + 1))
  echo "$i $(memory)" >>"$table"
  if [ "$i" = $((switches / 3)) ]; then first=$(memory) files=$(descriptors); fi
done
last=$(memory)
[ "$last" -lt $((first + 16384)) ] || fail "$switches switches: $first kB after a third, $last kB at the end"
[ "$(descriptors)" -le $((files + 2)) ] || fail "$switches switches: $files files were open, now $(descriptors)"

# A file that is written anew; the last state is what is shown.
name=model$((switches % 3)).gltf first=$(memory)
for i in $(seq "$changes"); do
  frames=$(count "frame drawn: .*$name")
  model "$folder/$name" "$((1 + i % 5))"
  await "frame drawn: .*$name" $((frames + 1))
done
last=$(memory)
[ "$last" -lt $((first + 16384)) ] || fail "$changes changes of a file: $first kB before, $last kB at the end"

# Another resolution of the monitor, and back, where the server can do that.
if command -v xrandr >/dev/null && xrandr 2>/dev/null | grep -q 800x600; then
  xrandr -s 800x600 >/dev/null 2>&1 && sleep 0.3 && xrandr -s 1280x800 >/dev/null 2>&1
  kill -0 $viewer 2>/dev/null || fail "a change of the monitor ends the viewer"
fi
quit
echo "passed"
