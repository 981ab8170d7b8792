#!/usr/bin/env bash
# What tools/setup says on systems other than Debian, with package managers of ours.
set -euo pipefail
setup=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)/tools/setup
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "$*" >&2; exit 1; }
mkdir "$folder/bin"
# rpm and pacman that know the packages of the file "installed".
for manager in rpm pacman; do
  printf '#!/bin/sh\nfor last; do :; done\ngrep -qx -- "$last" %s/installed\n' "$folder" >"$folder/bin/$manager"
  chmod +x "$folder/bin/$manager"
done
: >"$folder/installed"
PATH=$folder/bin:$PATH

# on ID NAME ARGUMENTS...: what setup says there -> said, status.
on() {
  printf 'ID=%s\nPRETTY_NAME="%s"\n' "$1" "$2" >"$folder/os-release"
  status=0
  said=$(OS_RELEASE=$folder/os-release "$setup" "${@:3}" 2>&1) || status=$?
}

on fedora "Fedora 41"
((status == 2)) && [[ $said == *"on Fedora 41 nothing is installed for you; what is missing: dnf install cmake "*" mesa-libGL" ]] ||
  fail "Fedora: $status: $said"
[[ $said != *catch-devel* ]] || fail "Fedora: packages of tests without --tests: $said"
on fedora "Fedora 41" --tests
[[ $said == *" catch-devel "* ]] || fail "Fedora: --tests: $said"
on arch "Arch Linux"
((status == 2)) && [[ $said == *"pacman -S cmake "*" aur/tinygltf "* && $said == *"user repository"* ]] || fail "Arch: $said"
on void "Void"
((status == 2)) && [[ $said == *"Void is not known here"*" libtinygltf-dev "*"cmake --preset release"* ]] || fail "Void: $said"

# All but one there, then all.
on arch "Arch Linux"
line=${said%%$'\n'*}
printf '%s\n' ${line#*pacman -S } | sed 's|^aur/||' | grep -vx draco >"$folder/installed"
on arch "Arch Linux"
((status == 2)) && [[ $said == *"pacman -S draco" ]] || fail "Arch without draco: $said"
echo draco >>"$folder/installed"
on arch "Arch Linux"
((status == 0)) && [[ -z $said ]] || fail "Arch with all: $status: $said"
