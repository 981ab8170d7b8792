float drawnWeight(float density, float other) { return 1.0; }
