/* Standard input, output and error of the whole program. */
#ifndef SIM_CLI_STANDARD_H
#define SIM_CLI_STANDARD_H

/* Before anything is opened: those that the caller closed become streams that
 * always fail, so that no file gets their numbers; and however the program
 * ends, it ends with STATUS_ERROR, and a message, when anything that it wrote
 * there is lost. Files beyond the size limit are errors like others. */
void standard_watch(void);

#endif
