// The Arduino IDE, as far as the example board.ino uses it.
#include <stdint.h>
#include <stdio.h>

struct port {
    void begin(long)
    {
    }
    void print(char c)
    {
        putchar(c);
    }
    operator bool() const
    {
        return true;
    }
};
static port Serial;

#include "board.ino"

int main()
{
    setup();
    loop();
    return 0;
}
