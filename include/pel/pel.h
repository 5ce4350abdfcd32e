/* <pel/pel.h> in this tree; where core is installed or copied as pel/, core's
 * own file is. */
#include "../../core/pel.h"
