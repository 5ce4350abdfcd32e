/* The golden scenes: their size, and the lines of a band. */
#ifndef TESTS_GOLDEN_SIZE_H
#define TESTS_GOLDEN_SIZE_H

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "core/pel.h"

enum { WIDTH = 96, HEIGHT = 72, LINES = 8 };

#endif
