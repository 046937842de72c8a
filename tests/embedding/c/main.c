/* All calls for C, as a program of its own: for libraries that the tests are not linked with. */

#include <stdio.h>

#include "host.h"

int main(int count, char** arguments) {
    const uint64_t hash = hash_of_host_in_c(count > 1 ? arguments[1] : ".");
    printf("%08lx%08lx\n", (unsigned long)(hash >> 32), (unsigned long)(hash & 0xffffffffu));
    return 0;
}
