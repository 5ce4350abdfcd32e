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

/* Of equal vertices of a part moves the first to the front; `to` gets the new
 * indices. */
static uint32_t join(const struct mesh *mesh, uint32_t *table, uint32_t mask,
                     uint32_t *to)
{
    uint32_t n = 0, first = 0;
    struct mesh_part *part = mesh->part;
    for (uint32_t i = 0; i < mesh->vertices; i++) {
        for (; i == part->vertices; part++)
            part->vertices = first = n;
        uint32_t *slot = slot_of(mesh, table, mask, &mesh->vertex[i], first);
        if (!*slot) {
            mesh->vertex[n] = mesh->vertex[i];
            *slot = ++n;
        }
        to[i] = *slot - 1;
    }
    part->vertices = n;
    return n;
}

bool mesh_weld(struct mesh *mesh)
{
    uint32_t slots = 2;
    while (slots < 2 * mesh->vertices)
        slots *= 2;
    uint32_t *table = calloc(slots, sizeof(*table));
    uint32_t *to = malloc(mesh->vertices * sizeof(*to));
    const bool done = table && to;
    if (done) {
        const uint32_t before = mesh->vertices;
        mesh->vertices = join(mesh, table, slots - 1, to);
        mesh->joined += before - mesh->vertices;
        for (uint32_t i = 0; i < mesh->triangles; i++)
            for (int k = 0; k < 3; k++)
                mesh->triangle[i][k] = to[mesh->triangle[i][k]];
    }
    free(table);
    free(to);
    return done ||
           message_error("no memory to join %u vertices", mesh->vertices);
}
