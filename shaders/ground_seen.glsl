// What paths from the camera see of the floor where they leave the scene.
#include "ground.glsl"

// background: it is seen through the floor.
void seeGround(inout PathState p, bool background, inout vec3 share) {
  float distance = groundDistance(p.origin.xyz, p.direction.xyz);
  if (distance < p.origin.w) return;
  vec2 uv = groundUv((p.origin.xyz + distance * p.direction.xyz).xz);
  if (background) {
    share = groundShare(uv);
    return;
  }
  vec4 cover = groundCover(uv);
  gather(p, p.throughput.rgb * cover.rgb, p.throughput.w);
  p.radiance.a = cover.a;
}
