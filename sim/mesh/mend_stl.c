/* Binary STL with colours of faces, of 5 bits a channel in the two bytes that
 * the format leaves free. Of a file whose head says COLOR=, Magics has made it:
 * red is lowest, and bit 15 set is the colour of the head, as are all faces
 * where none has a bit. Of others, VisCAM's: red is highest, and bit 15 clear
 * is no colour. */
#include "sim/mesh/mend.h"

#include <string.h>

#include "sim/cli/bytes.h"

enum { HEAD = 80, FACE = 50 };

static const unsigned char *face_at(const struct mend *m, size_t i)
{
    return (const unsigned char *)m->text + HEAD + 4 + FACE * i;
}

static size_t faces_of(const struct mend *m)
{
    const size_t n =
        m->size < HEAD + 4
            ? 0
            : bytes_little((const unsigned char *)m->text + HEAD, 4);
    return m->size >= HEAD + 4 && (m->size - HEAD - 4) / FACE >= n &&
                   (m->size - HEAD - 4) % FACE == 0
               ? n
               : 0;
}

static const unsigned char *color_of_head(const struct mend *m)
{
    const unsigned char *at = memmem(m->text, HEAD - 4, "COLOR=", 6);
    return at ? at + 6 : NULL;
}

bool mend_stl_wanted(struct mend *m)
{
    bool colored = false;
    const size_t n = faces_of(m);
    for (size_t i = 0; i < n && !colored; i++)
        colored = bytes_little(face_at(m, i) + 48, 2) >> 15;
    return n > 0 && (colored || color_of_head(m));
}

static void set_color(unsigned bits, bool red_lowest, double color[3])
{
    for (int k = 0; k < 3; k++) {
        const unsigned v = bits >> (red_lowest ? 5 * k : 10 - 5 * k) & 31;
        color[k] = (v << 3 | v >> 2) / 255.0;
    }
}

static void set_vector(const unsigned char *from, double to[3])
{
    for (int k = 0; k < 3; k++) {
        const uint32_t bits = bytes_little(from + 4 * k, 4);
        float value;
        memcpy(&value, &bits, sizeof(value));
        to[k] = (double)value;
    }
}

bool mend_stl(struct mend *m)
{
    const size_t n = faces_of(m);
    const unsigned char *head = color_of_head(m);
    bool any = false;
    mend_white(m);
    for (size_t i = 0; i < n; i++)
        any = any || bytes_little(face_at(m, i) + 48, 2);
    for (size_t i = 0; i < n; i++) {
        const unsigned char *from = face_at(m, i);
        const unsigned bits = bytes_little(from + 48, 2);
        struct mend_corner c = {.has_normal = true};
        set_vector(from, c.normal);
        set_color(bits, head, c.color);
        for (int k = 0; k < 3; k++) {
            if (head && (!any || bits >> 15))
                c.color[k] = head[k] / 255.0;
            if (!head && !(bits >> 15))
                c.color[k] = MEND_NO_COLOR;
        }
        for (int k = 1; k <= 3; k++) {
            set_vector(from + 12 * k, c.at);
            mend_corner(m, &c);
        }
        mend_face(m, 3, &c);
    }
    return true;
}
