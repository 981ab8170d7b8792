void gather(inout PathState p, vec3 radiance, float broad) { p.radiance.rgb += radiance; }
void gatherLight(inout PathState p, vec3 radiance, float broad, bool first) { p.radiance.rgb += radiance; }
