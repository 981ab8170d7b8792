#!/bin/bash
# Panels in narrow windows and after them, folded sections, what is framed beside the panels, what comes back at the next
# start: in the window itself.
. "$(dirname "$0")/window_driver.sh"
start_server 1280x800
layout=$XDG_CONFIG_HOME/facet/imgui.ini

# A window that was narrow once leaves the panels as wide as they were; a folded section stays folded.
start builtin:spheres --size 1280x800 --samples 1
await "frame drawn: builtin:spheres, builtin:studio$" 1
find_window
sleep 0.5
for size in "640 480" "300 300" "160 120" "640 480" "1280 800" "400 800" "1280 300" "1280 800"; do
  xdotool windowsize --sync "$window" $size
  sleep 0.4
done
await "frame drawn" 2
# What is in the window is the picture: it has not stayed black.
if command -v import >/dev/null; then
  xdotool key h
  sleep 1
  import -window "$window" PNG24:shown.png || fail "no picture of the window"
  screenshot picture
  same shown picture
  xdotool key h
  sleep 0.5
fi
xdotool mousemove --window "$window" 1100 93 click 1 # the header "Camera"
sleep 0.5
quit
grep -q "^left=18.00$" "$layout" && grep -q "^right=21.00$" "$layout" || fail "other widths: $(cat "$layout")"
grep -q "^section=0 Camera$" "$layout" || fail "no folded section: $(cat "$layout")"
start builtin:spheres --size 1280x800 --samples 1
await "frame drawn: builtin:spheres, builtin:studio$" 1
find_window
sleep 0.5
xdotool mousemove --window "$window" 1100 93 click 1
sleep 0.5
# What is dragged is wished.
for border in 251 233; do # of 18 font sizes of 14 pixels, or of ImGui's own 13
  xdotool mousemove --window "$window" $border 400 mousedown 1
  sleep 0.2
  xdotool mousemove --window "$window" 350 400
  sleep 0.2
  xdotool mouseup 1
  sleep 0.3
done
quit
grep -q "^section=1 Camera$" "$layout" || fail "the section was not folded: $(cat "$layout")"
grep -q "^left=2[4-7]" "$layout" || fail "the dragged width is forgotten: $(cat "$layout")"
rm "$layout"

# The search opens the browser where there was room for the settings only, and has what is typed at once.
start builtin:spheres --size 480x360 --samples 1
await "frame drawn: builtin:spheres, builtin:studio$" 1
find_window
sleep 0.5
kill -STOP $viewer
xdotool type --delay 2 "/white"
xdotool key Return
kill -CONT $viewer
await "environment: builtin:white" 1
quit

# All of a new model is beside the panels: nothing of a wide one is below them.
cat >wide.gltf <<'END'
{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"scale":[8,1,1]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],"materials":[{"extensions":{"KHR_materials_unlit":{}},"doubleSided":true}],"extensionsUsed":["KHR_materials_unlit"],
"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3,"min":[0,0,0],"max":[1,1,0]}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}
END
cp wide.gltf first.gltf
sed 's/"scale":\[8,1,1\]/"scale":[4,1,1]/' wide.gltf >second.gltf
start wide.gltf --env none --size 1280x800 --samples 1
await "frame drawn: wide.gltf, none" 1
find_window
sleep 0.5
xdotool key ctrl+c
await "copied: facet render wide.gltf" 1
# radius, of half the width 4.03: tan 22.5 x (1280 - 2 x 294) / 800 is 0.358, its sine 0.337
radius=$(sed -n 's/.*copied: .*--orbit [^,]*,[^,]*,\([0-9.]*\).*/\1/p' log)
awk -v r="${radius:-0}" 'BEGIN { exit !(r > 11.5 && r < 13) }' || fail "framed from $radius"

