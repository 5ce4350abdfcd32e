/* The lines of docs/linux.md that wait for a button, of a chip that is not
 * there. */
#include <stdio.h>

#include "port/linux/input.h"

int main(void)
{
#include "input.inc"
    return 0;
}
