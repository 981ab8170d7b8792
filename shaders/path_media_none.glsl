vec3 mediumTransmittance(uint media, float distance) { return vec3(1.0); }
