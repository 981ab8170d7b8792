// A library that is loaded before all others and makes the OpenGL driver fail as FACET_GL_FAULT says: "KIND N" is about
// the N-th call, from 1 on. What is not about N goes to the driver.
//   textures  this storage of a texture, and all that follow, cannot be had: GL_OUT_OF_MEMORY
//   buffers   likewise of buffers
//   targets   likewise of what is drawn into: depth, and pictures of several samples
//   once      the storage of this texture alone
//   reset     glFinish: the GPU is reset, and the context is lost for good
//   hang      glFinish never returns
// With a file FACET_GL_FAULT_WHILE only calls while that exists count. EGL and GLX alike.

#define _GNU_SOURCE
#include <GL/gl.h>
#include <GL/glext.h>
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void* (*realDlsym)(void*, const char*);
static void* (*realGetProcAddress)(const char*);  // EGL's or GLX's

static char kind[16];
static int first, counted, outOfMemory, lost;

static int isKind(const char* name) {
  if (kind[0] == 0) {
    const char* said = getenv("FACET_GL_FAULT");
    if (!said || sscanf(said, "%15s %d", kind, &first) != 2) strcpy(kind, "none");
  }
  return strcmp(kind, name) == 0;
}

// Whether this call of the kind fails.
static int counts(const char* name) {
  const char* file = isKind(name) ? getenv("FACET_GL_FAULT_WHILE") : NULL;
  return isKind(name) && (!file || access(file, F_OK) == 0) && ++counted;
}
static int fails(const char* name) { return counts(name) && counted >= first; }
static int noTexture(void) {
  const int none = fails("textures") || (counts("once") && counted == first);
  outOfMemory |= none;
  return none;
}
static int noTarget(void) {
  const int none = fails("targets");
  outOfMemory |= none;
  return none;
}

#define REAL(type, name) ((type)realGetProcAddress(name))

static void textureStorage2D(GLuint t, GLsizei levels, GLenum format, GLsizei width, GLsizei height) {
  if (!(format == GL_DEPTH_COMPONENT32F && noTarget()) && !noTexture())
    REAL(PFNGLTEXTURESTORAGE2DPROC, "glTextureStorage2D")(t, levels, format, width, height);
}
static void textureStorage3D(GLuint t, GLsizei levels, GLenum format, GLsizei width, GLsizei height, GLsizei depth) {
  if (!noTexture()) REAL(PFNGLTEXTURESTORAGE3DPROC, "glTextureStorage3D")(t, levels, format, width, height, depth);
}
static void textureStorage2DMultisample(GLuint t, GLsizei samples, GLenum format, GLsizei width, GLsizei height,
                                        GLboolean fixed) {
  if (!noTarget() && !noTexture()) REAL(PFNGLTEXTURESTORAGE2DMULTISAMPLEPROC, "glTextureStorage2DMultisample")
  (t, samples, format, width, height, fixed);
}
static void namedBufferStorage(GLuint b, GLsizeiptr size, const void* data, GLbitfield flags) {
  if (fails("buffers"))
    outOfMemory = 1;
  else
    REAL(PFNGLNAMEDBUFFERSTORAGEPROC, "glNamedBufferStorage")(b, size, data, flags);
}
static GLenum getError(void) {
  if (lost) return GL_CONTEXT_LOST;
  const int memory = outOfMemory;
  outOfMemory = 0;
  // What follows from it is not told.
  const GLenum real = REAL(GLenum(*)(void), "glGetError")();
  return memory ? GL_OUT_OF_MEMORY : real;
}
static GLenum getGraphicsResetStatus(void) { return lost ? GL_UNKNOWN_CONTEXT_RESET : GL_NO_ERROR; }
static void finish(void) {
  if (fails("reset")) lost = 1;
  if (fails("hang"))
    for (;;) pause();
  REAL(void (*)(void), "glFinish")();
}

static void* ours(const char* name) {
  if (strcmp(name, "glTextureStorage2D") == 0) return (void*)textureStorage2D;
  if (strcmp(name, "glTextureStorage3D") == 0) return (void*)textureStorage3D;
  if (strcmp(name, "glTextureStorage2DMultisample") == 0) return (void*)textureStorage2DMultisample;
  if (strcmp(name, "glNamedBufferStorage") == 0) return (void*)namedBufferStorage;
  if (strcmp(name, "glGetError") == 0) return (void*)getError;
  if (strcmp(name, "glGetGraphicsResetStatus") == 0) return (void*)getGraphicsResetStatus;
  if (strcmp(name, "glFinish") == 0) return (void*)finish;
  return NULL;
}

static int finds(const char* name) {
  return strcmp(name, "eglGetProcAddress") == 0 || strcmp(name, "glXGetProcAddress") == 0 ||
         strcmp(name, "glXGetProcAddressARB") == 0;
}
static void* getProcAddress(const char* name) {
  void* const found = finds(name) ? (void*)getProcAddress : ours(name);
  return found ? found : realGetProcAddress(name);
}

// libepoxy, through which facet calls OpenGL, finds all of it so.
void* dlsym(void* handle, const char* name) {
  if (!realDlsym) {
    realDlsym = dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.34");
    if (!realDlsym) realDlsym = dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.2.5");
    if (!realDlsym) realDlsym = dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.17");
  }
  void* const found = realDlsym(handle, name);
  if (found && finds(name)) {
    realGetProcAddress = found;
    return (void*)getProcAddress;
  }
  if (found && realGetProcAddress && ours(name)) return ours(name);
  return found;
}
