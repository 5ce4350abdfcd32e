#include "sim/view/record.h"

#include <stdlib.h>
#include <string.h>

#include "sim/cli/list.h"
#include "sim/cli/message.h"
#include "sim/cli/text_line.h"

static const struct {
    const char *name;
    int kind;
} kinds[] = {
    {"key", PEL_INPUT_KEY},     {"button", PEL_INPUT_BUTTON},
    {"move", PEL_INPUT_MOVE},   {"point", PEL_INPUT_POINT},
    {"touch", PEL_INPUT_TOUCH}, {"wheel", PEL_INPUT_WHEEL},
    {"size", RECORD_SIZE},
};
enum { KINDS = sizeof kinds / sizeof kinds[0] };

static const char *const states[] = {"up", "down", "again"};

static bool parse(const char *line, struct record_entry *entry)
{
    char kind[8], state[8] = "up";
    int code = 0, x = 0, y = 0, at = 0, end = -1, k = 0, s = 0;
    if (sscanf(line, "%ld %7s %n", &entry->frame, kind, &at) != 2)
        return false;
    const bool size = strcmp(kind, "size") == 0;
    const bool whole = size ? sscanf(line + at, "%d %d %n", &x, &y, &end) == 2
                            : sscanf(line + at, "%d %7s %d %d %n", &code, state,
                                     &x, &y, &end) == 4;
    while (k < KINDS - 1 && strcmp(kind, kinds[k].name) != 0)
        k++;
    while (s < 3 && strcmp(state, states[s]) != 0)
        s++;
    entry->input = (struct pel_input){.kind = (uint8_t)kinds[k].kind,
                                      .state = (uint8_t)s,
                                      .code = (uint16_t)code,
                                      .x = (int16_t)x,
                                      .y = (int16_t)y};
    return whole && end >= 0 && !line[at + end] && entry->frame >= 0 &&
           size == (k == KINDS - 1) && s < 3 && code == (uint16_t)code &&
           x == (int16_t)x && y == (int16_t)y && (!size || (x > 0 && y > 0));
}

static bool add(struct record *r, const char *path, long line, const char *text)
{
    struct record_entry *list = list_grow(r->entry, r->count, sizeof *list);
    if (!list)
        return false;
    r->entry = list;
    if (!parse(text, &list[r->count]) ||
        (r->count > 0 && list[r->count].frame < list[r->count - 1].frame))
        return message_error_at(path, line,
                                "expected FRAME KIND CODE STATE X Y, or FRAME "
                                "size WIDTH HEIGHT, with frames that ascend");
    r->count++;
    return true;
}

bool record_load(struct record *r, const char *path)
{
    struct text_lines lines;
    *r = (struct record){NULL, 0, 0};
    bool done = text_lines_read(&lines, path);
    for (size_t i = 0; done && i < lines.count; i++)
        done =
            *lines.text[i] == '#' || add(r, path, (long)i + 1, lines.text[i]);
    text_lines_free(&lines);
    if (!done)
        record_free(r);
    return done;
}

void record_free(struct record *r)
{
    free(r->entry);
    *r = (struct record){NULL, 0, 0};
}

const struct pel_input *record_next(struct record *r, long frame)
{
    return r->next < r->count && r->entry[r->next].frame <= frame
               ? &r->entry[r->next++].input
               : NULL;
}

void record_write(FILE *out, long frame, const struct pel_input *in)
{
    int k = 0;
    if (in->kind == RECORD_SIZE) {
        fprintf(out, "%ld size %d %d\n", frame, in->x, in->y);
        return;
    }
    while (k < KINDS && kinds[k].kind != in->kind)
        k++;
    if (k < KINDS)
        fprintf(out, "%ld %s %u %s %d %d\n", frame, kinds[k].name,
                (unsigned)in->code, states[in->state], in->x, in->y);
}
