/* Accessors (chapter 3.6.2). */
#include "sim/mesh/gltf.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/bytes.h"

enum kind { BYTE = 5120, UBYTE, SHORT, USHORT, UINT = 5125, FLOAT };

static int bytes_of(json_int_t kind)
{
    return kind == BYTE || kind == UBYTE     ? 1
           : kind == SHORT || kind == USHORT ? 2
           : kind == UINT || kind == FLOAT   ? 4
                                             : 0;
}

static bool is_index(json_int_t kind)
{
    return kind == UBYTE || kind == USHORT || kind == UINT;
}

static int components_of(const char *type)
{
    static const struct {
        const char *name;
        int n;
    } types[] = {
        {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
    for (int i = 0; type && i < 5; i++)
        if (strcmp(type, types[i].name) == 0)
            return types[i].n;
    return 0;
}

/* Signed ones have one value less than they could: -128 is -127. */
static double number_at(const uint8_t *at, json_int_t kind, bool normalized)
{
    const uint32_t v = bytes_little(at, bytes_of(kind));
    float real;
    switch (kind) {
    case BYTE:
        return normalized ? fmax((int8_t)v / 127.0, -1) : (int8_t)v;
    case SHORT:
        return normalized ? fmax((int16_t)v / 32767.0, -1) : (int16_t)v;
    case UBYTE:
        return normalized ? v / 255.0 : v;
    case USHORT:
        return normalized ? v / 65535.0 : v;
    case FLOAT:
        memcpy(&real, &v, sizeof(real));
        return (double)real;
    default:
        return v;
    }
}

/* Elements of `components` numbers, from some bytes of a view. */
struct elements {
    json_int_t view, kind;
    double offset, stride; /* bytes; 0: packed */
    size_t count;
    int components;
    bool normalized;
};

static double stride_of(const struct elements *e)
{
    return e->stride > 0 ? e->stride
                         : (double)(e->components * bytes_of(e->kind));
}

static const uint8_t *find_bytes(struct gltf *g, const struct elements *e)
{
    return gltf_view(g, e->view, e->offset,
                     stride_of(e) * (double)(e->count - 1) +
                         (double)(e->components * bytes_of(e->kind)));
}

static bool read(struct gltf *g, const struct elements *e, double *to)
{
    const size_t stride = (size_t)stride_of(e);
    const uint8_t *at = find_bytes(g, e);
    for (size_t i = 0; at && i < e->count; i++)
        for (int k = 0; k < e->components; k++)
            to[i * (size_t)e->components + (size_t)k] =
                number_at(at + stride * i + k * bytes_of(e->kind), e->kind,
                          e->normalized);
    return at;
}

/* A few elements, by their indices, in place of others. */
static bool read_sparse(struct gltf *g, const json_t *sparse,
                        const struct elements *all, double *to)
{
    const json_t *indices = json_object_get(sparse, "indices");
    const json_t *values = json_object_get(sparse, "values");
    const double count = gltf_size(g, sparse, "count");
    if (!(count >= 1 && count <= (double)all->count))
        return gltf_refuse_in(
            g, sparse,
            "a sparse accessor has %g elements: expected 1 to "
            "%zu",
            count, all->count);
    struct elements e = {.view = gltf_index(g, indices, "bufferView"),
                         .kind = gltf_index(g, indices, "componentType"),
                         .offset = gltf_size(g, indices, "byteOffset"),
                         .count = (size_t)count,
                         .components = 1};
    const size_t n = (size_t)all->components;
    double *index = malloc(e.count * sizeof(*index));
    double *value = malloc(e.count * n * sizeof(*value));
    if (!index || !value)
        gltf_refuse(g, "no memory for %zu numbers", e.count);
    else if (!is_index(e.kind))
        gltf_refuse_in(g, sparse,
                       "a sparse accessor has indices of componentType %lld: "
                       "expected 5121, 5123 or 5125",
                       (long long)e.kind);
    bool good = g->good && read(g, &e, index);
    e = *all;
    e.count = (size_t)count;
    e.stride = 0;
    e.view = gltf_index(g, values, "bufferView");
    e.offset = gltf_size(g, values, "byteOffset");
    good = good && read(g, &e, value);
    for (size_t i = 0; good && i < e.count; i++) {
        if (index[i] >= (double)all->count)
            good = gltf_refuse_in(g, sparse,
                                  "a sparse accessor has the index %.0f: "
                                  "expected less than %zu",
                                  index[i], all->count);
        else
            memcpy(to + (size_t)index[i] * n, value + i * n,
                   n * sizeof(*value));
    }
    free(index);
    free(value);
    return good;
}

bool gltf_accessor(struct gltf *g, json_int_t index, struct gltf_array *array)
{
    const json_t *object = gltf_at(g, "accessors", index);
    const json_t *sparse = json_object_get(object, "sparse");
    const double count = gltf_size(g, object, "count");
    struct elements e = {
        .view = gltf_index(g, object, "bufferView"),
        .kind = gltf_index(g, object, "componentType"),
        .offset = gltf_size(g, object, "byteOffset"),
        .components =
            components_of(json_string_value(json_object_get(object, "type"))),
        .normalized = json_is_true(json_object_get(object, "normalized"))};
    if (!g->good)
        return false;
    if (!bytes_of(e.kind) || !e.components || !(count >= 1 && count <= 1 << 28))
        return gltf_refuse(g,
                           "accessors[%lld] has no legal type, componentType "
                           "or count: expected such as VEC3, 5126, 1 to 2^28",
                           (long long)index);
    e.count = (size_t)count;
    if (e.view >= 0)
        e.stride =
            gltf_size(g, gltf_at(g, "bufferViews", e.view), "byteStride");
    if (!g->good || (e.view >= 0 && !find_bytes(g, &e)))
        return false; /* before memory is taken for them */
    array->count = e.count;
    array->components = e.components;
    array->number = calloc(e.count * (size_t)e.components, sizeof(double));
    if (!array->number)
        return gltf_refuse(g, "no memory for %zu numbers", e.count);
    return (e.view < 0 || read(g, &e, array->number)) &&
           (!sparse || read_sparse(g, sparse, &e, array->number));
}

bool gltf_indices(struct gltf *g, json_int_t index, struct gltf_array *array)
{
    const json_t *object = gltf_at(g, "accessors", index);
    const char *type = json_string_value(json_object_get(object, "type"));
    if (g->good && is_index(gltf_index(g, object, "componentType")) &&
        components_of(type) == 1 &&
        !json_is_true(json_object_get(object, "normalized")))
        return gltf_accessor(g, index, array);
    return gltf_refuse(g,
                       "accessors[%lld] has no indices: expected SCALAR of "
                       "componentType 5121, 5123 or 5125, not normalized",
                       (long long)index);
}
