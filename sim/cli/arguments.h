/* Command lines through argp, with errors in the words of message.h. */
#ifndef SIM_CLI_ARGUMENTS_H
#define SIM_CLI_ARGUMENTS_H

#include <argp.h>

/* argp_parse for a command: argv[0] is "pel NAME". Wrong options end the
 * program with STATUS_ERROR. */
void arguments_parse(const struct argp *argp, int argc, char **argv,
                     void *input);

#endif
