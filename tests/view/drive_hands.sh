#!/bin/bash
# Keys of other layouts, taps and clicks while the window is busy, screenshots: in the window itself.
. "$(dirname "$0")/window_driver.sh"
start_server 1280x800

# While it is stopped, it is as busy as a long turn makes it.
busy() { kill -STOP $viewer; }
idle() { kill -CONT $viewer; }

start builtin:spheres --size 1280x800 --samples 1
await "frame drawn: builtin:spheres, builtin:studio$" 1
find_window
sleep 0.5

# A tap of Escape closes the help, however long the turn; Escape alone never ends the viewer.
xdotool key F1
sleep 0.7
busy
xdotool key Escape
sleep 0.1
idle
sleep 0.7
xdotool key e
await "environment: builtin:sky" 1
for _ in 1 2 3; do xdotool key Escape; sleep 0.1; done
sleep 0.3
kill -0 $viewer 2>/dev/null || fail "Escape ends the viewer"

# What is typed after the search's key is for the search, however fast it comes.
busy
xdotool type --delay 2 "/white"
xdotool key Return
idle
await "environment: builtin:white" 1
# A click is where it was, not where the pointer has gone since: on the only row that the search leaves.
choose studio "environment: builtin:studio" 2
xdotool key slash
sleep 0.3
xdotool key ctrl+a
xdotool type --delay 30 sky
sleep 0.5
busy
xdotool mousemove --window "$window" 100 135 click 1 mousemove --window "$window" 640 400
idle
await "environment: builtin:sky" 2
xdotool key Escape

# By what is written on the keys.
if command -v setxkbmap >/dev/null; then
  setxkbmap de
  sleep 0.5
  choose none "environment: none" 1 # / is Shift+7 there
  xdotool key Escape
  setxkbmap us -variant dvorak
  sleep 0.5
  before=$(count "environment: builtin:studio")
  xdotool key e # where D is otherwise
  await "environment: builtin:studio" $((before + 1))
  setxkbmap fr
  sleep 0.5
  choose white "environment: builtin:white" 2
  choose sky "environment: builtin:sky" 3 # its Ctrl+A is in the text
  xdotool key Escape
  xdotool key ctrl+a # where Q is otherwise
  sleep 0.5
  kill -0 $viewer 2>/dev/null || fail "Ctrl+A ends the viewer where A is in the place of Q"
  quit
  setxkbmap us
else
  quit
fi

# Other keys from a file; a mistake in it is told, and the usual ones stay.
mkdir -p "$XDG_CONFIG_HOME/facet"
echo '{"nextEnvironment": "Shift+X", "quit": ["F9"]}' >"$XDG_CONFIG_HOME/facet/keys.json"
start builtin:spheres --size 640x480 --samples 1
await "frame drawn: builtin:spheres, builtin:studio$" 1
find_window
sleep 0.5
xdotool key shift+x
await "environment: builtin:sky" 1
xdotool key F9
ended F9
echo '{"quit": "P"}' >"$XDG_CONFIG_HOME/facet/keys.json"
start builtin:spheres --size 640x480 --samples 1
await "error: .*keys.json: /quit: has the key P, and so has screenshot" 1
await "frame drawn: builtin:spheres, builtin:studio$" 1
find_window
sleep 0.5
quit
rm "$XDG_CONFIG_HOME/facet/keys.json"

# A textured file with nodes that turn and stretch it: what is shown is what the copied command renders, to the byte. A
# screenshot that is taken before says of how many samples it is; one that waits has them all.
cat >turned.gltf <<'END'
{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"children":[1,2],"rotation":[0.48,0.6,0,0.64]},{"mesh":0,"scale":[2,1.3,0.7],"rotation":[0,0.6,0.8,0]},
{"mesh":0,"translation":[0.7,0.2,0.9],"scale":[1,2,3],"rotation":[0.6,0,0,0.8]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"material":0}]}],
"materials":[{"doubleSided":true,"pbrMetallicRoughness":{"roughnessFactor":0.3,"baseColorTexture":{"index":0}}}],
"textures":[{"source":0}],"images":[{"uri":"noise.png"}],
"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3,"min":[0,0,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5126,"type":"VEC2","count":3}],
"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":8,"byteLength":24}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}
END
"$facet" render builtin:marbles --size 32x32 --samples 1 -o noise.png >/dev/null 2>&1 || fail "no texture"
for samples in 3 60; do
  start turned.gltf --size 1000x700 --samples $samples --visibility none
  await "frame drawn: turned.gltf" 1
  find_window
  if [ $samples = 60 ]; then
    screenshot early
    grep -q "[0-9]* of 60 samples; screenshot written: /" log || fail "nothing says that the screenshot is not of all"
    before=$(count "screenshot written: ")
    xdotool key shift+p
    await "screenshot written: " $((before + 1))
    mv "$(sed -n 's/.*screenshot written: //p' log | tail -1)" window.png || fail "no screenshot"
    tail -1 log | grep -q "samples; screenshot" && fail "the screenshot has not waited"
  else
    sleep 0.5
    screenshot window
  fi
  xdotool key ctrl+c
  await "copied: facet render turned.gltf" 1
  command=$(sed -n 's/.*copied: facet //p' log | tail -1)
  quit
  eval "\"$facet\" $command" >/dev/null 2>&1 || fail "the copied command fails: $command"
  cmp window.png picture.png || fail "the copied command has other bytes: $command"
