// The sampler does what there is to do.
vec4 readTexture(sampler2D image, vec2 uv, float mostStretch) { return texture(image, uv); }
