#!/usr/bin/env bash
# completion_test.sh FACET: the shells' completions ask this program; what zsh and fish say only where they are there.
set -euo pipefail
program=$1
scripts=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)/resources/completion
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/models" "$folder/bin"
cd "$folder"
ln -s "$program" bin/facet
export PATH=$folder/bin:$PATH
touch 'a chair.glb' B.GLTF other.png
# expect WHO ASKED WANTED FOUND
expect() { [[ $4 == "$3" ]] || { echo "$1: $2: wanted <$3>, found <$4>" >&2; exit 1; }; }

bash -n "$scripts/facet.bash"
# in_bash WORD...: the last one is completed.
in_bash() {
  bash --norc -c 'source "$0"; COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)); _facet; IFS=,; echo "${COMPREPLY[*]}"' \
    "$scripts/facet.bash" facet "$@"
}
expect bash "facet rend" render "$(in_bash rend)"
expect bash "--tonemap" aces,agx "$(in_bash render x.glb --tonemap a)"
expect bash "--tonem" --tonemap "$(in_bash render --tonem)"
expect bash "a model" "B.GLTF,a chair.glb,bin,models" \
  "$(in_bash inspect '' | tr , '\n' | grep -v builtin: | LC_ALL=C sort | paste -sd,)"
expect bash "a folder" models "$(in_bash regress m)"
expect bash "a file" "a chair.glb" "$(in_bash render a)"
expect bash "no model" "" "$(in_bash render o)"
# Readline breaks words at colons: only what is behind them is replaced.
expect bash "builtin:" spheres "$(in_bash render builtin:sp)"

if command -v zsh >/dev/null; then
  zsh -n "$scripts/_facet"
  in_zsh() {
    zsh -fc '_describe() { print -rl -- "${(@P)argv[-1]}"; }; _files() { print -- files "$@"; }
      words=("$@") CURRENT=$#words; source $0' "$scripts/_facet" facet "$@"
  }
  expect zsh "--tonemap" $'aces\nagx' "$(in_zsh render --tonemap a)"
  expect zsh "builtin:" 'builtin\:sky' "$(in_zsh render --env builtin:sk | sed -n 's/:[a-z ]*clear.*//p')"
  expect zsh "a folder" "files -/" "$(in_zsh regress '')"
  expect zsh "a model" "files -g *.(#i)(glb|gltf)(-.)" "$(in_zsh render a)"
fi
if command -v fish >/dev/null; then
  fish -n "$scripts/facet.fish"
  in_fish() { fish --no-config -c "source '$scripts/facet.fish'; complete -C '$1'" | cut -f1; }
  expect fish "--tonemap" $'aces\nagx' "$(in_fish 'facet render --tonemap a')"
  expect fish "builtin:" builtin:sky "$(in_fish 'facet render --env builtin:sk')"
  expect fish "a folder" models/ "$(in_fish 'facet regress mo')"
  expect fish "a model" B.GLTF "$(in_fish 'facet render B.')"
fi
