#include "sim/mesh/mend.h"

void mend_white(struct mend *m)
{
    fputs("newmtl white\nKd 1 1 1\n", m->mtl);
    fputs("mtllib pel.mtl\nusemtl white\n", m->obj);
}

void mend_corner(struct mend *m, const struct mend_corner *c)
{
    fprintf(m->obj, "v %.9g %.9g %.9g", c->at[0], c->at[1], c->at[2]);
    if (!m->colorless)
        fprintf(m->obj, " %.9g %.9g %.9g", c->color[0], c->color[1],
                c->color[2]);
    fputc('\n', m->obj);
    if (c->has_uv)
        fprintf(m->obj, "vt %.9g %.9g\n", c->uv[0], c->uv[1]);
    if (c->has_normal)
        fprintf(m->obj, "vn %.9g %.9g %.9g\n", c->normal[0], c->normal[1],
                c->normal[2]);
}

void mend_face(struct mend *m, long corners, const struct mend_corner *like)
{
    fputc('f', m->obj);
    for (long i = -corners; i < 0; i++) {
        fprintf(m->obj, " %ld", i);
        if (like->has_uv)
            fprintf(m->obj, "/%ld", i);
        if (like->has_normal)
            fprintf(m->obj, "%s/%ld", like->has_uv ? "" : "/", i);
    }
    fputc('\n', m->obj);
}
