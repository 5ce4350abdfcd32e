#include <stdlib.h>
#include <string.h>

#include "sim/mesh/mesh.h"
#include "sim/cli/message.h"

/* Of a vertex: all but the padding. */
enum { BYTES = offsetof(struct mesh_vertex, color) + sizeof(pel_color) };

/* FNV-1a. */
static uint32_t hash_of(const struct mesh_vertex *vertex)
{
    const unsigned char *byte = (const unsigned char *)vertex;
    uint32_t hash = 2166136261u;
    for (size_t i = 0; i < BYTES; i++)
        hash = (hash ^ byte[i]) * 16777619u;
    return hash ^ hash >> 15;
}

/* The slot of a vertex that is the same, from index `part` on, or a free one:
 * 0, else 1 more than its index. */
static uint32_t *slot_of(const struct mesh *mesh, uint32_t *table,
                         uint32_t mask, const struct mesh_vertex *vertex,
                         uint32_t part)
{
    uint32_t i = hash_of(vertex) & mask;
    while (table[i] && (table[i] <= part || memcmp(&mesh->vertex[table[i] - 1],
                                                   vertex, BYTES) != 0))
        i = (i + 1) & mask;
    return &table[i];
}

/* Of equal vertices of a part the first goes to the front; `to` has the new
 * indices. */
bool mesh_weld(struct mesh *mesh)
{
    const uint32_t before = mesh->vertices;
    uint32_t n = 0, first = 0, mask = 1;
    struct mesh_part *part = mesh->part;
    while (mask < 2 * before)
        mask = 2 * mask + 1;
    uint32_t *table = calloc((size_t)mask + 1, sizeof(*table));
    uint32_t *to = malloc(before * sizeof(*to));
    const bool done = table && to;
    for (uint32_t i = 0; done && i < before; i++) {
        for (; i == part->vertices; part++)
            part->vertices = first = n;
        uint32_t *slot = slot_of(mesh, table, mask, &mesh->vertex[i], first);
        if (!*slot) {
            mesh->vertex[n] = mesh->vertex[i];
            *slot = ++n;
        }
        to[i] = *slot - 1;
    }
    for (uint32_t i = 0; done && i < 3 * mesh->triangles; i++)
        mesh->triangle[i / 3][i % 3] = to[mesh->triangle[i / 3][i % 3]];
    if (done) {
        part->vertices = mesh->vertices = n;
        mesh->joined += before - n;
    }
    free(table);
    free(to);
    return done || message_error("no memory to join %u vertices", before);
}
