// Paths at surfaces of one class: what these emit, one light that they see, and the way on.
#define MATERIAL_BY_INDEX
#include "path_class.glsl"
#include "path_surface.glsl"
#define TEXCOORD_OF(v, n) v.texCoord[n]
#define READ_TEXTURE(image, uv, slot) textureLod(image, uv, 0.0)
#include "material_texels.glsl"
#include "path_media.glsl" if SCENE_MEDIA
#ifndef UNLIT
#include "path_lit.glsl"
#else
#include "material.glsl"
#endif

layout(local_size_x = groupInvocations) in;

void main() {
  uint path;
  if (!pathOfClass(gl_GlobalInvocationID.x, path)) return;
  PathState p = paths[path];
  PathSurface at = pathSurface(p);
  selectMaterial(at.material);
  p.throughput.rgb *= mediumTransmittance(mediaOf(p), p.distance);
  vec4 baseColor = materialBaseColor(at.v);
#ifdef UNLIT
#ifdef DIFFERENCE
  if (p.vertices == 0u) return;  // it is drawn
#endif
  gather(p, p.throughput.rgb * baseColor.rgb, p.throughput.w);
  paths[path].radiance = p.radiance;
#else
  PathTurn turn = turnAt(p, at, baseColor.rgb);
  paths[path].radiance = turn.path.radiance;
  if (turn.lit) {
    paths[path].lightOrigin = turn.path.lightOrigin;
    paths[path].lightDirection = turn.path.lightDirection;
    paths[path].lightRadiance = turn.path.lightRadiance;
    work[listAt(lightsList, atomicAdd(work[workLights], 1u))] = path;
  }
  if (turn.goesOn) {
    paths[path].origin = turn.path.origin;
    paths[path].direction = turn.path.direction;
    paths[path].throughput = turn.path.throughput;
    paths[path].onMiss = turn.path.onMiss;
    paths[path].vertices = turn.path.vertices;
    paths[path].media = turn.path.media;
    paths[path].outerMedia = turn.path.outerMedia;
    work[listAt(nextList(), atomicAdd(work[workNext], 1u))] = path;
  }
#endif
}