done

# The slider that blurs the background, dragged; the copied command knows of it.
start builtin:metals --size 1280x800 --samples 1 --env builtin:studio --orbit 0,125 --visibility none
await "frame drawn: builtin:metals, builtin:studio$" 1
find_window
sleep 0.5
screenshot sharp
xdotool mousemove --window "$window" 1003 545 mousedown 1
for x in 1015 1030 1040; do sleep 1; xdotool mousemove --window "$window" $x 545; done
sleep 1
xdotool mouseup 1
sleep 1
xdotool mousemove --window "$window" 640 700
await "table: blurred background" 1
sleep 3 # coarse tables are sharpened
screenshot window
differ sharp window
xdotool key ctrl+c
await "copied: facet render builtin:metals .*--background-blur 0\.[0-9]" 1
command=$(sed -n 's/.*copied: facet //p' log | tail -1)
quit
eval "\"$facet\" $command" >/dev/null 2>&1 || fail "the copied command fails: $command"
cmp window.png picture.png || fail "the copied command has other bytes: $command"

# A node hidden by its check in the scene's list: as the copied command has it, undone and done again, and as a file.
start builtin:metals --size 1280x800 --samples 1 --env builtin:studio --visibility none
await "frame drawn: builtin:metals, builtin:studio$" 1
find_window
sleep 0.5
screenshot plain
xdotool mousemove --window "$window" 1091 70 click 1
sleep 1
xdotool mousemove --window "$window" 1036 128 click 1 mousemove --window "$window" 640 700
sleep 2
screenshot window
differ plain window
xdotool key ctrl+c
await "copied: facet render builtin:metals .*--set /nodes/[0-9]*/extensions/KHR_node_visibility/visible=false" 1
command=$(sed -n 's/.*copied: facet //p' log | tail -1)
xdotool key ctrl+z
sleep 2
screenshot undone
same plain undone
xdotool key ctrl+y
sleep 2
screenshot redone
same window redone
xdotool mousemove --window "$window" 1199 95 click 1
await "exported: /.*metals-changed.glb" 1
quit
eval "\"$facet\" $command" >/dev/null 2>&1 || fail "the copied command fails: $command"
cmp window.png picture.png || fail "the copied command has other bytes: $command"
"$facet" inspect metals-changed.glb | grep -q "KHR_node_visibility" || fail "the exported model does not hide the node"

# Lines over the picture, chosen in their section: beside screenshots until that is chosen, too.
start builtin:metals --size 1280x800 --samples 1 --env builtin:studio --visibility none
await "frame drawn: builtin:metals, builtin:studio$" 1
find_window
sleep 0.5
for header in 95 120 195 220; do # folded: Camera, Environment, Picture; unfolded: Overlays
  xdotool mousemove --window "$window" 1100 $header click 1
  sleep 1
done
screenshot plain
for box in 245 295 320; do # wireframe, axes, grid
  xdotool mousemove --window "$window" 1008 $box click 1
  sleep 1
done
screenshot lines
same plain lines
xdotool mousemove --window "$window" 1008 470 click 1
sleep 1
screenshot window
differ plain window
xdotool key ctrl+c
await "copied: facet render builtin:metals .*--overlay wireframe,axes,grid" 1
command=$(sed -n 's/.*copied: facet //p' log | tail -1)
quit
eval "\"$facet\" $command" >/dev/null 2>&1 || fail "the copied command fails: $command"
cmp window.png picture.png || fail "the copied command has other bytes: $command"
echo "passed"
