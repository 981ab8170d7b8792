struct Film {
  bool none;
};

const bool filmColors = false;

void setFilm(inout Film film, float weight, float ior, float thicknessNm, float NoV, vec3 dielectricF0, float f90,
             vec3 metalF0) {}
vec3 filmedDielectric(Film film, float VoH, vec3 F, vec3 f0, float f90) { return F; }
vec3 filmedMetal(Film film, float VoH, vec3 F, vec3 f0) { return F; }
vec3 filmedDielectricF0(Film film, vec3 f0) { return f0; }
vec3 filmedDielectricBound(Film film, vec3 f0) { return f0; }
vec3 filmedMetalF0(Film film, vec3 f0) { return f0; }
