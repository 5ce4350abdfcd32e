/* OSMesa, OpenGL on the CPU: llvmpipe without threads of its own. Arrays of
 * triangles, one call for all. */
#define _POSIX_C_SOURCE 200809L
#include "method.h"

#include <stdlib.h>

#include <GL/osmesa.h>

struct vertex {
    float x, y, u, v;
    GLubyte color[4];
};

struct job {
    OSMesaContext context;
    struct vertex *vertex;
};

static struct vertex vertex_of(const struct workload *w, const struct shape *s,
                               int k)
{
    const uint32_t color = s->color[w->paint == PAINT_GOURAUD ? k : 0];
    return (struct vertex){(float)s->x[k],
                           (float)s->y[k],
                           (float)(s->u[k] / TEXTURE_SIDE),
                           (float)(s->v[k] / TEXTURE_SIDE),
                           {(GLubyte)(color >> 16), (GLubyte)(color >> 8),
                            (GLubyte)color,
                            w->paint == PAINT_ALPHA ? WORKLOAD_ALPHA : 255}};
}

static void open_texture(const struct workload *w)
{
    const GLint filter = w->paint == PAINT_BILINEAR ? GL_LINEAR : GL_NEAREST;
    glEnable(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, TEXTURE_SIDE, TEXTURE_SIDE, 0,
                 GL_BGRA, GL_UNSIGNED_BYTE, workload_texture());
}

static void set_state(const struct workload *w, const struct vertex *vertex)
{
    glViewport(0, 0, w->width, w->height);
    glOrtho(0, w->width, 0, w->height, -1, 1);
    glDisable(GL_DITHER);
    if (w->paint == PAINT_ALPHA)
        glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    if (w->paint >= PAINT_NEAREST)
        open_texture(w);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glVertexPointer(2, GL_FLOAT, sizeof *vertex, &vertex->x);
    glTexCoordPointer(2, GL_FLOAT, sizeof *vertex, &vertex->u);
    glColorPointer(4, GL_UNSIGNED_BYTE, sizeof *vertex, vertex->color);
}

static void open_context(struct job *job, const struct canvas *c)
{
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    setenv("LP_NUM_THREADS", "0", 1);
    const GLenum format = c->bits == 32 ? OSMESA_BGRA : OSMESA_RGB_565;
    const GLenum type =
        c->bits == 32 ? GL_UNSIGNED_BYTE : GL_UNSIGNED_SHORT_5_6_5;
    job->context = OSMesaCreateContextExt(format, 0, 0, 0, NULL);
    if (!job->context ||
        !OSMesaMakeCurrent(job->context, c->pixels, type, c->width, c->height))
        method_fail("OSMesa refuses the canvas", "check its installation");
}

static void *open_job(const struct workload *w, const struct canvas *c)
{
    if ((w->form != FORM_TRIANGLE && w->form != FORM_SLIVER) ||
        w->paint == PAINT_SMOOTH)
        return NULL;
    struct job *job = method_allocate(1, sizeof *job);
    open_context(job, c);
    job->vertex = method_allocate(w->count * 3, sizeof *job->vertex);
    for (int i = 0; i < w->count * 3; i++)
        job->vertex[i] = vertex_of(w, &w->shape[i / 3], i % 3);
    set_state(w, job->vertex);
    return job;
}

/* The context is current as long as the job is open. */
static void draw(void *data, int first, int n)
{
    (void)data;
    glDrawArrays(GL_TRIANGLES, first * 3, n * 3);
    glFinish();
}

static void close_job(void *data)
{
    struct job *job = data;
    OSMesaDestroyContext(job->context);
    free(job->vertex);
    free(job);
}

extern const struct method method_osmesa;
const struct method method_osmesa = {"osmesa", "packaged", open_job, draw,
                                     close_job};
