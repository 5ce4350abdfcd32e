#include "status.h"

const char *pel_status_name(enum pel_status status)
{
    switch (status) {
    case PEL_OK:
        return "PEL_OK";
    case PEL_ERROR_NULL:
        return "PEL_ERROR_NULL";
    case PEL_ERROR_SIZE:
        return "PEL_ERROR_SIZE";
    case PEL_ERROR_STRIDE:
        return "PEL_ERROR_STRIDE";
    case PEL_ERROR_ALIGNMENT:
        return "PEL_ERROR_ALIGNMENT";
    case PEL_ERROR_SCRATCH:
        return "PEL_ERROR_SCRATCH";
    case PEL_ERROR_RANGE:
        return "PEL_ERROR_RANGE";
    case PEL_ERROR_FORMAT:
        return "PEL_ERROR_FORMAT";
    case PEL_ERROR_DEVICE:
        return "PEL_ERROR_DEVICE";
    }
    return "PEL_ERROR";
}
