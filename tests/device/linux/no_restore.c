/* Linked in place of the restore, to see that the tests notice. */
#include <stdbool.h>

struct pel_console_state;

bool __wrap_pel_console_state_restore(const struct pel_console_state *state)
{
    return state != 0;
}