# What was shown comes back: camera, environment, model.
xdotool mousemove --window "$window" 640 400 mousedown 1 mousemove_relative 60 20 mouseup 1
xdotool key e
await "environment: builtin:studio" 1
sleep 0.3
screenshot left
# S flies, but not as a part of Ctrl+S, whichever of the two is let go first.
xdotool keydown Control_L keydown s keyup Control_L
sleep 0.3
xdotool keyup s
await "session written: " 1
session=$(sed -n 's/.*session written: //p' log)
quit
start --last --size 1280x800
await "frame drawn: .*wide.gltf, builtin:studio$" 1
find_window
sleep 0.5
screenshot back
same left back
quit
# A session brings it back as well, whatever came after it; Ctrl+O opens by the system's dialog.
mv "$XDG_STATE_HOME/facet/last.json" kept.json
mkdir -p bin
printf '#!/bin/sh\necho "$@" >%s/asked\necho %s\n' "$folder" "$folder/chosen.gltf" >bin/zenity
chmod +x bin/zenity
cp wide.gltf chosen.gltf
PATH=$folder/bin:$PATH start "$session" --size 1280x800
await "frame drawn: .*wide.gltf, builtin:studio$" 1
find_window
sleep 0.5
screenshot session
same left session
xdotool key ctrl+o
await "frame drawn: .*chosen.gltf, builtin:studio$" 1
grep -q -- "--file-selection .*--filename=$folder/" asked || fail "the dialog was asked otherwise: $(cat asked)"
printf '#!/bin/sh\nexit 1\n' >bin/zenity # closed without a choice
xdotool key ctrl+o
sleep 0.5
screenshot still
# Saved by the dialog: what it is goes by its name, and the window writes where it was started alone.
save_as() {  # FILE PATTERN
  printf '#!/bin/sh\necho "$@" >%s/asked\necho %s\n' "$folder" "$1" >bin/zenity
  xdotool key ctrl+shift+s
  await "$2" 1
}
save_as "$folder/chosen.webp" "screenshot written: $folder/chosen.webp"
grep -q -- "--file-selection --save .*--filename=$folder/facet-" asked || fail "the dialog was asked otherwise: $(cat asked)"
"$facet" compare still.png chosen.webp --metric drmse --max-error 3 || fail "the saved picture is another one"
save_as "$folder/chosen.facet" "session written: $folder/chosen.facet"
save_as "$folder/chosen.glb" "exported: $folder/chosen.glb"
save_as "$folder/chosen.txt" "chosen.txt: is no name of a picture of what the screen shows; end it in .png, .jpg"
if grep -q "sandbox: files landlock" log; then # temporary files may be written, others not
  outside=$(mktemp -d -p /var/tmp)
  save_as "$outside/chosen.png" "$outside/chosen.png: cannot be written: the program has confined itself to other folders"
  rmdir "$outside" || fail "something was written outside"
fi
quit
mv kept.json "$XDG_STATE_HOME/facet/last.json"
mkdir -p "$XDG_CONFIG_HOME/facet"
echo '{"startWithLast": true}' >"$XDG_CONFIG_HOME/facet/settings.json"
start
await "frame drawn: .*wide.gltf, builtin:studio$" 1
find_window
sleep 0.3
quit
rm wide.gltf # what is gone is told, and the window comes all the same
start
await "warning: .*wide.gltf: " 1
await "frame drawn: builtin:poster" 1
find_window
sleep 0.3
quit

