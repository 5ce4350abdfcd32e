#include "sim/mesh/pel2d.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LIMB INT64_C(1000000000000000000)
#define ZEROS "000000000000000000"

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
    char limbs[3][19] = {ZEROS, ZEROS, ZEROS}; /* as text */
    long exponent;
    if (whole == 0 || (*rest == '.' && fraction == 0))
        return false;
    if (!parse_exponent(rest + (fraction ? fraction + 1 : 0), &exponent))
        return false;
    long place = 18 - (long)whole - exponent; /* behind the first digit */
    for (const char *c = first; c < rest + (fraction ? fraction + 1 : 0); c++) {
        if (*c >= '1' && *c <= '9' && (place < 0 || place >= 54))
            return false;
        if (*c >= '1' && *c <= '9')
            limbs[place / 18][place % 18] = *c;
        place += *c != '.';
    }
    for (int i = 0; i < 3; i++)
        depth->limb[i] = atoll(limbs[i]) * (*text == '-' ? -1 : 1);
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
