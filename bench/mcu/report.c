#include "bench/mcu/report.h"

#include "port/cortex_m/semihost.h"

void report(const char *name, int32_t parameter, uint32_t ticks, uint32_t per)
{
    const uint32_t numbers[] = {(uint32_t)parameter, ticks, per};
    semihost_write(name);
    for (int i = 0; i < 3; i++) {
        semihost_write(" ");
        semihost_write_number(numbers[i]);
    }
    semihost_write("\n");
}
