/* OSMesa, OpenGL on the CPU: llvmpipe without threads of its own. Arrays of
 * triangles, one call for all; colours at vertices for linear gradients too. */
#define _POSIX_C_SOURCE 200809L
#include "method.h"

#include <stdlib.h>

#include <GL/osmesa.h>

enum { VERTICES = 6 }; /* of a quad; a triangle has 3 */

struct vertex {
    float x, y, u, v;
    GLubyte color[4];
};

struct job {
    OSMesaContext context;
    struct vertex *vertex;
    int vertices; /* of a shape */
};

static bool can_draw(const struct workload *w)
{
    if (w->form == FORM_SCREEN)
        return w->paint < PAINT_DITHERED;
    return (w->form == FORM_TRIANGLE || w->form == FORM_SLIVER ||
            w->form == FORM_COPY) &&
           w->paint != PAINT_KEYED;
}

/* The place of vertex (x, y) on the way of a linear gradient, 0 to 1. */
static double way_of(const struct shape *s, int x, int y)
{
    const double square = s->x[2] * s->x[2] + s->y[2] * s->y[2];
    return (x * s->x[2] + y * s->y[2]) / square;
}

static void set_color(const struct workload *w, const struct shape *s, int k,
                      struct vertex *v)
{
    const uint32_t from = s->color[w->paint == PAINT_GOURAUD ? k : 0];
    double t = 0;
    if (w->form == FORM_SCREEN)
        t = way_of(s, (int)v->x, (int)v->y);
    for (int i = 0; i < 3; i++) {
        const int a = from >> (16 - 8 * i) & 255;
        const int b = s->color[1] >> (16 - 8 * i) & 255;
        v->color[i] = (GLubyte)(a + (b - a) * t + .5);
    }
    v->color[3] = w->paint == PAINT_ALPHA ? WORKLOAD_ALPHA : 255;
}

static struct vertex vertex_of(const struct workload *w, const struct shape *s,
                               int k)
{
    static const int corner[VERTICES][2] = {{0, 0}, {1, 0}, {1, 1},
                                            {0, 0}, {1, 1}, {0, 1}};
    struct vertex v = {0};
    if (w->form == FORM_SCREEN || w->form == FORM_COPY) {
        v.u = (float)corner[k][0];
        v.v = (float)corner[k][1];
        v.x = (float)s->x[corner[k][0]];
        v.y = (float)s->y[corner[k][1]];
    } else {
        v.u = (float)(s->u[k] / TEXTURE_SIDE);
        v.v = (float)(s->v[k] / TEXTURE_SIDE);
        v.x = (float)s->x[k];
        v.y = (float)s->y[k];
    }
    set_color(w, s, k, &v);
    return v;
}

static void open_texture(const struct workload *w)
{
    const bool copy = w->form == FORM_COPY;
    const int side = copy ? SPRITE_SIDE : TEXTURE_SIDE;
    const GLint filter = w->paint == PAINT_BILINEAR ? GL_LINEAR : GL_NEAREST;
    glEnable(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glTexImage2D(GL_TEXTURE_2D, 0,
                 w->paint == PAINT_COPY_ALPHA ? GL_RGBA : GL_RGB, side, side, 0,
                 GL_BGRA, GL_UNSIGNED_BYTE,
                 copy ? workload_sprite(w->paint) : workload_texture());
}

static void set_state(const struct workload *w, const struct vertex *vertex)
{
    glViewport(0, 0, w->width, w->height);
    glOrtho(0, w->width, 0, w->height, -1, 1);
    glDisable(GL_DITHER);
    if (w->paint == PAINT_ALPHA || w->paint == PAINT_COPY_ALPHA)
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
    OSMesaPixelStore(OSMESA_Y_UP, 0);
}

static void *open_job(const struct workload *w, const struct canvas *c)
{
    if (!can_draw(w))
        return NULL;
    struct job *job = method_allocate(1, sizeof *job);
    open_context(job, c);
    job->vertices =
        w->form == FORM_SCREEN || w->form == FORM_COPY ? VERTICES : 3;
    job->vertex =
        method_allocate(w->count * job->vertices, sizeof *job->vertex);
    for (int i = 0; i < w->count * job->vertices; i++)
        job->vertex[i] =
            vertex_of(w, &w->shape[i / job->vertices], i % job->vertices);
    set_state(w, job->vertex);
    return job;
}

static void draw(void *data, int first, int n)
{
    const struct job *job = data;
    glDrawArrays(GL_TRIANGLES, first * job->vertices, n * job->vertices);
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
