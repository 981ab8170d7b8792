float sheenChance(Surface s) { return 0.0; }
float densityOfSheen(vec3 local) { return 0.0; }
void drawSheen(Surface s, vec2 u, inout LobeFrame at, inout LobeSample drawn) {}
