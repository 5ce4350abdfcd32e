/* The characters of a font's codes. */
#ifndef SIM_FONT_CHARSET_H
#define SIM_FONT_CHARSET_H

#include <iconv.h>
#include <stdbool.h>
#include <stdint.h>

struct charset {
    iconv_t convert;
    bool as_is;      /* codes are those of Unicode */
    unsigned add;    /* to a code of two bytes, as iconv has it */
    bool is_lead_8f; /* a byte 0x8F comes before them */
    unsigned lost;   /* codes that are no character */
};

/* `name` as X11 names it, koi8-r, jisx0208.1983-0, or as iconv does; unicode,
 * and "", are Unicode itself. False, with a message that names the file, when
 * nobody knows it. */
bool charset_open(struct charset *charset, const char *name, const char *path);
void charset_close(struct charset *charset);

/* The end of a long X11 name, which is the encoding; "" of another name. */
const char *charset_of_name(const char *name);

/* The character of a code, or -1, which is counted. */
long charset_code(struct charset *charset, uint32_t code);

/* Tells how many there were, if any. */
void charset_report(const struct charset *charset, const char *path);

#endif
