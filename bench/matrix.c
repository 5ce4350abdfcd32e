/* The paints of bench/mcu/matrix.c on this machine: many rounds, of which the
 * median counts. */
#include "bench/mcu/report.h"

enum { ROUNDS = 41 };

int main(void)
{
    for (int i = 0; i < ROUNDS; i++)
        matrix_report();
    return 0;
}
