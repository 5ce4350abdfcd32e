#define _POSIX_C_SOURCE 200809L
#include "budget.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "method.h"

static void fail(const char *path, const char *what)
{
    char text[256];
    snprintf(text, sizeof text, "%s: %s", path, what);
    method_fail(text, "want lines workload,budget,native,memset,peer...");
}

/* The next cell of a line; NULL after the last. */
static const char *next_cell(char **line)
{
    char *cell = *line;
    if (!cell)
        return NULL;
    *line = strchr(cell, ',');
    if (*line)
        *(*line)++ = '\0';
    return cell;
}

/* The next cell, which is a name. */
static void next_name(char **line, char *name, const char *path)
{
    const char *cell = next_cell(line);
    size_t length = cell ? strlen(cell) : 0;
    if (length == 0 || length >= BUDGET_NAME)
        fail(path, "a name that is empty or too long");
    memcpy(name, cell, length + 1);
}

static double next_number(char **line)
{
    const char *cell = next_cell(line);
    return cell ? strtod(cell, NULL) : 0;
}

static void read_header(struct budgets *b, char *line, const char *path)
{
    for (int skip = 0; skip < 4; skip++)
        if (!next_cell(&line))
            fail(path, "the header is too short");
    while (line) {
        if (b->peers == BUDGET_PEERS)
            fail(path, "too many peers");
        next_name(&line, b->peer[b->peers++], path);
    }
}

static void read_row(struct budgets *b, char *line, const char *path)
{
    if (b->n == BUDGETS_MAX)
        fail(path, "too many rows");
    struct budget *row = &b->row[b->n++];
    next_name(&line, row->workload, path);
    row->ns = next_number(&line);
    row->native = next_number(&line);
    row->memset = next_number(&line);
    for (int i = 0; i < b->peers; i++)
        row->peer[i] = next_number(&line);
    if (row->ns <= 0)
        fail(path, "a row without a budget");
}

void budgets_read(struct budgets *b, const char *path)
{
    char line[256];
    FILE *file = fopen(path, "r");
    if (!file)
        fail(path, "cannot be read");
    *b = (struct budgets){0};
    for (int number = 0; fgets(line, sizeof line, file); number++) {
        line[strcspn(line, "\n")] = '\0';
        if (number == 0)
            read_header(b, line, path);
        else
            read_row(b, line, path);
    }
    fclose(file);
}

const struct budget *budgets_find(const struct budgets *b, const char *workload)
{
    for (int i = 0; i < b->n; i++)
        if (strcmp(b->row[i].workload, workload) == 0)
            return &b->row[i];
    return NULL;
}
