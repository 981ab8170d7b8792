vec3 lookUpIrradiance(vec3 N) { return vec3(0.0); }
