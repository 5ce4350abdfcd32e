/* The commands of `pel`. Each gets the arguments after `pel`, argv[0] being
 * "pel NAME", and returns the exit status. */
#ifndef SIM_CLI_COMMANDS_H
#define SIM_CLI_COMMANDS_H

enum {
    STATUS_OK = 0,
    STATUS_DIFFERENT = 1, /* pel compare */
    STATUS_ERROR = 2      /* a message is on standard error */
};

int command_run(int argc, char **argv);
int command_render(int argc, char **argv);
int command_view(int argc, char **argv);
int command_compare(int argc, char **argv);
int command_import(int argc, char **argv);
int command_info(int argc, char **argv);
int command_explain(int argc, char **argv);
int command_demo(int argc, char **argv);
int command_console(int argc, char **argv);
int command_input(int argc, char **argv);

#endif
