/* Time, for those who print how long something took. */
#ifndef SIM_CLI_MILLISECONDS_H
#define SIM_CLI_MILLISECONDS_H

/* Of a clock that only runs forwards. */
double milliseconds(void);

#endif
