#include "key_names.h"

#include <stdio.h>
#include <string.h>

static const struct {
    int code;
    const char *name;
} names[] = {
    {PEL_KEY_BACKSPACE, "backspace"},
    {PEL_KEY_TAB, "tab"},
    {PEL_KEY_ENTER, "enter"},
    {PEL_KEY_ESCAPE, "escape"},
    {PEL_KEY_DELETE, "delete"},
    {' ', "space"},
    {',', "comma"},
    {PEL_KEY_LEFT, "left"},
    {PEL_KEY_RIGHT, "right"},
    {PEL_KEY_UP, "up"},
    {PEL_KEY_DOWN, "down"},
    {PEL_KEY_HOME, "home"},
    {PEL_KEY_END, "end"},
    {PEL_KEY_PAGE_UP, "page-up"},
    {PEL_KEY_PAGE_DOWN, "page-down"},
    {PEL_KEY_INSERT, "insert"},
    {PEL_KEY_SHIFT, "shift"},
    {PEL_KEY_CTRL, "ctrl"},
    {PEL_KEY_ALT, "alt"},
};

int pel_key_find(const char *name)
{
    int f, read = 0;
    for (size_t i = 0; i < sizeof(names) / sizeof(names[0]); i++)
        if (strcmp(names[i].name, name) == 0)
            return names[i].code;
    if (sscanf(name, "f%2d%n", &f, &read) == 1 && !name[read] && f >= 1 &&
        f <= 24)
        return PEL_KEY_F1 + f - 1;
    return name[0] > ' ' && name[0] < 127 && !name[1] ? name[0] : -1;
}

const char *pel_key_name(int code, char name[PEL_KEY_NAME_SIZE])
{
    for (size_t i = 0; i < sizeof(names) / sizeof(names[0]); i++)
        if (names[i].code == code)
            return names[i].name;
    if (code > ' ' && code < 127)
        snprintf(name, PEL_KEY_NAME_SIZE, "%c", code);
    else if (code >= PEL_KEY_F1 && code < PEL_KEY_F1 + 24)
        snprintf(name, PEL_KEY_NAME_SIZE, "f%d",
                 (code - PEL_KEY_F1 + 1) & 0xFF);
    else
        snprintf(name, PEL_KEY_NAME_SIZE, "key %d", code & 0xFFFF);
    return name;
}
