#ifndef STUBS_ESP_TASK_H
#define STUBS_ESP_TASK_H

void vTaskDelay(TickType_t ticks);

#endif
