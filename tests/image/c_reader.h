/* The C reader, compiled as C99, for tests in C++. */
#ifndef CGW_TESTS_C_READER_H
#define CGW_TESTS_C_READER_H

#include "image/c/cgw_image.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef void (*c_reader_put)(void* to, uint64_t value);

/* Opens the bytes; of an image that is not refused every value is put, one after the other. Returns the
 * status. */
unsigned c_reader_dump(const void* bytes, size_t size, c_reader_put put, void* to);

/* How much of an area is to be opened, and what opening that says. */
size_t c_reader_in(const void* area, size_t size);
unsigned c_reader_open_region(const void* region, size_t region_size);

/* 1 when everything can be found by its number, and nothing else; what is not found changes nothing. */
int c_reader_finds(const void* bytes, size_t size);

#ifdef __cplusplus
}
#endif

#endif
