void seeGround(inout PathState p, bool background, inout vec3 share) {}
