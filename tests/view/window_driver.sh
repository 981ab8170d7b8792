# What drives the viewer as a hand would, under a virtual X server. Sourced by drive_*.sh FACET SHADERS, which are
# skipped, with exit status 77 and a line "skipped: REASON", where the tools for it are missing.
set -u
facet=$1 shaders=$2

for tool in Xvfb xdotool; do
  command -v $tool >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
folder=$(mktemp -d) || exit 1
cd "$folder" || exit 1
export XDG_CACHE_HOME=$folder/cache XDG_CONFIG_HOME=$folder/config XDG_STATE_HOME=$folder/state
server= viewer=
finish() {
  [ -n "$viewer" ] && kill -CONT "$viewer" 2>/dev/null && kill "$viewer" 2>/dev/null
  [ -n "$server" ] && kill "$server" 2>/dev/null
  wait 2>/dev/null
  rm -rf "$folder"
}
trap finish EXIT
fail() {
  echo "FAILED: $*"
  [ -f log ] && sed 's/^/  /' log
  exit 1
}

start_server() {  # WIDTHxHEIGHT
  Xvfb -displayfd 9 -screen 0 "${1}x24" +extension GLX -nolisten tcp -noreset 9>display 2>server_log &
  server=$!
  for _ in $(seq 100); do [ -s display ] && break; sleep 0.1; done
  [ -s display ] || { echo "skipped: Xvfb does not start: $(tail -1 server_log)"; exit 77; }
  export DISPLAY=:$(cat display)
  unset WAYLAND_DISPLAY
}

start() {  # OPTIONS of the viewer
  : >log
  "$facet" "$@" --log-level debug >log 2>&1 &
  viewer=$!
}
find_window() {
  window=$(xdotool search --sync --onlyvisible --pid $viewer 2>/dev/null | head -1)
  [ -n "$window" ] || window=$(xdotool search --onlyvisible --name facet | head -1)
  [ -n "$window" ] || fail "no window"
  xdotool windowfocus --sync "$window" || fail "the window takes no focus"
}

# Waits until the line has been logged more often than before; at most 20 s.
count() { grep -c "$1" log; }
await() {  # PATTERN COUNT
  for _ in $(seq 400); do
    [ "$(count "$1")" -ge "$2" ] && return
    kill -0 $viewer 2>/dev/null || fail "the viewer ended while waiting for '$1'"
    sleep 0.05
  done
  fail "no line '$1'"
}
# A key that comes while a text still has the keyboard is lost: once more then.
screenshot() {  # NAME
  before=$(count "screenshot written: ")
  for _ in 1 2 3; do
    xdotool key p
    for _ in $(seq 120); do
      [ "$(count "screenshot written: ")" -gt "$before" ] && break 2
      kill -0 $viewer 2>/dev/null || fail "the viewer ended while waiting for a screenshot"
      sleep 0.05
    done
  done
  mv "$(sed -n 's/.*screenshot written: //p' log | tail -1)" "$1.png" || fail "the screenshot $1 is not there"
}
same() { "$facet" compare "$1.png" "$2.png" --metric largest --max-error 0 || fail "$1 and $2 differ"; }
differ() {  # at least 5/255, far above what any driver's rounding makes
  "$facet" compare "$1.png" "$2.png" --metric drmse --max-error 5
  [ $? = 1 ] || fail "$1 and $2 look the same"
}

search() {
  xdotool key slash
  sleep 0.3
  xdotool key ctrl+a
  xdotool type --delay 30 "$1"
  sleep 0.3
  xdotool key Return
}
# On a busy machine the window may not be ready for what is typed: once more then.
choose() {  # TEXT PATTERN COUNT
  for _ in 1 2 3 4; do
    search "$1"
    for _ in $(seq 80); do
      [ "$(count "$2")" -ge "$3" ] && return
      sleep 0.05
    done
  done
  fail "no line '$2' after a search for '$1'"
}

# After errors of the driver's that were to be told.
quit_after_faults() {
  sed -i '/error: OpenGL: the driver/d' log
  quit
}
ended() {
  for _ in $(seq 200); do kill -0 $viewer 2>/dev/null || break; sleep 0.05; done
  kill -0 $viewer 2>/dev/null && fail "$1 does not end the viewer"
  wait $viewer
  status=$?
  viewer=
  [ $status = 0 ] || fail "exit status $status"
  grep -q "\(error\|warning\): OpenGL: " log && fail "OpenGL complains"
}
quit() {
  xdotool key ctrl+q
  ended Ctrl+Q
}
