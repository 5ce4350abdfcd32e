#ifndef STUBS_ESP_FREERTOS_H
#define STUBS_ESP_FREERTOS_H

#include <stdint.h>

typedef uint32_t TickType_t;
#define pdMS_TO_TICKS(ms) ((TickType_t)(ms) / 10)

#endif
