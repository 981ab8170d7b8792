#!/bin/bash
# Drives the viewer as a hand would, under a virtual X server: open, orbit, switch the environment, take pictures, quit.
# drive_window.sh FACET SHADERS; exit status 77 and a line "skipped: REASON" where the tools for it are missing.
. "$(dirname "$0")/window_driver.sh"
# Without a display: a sentence and exit status 3.
env -u DISPLAY -u WAYLAND_DISPLAY "$facet" builtin:spheres >no_display 2>&1
[ $? = 3 ] || fail "exit status without a display is not 3: $(cat no_display)"
grep -q "window: no display could be opened: .*facet render.*needs no display\.$" no_display ||
  fail "no sentence about the missing display: $(cat no_display)"

start_server 640x480

# What cannot be read is told before there is a window.
"$facet" missing.glb >missing 2>&1
[ $? = 2 ] || fail "exit status of a missing model is not 2: $(cat missing)"

for options in "builtin:postre" "builtin:spheres --env missing.hdr" "builtin:spheres --brdf nowhere"; do
  "$facet" $options >missing 2>&1
  [ $? = 2 ] || fail "exit status of $options is not 2: $(cat missing)"
done

# What cannot be read in it is told by a window that stays, and by the exit status where nothing was shown.
printf 'glTF half a fi' >cut.glb
for options in "cut.glb" "builtin:spheres --camera door"; do
  : >log
  "$facet" $options --size 480x360 --log-level debug >log 2>&1 &
  viewer=$!
  for _ in $(seq 400); do grep -q "facet: error: " log && break; sleep 0.05; done
  grep -q "facet: error: .*\(cut.glb\|door\)" log || fail "nothing is told of $options"
  window=$(xdotool search --sync --onlyvisible --name facet | head -1)
  xdotool windowfocus --sync "$window" || fail "the window takes no focus"
  for _ in 1 2 3 4; do # a key may come before the window listens
    xdotool key ctrl+q
    for _ in $(seq 40); do kill -0 $viewer 2>/dev/null || break 2; sleep 0.05; done
  done
  wait $viewer
  status=$?
  viewer=
  [ $status = 2 ] || fail "exit status is $status where nothing could be shown of $options"
done

cp -r "$shaders" shaders || fail "no copy of the shaders"
start builtin:spheres --size 480x360 --samples 1 --orbit 0,90,9.2 --shader-dir shaders --gl-debug
await "frame drawn: builtin:spheres, builtin:studio$" 1
find_window

xdotool key h # the panel covers much of so small a window
screenshot start
"$facet" render builtin:spheres --size 480x360 --samples 1 --visibility screen --env builtin:studio --orbit 0,90,9.2 --target 0,0,0 \
  --fov-y 45 -o headless.png >/dev/null 2>&1 || fail "no headless picture"
same headless start
screenshot again
same start again

xdotool mousemove --window "$window" 240 180 mousedown 1 mousemove_relative 60 20 mouseup 1
await "frame drawn" 2
screenshot orbited
differ start orbited

xdotool key r
await "frame drawn" 3
screenshot reset
same start reset

xdotool key e
await "frame drawn: builtin:spheres, builtin:sky$" 1
screenshot sky
differ start sky

# With the panel, the picture stays the picture.
xdotool key h
screenshot panel
same sky panel

# A shader is edited: a slip is told and leaves the picture, its correction is taken.
cp shaders/passes/display.frag.glsl good.glsl
echo "slip" >>shaders/passes/display.frag.glsl
await "error: .*fragment shader: shaders/passes/display.frag.glsl:[0-9]*: .*error" 1
screenshot slip
same sky slip
sleep 0.1 # a newer time on any file system
cp good.glsl shaders/passes/display.frag.glsl
await "shaders reloaded" 1
screenshot corrected
same sky corrected

quit

