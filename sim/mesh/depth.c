#include "sim/mesh/depth.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LIMB INT64_C(1000000000000000000)

/* Adds digit 10^place. */
static bool place_digit(struct mesh_depth *depth, int digit, long place)
{
    int64_t weight = 1;
    if (digit == 0)
        return true;
    if (place >= 18 || place < -36)
        return false;
    int i = place >= 0 ? 0 : place >= -18 ? 1 : 2;
    for (long n = place + 18 * i; n > 0; n--)
        weight *= 10;
    depth->limb[i] += digit * weight;
    return true;
}

/* The exponent at `text`, the end of the number, or 0; false when what stands
 * there is no exponent of at most four digits. */
static bool parse_exponent(const char *text, long *exponent)
{
    char *end;
    *exponent = 0;
    if (*text == '\0')
        return true;
    size_t digits = strspn(text + 1 + strspn(text + 1, "+-"), "0123456789");
    if ((*text != 'e' && *text != 'E') || digits < 1 || digits > 4)
        return false;
    *exponent = strtol(text + 1, &end, 10);
    return end != text + 1 && *end == '\0';
}

bool mesh_depth_parse(const char *text, struct mesh_depth *depth)
{
    const char *first = text + (*text == '-' || *text == '+');
    size_t whole = strspn(first, "0123456789");
    const char *rest = first + whole;
    size_t fraction = *rest == '.' ? strspn(rest + 1, "0123456789") : 0;
    long exponent;
    memset(depth, 0, sizeof(*depth));
    if (whole == 0 || (*rest == '.' && fraction == 0))
        return false;
    if (!parse_exponent(rest + (fraction ? fraction + 1 : 0), &exponent))
        return false;
    long place = (long)whole - 1 + exponent;
    for (const char *c = first; c < rest + (fraction ? fraction + 1 : 0); c++)
        if (*c != '.' && !place_digit(depth, *c - '0', place--))
            return false;
    if (*text == '-')
        for (int i = 0; i < 3; i++)
            depth->limb[i] = -depth->limb[i];
    return true;
}

void mesh_depth_format(const struct mesh_depth *depth,
                       char text[MESH_DEPTH_TEXT])
{
    const int64_t *limb = depth->limb;
    bool negative = limb[0] < 0 || limb[1] < 0 || limb[2] < 0;
    int n =
        snprintf(text, MESH_DEPTH_TEXT,
                 "%s%" PRId64 ".%018" PRId64 "%018" PRId64, negative ? "-" : "",
                 imaxabs(limb[0]), imaxabs(limb[1]), imaxabs(limb[2]));
    while (text[n - 1] == '0')
        n--;
    text[text[n - 1] == '.' ? n - 1 : n] = '\0';
}

struct mesh_depth mesh_depth_sum(const struct mesh_depth *a,
                                 const struct mesh_depth *b,
                                 const struct mesh_depth *c)
{
    struct mesh_depth sum;
    for (int i = 0; i < 3; i++)
        sum.limb[i] = a->limb[i] + b->limb[i] + c->limb[i];
    for (int i = 2; i > 0; i--) { /* the lower limbs into 0..LIMB-1 */
        int64_t carry = sum.limb[i] / LIMB - (sum.limb[i] % LIMB < 0);
        sum.limb[i] -= carry * LIMB;
        sum.limb[i - 1] += carry;
    }
    return sum;
}

int mesh_depth_compare(const struct mesh_depth *a, const struct mesh_depth *b)
{
    for (int i = 0; i < 3; i++)
        if (a->limb[i] != b->limb[i])
            return a->limb[i] < b->limb[i] ? -1 : 1;
    return 0;
}