# What is wrong with a file: looked for once its section is open, and a click on a line selects the node.
cat >wrong.gltf <<'END'
{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],"nodes":[{"name":"first"},{"name":"second","mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],"materials":[{"extensions":{"KHR_materials_unlit":{}}}],"extensionsUsed":["KHR_materials_unlit"],
"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3,"min":[0,0,0],"max":[1,7,0]}],
"bufferViews":[{"buffer":0,"byteLength":36,"target":34962}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}
END
start wrong.gltf --env none --size 1280x800 --samples 1
await "frame drawn: wrong.gltf, none" 1
find_window
sleep 0.5
[ "$(count "checked: ")" = 0 ] || fail "the file was looked through unasked"
quit
mkdir -p "${layout%/*}"
printf '[facet][Shown]\nbrowser=1\nsettings=1\ntimeline=1\n' >"$layout"
for section in Camera "Environment and lights" Material Model Picture "Reflection models" Accuracy Statistics Window; do
  echo "section=0 $section" >>"$layout"
done
echo "section=1 validation" >>"$layout"
start wrong.gltf --env none --size 1280x800 --samples 1
await "checked: wrong.gltf: 1 error, 0 warnings, 1 more" 1
find_window
sleep 0.5
for y in 305 315 325 335; do # the first line, whatever the font
  xdotool mousemove --window "$window" 1100 $y click 1
  sleep 0.4
  [ "$(count "finding chosen: ")" -gt 0 ] && break
done
await "finding chosen: ACCESSOR_MAX_MISMATCH, node 1" 1
quit

# What each pass takes is measured once it is looked at, and not before.
sed -i 's/^section=1 validation$/section=0 validation/; s/^section=0 Statistics$/section=1 Statistics/' "$layout"
start builtin:spheres --size 1280x800 --samples 1
await "frame drawn: builtin:spheres, builtin:studio$" 1
find_window
sleep 0.5
[ "$(count "passes timed: ")" = 0 ] || fail "passes were timed unasked"
for y in $(seq 500 12 760); do # the last line of the section, whatever the font
  xdotool mousemove --window "$window" 1100 $y click 1
  sleep 0.4
  [ "$(count "passes timed: ")" -gt 0 ] && break
done
await "passes timed: .*opaque [0-9.]* ms.*, display [0-9.]* ms" 1
quit

# Lines over a picture that goes on converging without anybody's doing.
start builtin:spheres --overlay axes,skeleton --size 640x480 --samples 16 --visibility none
await "picture converged: 16 samples" 1
find_window
quit

# Two models beside each other: where nothing of one is there, what differs is the other.
start first.gltf second.gltf --env none --size 1280x800 --samples 1 --background 1,0,0
await "frame drawn: first.gltf, none" 1
await "beside second.gltf: RMS [0-9.]*/255 where they differ ([0-9]* % of the picture), " 1
await "beside second.gltf: FLIP 0[.][0-9]*" 1
find_window
sleep 0.5
shown=$(count "beside second.gltf: RMS ")
xdotool mousemove --window "$window" 500 300 mousedown 1 mousemove_relative 60 20 mouseup 1
await "beside second.gltf: RMS " $((shown + 1))
# Its file is looked at, too: as it was until it can be read again.
cp second.gltf whole.gltf
shown=$(count "beside second.gltf: RMS ")
head -c 100 whole.gltf >second.gltf
await "error: second.gltf: " 1
sed 's/"scale":\[4,1,1\]/"scale":[2,1,1]/' whole.gltf >second.gltf
flips=$(count "beside second.gltf: FLIP ")
await "reloaded: second.gltf$" 1
await "beside second.gltf: RMS " $((shown + 1))
await "beside second.gltf: FLIP " $((flips + 1)) # the end waits for one that is being found
quit
mv whole.gltf second.gltf
start --last --size 1280x800 # both come back
await "beside .*/second.gltf: RMS " 1
quit
start first.gltf second.gltf third.gltf --size 320x240
wait $viewer
[ $? = 2 ] || fail "three models are taken"
viewer=
grep -q "third.gltf: is the third model" log || fail "nothing is told of the third model"

# The fast picture beside the traced one: the list below each pixel's error, its second entry.
sed -i 's/^section=1 Statistics$/section=0 Statistics/; s/^section=0 Accuracy$/section=1 Accuracy/' "$layout"
start builtin:spheres --size 640x480 --samples 4 --visibility none
await "frame drawn: builtin:spheres, builtin:studio$" 1
find_window
sleep 0.5
[ "$(count "against truth: ")" = 0 ] || fail "the truth was traced unasked"
for y in 340 350 360 370; do
  xdotool mousemove --window "$window" 460 $y click 1
  sleep 0.3
  xdotool mousemove --window "$window" 460 $((y + 46)) click 1
  for _ in $(seq 30); do [ "$(count "against truth: ")" -gt 0 ] && break 2; sleep 0.1; done
done
await "against truth: drawn, nothing in the way: RMS [0-9.]*/255 " 1
quit
rm "$layout"
echo "passed"