# A triangle that rises by 1 m in a second: Space plays, Space pauses, and what stands still stays the same.
cat >rise.gltf <<'END'
{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],"materials":[{"extensions":{"KHR_materials_unlit":{}},"doubleSided":true}],"extensionsUsed":["KHR_materials_unlit"],
"animations":[{"name":"rise","samplers":[{"input":1,"output":2}],"channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3,"min":[0,0,0],"max":[1,1,0]},{"bufferView":1,"componentType":5126,"type":"SCALAR","count":2,"min":[0],"max":[1]},{"bufferView":2,"componentType":5126,"type":"VEC3","count":2}],
"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":8},{"buffer":0,"byteOffset":44,"byteLength":24}],
"buffers":[{"byteLength":68,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAAAAAACAPwAAAAA="}]}
END
start rise.gltf --env none --size 320x240 --samples 1 --gl-debug
await "frame drawn: rise.gltf" 1
find_window
xdotool key h
screenshot rest
xdotool key space
await "frame drawn" 10
xdotool key space
sleep 0.3
screenshot paused
screenshot still
same paused still
differ rest paused
quit

# The browser: search and Enter open a model and an environment; what changes on disk is read again, camera kept, and
# what cannot be read leaves what is shown.
triangle() {  # RED GREEN BLUE
  echo '{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],"extensionsUsed":["KHR_materials_unlit"],
"materials":[{"pbrMetallicRoughness":{"baseColorFactor":['"$1,$2,$3"',1]},"extensions":{"KHR_materials_unlit":{}},"doubleSided":true}],
"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3,"min":[0,0,0],"max":[1,1,0]}],
"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,
"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}'
}
mkdir -p models/deep
triangle 1 0 0 >models/red.gltf
triangle 0 1 0 >models/deep/green.gltf
start models/red.gltf models --size 480x360 --samples 1 --gl-debug
await "frame drawn: models/red.gltf, none" 1
find_window
await "listed: models" 1
screenshot red
choose "deep green" "model: .*/models/deep/green.gltf" 1
screenshot green
differ red green
choose white "environment: builtin:white" 1
screenshot white
differ green white
choose none "environment: none" 2
screenshot none
same green none

xdotool mousemove --window "$window" 240 180 mousedown 1 mousemove_relative 10 20 mouseup 1
sleep 0.3
screenshot turned
echo '{"asset":{"version":"2.0"},"scene' >models/deep/green.gltf # as if it were still being written
await "error: .*green.gltf" 1
screenshot broken
same turned broken
triangle 1 0 0 >models/deep/green.gltf
await "reloaded: .*green.gltf" 1
screenshot changed
differ turned changed
triangle 0 1 0 >models/deep/green.gltf
await "reloaded: .*green.gltf" 2
screenshot again
same turned again

# A measured BRDF is chosen in the browser; one that cannot be read leaves the picture; a changed file is read again.
mkdir brdfs
"$facet" brdf --synthesize utia-lambert -o brdfs/matte.bin >/dev/null || fail "no BRDF was written"
"$facet" brdf --synthesize utia-satin -o brdfs/satin.bin >/dev/null || fail "no BRDF was written"
head -c 1000 brdfs/matte.bin >brdfs/cut.binary
quit
start builtin:spheres --brdf matte --brdf-dir brdfs --size 480x360 --samples 1 \
  --orbit 0,90,16 --target 0,0,0 --fov-y 45 --gl-debug
await "frame drawn: builtin:spheres, builtin:studio$" 1 # not by a preview of the light
find_window
await "listed: brdfs" 1
screenshot matte
"$facet" render builtin:spheres --brdf brdfs/matte.bin --size 480x360 --samples 1 --visibility screen --env builtin:studio --orbit 0,90,16 \
  --target 0,0,0 --fov-y 45 -o measured.png >/dev/null 2>&1 || fail "no headless picture of a measured BRDF"
same measured matte
choose satin.bin "measured BRDF: .*/brdfs/satin.bin" 1
screenshot satin
differ matte satin
choose cut.binary "error: .*cut.binary" 1
screenshot cut
same satin cut
cp brdfs/matte.bin brdfs/satin.bin
await "reloaded: .*satin.bin" 1
screenshot reread
same matte reread

head -1 "$XDG_STATE_HOME/facet/recent" | grep -q "/brdfs/satin.bin$" || fail "satin.bin is not remembered"
grep -q "/models/deep/green.gltf$" "$XDG_STATE_HOME/facet/recent" || fail "green.gltf is not remembered"
for _ in $(seq 400); do
  [ -n "$(find "$XDG_CACHE_HOME/facet/thumbnails" -name '*.bin' 2>/dev/null)" ] && break
  sleep 0.05
done
[ -n "$(find "$XDG_CACHE_HOME/facet/thumbnails" -name '*.bin' 2>/dev/null)" ] || fail "no preview was made"
quit
[ -s "$XDG_CONFIG_HOME/facet/imgui.ini" ] || fail "the layout is not remembered"
echo "passed"
