#pragma once
// What the C tests say where something is not so.

#include <stdio.h>
#include <stdlib.h>

#include "weft/weft_c.h"

#define CHECK(condition)                                                                               \
    do {                                                                                               \
        if (!(condition)) {                                                                            \
            fprintf(stderr, "%s:%d: %s; \"%s\"\n", __FILE__, __LINE__, #condition, weft_error_text()); \
            exit(1);                                                                                   \
        }                                                                                              \
    } while (0)
#define TAKES(call) CHECK((call) == WEFT_OK)
// What is wrong with it the text has a word of.
#define REFUSES(code, word, call)                         \
    do {                                                  \
        CHECK((call) == (code));                          \
        CHECK(strstr(weft_error_text(), (word)) != NULL); \
    } while (0)
