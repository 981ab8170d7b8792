uint holesSeed;
bool stopsRay(uint primitive, uint triangle, vec2 weights) { return true; }
