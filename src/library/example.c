/* A model's picture as a PAM file: example MODEL OUT.pam [OPTION VALUE]...
   cc example.c $(pkg-config --cflags --libs facet) -o example */
#include <facet.h>
#include <stdio.h>

static int wrong(facet_renderer* renderer, int status) {
  fprintf(stderr, "example: %s\n", facet_message(renderer));
  facet_close(renderer);
  return status;
}

int main(int argc, char** argv) {
  facet_renderer* renderer = NULL;
  facet_picture picture;
  if (argc < 3) return 2;
  int status = facet_open(0, &renderer);
  for (int i = 3; status == FACET_GOOD && i + 1 < argc; i += 2) status = facet_set(renderer, argv[i], argv[i + 1]);
  if (status == FACET_GOOD) status = facet_load(renderer, argv[1]);
  if (status == FACET_GOOD) status = facet_render(renderer, FACET_RGBA8, &picture);
  if (status != FACET_GOOD) return wrong(renderer, status);
  FILE* out = fopen(argv[2], "wb");
  if (!out) return 2;
  fprintf(out, "P7\nWIDTH %d\nHEIGHT %d\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n", picture.width,
          picture.height);
  fwrite(picture.pixels, 1, picture.bytes, out);
  facet_close(renderer);
  return fclose(out) == 0 ? 0 : 2;
}
