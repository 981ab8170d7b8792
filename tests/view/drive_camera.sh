#!/bin/bash
# What the hand does to the camera: wheel, clicks, drags, projection, text; and that the copied command has it all.
. "$(dirname "$0")/window_driver.sh"
start_server 1280x800
command -v python3 >/dev/null || { echo "skipped: python3 is not installed"; exit 77; }

# The numbers of an option of the camera that Ctrl+Shift+C copies.
copied() {
  before=$(count "copied: ")
  xdotool key ctrl+shift+c
  await "copied: " $((before + 1))
  camera=$(sed -n 's/.*copied: //p' log | tail -1)
}
option() { echo " $camera" | sed -n "s/.* --$1 \([^ ]*\).*/\1/p"; }
holds() { python3 -c "import math, sys; sys.exit(0 if ($1) else 1)" || fail "$2: $1 of $camera"; }

# A panel of 4 m x 3 m at z = 0 whose corners are known, before a darker one far behind it.
cat >panels.gltf <<'END'
{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],
"nodes":[{"mesh":0,"scale":[4,3,1]},{"mesh":0,"scale":[9,9,1],"translation":[-0.2,0.3,-6]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":5,"material":0}]}],
"materials":[{"doubleSided":true,"pbrMetallicRoughness":{"roughnessFactor":0.6}}],
"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":4,"min":[-0.5,-0.5,0],"max":[0.5,0.5,0]}],
"bufferViews":[{"buffer":0,"byteLength":48}],
"buffers":[{"byteLength":48,"uri":"data:application/octet-stream;base64,AAAAvwAAAL8AAAAAAAAAPwAAAL8AAAAAAAAAvwAAAD8AAAAAAAAAPwAAAD8AAAAA"}]}
END
start panels.gltf --size 1000x700 --samples 1 --visibility none --orbit 0,90,10 --target 0,0,0 --fov-y 40
await "frame drawn: panels.gltf" 1
find_window
sleep 0.5
xdotool key h # no panels over the picture
sleep 0.5

# The wheel: what is below the pointer stays there. At 700, 200 that is 2 x 10 tan 20 / 700 metres a pixel.
xdotool mousemove --window "$window" 700 200 click 4 click 4
sleep 1
copied
radius=$(option orbit | cut -d, -f3) target=$(option target)
holds "abs($radius - 8.1) < 1e-9" "two steps of the wheel"
holds "max(abs(a - b) for a, b in zip(($target), (200 * 20 * math.tan(math.radians(20)) / 700 * 0.19, 150 * 20 * math.tan(math.radians(20)) / 700 * 0.19, 0))) < 1e-9" "the wheel at the pointer"
# A double click makes what is there the target: a point of the panel, which then is in the middle.
xdotool mousemove --window "$window" 400 420 click --repeat 2 --delay 60 1
sleep 1.5
copied
target=$(option target)
holds "abs(($target)[2]) < 1e-9 and abs(($target)[0] - (200 * 20 * 0.19 - 100 * 16.2) * math.tan(math.radians(20)) / 700) < 0.02" "a double click"
xdotool mousemove --window "$window" 500 350 click --repeat 2 --delay 60 1
sleep 1.5
was=$target
copied
holds "max(abs(a - b) for a, b in zip(($was), ($(option target)))) < 0.02" "the middle is the target"
# Two clicks that are far apart in time are no double click.
xdotool mousemove --window "$window" 420 300 click 1
sleep 1.5
xdotool click 1
sleep 1
was=$(option target)
copied
[ "$(option target)" = "$was" ] || fail "two slow clicks move the target: $camera"

# Ctrl and a drag from the right to above the middle: a quarter turn, counterclockwise.
xdotool mousemove --window "$window" 800 350 keydown ctrl mousedown 1
for to in "750 200" "600 100" "500 50"; do sleep 0.1; xdotool mousemove --window "$window" $to; done
sleep 0.3
xdotool mouseup 1 keyup ctrl
sleep 1
copied
holds "abs($(option roll) - 90) < 1" "a roll"
# Orthographic, and back to nothing but that: the text of the camera is pasted. The command has all of it.
xdotool key 5
sleep 1
copied
[ "$(option projection)" = orthographic ] || fail "5 is not orthographic: $camera"
kept=$camera
screenshot orthographic
xdotool key ctrl+c
await "copied: facet render panels.gltf" 1
command=$(sed -n 's/.*copied: facet //p' log | tail -1)
cp orthographic.png window.png
eval "\"$facet\" $command" >/dev/null 2>&1 || fail "the copied command fails: $command"
cmp window.png picture.png || fail "the copied command has other bytes: $command"
xdotool key 5 7
sleep 1
screenshot above
differ orthographic above
copied
[ -z "$(option roll)" ] || fail "the view from above is rolled: $camera"
xdotool key r ctrl+c
sleep 1
# What was copied last is the command at the start: its camera is taken, and nothing else.
xdotool key 5 7 ctrl+v
await "pasted: " 1
copied
[ "$camera" = "--orbit 0,90,10 --target 0,0,0 --fov-y 40" ] || fail "the pasted camera is another one: $camera"
quit

