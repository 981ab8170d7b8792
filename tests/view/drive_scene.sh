#!/usr/bin/env bash
# drive_scene.sh FACET SHADERS: several files in one scene, light in false colours, layers that are left out and a picture
# of another size, by hand; what is shown is each time what the copied command writes.
. "$(dirname "$0")/window_driver.sh"
start_server 1280x800

layout=$XDG_CONFIG_HOME/facet/imgui.ini
mkdir -p "${layout%/*}"
printf '[facet][Shown]\nbrowser=1\nsettings=1\ntimeline=1\n' >"$layout"
for section in Camera "Environment and lights" Material Model Overlays "Reflection models" Accuracy Statistics Window; do
  echo "section=0 $section" >>"$layout"
done

# A triangle with a sheen, and the same one turned upside down.
cat >first.gltf <<'END'
{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"rotation":[0.3826834,0,0,0.9238795],"scale":[8,4,1]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],
"materials":[{"pbrMetallicRoughness":{"metallicFactor":0,"baseColorFactor":[0.02,0.002,0.002,1]},"doubleSided":true,
"extensions":{"KHR_materials_sheen":{"sheenColorFactor":[1,1,1],"sheenRoughnessFactor":0.5}}}],"extensionsUsed":["KHR_materials_sheen"],
"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3,"min":[0,0,0],"max":[1,1,0]}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}
END
sed 's/"mesh":0,"rotation":\[0.3826834,0,0,0.9238795\],"scale":\[8,4,1\]/"mesh":0,"translation":[8,4,0],"rotation":[0,0,1,0],"scale":[8,3,1]/' first.gltf >second.gltf
echo '{"asset":{"version":"2.0"},"nodes":[{"children":[0]}]}' >broken.gltf

as_copied() {  # PATTERN in the copied command
  screenshot window
  xdotool key ctrl+c
  sleep 0.3
  command=$(sed -n 's/.*copied: facet //p' log | tail -1)
  grep -q -- "$1" <<<"$command" || fail "copied: $command"
  eval "\"$facet\" $command" >/dev/null 2>&1 || fail "the copied command fails: $command"
  cmp window.png picture.png || fail "the copied command has other bytes: $command"
}

# Control and a click in the browser: broken.gltf in the second row, which changes nothing, then second.gltf.
start first.gltf --env builtin:studio --size 1280x800 --samples 1 --visibility none
await "frame drawn: first.gltf, builtin:studio$" 1
await "listed: " 1
find_window
sleep 0.5
xdotool mousemove --window "$window" 640 700
screenshot alone
click() { xdotool mousemove --window "$window" "$1" "$2" click 1 mousemove --window "$window" 640 700; }
add() {
  xdotool keydown Control_L
  sleep 0.2
  click 120 "$1"
  sleep 0.2
  xdotool keyup Control_L
}
add 122
await "error: .*broken.gltf: " 1
sleep 0.3
screenshot kept
same alone kept
add 164
await "with .*second.gltf$" 1
sleep 0.5
screenshot both
differ alone both
as_copied "--with [^ ]*second.gltf"

# False colours: the check below the tone mappers.
click 1008 269
sleep 1
as_copied "--with [^ ]*second.gltf.* --false-colors"
differ both window
click 1008 269
sleep 1
screenshot again
same both again

# Out of the scene: the button of the section of the model.
click 1100 169
sleep 1
for y in $(seq 315 6 351); do
  click 1020 "$y"
  sleep 0.5
  [ "$(count "reloaded: first.gltf$")" -gt 0 ] && break
done
await "reloaded: first.gltf$" 1
sleep 0.5
screenshot single
same alone single
click 1100 169

# Without its sheen, and with it again: the check below the source of the materials.
click 1100 144
sleep 1
click 1008 194
sleep 1
as_copied "--without sheen"
differ alone window
click 1008 194
sleep 1
screenshot shining
same alone shining
click 1100 144

# A picture of another size: drawn beside the window, the bytes of the copied command; and one that is given up.
xdotool mousemove --window "$window" 1040 444 click --repeat 2 --delay 50 1
sleep 0.5
xdotool key ctrl+a
xdotool type --delay 50 320
xdotool key Tab
sleep 0.3
xdotool type --delay 50 200
xdotool key Return
sleep 0.5
click 1060 469
await "a picture of 320 x 200 is drawn beside the window" 1
await "picture written: " 1
mv "$(sed -n 's/.*picture written: //p' log)" large.png || fail "the picture is not there"
xdotool key ctrl+c
sleep 0.3
command=$(sed -n 's/.*copied: facet //p' log | tail -1)
eval "\"$facet\" ${command/--size 1280x800/--size 320x200}" >/dev/null 2>&1 || fail "the copied command fails: $command"
cmp large.png picture.png || fail "a picture of that size has other bytes: $command"
click 1060 469
await "a picture of 320 x 200 is drawn beside the window" 2
click 1060 469
await "\(the picture is not drawn\|picture written\)" 2
quit
ls -A | grep -q "said" && fail "what a process said is left"
echo "passed"
