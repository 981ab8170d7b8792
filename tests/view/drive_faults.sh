#!/bin/bash
# What a machine does to the viewer: a home that nothing can be written to, sleep, a monitor that is unplugged and
# plugged in, a driver without memory, a display that ends. drive_faults.sh FACET SHADERS DROP GL_FAULTS
. "$(dirname "$0")/window_driver.sh"
start_server 1280x800
model=$folder/turning.gltf
cat >"$model" <<END
{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"animations":[{"name":"lift","channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}],
"samplers":[{"input":1,"output":2}]}],
"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3,"min":[0,0,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5126,"type":"SCALAR","count":2,"min":[0],"max":[1]},
{"bufferView":2,"componentType":5126,"type":"VEC3","count":2}],
"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":8},{"buffer":0,"byteOffset":44,"byteLength":24}],
"buffers":[{"byteLength":68,"uri":"data:application/octet-stream;base64,$(
  zero='\0\0\0\0' one='\0\0\200\77'
  printf "$zero$zero$zero$one$zero$zero$zero$one$zero$zero$one$zero$zero$zero$zero$one$zero" | base64 -w0)"}]}
END
mkdir here && cd here || exit 1

# A home in which nothing can be made: everything works, and what cannot be kept is said at the end.
touch nothing; closed=$PWD/nothing
XDG_CACHE_HOME=$closed XDG_CONFIG_HOME=$closed XDG_STATE_HOME=$closed \
  start builtin:spheres --samples 1 --env none
await "frame drawn: builtin:spheres, none$" 1
find_window
screenshot closed
quit
for file in settings.json last.json; do
  grep -q "warning: .*nothing.*$file: cannot be written: Not a directory; check the folder" log || fail "nothing is said of $file"
done

# Confined: what was opened is read wherever it lies, screenshots are written, and nothing is anywhere else.
start "$model" --size 480x360 --samples 1 --env none --visibility none --animation lift
await "frame drawn: .*turning.gltf, none$" 3
find_window
if grep -q "sandbox: files landlock" log; then
  grep -q "NoNewPrivs:.*1" /proc/$viewer/status || fail "the window may still get more rights"
fi
! grep -q "sandbox: .* calls seccomp" log || grep -q "Seccomp:.*2" /proc/$viewer/status || fail "the window's calls are not filtered"

# Asleep for two seconds: it goes on, and draws no more than the time that passed asks for.
frames=$(count "frame drawn")
kill -STOP $viewer
sleep 2
asleep=$(count "frame drawn")
sleep 0.5
[ "$(count "frame drawn")" = "$asleep" ] || fail "it draws while it sleeps"
kill -CONT $viewer
await "frame drawn" $((asleep + 3))
screenshot slept

# The monitor: other resolutions, unplugged, plugged in again.
if command -v xrandr >/dev/null && output=$(xrandr 2>/dev/null | awk '/ connected/ {print $1; exit}') && [ -n "$output" ]; then
  changed=
  for change in "-s 800x600" "-s 640x480" "-s 1280x800" "--output $output --off" "--output $output --auto"; do
    xrandr $change >/dev/null 2>&1 || continue
    changed="$changed $change;"
    frames=$(count "frame drawn")
    await "frame drawn" $((frames + 2))
  done
  [ -n "$changed" ] || echo "this server's monitor cannot be changed"
  screenshot changed
fi
quit

# The driver has no memory for a while: of what is to be shown there is a sentence, and what was shown stays.
faults=$4
if [ -f "$faults" ]; then
  triangle() {  # RED GREEN BLUE
    cat >new.gltf <<END
{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],"extensionsUsed":["KHR_materials_unlit"],
"materials":[{"pbrMetallicRoughness":{"baseColorFactor":[$1,$2,$3,1]},"extensions":{"KHR_materials_unlit":{}},"doubleSided":true}],
"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3,"min":[0,0,0],"max":[1,1,0]}],
"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,
"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}
END
    mv new.gltf triangle.gltf
  }
  short_of() {  # KIND
    LD_PRELOAD=$faults FACET_GL_FAULT="$1 1" FACET_GL_FAULT_WHILE=$PWD/short \
      start triangle.gltf --size 480x360 --samples 1 --env none --visibility none
    await "frame drawn: triangle.gltf, none$" 1
    find_window
    screenshot "$1_before"
    touch short
  }
  sentence="error: OpenGL: the driver's memory does not suffice for "
  triangle 1 0 0

  short_of buffers
  triangle 0 1 0
  await "$sentence" 1
  screenshot buffers_short
  same buffers_before buffers_short
  rm short
  triangle 0 0 1
  await "reloaded: triangle.gltf" 1
  screenshot buffers_after
  differ buffers_before buffers_after
  quit_after_faults

  short_of textures
  choose sky "$sentence" 1
  screenshot textures_short
  same textures_before textures_short
  rm short
  choose sky "environment: builtin:sky" 1
  screenshot textures_after
  differ textures_before textures_after
  quit_after_faults

  # A larger window has no picture until there is memory again.
  short_of targets
  xdotool windowsize "$window" 600 500
  await "$sentence" 1
  rm short
  frames=$(count "frame drawn")
  xdotool windowsize "$window" 480 360
  await "frame drawn" $((frames + 1))
  screenshot targets_after
  same targets_before targets_after
  quit_after_faults
fi

# The display ends: so does the viewer, with a status and not by a signal.
start builtin:spheres --size 480x360 --samples 1 --env none
await "frame drawn: builtin:spheres, none$" 1
kill $server
wait $server 2>/dev/null
server=
for _ in $(seq 200); do kill -0 $viewer 2>/dev/null || break; sleep 0.05; done
kill -0 $viewer 2>/dev/null && fail "it goes on without a display"
wait $viewer
status=$?
viewer=
[ $status -gt 0 ] && [ $status -lt 128 ] || fail "exit status $status after the display's end"
echo "passed"
