struct UnblockedLight {
  vec3 broad, sharp;
};
UnblockedLight noLight() { return UnblockedLight(vec3(0.0), vec3(0.0)); }
UnblockedLight unblockedLight(PathSurface at, PathBsdf b, bool punctual) { return noLight(); }
bool correcting(PathState p) { return false; }
bool staysDrawn(PathState p, PathSurface at, vec3 L) { return false; }
bool byTables(PathState p, PathBsdf b) { return false; }
float broadShare(PathBsdf b, vec3 L, float density) { return 0.0; }
void rememberFirst(inout PathState p, PathSurface at, PathBsdf b) {}
void rememberUnblocked(inout PathState p, vec3 radiance, float broad, bool environment) {}
bool seeSun(PathSurface at, PathBsdf b, out vec3 L, out vec3 reflected) {
  L = reflected = vec3(0.0);
  return false;
}
vec4 onMiss(PathSurface at, PathBsdf b, UnblockedLight light, PathSample drawn) { return vec4(0.0); }
vec3 unblockedRadiance(PathSample drawn) { return vec3(0.0); }
