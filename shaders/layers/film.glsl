// KHR_materials_iridescence: a thin film changes the Fresnel terms of the base's lobes.
#include "iridescence.glsl"

struct Film {
  float weight;
  float ior;
  float thicknessNm;
  vec3 dielectricF0, metalF0;  // Schlick's curve through the filmed reflectance at NoV, for the albedos
  vec3 dielectricBound;        // the largest such f0 over the angles of a lobe: what is below gets no more than is left
};

const bool filmColors = true;

// The film is colourless as a whole: what a channel gains above 1 is Gaussians' overshoot.
vec3 filmReflectance(Film film, float cosine, vec3 f0) {
  return min(F_ThinFilm(cosine, 1.0, film.ior, film.thicknessNm, f0), 1.0);
}

// Of the dielectric's f0 and f90 and the metal's f0 without it.
void setFilm(inout Film film, float weight, float ior, float thicknessNm, float NoV, vec3 dielectricF0, float f90,
             vec3 metalF0) {
  film.weight = weight;
  film.ior = ior;
  film.thicknessNm = thicknessNm;
  vec3 dielectric = f0FromSchlick(filmReflectance(film, NoV, dielectricF0 / max(f90, 1e-6)), NoV) * f90;
  vec3 metal = f0FromSchlick(filmReflectance(film, NoV, metalF0), NoV);
  film.dielectricF0 = mix(dielectricF0, dielectric, weight);
  film.metalF0 = mix(metalF0, metal, weight);
  vec3 largest = dielectric;
  for (float cosine = 1.0; cosine > 0.4; cosine -= 0.125) {
    vec3 F = filmReflectance(film, cosine, dielectricF0 / max(f90, 1e-6));
    largest = max(largest, f0FromSchlick(F, cosine) * f90);
  }
  film.dielectricBound = mix(dielectricF0, largest, weight);
}

// F: the Fresnel term without it, of that f0 and f90.
vec3 filmedDielectric(Film film, float VoH, vec3 F, vec3 f0, float f90) {
  return mix(F, f90 * filmReflectance(film, VoH, f0 / max(f90, 1e-6)), film.weight);
}
vec3 filmedMetal(Film film, float VoH, vec3 F, vec3 f0) { return mix(F, filmReflectance(film, VoH, f0), film.weight); }

// The f0 that albedos are reckoned with; f0: that without it.
vec3 filmedDielectricF0(Film film, vec3 f0) { return film.dielectricF0; }
vec3 filmedDielectricBound(Film film, vec3 f0) { return film.dielectricBound; }
vec3 filmedMetalF0(Film film, vec3 f0) { return film.metalF0; }
