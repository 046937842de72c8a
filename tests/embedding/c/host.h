#pragma once
/* The C test's parts. */

#include "weft/weft_c.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Makes every call of weft_c.h; exits where one is not as it should be. The state's hash after some steps.
 * folder: for files.
 */
uint64_t hash_of_host_in_c(const char* folder);

void look_at(WeftWorld* world, WeftClothId cloth, const char* folder);
void go_back(WeftWorld* world);
void record(const char* folder);
void cut_cloth(void);
void rest_of_the_host(void);

#ifdef __cplusplus
}
#endif
