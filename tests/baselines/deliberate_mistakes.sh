#!/usr/bin/env bash
# deliberate_mistakes.sh FACET SHADERS: a copy of the shaders gets one mistake at a time, each of a kind that people make,
# and the suite beside this script must notice each, and nothing without one.
set -euo pipefail
facet=$1 shaders=$2
suite=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0

# regress FILTER: the exit status; the jobs that differ -> $work/log.
regress() {
  local status=0
  "$facet" regress "$suite" --filter "$1" --shader-dir "$work/shaders" -o "$work/results" >"$work/log" 2>&1 || status=$?
  return $status
}

fresh() { rm -rf "$work/shaders" && cp -r "$shaders" "$work/shaders"; }

# mistake NAME FILTER FILE OLD NEW
mistake() {
  local name=$1 filter=$2 file=$work/shaders/$3 old=$4 new=$5 text status=0
  fresh
  text=$(<"$file")
  if [[ $text != *"$old"* ]]; then
    echo "$name: $3 does not hold '$old' any more; adapt this script" >&2
    failed=1
    return
  fi
  printf '%s\n' "${text/"$old"/"$new"}" >"$file"
  regress "$filter" || status=$?
  if [[ $status == 1 ]] && grep -q ' differs ' "$work/log"; then
    echo "caught: $name: $(grep -o 'differs .*' "$work/log" | tr '\n' ';')"
  else
    echo "not caught (exit status $status): $name" >&2
    cat "$work/log" >&2
    failed=1
  fi
}

fresh
for filter in clearcoat textured lights-only; do
  status=0
  regress "$filter" || status=$?
  if [[ $status == 3 ]]; then
    echo "no usable OpenGL" && exit 77
  elif [[ $status != 0 ]]; then
    echo "the unchanged shaders do not pass $filter:" >&2
    cat "$work/log" >&2
    failed=1
  fi
done

mistake "the coat's NoV is the base's" clearcoat material_layers.glsl \
  'float NoV = clamp(dot(N, s.V), minNoV, 1.0);' 'float NoV = s.NoV;'
mistake "sRGB is not decoded" textured material.glsl \
  'baseColorTexel(v)' 'pow(baseColorTexel(v), vec4(vec3(1.0 / 2.2), 1.0))'
mistake "the normal texture's green is flipped" textured material.glsl \
  'vec3 n = texel * 2.0 - 1.0;' 'vec3 n = (texel * 2.0 - 1.0) * vec3(1.0, -1.0, 1.0);'
mistake "roughness in place of alpha" lights-only bsdf.glsl \
  's.alpha = perceptualRoughness * perceptualRoughness;' 's.alpha = perceptualRoughness;'
mistake "occlusion is dropped" textured image_light.glsl \
  'radiance * (frame.environmentScale.x * s.occlusion)' 'radiance * frame.environmentScale.x'
exit $failed
