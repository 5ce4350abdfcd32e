#ifndef STUBS_ESP_GPIO_H
#define STUBS_ESP_GPIO_H

#include <stdint.h>

typedef enum { GPIO_MODE_OUTPUT = 2 } gpio_mode_t;
int gpio_set_direction(int pin, gpio_mode_t mode);
int gpio_set_level(int pin, uint32_t level);

#endif
