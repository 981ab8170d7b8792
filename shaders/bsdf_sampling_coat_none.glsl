float coatChance(Surface s) { return 0.0; }
float densityOfCoat(Surface s, vec3 L) { return 0.0; }
void drawCoat(Surface s, vec2 u, inout LobeFrame at, inout LobeSample drawn) {}