# A file's camera in place of the text; what is no camera is told.
start panels.gltf --size 1000x700 --samples 1 --visibility none --up z --projection orthographic --roll 12
await "frame drawn: panels.gltf" 1
find_window
sleep 0.5
copied
[ "$(option up)" = z ] && [ "$(option projection)" = orthographic ] && [ "$(option roll)" = 12 ] ||
  fail "the options are not in the text: $camera"
# 2D: a drag of the left button moves the picture. Trackball: it turns it. Both are remembered.
quit
for mouse in 2d trackball; do
  echo "{\"mouse\": \"$mouse\"}" >"$XDG_CONFIG_HOME/facet/settings.json"
  start panels.gltf --size 1000x700 --samples 1 --visibility none --orbit 0,90,10 --target 0,0,0 --fov-y 40
  await "frame drawn: panels.gltf" 1
  find_window
  sleep 0.5
  xdotool key h
  sleep 0.5
  xdotool mousemove --window "$window" 500 350 mousedown 1
  for to in "520 360" "560 400" "600 450"; do sleep 0.1; xdotool mousemove --window "$window" $to; done
  sleep 0.3
  xdotool mouseup 1
  sleep 1
  copied
  if [ $mouse = 2d ]; then
    [ "$(option orbit)" = 0,90,10 ] || fail "2D turns: $camera"
    holds "max(abs(a - b) for a, b in zip(($(option target)), (-100 * 20 * math.tan(math.radians(20)) / 700, 100 * 20 * math.tan(math.radians(20)) / 700, 0))) < 1e-9" "2D"
  else
    [ -n "$(option roll)" ] && [ "$(option target)" = 0,0,0 ] || fail "the trackball does not turn freely: $camera"
  fi
  quit
  grep -q "\"mouse\": \"$mouse\"" "$XDG_CONFIG_HOME/facet/settings.json" || fail "the hand is forgotten"
done

# Bookmarks: of the file that the window writes, and a broken one.
echo '{"a": 3}' >"$XDG_CONFIG_HOME/facet/bookmarks.json"
start panels.gltf --size 1000x700 --samples 1 --visibility none
await "error: .*bookmarks.json: /a: is no JSON object; correct or delete it" 1
await "frame drawn: panels.gltf" 1
find_window
sleep 0.5
quit
grep -q '{"a": 3}' "$XDG_CONFIG_HOME/facet/bookmarks.json" || fail "the broken bookmarks are written over"
rm "$XDG_CONFIG_HOME/facet/bookmarks.json"
start builtin:metals --size 1280x800 --samples 1 --env builtin:studio --visibility none --orbit 10,80,6 --roll 5
await "frame drawn: builtin:metals, builtin:studio$" 1
find_window
sleep 0.5
xdotool mousemove --window "$window" 1012 342 click 1 # unfolds them
sleep 1
xdotool mousemove --window "$window" 1060 368 click 1 # the name
sleep 1
xdotool type --delay 60 "front side"
xdotool key Return
sleep 1
grep -q '"front side": "--orbit 10,80,6 --target 0,0,0 --fov-y 45 --roll 5"' "$XDG_CONFIG_HOME/facet/bookmarks.json" ||
  fail "the bookmark is not kept: $(cat "$XDG_CONFIG_HOME/facet/bookmarks.json")"
xdotool mousemove --window "$window" 1127 120 click 1 # from the right
sleep 1
copied
[ "$(option orbit)" = 90,90,6 ] || fail "not from the right: $camera"
xdotool mousemove --window "$window" 1070 361 click 1
sleep 1
copied
[ "$camera" = "--orbit 10,80,6 --target 0,0,0 --fov-y 45 --roll 5" ] || fail "not what was kept: $camera"
quit
echo "passed"
