#pragma once
// Checks of the C tests: a failure prints the condition and the library's error text.

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
// The error's text must contain `word`.
#define REFUSES(code, word, call)                         \
    do {                                                  \
        CHECK((call) == (code));                          \
        CHECK(strstr(weft_error_text(), (word)) != NULL); \
    } while (0)
