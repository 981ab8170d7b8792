#ifndef FACET_H
#define FACET_H

/* facet as a library: models and settings in, pixels out, the same as `facet render` writes. What goes wrong is a
   status and a sentence; nothing here ends the program, writes to the terminal, or touches the caller's OpenGL.

   A renderer draws on a thread of its own. Any thread may call; calls on one renderer wait for each other. Texts and
   pixels that are returned stay until the next call on their renderer but for those that only ask (const). */

#include <stddef.h>

#if defined(__GNUC__)
#define FACET_API __attribute__((visibility("default")))
#else
#define FACET_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Grows when something is added here; what is here stays as it is. */
#define FACET_INTERFACE 1

enum { /* statuses, as the command exits with */
       FACET_GOOD = 0,
       FACET_BAD_INPUT = 2, /* a file, an option, a value; also memory or the driver gave out */
       FACET_NO_OPENGL = 3  /* no usable OpenGL */
};

enum {                      /* formats */
       FACET_RGBA8 = 0,     /* what one sees: 4 bytes a pixel, sRGB, straight alpha; the bytes of the PNG */
       FACET_RGBA_FLOAT = 1 /* scene-linear radiance: 4 floats a pixel, Rec. 709, associated alpha; those of the EXR */
};

enum {                    /* flags of facet_open */
       FACET_NO_CACHE = 1 /* neither reads nor writes the caches of compiled shaders and of light tables */
};

typedef struct facet_renderer facet_renderer;

typedef struct facet_picture {
  int width, height, format;
  size_t bytes;       /* of all pixels */
  const void* pixels; /* row by row, the top one first, without gaps */
} facet_picture;

FACET_API const char* facet_version(void); /* "0.1.0" */
FACET_API int facet_interface(void);       /* FACET_INTERFACE of the library that was loaded */

/* Starts OpenGL without a window (EGL). After an error *renderer is there, too, unless memory gave out: it says why,
   and is to be closed. flags: 0 or FACET_NO_CACHE. */
FACET_API int facet_open(unsigned flags, facet_renderer** renderer);
FACET_API void facet_close(facet_renderer* renderer); /* NULL is fine */

/* Reads a .gltf or .glb file, or "builtin:NAME". Options say how ("bump", "allow-outside"), as far as they are set by
   then. After an error there is no model. */
FACET_API int facet_load(facet_renderer* renderer, const char* model);

/* An option of `facet render` by its name without dashes, with the text that the command line takes: "size", "640x480";
   "env", "studio.hdr"; "ground", "true". NULL: as if it had not been given. */
FACET_API int facet_set(facet_renderer* renderer, const char* option, const char* value);

/* Draws the model. */
FACET_API int facet_render(facet_renderer* renderer, int format, facet_picture* picture);

/* What went wrong in the last call, in one sentence; empty where nothing did. */
FACET_API const char* facet_message(const facet_renderer* renderer);
/* Of the last call: where what is shown differs from what was asked for. NULL where there are no more. */
FACET_API const char* facet_warning(const facet_renderer* renderer, size_t index);
/* The line for a shell that makes the last picture: "facet render helmet.glb -o picture.png --size 640x480". */
FACET_API const char* facet_command(const facet_renderer* renderer);

/* All options, in their order. NULL where there are no more. */
FACET_API const char* facet_option_name(size_t index);
FACET_API const char* facet_option_help(size_t index);

#ifdef __cplusplus
}
#endif

#endif
