/* mutate FROM TO SEED: a copy of a file with a few changes: bytes, bits,
 * numbers, parts that are lost, doubled or moved, and an early end. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 1 << 20 };

static unsigned char bytes[MOST];
static size_t size;
static unsigned long seed;

static size_t any(size_t n)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return n ? (size_t)(seed >> 33) % n : 0;
}

static void put(size_t at, const void *from, size_t n)
{
    if (n < MOST - size && at <= size) {
        memmove(bytes + at + n, bytes + at, size - at);
        memcpy(bytes + at, from, n);
        size += n;
    }
}

static void change(void)
{
    static const char *const texts[] = {
        "-1",   "99999999999", "1e400",     "nan", "\n",
        "0",    "\x1B[2J",     "%s%n",      "/",   "{[",
        "\"\\", "\xFF\xFE",    "4294967295"};
    unsigned char part[256];
    const size_t at = any(size), n = 1 + any(any(4) ? 8 : 255);
    const size_t some = n < size - at ? n : size - at;
    const char *text = texts[any(sizeof(texts) / sizeof(*texts))];
    memcpy(part, bytes + at, some);
    switch (any(7)) {
    case 0:
        bytes[at] ^= (unsigned char)(1 << any(8));
        break;
    case 1:
        bytes[at] = (unsigned char)any(256);
        break;
    case 2:
        memset(bytes + at, any(2) ? 0 : 255, some < 4 ? some : 4);
        break;
    case 3:
        put(at, text, strlen(text));
        break;
    case 4:
        put(any(size), part, some);
        break;
    case 5:
        memmove(bytes + at, bytes + at + some, size - at - some);
        size -= some;
        break;
    default:
        if (any(8) == 0)
            size = at;
        else
            bytes[at] = (unsigned char)('0' + any(10));
    }
}

int main(int argc, char **argv)
{
    FILE *from = argc == 4 ? fopen(argv[1], "rb") : NULL;
    FILE *to = from ? fopen(argv[2], "wb") : NULL;
    if (!to)
        return 1;
    size = fread(bytes, 1, MOST / 2, from);
    fclose(from);
    seed = strtoul(argv[3], NULL, 10);
    for (size_t i = 1 + any(4); i > 0 && size > 0; i--)
        change();
    fwrite(bytes, 1, size, to);
    return fclose(to) != 0;
}
