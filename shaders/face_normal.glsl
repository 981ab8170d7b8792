// Of a triangle itself, by the positions of neighbouring pixels; towards the viewer, whichever way it winds. Of lengths
// whose product does not underflow.
vec3 faceNormal(vec3 position) {
  vec3 dx = dFdx(position), dy = dFdy(position);
  return cross(dx / max(max(abs(dx.x), max(abs(dx.y), abs(dx.z))), 1e-37),
               dy / max(max(abs(dy.x), max(abs(dy.y), abs(dy.z))), 1e-37));
}
