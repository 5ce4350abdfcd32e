#include "evdev.h"

#include <linux/input-event-codes.h>
#include <stddef.h>

/* Keys whose character, or control character, is their code: KEY_ESC (1) to
 * KEY_KPDOT (83). 1 stands for none. */
static const char characters[] = "\1\0331234567890-=\b\t"
                                 "qwertyuiop[]\r\1asdfghjkl;'`"
                                 "\1\\zxcvbnm,./\1*\1 \1"
                                 "\1\1\1\1\1\1\1\1\1\1\1\1"
                                 "789-456+1230.";

static const struct {
    uint16_t from, to;
} others[] = {
    {KEY_LEFTCTRL, PEL_KEY_CTRL},   {KEY_RIGHTCTRL, PEL_KEY_CTRL},
    {KEY_LEFTSHIFT, PEL_KEY_SHIFT}, {KEY_RIGHTSHIFT, PEL_KEY_SHIFT},
    {KEY_LEFTALT, PEL_KEY_ALT},     {KEY_RIGHTALT, PEL_KEY_ALT},
    {KEY_F11, PEL_KEY_F1 + 10},     {KEY_F12, PEL_KEY_F1 + 11},
    {KEY_KPENTER, PEL_KEY_ENTER},   {KEY_KPSLASH, '/'},
    {KEY_HOME, PEL_KEY_HOME},       {KEY_UP, PEL_KEY_UP},
    {KEY_PAGEUP, PEL_KEY_PAGE_UP},  {KEY_LEFT, PEL_KEY_LEFT},
    {KEY_RIGHT, PEL_KEY_RIGHT},     {KEY_END, PEL_KEY_END},
    {KEY_DOWN, PEL_KEY_DOWN},       {KEY_PAGEDOWN, PEL_KEY_PAGE_DOWN},
    {KEY_INSERT, PEL_KEY_INSERT},   {KEY_DELETE, PEL_KEY_DELETE},
    {KEY_OK, PEL_KEY_ENTER},        {KEY_SELECT, PEL_KEY_ENTER},
};

uint16_t pel_evdev_key(int code)
{
    if (code < (int)sizeof(characters) - 1 && characters[code] != 1)
        return (uint16_t)characters[code];
    if (code >= KEY_F1 && code <= KEY_F10)
        return (uint16_t)(PEL_KEY_F1 + code - KEY_F1);
    if (code >= KEY_F13 && code <= KEY_F24)
        return (uint16_t)(PEL_KEY_F1 + 12 + code - KEY_F13);
    for (size_t i = 0; i < sizeof(others) / sizeof(others[0]); i++)
        if (others[i].from == code)
            return others[i].to;
    return (uint16_t)(PEL_KEY_OTHER + code);
}
