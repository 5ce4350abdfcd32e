#include "sim/font/charset.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "sim/cli/bytes.h"
#include "sim/cli/message.h"

/* How X11 names what iconv knows by another name. */
static const struct {
    const char *begins;
    const char *name; /* of iconv, with what follows for %s; NULL: Unicode */
    unsigned add;
    bool is_lead_8f;
} names[] = {
    {"iso10646", NULL, 0, false},
    {"unicode", NULL, 0, false},
    {"iso8859-", "ISO-8859-%s", 0, false},
    {"iso646", "ASCII", 0, false},
    {"us-ascii", "ASCII", 0, false},
    {"jisx0201", "SHIFT_JIS", 0, false}, /* its single bytes */
    {"jisx0208", "EUC-JP", 0x8080, false},
    {"jisx0212", "EUC-JP", 0x8080, true},
    {"jisx0213", "EUC-JISX0213", 0x8080, false},
    {"gb2312", "EUC-CN", 0x8080, false},
    {"gbk", "GBK", 0, false},
    {"gb18030", "GB18030", 0, false},
    {"big5", "BIG5", 0, false},
    {"ksc5601", "EUC-KR", 0x8080, false},
    {"ksx1001", "EUC-KR", 0x8080, false},
    {"tis620", "TIS-620", 0, false},
    {"viscii", "VISCII", 0, false},
};

bool charset_open(struct charset *charset, const char *name, const char *path)
{
    char of_iconv[64];
    size_t i = 0;
    const size_t count = sizeof names / sizeof *names;
    *charset = (struct charset){.convert = (iconv_t)-1};
    while (i < count &&
           strncasecmp(name, names[i].begins, strlen(names[i].begins)) != 0)
        i++;
    charset->as_is = !*name || (i < count && !names[i].name) ||
                     strcasecmp(name, "iso8859-1") == 0;
    if (charset->as_is)
        return true;
    if (i < count) {
        charset->add = names[i].add;
        charset->is_lead_8f = names[i].is_lead_8f;
        snprintf(of_iconv, sizeof of_iconv, names[i].name,
                 name + strlen(names[i].begins));
    } else
        snprintf(of_iconv, sizeof of_iconv, "%s", name);
    charset->convert = iconv_open("UTF-32LE", of_iconv);
    const char *part = strchr(name, '-'); /* paratype-pt154, ibm-cp437 */
    if (charset->convert == (iconv_t)-1 && part && isalpha((uint8_t)part[1]))
        charset->convert = iconv_open("UTF-32LE", part + 1);
    return charset->convert != (iconv_t)-1 ||
           message_error_at(path, 0,
                            "the font is encoded in %s, which iconv does not "
                            "know: expected --encoding NAME, such as koi8-r, "
                            "or unicode for its codes as they are",
                            name);
}

const char *charset_of_name(const char *name)
{
    for (int i = 0; i < 13; i++) {
        name = strchr(name, '-');
        if (!name++)
            return "";
    }
    return name;
}

void charset_close(struct charset *charset)
{
    if (charset->convert != (iconv_t)-1)
        iconv_close(charset->convert);
    charset->convert = (iconv_t)-1;
}

long charset_code(struct charset *charset, uint32_t code)
{
    char from[3], *in = from;
    uint8_t to[8];
    char *out = (char *)to;
    size_t room = sizeof to, left;
    if (charset->as_is)
        return (long)code;
    if (code > 0xFF) {
        if (charset->is_lead_8f)
            *in++ = (char)0x8F;
        *in++ = (char)((code + charset->add) >> 8);
    }
    *in++ = (char)(code + (code > 0xFF ? charset->add : 0));
    left = (size_t)(in - from);
    in = from;
    if (code <= 0xFFFF &&
        iconv(charset->convert, &in, &left, &out, &room) == 0 && left == 0 &&
        room == sizeof to - 4)
        return (long)bytes_little(to, 4);
    iconv(charset->convert, NULL, NULL, NULL, NULL);
    charset->lost++;
    return -1;
}

void charset_report(const struct charset *charset, const char *path)
{
    if (charset->lost > 0)
        message_error_at(path, 0,
                         "%u glyphs are no character of the font's encoding "
                         "and are left out",
                         charset->lost);
}
