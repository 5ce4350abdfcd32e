#include "bench/mcu/report.h"

#include <inttypes.h>
#include <stdio.h>

void report(const char *name, int32_t parameter, int32_t time, uint32_t per)
{
    printf("%s %" PRId32 " %" PRId32 " %" PRIu32 "\n", name, parameter, time,
           per);
}
