float passingDensity(PathState p, PathSurface at, vec3 L, float density) { return density; }
#ifdef HAS_ENVIRONMENT
vec3 radianceFromAfar(PathState p, PathSurface at, vec3 L) { return environmentRadiance(L); }
#endif
